// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A stand-in for PX4's header: microseconds since the start. The test defines the clock.
#pragma once

#include <stdint.h>

typedef uint64_t hrt_abstime;

extern "C" hrt_abstime hrt_absolute_time();
