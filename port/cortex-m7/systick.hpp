// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_PORT_CORTEX_M7_SYSTICK_HPP
#define TERN_PORT_CORTEX_M7_SYSTICK_HPP

#include <cstdint>

namespace tern_board {

/// Processor cycles since start-up, to the resolution of SysTick.
std::uint64_t systick_cycles() noexcept;

/// The processor's clock on this board.
constexpr std::uint64_t kClockHertz = 25000000;

}  // namespace tern_board

#endif
