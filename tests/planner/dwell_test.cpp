// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Plans that rest at a via for a while.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <vector>

#include "base/math.hpp"
#include "support/random.hpp"
#include "support/world.hpp"
#include "tern/yaw.hpp"

namespace tern_test {
namespace {

using tern::Status;
using tern::Vec3;
using tern::Via;

/// 8 x 4 x 2 m at 0.1 m, radius 0.25.
class Dwell : public testing::Test {
 protected:
  Dwell() : world_({80, 40, 20}, 0.1, 0.25, {10.0, -20.0, 5.0}) { world_.from({1.0, 1.0, 1.0}).to({7.0, 1.0, 1.0}); }
  Via& stop(const Vec3& relative, double dwell) {
    vias_.push_back({relative + world_.spec.origin, 0.0, true, false, {}, dwell});
    return vias_.back();
  }
  Status plan() {
    world_.request.vias = vias_.data();
    world_.request.via_count = static_cast<std::int32_t>(vias_.size());
    return world_.plan();
  }
  double arrival(std::size_t v) const { return world_.report.vias[v].time; }
  /// The plan does not move from its arrival at each via on, for as long as was asked.
  void expect_rests() {
    for (std::size_t v = 0; v < vias_.size(); ++v) {
      for (int k = 0; k <= 20; ++k) {
        const tern::Sample at = tern::evaluate(world_.trajectory, arrival(v) + vias_[v].dwell * k / 20.0);
        EXPECT_LE(tern::distance(at.position, vias_[v].position), vias_[v].tolerance + 1e-9) << v << " " << k;
        EXPECT_LE(tern::length(at.velocity), 1e-6) << v << " " << k;
      }
    }
  }

  World world_;
  std::vector<Via> vias_;
};

TEST_F(Dwell, AddsExactlyItsTimeToThePlan) {
  stop({4.0, 3.0, 1.0}, 0.0);
  ASSERT_EQ(plan(), Status::kOk);
  const double without = tern::duration(world_.trajectory), there = arrival(0);
  const int segments = world_.trajectory.count;
  for (const double dwell : {0.001, 2.5, 3600.0}) {
    vias_[0].dwell = dwell;
    ASSERT_EQ(plan(), Status::kOk);
    EXPECT_EQ(world_.report.quality, tern::Quality::kOptimised);
    EXPECT_NEAR(tern::duration(world_.trajectory), without + dwell, 1e-9 + 1e-12 * dwell);
    EXPECT_EQ(arrival(0), there);
    EXPECT_EQ(world_.trajectory.count, segments + 1);
    expect_rests();
  }
}

TEST_F(Dwell, HoldsAtEveryStopAndAtBothEnds) {
  stop({1.0, 1.0, 1.0}, 1.0);  // the start
  stop({3.0, 2.0, 1.0}, 0.5);
  stop({3.0, 2.0, 1.0}, 0.25);  // again
  stop({5.0, 3.0, 1.2}, 2.0);
  stop({7.0, 1.0, 1.0}, 3.0);  // the goal
  ASSERT_EQ(plan(), Status::kOk);
  expect_rests();
  EXPECT_GE(arrival(2), arrival(1) + 0.5);
  EXPECT_GE(tern::duration(world_.trajectory), arrival(4) + 3.0 - 1e-9);
  world_.request.budget.trajectory = 0;
  ASSERT_EQ(plan(), Status::kOk);
  EXPECT_EQ(world_.report.quality, tern::Quality::kStopAndGo);
  expect_rests();
  EXPECT_NEAR(tern::duration(world_.trajectory), arrival(4) + 3.0, 1e-9);
}

TEST_F(Dwell, HoldsInStopAndGoAndAfterAStartInMotion) {
  stop({4.0, 3.0, 1.0}, 1.5);
  world_.request.budget.trajectory = 0;
  ASSERT_EQ(plan(), Status::kOk);
  EXPECT_EQ(world_.report.quality, tern::Quality::kStopAndGo);
  expect_rests();
  world_.request.budget = {};
  world_.request.start.velocity = {0.0, -1.0, 0.0};
  ASSERT_EQ(plan(), Status::kOk);
  expect_rests();
}

TEST_F(Dwell, TheNoseHoldsItsHeading) {
  stop({4.0, 3.0, 1.0}, 4.0);
  ASSERT_EQ(plan(), Status::kOk);
  auto planner = std::make_unique<tern::YawPlanner>();
  tern::YawPlan yaw{};
  ASSERT_EQ(planner->plan(world_.trajectory, tern::yaw_request({1.0, 0.0}, 1.0, 2.0), yaw), Status::kOk);
  const double middle = arrival(0) + 2.0;
  EXPECT_LE(std::fabs(tern::evaluate(yaw, middle).yaw.rate), 1.0);
  EXPECT_TRUE(std::isfinite(tern::evaluate(yaw, middle).angle));
}

TEST_F(Dwell, SlicesChangeNoBit) {
  stop({4.0, 3.0, 1.0}, 1.5);
  stop({5.0, 1.0, 1.0}, 0.5);
  ASSERT_EQ(plan(), Status::kOk);
  const tern::Trajectory whole = world_.trajectory;
  ASSERT_EQ(world_.planner.begin(world_.grid, world_.request), Status::kRunning);
  while (world_.planner.step(7) == Status::kRunning) {
  }
  ASSERT_EQ(world_.planner.finish(world_.trajectory, world_.report), Status::kOk);
  EXPECT_EQ(std::memcmp(&whole, &world_.trajectory, sizeof whole), 0);
}

TEST_F(Dwell, RefusesWhatIsNoDwell) {
  Via& via = stop({4.0, 3.0, 1.0}, -1.0);
  EXPECT_EQ(plan(), Status::kInvalidArgument);
  EXPECT_EQ(world_.report.field, tern::Field::kVias);
  EXPECT_EQ(world_.report.via, 0);
  via.dwell = 3600.1;
  EXPECT_EQ(plan(), Status::kInvalidArgument);
  via.dwell = 1.0;
  via.stop = false;
  EXPECT_EQ(plan(), Status::kInvalidArgument) << "it passes at speed";
  via.dwell = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(plan(), Status::kNonFiniteInput);
  via.dwell = std::numeric_limits<double>::infinity();
  EXPECT_EQ(plan(), Status::kNonFiniteInput);
}

}  // namespace
}  // namespace tern_test
