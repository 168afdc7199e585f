/* Copyright (c) 2026, the Tern authors
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * A stand-in for the Crazyflie's log variables. The test defines the functions. */
#pragma once

#include <stdint.h>

typedef uint16_t logVarId_t;

logVarId_t logGetVarId(const char* group, const char* name);
float logGetFloat(logVarId_t varid);
