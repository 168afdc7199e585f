// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_PORT_LINUX_PERF_COUNTER_HPP
#define TERN_PORT_LINUX_PERF_COUNTER_HPP

#include <cstdint>

namespace tern_port {

/// A hardware counter of the calling thread, user space only, through perf_event_open. Not available where
/// /proc/sys/kernel/perf_event_paranoid is above 2, in most containers, and under qemu-user: every reading is then 0.
class PerfCounter {
 public:
  enum class Event : std::uint8_t { kCycles, kInstructions };

  explicit PerfCounter(Event event) noexcept;
  ~PerfCounter();
  PerfCounter(const PerfCounter&) = delete;
  PerfCounter& operator=(const PerfCounter&) = delete;

  bool available() const noexcept { return file_ >= 0; }
  /// Counts since construction. One system call: for stages of many microseconds, not for single loops.
  std::uint64_t read() const noexcept;

 private:
  int file_;
};

/// PerfCounter as a clock for Planner::set_clock: `counter` points to one that is available.
std::uint64_t perf_ticks(void* counter) noexcept;

}  // namespace tern_port

#endif
