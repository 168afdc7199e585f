// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A stand-in for PX4's header. The test defines the function, which lets its clock run.
#pragma once

extern "C" int px4_usleep(unsigned microseconds);
