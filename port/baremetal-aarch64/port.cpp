// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tern_port/port.hpp"

#include "baremetal-aarch64/counters.hpp"

namespace tern_port {

// The generic timer. Under -icount it advances in steps of 16 instructions: good for a deadline, not for counting.
std::uint64_t monotonic_nanoseconds() noexcept {
  std::uint64_t count;
  std::uint64_t frequency;
  asm volatile("isb\n mrs %0, cntvct_el0" : "=r"(count) : : "memory");
  asm volatile("mrs %0, cntfrq_el0" : "=r"(frequency));
  constexpr std::uint64_t kNanoseconds = 1000000000u;
  // In two parts, so that the product does not overflow before 584 years of a 1 GHz counter.
  return count / frequency * kNanoseconds + count % frequency * kNanoseconds / frequency;
}

// Instructions, because they are exact under emulation. A board's owner returns tern_board::cycles() instead.
std::uint64_t ticks(void* /*context*/) noexcept {
  return tern_board::instructions();
}

// Of QEMU's virtual time at -icount shift=0: one instruction is one nanosecond.
double ticks_per_second() noexcept {
  return 1e9;
}

}  // namespace tern_port
