// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A stand-in for PX4's header. The test defines the function.
#pragma once

typedef int px4_task_t;
typedef int (*px4_main_t)(int argc, char* argv[]);

#define SCHED_DEFAULT 1
#define SCHED_PRIORITY_DEFAULT 100

extern "C" px4_task_t px4_task_spawn_cmd(const char* name, int scheduler, int priority, int stack_size,
                                         px4_main_t entry, char* const argv[]);
