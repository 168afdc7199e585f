/* Copyright (c) 2026, the Tern authors
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * A stand-in for FreeRTOS. The test defines the function. */
#pragma once

#include <stdint.h>

void vTaskDelay(uint32_t ticks);
