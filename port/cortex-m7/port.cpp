// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tern_port/port.hpp"

#include "cortex-m7/systick.hpp"

namespace tern_port {

std::uint64_t monotonic_nanoseconds() noexcept {
  constexpr std::uint64_t kNanosecondsPerCycle = 1000000000u / tern_board::kClockHertz;
  return tern_board::systick_cycles() * kNanosecondsPerCycle;
}

std::uint64_t ticks(void* /*context*/) noexcept {
  return tern_board::systick_cycles();
}

double ticks_per_second() noexcept {
  return static_cast<double>(tern_board::kClockHertz);
}

}  // namespace tern_port
