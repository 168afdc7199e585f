/* Copyright (c) 2026, the Tern authors
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * A stand-in for FreeRTOS: ticks of a millisecond. */
#pragma once

#include <stdint.h>

#define M2T(milliseconds) ((uint32_t)(milliseconds))
