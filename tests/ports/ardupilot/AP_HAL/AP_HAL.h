// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A stand-in for ArduPilot's header. The test defines the clock.
#pragma once

#include <stdint.h>

namespace AP_HAL {
uint64_t micros64();
}
