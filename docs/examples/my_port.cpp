// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// port/README.md: a port of one's own. tests/consume builds it as one and plans with it.
#include "tern_port/port.hpp"

extern "C" unsigned long long my_timer_count();  // 64 bits; a timer of 32 is widened in its interrupt
constexpr std::uint64_t kTimerHertz = 1000000;

namespace tern_port {

// Never runs backwards. The division comes last: split it where count * 1000 could overflow.
std::uint64_t monotonic_nanoseconds() noexcept {
  return my_timer_count() * (1000000000u / kTimerHertz);
}

// What the planner's report counts in: a cycle counter where there is one (DWT CYCCNT on a Cortex-M7, PMCCNTR_EL0 on a
// Cortex-A that allows it), the same as above where there is none.
std::uint64_t ticks(void* /*context*/) noexcept {
  return my_timer_count();
}

// Turns a report's ticks into time.
double ticks_per_second() noexcept {
  return static_cast<double>(kTimerHertz);
}

}  // namespace tern_port
