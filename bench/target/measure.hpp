// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_BENCH_TARGET_MEASURE_HPP
#define TERN_BENCH_TARGET_MEASURE_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "host/session.hpp"
#include "linux-perf/perf_counter.hpp"

namespace tern_target {

/// Over the repetitions.
struct Spread {
  double median;
  double p99;
  double max;
};

/// One row of the table.
struct Figures {
  const char* stage;
  Spread nanoseconds;
  Spread cycles;  ///< zeros where no cycle counter was to be had
  bool has_work;  ///< the row counts work
  std::uint64_t work;
  std::uint64_t bound;
};

struct CaseFigures {
  std::string name;
  std::uint64_t bits;  ///< hash over every bit of the plan, to compare with other machines'
  std::vector<Figures> rows;
};

/// Plans one scenario after another with the memory and counters it owns.
class Measurement {
 public:
  Measurement();

  bool has_cycles() const { return cycle_counter_.available(); }

  /// Plans `repetitions` (>= 1) times by the clock, and as often again by the cycle counter where there is one: reading
  /// that is a system call, which must not be in the times. Throws std::runtime_error where there is no plan, or where
  /// two plans of the same input have different bits.
  CaseFigures measure(const tern_host::Scenario& scenario, int repetitions);

 private:
  tern_port::PerfCounter cycle_counter_;
  tern_host::Session timed_;
  tern_host::Session counted_;
};

}  // namespace tern_target

#endif
