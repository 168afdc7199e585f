// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a bare-metal image finds on its board. Start-up runs the constructors and calls main(argc, argv), whose result
// ends the run. A board's folder gives start-up code, a linker script, counters and fault reports.
#ifndef TERN_PORT_BAREMETAL_BOARD_HPP
#define TERN_PORT_BAREMETAL_BOARD_HPP

#include <cstddef>
#include <cstdint>

#include "baremetal/print.hpp"
#include "baremetal/semihosting.hpp"

/// Places an object in the board's largest memory. It is not cleared at start-up: Tern's workspace and grid words need
/// no initial value.
#define TERN_BOARD_LARGE __attribute__((section(".large")))

namespace tern_board {

/// Exit status of a run that a fault ended.
constexpr int kFaultStatus = 70;

/// The board's name, for headings.
const char* name() noexcept;

/// Starts counters; called by start-up before main.
void start_counters() noexcept;

/// The board's finest exact counter, 64 bits wide; what tern_port::ticks returns.
std::uint64_t counter() noexcept;
/// What it counts, for headings: "instructions retired", ...
const char* counter_unit() noexcept;

/// Fills the unused part of the stack with a pattern, down to its end.
void paint_stack() noexcept;
/// Bytes of stack below the caller that were written since paint_stack(), called from the same depth.
std::size_t stack_used() noexcept;
/// Bytes of stack that the linker script gives.
std::size_t stack_size() noexcept;

}  // namespace tern_board

#endif
