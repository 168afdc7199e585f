// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The trajectory stage, run alone.
#ifndef TERN_TESTS_TRAJECTORY_STAGE_FLIGHT_HPP
#define TERN_TESTS_TRAJECTORY_STAGE_FLIGHT_HPP

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <memory>

#include "curve/brake.hpp"
#include "curve/motion_limits.hpp"
#include "curve/rest.hpp"
#include "support/box_corridor.hpp"
#include "support/chain.hpp"
#include "trajectory/stop_and_go.hpp"
#include "trajectory/trajectory_stage.hpp"

namespace tern_test {

/// The speed limit alone decides how long a flight takes.
inline constexpr tern::Limits kAgileLimits{{1.0, 1.0, 1.0}, {4.0, 4.0, 4.0}};

/// A plan with everything that it was made from and says about itself.
struct Flight {
  std::unique_ptr<tern::TrajectoryStage> stage = std::make_unique<tern::TrajectoryStage>();
  tern::Trajectory plan;
  tern::Status status;
  tern::Operations spent = 0;

  /// Runs in slices; stopped once `budget` is spent.
  Flight(const tern::Corridor& corridor, const tern::TrajectoryQuery& query, std::uint32_t slice = kUnlimited,
         int fill = 0, std::uint32_t budget = kUnlimited) {
    std::memset(static_cast<void*>(stage.get()), fill, sizeof(tern::TrajectoryStage));
    std::memset(static_cast<void*>(&plan), 0, sizeof(plan));
    begin_trajectory(*stage, corridor, query);
    tern::Progress progress = tern::Progress::kMore;
    while (progress == tern::Progress::kMore) {
      tern::Work work = tern::Work{slice}.within(tern::kUnit * budget - spent);
      const tern::Operations given = work.operations();
      progress = tern::trajectory_advance(*stage, corridor, work, plan);
      spent += given - work.operations();
      if (progress == tern::Progress::kMore && spent >= tern::kUnit * budget) tern::trajectory_stop(*stage);
    }
    status = stage->status;
  }
  bool same_plan(const Flight& other) const { return std::memcmp(&plan, &other.plan, sizeof(plan)) == 0; }
};

inline tern::Corridor corner() {
  tern::Corridor corridor{};
  corridor.count = 3;
  corridor.polyhedra[0] = box_around({0, 0, 1}, {4, 0, 1}, 0.4);
  corridor.polyhedra[1] = box_around({4, 0, 1}, {4, 3, 1}, 0.3);
  corridor.polyhedra[2] = box_around({4, 3, 1}, {8, 3, 2}, 0.5);
  return corridor;
}

inline tern::TrajectoryQuery rest_to_rest(const tern::Corridor& corridor) {
  return {resting(corridor.polyhedra[0].from), resting(corridor.polyhedra[corridor.count - 1].to), kTwo,
          tern::kDefaultTimeWeight};
}

}  // namespace tern_test

#endif
