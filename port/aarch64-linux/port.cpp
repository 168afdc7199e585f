// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The generic timer, read without a system call. It runs at the same rate whatever the core's clock does, so it
// measures time; cycles and instructions come from perf_counter.hpp where the kernel allows.
#include "tern_port/port.hpp"

namespace tern_port {
namespace {

std::uint64_t timer() noexcept {
  std::uint64_t count;
  // The barrier keeps the read from moving ahead of the work before it.
  asm volatile("isb\n mrs %0, cntvct_el0" : "=r"(count) : : "memory");
  return count;
}

std::uint64_t timer_hertz() noexcept {
  std::uint64_t frequency;
  asm volatile("mrs %0, cntfrq_el0" : "=r"(frequency));
  return frequency;
}

}  // namespace

std::uint64_t monotonic_nanoseconds() noexcept {
  constexpr std::uint64_t kNanoseconds = 1000000000u;
  const std::uint64_t count = timer();
  const std::uint64_t frequency = timer_hertz();
  // In two parts, so that the product does not overflow.
  return count / frequency * kNanoseconds + count % frequency * kNanoseconds / frequency;
}

std::uint64_t ticks(void* /*context*/) noexcept {
  return timer();
}

double ticks_per_second() noexcept {
  return static_cast<double>(timer_hertz());
}

}  // namespace tern_port
