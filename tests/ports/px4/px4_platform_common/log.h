// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A stand-in for PX4's header: log lines go to standard output.
#pragma once

extern "C" int printf(const char* format, ...) __attribute__((format(printf, 1, 2)));

#define PX4_INFO(...) static_cast<void>((printf(__VA_ARGS__), printf("\n")))
#define PX4_ERR(...) static_cast<void>((printf("error: "), printf(__VA_ARGS__), printf("\n")))
