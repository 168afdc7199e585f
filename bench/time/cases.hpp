// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Worlds of things that move, by seed: 32 x 16 x 6 m, empty or with pillars, some with vias, and balls of which a
// quarter is aimed at the plan that is made without them.
#ifndef TERN_BENCH_TIME_CASES_HPP
#define TERN_BENCH_TIME_CASES_HPP

#include <cstdint>
#include <random>
#include <vector>

#include "tern/tern.hpp"

namespace tern_bench {

/// A row of the table.
struct TimeFamily {
  const char* name;
  int pillars;
  double speed;   ///< at the start, along x, m/s
  bool has_vias;  ///< two: one to pass, one to rest at for a second
};

/// Numbers of <random>'s engine, the same everywhere.
class Reals {
 public:
  explicit Reals(std::uint64_t seed) : engine_(seed) {}
  double operator()(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }

 private:
  std::mt19937_64 engine_;
};

/// One world, and what is asked for in it.
struct TimeCase {
  tern::Grid grid;
  std::vector<std::uint64_t> words;
  tern::Request request;
  std::vector<tern::Track> tracks;
  tern::Via vias[2];
};

/// The world without things; `reals` then goes on in add_things().
void build(const TimeFamily& family, Reals& reals, TimeCase& made);

/// `count` balls of 0.3 m with an error of 5 cm that grows by 2 cm/s, at 0.5 to 1.8 m/s, none of them near the start in
/// the first second. Every fourth one passes within half a metre of `alone`, the plan without things, when the plan is
/// there.
void add_things(int count, const tern::Trajectory& alone, Reals& reals, TimeCase& made);

/// By how much a plan is nearer to a thing than it should be, at the worst of 2000 instants; m, negative if never.
double too_near_by(const TimeCase& made, const tern::Trajectory& plan);

}  // namespace tern_bench

#endif
