// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A stand-in for PX4's header. The test defines the functions.
#pragma once

#include <stdint.h>

typedef uint32_t param_t;

extern "C" param_t param_find(const char* name);
extern "C" int param_get(param_t param, void* value);
