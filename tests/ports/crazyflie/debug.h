/* Copyright (c) 2026, the Tern authors
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * A stand-in for the Crazyflie's console. */
#pragma once

#include <stdio.h>

#define DEBUG_PRINT(...) printf(__VA_ARGS__)
