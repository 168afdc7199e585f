// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_BENCH_TIMING_YAW_ROWS_HPP
#define TERN_BENCH_TIMING_YAW_ROWS_HPP

#include <cstdint>

#include "tern/trajectory.hpp"
#include "tern/yaw.hpp"

namespace tern_timing {

/// The most expensive yaw plan of each mode, and the longest unit, over the trajectories of all cases.
class YawRows {
 public:
  /// Plans the yaw of a trajectory in every mode, whole and in units. False if a request is refused.
  bool add(const tern::Trajectory& trajectory);
  void print() const;

 private:
  struct Cost {
    std::uint64_t count;
    std::uint32_t work;
  };
  static constexpr int kModes = 4;

  bool plan(const tern::Trajectory& trajectory, const tern::YawRequest& request);

  tern::YawPlanner planner_;
  tern::YawPlan yaw_;
  Cost most_[kModes] = {};
  std::uint64_t longest_unit_ = 0;
};

}  // namespace tern_timing

#endif
