// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How much of a limit is used where it binds: for each limit row that is active in a programme's solution, the peak
// that the segment really has in that direction, over the limit. 1 minus that is what bounding by control points loses.
#ifndef TERN_BENCH_PLANS_LIMIT_ROWS_HPP
#define TERN_BENCH_PLANS_LIMIT_ROWS_HPP

#include <memory>
#include <vector>

#include "trajectory/trajectory_stage.hpp"

namespace tern_bench {

/// What an active row limits.
enum class RowKind { kUp, kDown, kHorizontal };

struct LimitRow {
  int order;  ///< 1: velocity, 2: acceleration
  int axis;   ///< 0 .. 2, of kUp and kDown; 0 of kHorizontal
  RowKind kind;
  double use;  ///< the segment's peak over the limit, in the programme's own durations
};

/// Runs the trajectory stage on a corridor, from rest to rest.
class Prober {
 public:
  /// Rows of every programme that became a plan, each segment and direction once a programme.
  std::vector<LimitRow> rows(const tern::Corridor& corridor, const tern::Limits& limits, double time_weight);

 private:
  void collect(std::vector<LimitRow>& rows) const;
  LimitRow measure(const tern::QpConstraint& row) const;

  std::unique_ptr<tern::TrajectoryStage> stage_ = std::make_unique<tern::TrajectoryStage>();
  std::unique_ptr<tern::Trajectory> plan_ = std::make_unique<tern::Trajectory>();
  std::vector<double> durations_;
};

}  // namespace tern_bench

#endif
