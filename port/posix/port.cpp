// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tern_port/port.hpp"

#include <time.h>

namespace tern_port {

std::uint64_t monotonic_nanoseconds() noexcept {
  timespec now{};
  if (clock_gettime(CLOCK_MONOTONIC, &now) != 0) return 0;
  return static_cast<std::uint64_t>(now.tv_sec) * 1000000000u + static_cast<std::uint64_t>(now.tv_nsec);
}

// The vDSO answers in about 20 ns without a system call; a cycle counter would need its own calibration.
std::uint64_t ticks(void* /*context*/) noexcept {
  return monotonic_nanoseconds();
}

double ticks_per_second() noexcept {
  return 1e9;
}

}  // namespace tern_port
