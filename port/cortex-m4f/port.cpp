// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The same counter as the Cortex-M7's, at the same clock.
#include "cortex-m7/port.cpp"
