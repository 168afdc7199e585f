// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_BENCH_TARGET_REALTIME_HPP
#define TERN_BENCH_TARGET_REALTIME_HPP

#include <string>

namespace tern_target {

/// What the system granted this thread.
struct Realtime {
  bool fifo = false;    ///< SCHED_FIFO
  bool locked = false;  ///< no page of the process leaves memory
  int processor = -1;   ///< the one that the thread is pinned to; -1: none
  std::string refused;  ///< what was asked for and not granted, with the reason; empty where all was
};

/// Asks for all three, for the calling thread. `processor` below 0 chooses the last one allowed: the first one serves
/// most interrupts on Linux boards.
Realtime request_realtime(int processor);

/// "SCHED_FIFO yes, memory locked yes, pinned to processor 5", with what was refused.
std::string describe(const Realtime& realtime);

/// Sleeps after a plan that took `seconds`, long enough that a SCHED_FIFO thread stays below the 95 % of a second that
/// Linux leaves to real-time threads: a plan that meets that limit would stand still for 50 ms and report it.
void rest_after(double seconds);

}  // namespace tern_target

#endif
