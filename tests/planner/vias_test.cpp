// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Plans through vias: where they pass, how fast, and what the report says of a via that they cannot pass.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "base/math.hpp"
#include "support/world.hpp"

namespace tern_test {
namespace {

using tern::Fence;
using tern::Field;
using tern::kNoVia;
using tern::Quality;
using tern::Sample;
using tern::Stage;
using tern::Status;
using tern::Vec3;
using tern::Via;

/// 8 x 4 x 2 m at 0.1 m, radius 0.25, away from the world's origin.
class ViasPlan : public testing::Test {
 protected:
  ViasPlan() : world_({80, 40, 20}, 0.1, 0.25, {10.0, -20.0, 5.0}) { world_.from({1.0, 1.0, 1.0}).to({7.0, 1.0, 1.0}); }
  Vec3 at(const Vec3& relative) const { return relative + world_.spec.origin; }
  Via& via(const Vec3& relative) {
    vias_.push_back({at(relative), 0.0, false, false, {}});
    return vias_.back();
  }
  Status plan() {
    world_.request.vias = vias_.data();
    world_.request.via_count = static_cast<std::int32_t>(vias_.size());
    return world_.plan();
  }
  const tern::Report& report() const { return world_.report; }
  Sample passage(std::size_t v) const { return tern::evaluate(world_.trajectory, report().vias[v].time); }
  static double speed(const Sample& sample) { return tern::length(sample.velocity); }

  /// The report's distances are those of the trajectory, within the tolerances and in order.
  void expect_passes() {
    double last = 0.0;
    for (std::size_t v = 0; v < vias_.size(); ++v) {
      const tern::ViaPassage& passed = report().vias[v];
      EXPECT_GE(passed.time, last) << v;
      EXPECT_LE(passed.distance, vias_[v].tolerance + 1e-9) << v;
      EXPECT_NEAR(tern::distance(passage(v).position, vias_[v].position), passed.distance, 1e-9) << v;
      last = passed.time;
    }
    EXPECT_LE(last, tern::duration(world_.trajectory));
    EXPECT_EQ(report().via, kNoVia);
    for (const tern::StageReport& stage : report().diagnostics.stages) EXPECT_LE(stage.work, stage.bound);
  }
  void expect_refused(Status status, int v) {
    EXPECT_EQ(plan(), status);
    EXPECT_EQ(report().field, Field::kVias);
    EXPECT_EQ(report().stage, Stage::kRequest);
    EXPECT_EQ(report().via, v);
    EXPECT_TRUE(world_.trajectory_untouched());
  }

  World world_;
  std::vector<Via> vias_;
};

TEST_F(ViasPlan, FliesThroughAPointOffTheStraightWay) {
  via({4.0, 3.0, 1.0});
  ASSERT_EQ(plan(), Status::kOk);
  expect_passes();
  EXPECT_EQ(report().quality, Quality::kOptimised);
  EXPECT_EQ(report().vias[0].distance, 0.0) << "through the point itself";
  EXPECT_GT(speed(passage(0)), 0.5);
}

TEST_F(ViasPlan, CarriesItsSpeedThroughAViaOnTheStraightWay) {
  ASSERT_EQ(plan(), Status::kOk);
  const double without = tern::duration(world_.trajectory);
  via({4.0, 1.0, 1.0});
  ASSERT_EQ(plan(), Status::kOk);
  expect_passes();
  EXPECT_LE(tern::duration(world_.trajectory), 1.1 * without);
  EXPECT_GT(speed(passage(0)), 1.0);
}

TEST_F(ViasPlan, StopsWhereItIsAskedTo) {
  via({4.0, 3.0, 1.0}).stop = true;
  via({5.0, 2.0, 1.2});
  ASSERT_EQ(plan(), Status::kOk);
  expect_passes();
  EXPECT_EQ(report().quality, Quality::kOptimised);
  EXPECT_LE(speed(passage(0)), 1e-9);
  EXPECT_LE(tern::length(passage(0).acceleration), 1e-7);
  EXPECT_GT(speed(passage(1)), 0.2);
}

TEST_F(ViasPlan, HasTheVelocityThatIsAskedFor) {
  Via& fast = via({4.0, 2.0, 1.0});
  fast.has_velocity = true;
  fast.velocity = {0.5, 1.25, -0.25};
  ASSERT_EQ(plan(), Status::kOk);
  expect_passes();
  EXPECT_EQ(report().quality, Quality::kOptimised);
  EXPECT_LE(tern::distance(passage(0).velocity, fast.velocity), 1e-9);
}

TEST_F(ViasPlan, AToleranceMakesTheWayShorter) {
  world_.request.time_weight = 1000.0;
  via({4.0, 3.0, 1.0});
  ASSERT_EQ(plan(), Status::kOk);
  const double through = tern::duration(world_.trajectory);
  vias_[0].tolerance = 0.5;
  ASSERT_EQ(plan(), Status::kOk);
  expect_passes();
  EXPECT_GT(report().vias[0].distance, 0.05);
  EXPECT_LT(tern::duration(world_.trajectory), through);
}

TEST_F(ViasPlan, KeepsTheOrder) {
  via({6.0, 3.0, 1.0});
  via({2.0, 3.0, 1.0});
  via({6.0, 1.5, 1.0});
  ASSERT_EQ(plan(), Status::kOk);
  expect_passes();
  EXPECT_LT(report().vias[0].time, report().vias[1].time);
  EXPECT_LT(report().vias[1].time, report().vias[2].time);
}

TEST_F(ViasPlan, StopAndGoPassesEveryVia) {
  via({4.0, 3.0, 1.0}).tolerance = 0.2;
  via({4.5, 1.0, 1.0});
  world_.request.budget.trajectory = 0;
  ASSERT_EQ(plan(), Status::kOk);
  EXPECT_EQ(report().quality, Quality::kStopAndGo);
  expect_passes();
  for (std::size_t v = 0; v < 2; ++v) EXPECT_LE(speed(passage(v)), 1e-9);
}

TEST_F(ViasPlan, TheSamePointTwiceAndTheEndsAreVias) {
  via({1.0, 1.0, 1.0});
  via({4.0, 2.0, 1.0});
  via({4.0, 2.0, 1.0});
  via({7.0, 1.0, 1.0});
  ASSERT_EQ(plan(), Status::kOk);
  expect_passes();
}

TEST_F(ViasPlan, HoversWhereEverythingIsOnePoint) {
  world_.to({1.0, 1.0, 1.0});
  via({1.0, 1.0, 1.0});
  ASSERT_EQ(plan(), Status::kOk);
  EXPECT_EQ(report().quality, Quality::kHover);
  expect_passes();
}

TEST_F(ViasPlan, BeginsAndEndsInMotion) {
  world_.request.start.velocity = {1.0, 0.5, 0.0};
  world_.request.goal.velocity = {0.5, -0.5, 0.0};
  via({3.0, 2.5, 1.0});
  via({5.0, 2.5, 1.0});
  ASSERT_EQ(plan(), Status::kOk);
  expect_passes();
  EXPECT_LE(tern::distance(passage(0).position, vias_[0].position), 1e-9);
}

TEST_F(ViasPlan, AStartThatMustStopFirstStillPassesItsVias) {
  world_.from({1.0, 0.4, 1.0});
  world_.request.start.velocity = {0.0, -1.0, 0.0};  // towards the boundary 0.4 m away
  world_.request.limits = {{2.0, 2.0, 2.0}, {2.0, 2.0, 2.0}};
  via({3.0, 2.5, 1.0});
  ASSERT_EQ(plan(), Status::kOk);
  expect_passes();
}

// No programme that begins towards the boundary has a solution, but one along the segments from stop to stop has.
// From a via to itself there is no such segment, so there the plan stays what it is.
TEST_F(ViasPlan, AStartThatMustStopFirstPassesTheSamePointTwiceFromStopToStop) {
  world_.from({1.0, 0.375, 1.0});  // exact in doubles: a via and the goal are one point in any frame
  world_.request.start.velocity = {0.0, -1.0, 0.0};
  for (const Quality quality : {Quality::kOptimised, Quality::kStopAndGo}) {
    via({3.0, 2.5, 1.0});
    ASSERT_EQ(plan(), Status::kOk);
    EXPECT_EQ(report().quality, quality) << vias_.size();
    expect_passes();
  }
  vias_.pop_back();
  via({7.0, 1.0, 1.0});  // nor from a via to the goal, in the same place
  ASSERT_EQ(plan(), Status::kOk);
  EXPECT_EQ(report().quality, Quality::kStopAndGo);
  expect_passes();
}

TEST_F(ViasPlan, SlicesChangeNoBit) {
  via({4.0, 3.0, 1.0}).tolerance = 0.1;
  via({6.0, 2.0, 1.0}).stop = true;
  ASSERT_EQ(plan(), Status::kOk);
  const tern::Trajectory whole = world_.trajectory;
  ASSERT_EQ(world_.planner.begin(world_.grid, world_.request), Status::kRunning);
  while (world_.planner.step(1) == Status::kRunning) {
  }
  ASSERT_EQ(world_.planner.finish(world_.trajectory, world_.report), Status::kOk);
  ASSERT_EQ(world_.trajectory.count, whole.count);
  for (int i = 0; i < whole.count; ++i) {
    EXPECT_EQ(world_.trajectory.segments[i].duration, whole.segments[i].duration);
    EXPECT_EQ(
        std::memcmp(world_.trajectory.segments[i].points, whole.segments[i].points, sizeof whole.segments[i].points),
        0);
  }
}

TEST_F(ViasPlan, ThePathLeadsThroughTheVias) {
  via({4.0, 3.0, 1.0});
  ASSERT_EQ(plan(), Status::kOk);
  const tern::Path* path = world_.planner.path();
  ASSERT_NE(path, nullptr);
  int met = 0;
  for (int i = 0; i < path->count; ++i) met += tern::distance(path->points[i], {4.0, 3.0, 1.0}) < 1e-12 ? 1 : 0;
  EXPECT_EQ(met, 1);
  EXPECT_NEAR(path->length, 2.0 * std::sqrt(13.0), 1e-9);
}

TEST_F(ViasPlan, AViaBehindAWallHasNoPath) {
  world_.block({4.0, 0.0, 0.0}, {4.2, 4.0, 2.0});
  world_.to({3.0, 3.0, 1.0});
  via({2.0, 2.0, 1.0});
  via({6.0, 2.0, 1.0});
  EXPECT_EQ(plan(), Status::kNoPath);
  EXPECT_EQ(report().stage, Stage::kSearch);
  EXPECT_EQ(report().via, 1);
  EXPECT_TRUE(report().has_reachable);
  EXPECT_NEAR(report().reachable.x, at({3.65, 0, 0}).x, 1e-9);
  EXPECT_TRUE(world_.trajectory_untouched());
}

TEST_F(ViasPlan, AGoalBehindAWallIsNoVia) {
  world_.block({4.0, 0.0, 0.0}, {4.2, 4.0, 2.0});
  via({2.0, 2.0, 1.0});
  EXPECT_EQ(plan(), Status::kNoPath);
  EXPECT_EQ(report().via, kNoVia);
}

TEST_F(ViasPlan, AViaInAnObstacleIsOccupied) {
  world_.block({4.0, 2.0, 0.0}, {4.5, 2.5, 2.0});
  via({2.0, 2.0, 1.0});
  via({4.25, 2.25, 1.0});
  EXPECT_EQ(plan(), Status::kViaOccupied);
  EXPECT_EQ(report().via, 1);
  EXPECT_TRUE(report().raw_occupied);
  EXPECT_TRUE(report().has_nearest_free);
}

TEST_F(ViasPlan, AStartInAnObstacleIsNoFaultOfAVia) {
  world_.block({0.5, 0.5, 0.5}, {1.5, 1.5, 1.5});
  via({2.0, 2.0, 1.0});
  EXPECT_EQ(plan(), Status::kStartOccupied);
  EXPECT_EQ(report().via, kNoVia);
  EXPECT_TRUE(report().raw_occupied);
}

TEST_F(ViasPlan, AFencedViaNamesBoth) {
  tern::Halfspace faces[2][tern::kBoxPlanes];
  tern::box_planes({at({0.0, 3.9, 0.0}), at({0.5, 4.0, 2.0})}, faces[0]);
  tern::box_planes({at({3.0, 2.0, 0.0}), at({4.0, 3.0, 2.0})}, faces[1]);
  const Fence fences[] = {{faces[0], tern::kBoxPlanes, tern::FenceKind::kKeepOut},
                          {faces[1], tern::kBoxPlanes, tern::FenceKind::kKeepOut}};
  world_.request.fences = fences;
  world_.request.fence_count = 2;
  via({3.5, 2.5, 1.0});
  EXPECT_EQ(plan(), Status::kViaFenced);
  EXPECT_EQ(report().via, 0);
  EXPECT_EQ(report().fence, 1);
  vias_[0].position = at({3.5, 1.5, 1.0});
  ASSERT_EQ(plan(), Status::kOk);
  expect_passes();
}

TEST_F(ViasPlan, RefusesWhatIsNoVia) {
  via({2.0, 2.0, 1.0});
  via({4.0, 2.0, 1.0});
  const Via good = vias_[1];
  vias_[1].position.x = std::numeric_limits<double>::quiet_NaN();
  expect_refused(Status::kNonFiniteInput, 1);
  vias_[1] = good;
  vias_[1].tolerance = -0.1;
  expect_refused(Status::kInvalidArgument, 1);
  vias_[1] = good;
  vias_[1].stop = vias_[1].has_velocity = true;
  expect_refused(Status::kInvalidArgument, 1);
  vias_[1] = good;
  vias_[1].position = at({9.0, 1.0, 1.0});
  expect_refused(Status::kOutOfMap, 1);
  vias_[1] = good;
  vias_[1].has_velocity = true;
  vias_[1].velocity = {2.1, 0.0, 0.0};
  expect_refused(Status::kViaExceedsLimits, 1);
}

TEST_F(ViasPlan, RefusesTooManyAndNone) {
  for (int v = 0; v <= tern::kMaxVias; ++v) via({4.0, 2.0, 1.0});
  expect_refused(Status::kViasFull, kNoVia);
  vias_.clear();
  world_.request.via_count = 1;
  world_.request.vias = nullptr;
  EXPECT_EQ(world_.plan(), Status::kInvalidArgument);
  EXPECT_EQ(report().field, Field::kVias);
  world_.request.via_count = -1;
  EXPECT_EQ(world_.plan(), Status::kInvalidArgument);
  EXPECT_EQ(report().field, Field::kVias);
}

TEST_F(ViasPlan, TakesAsManyAsFit) {
  for (int v = 0; v < tern::kMaxVias; ++v) via({1.2 + 0.35 * v, v % 2 == 0 ? 1.5 : 2.5, 1.0});
  ASSERT_EQ(plan(), Status::kOk);
  expect_passes();
}

TEST_F(ViasPlan, TakesNoPreviousPlanAndNoNearestGoal) {
  ASSERT_EQ(plan(), Status::kOk);
  const tern::Trajectory flown = world_.trajectory;
  via({4.0, 2.0, 1.0});
  world_.request.previous = &flown;
  EXPECT_EQ(plan(), Status::kInvalidArgument);
  EXPECT_EQ(report().field, Field::kPrevious);
  world_.request.previous = nullptr;
  world_.request.goal_mode = tern::GoalMode::kNearest;
  EXPECT_EQ(plan(), Status::kInvalidArgument);
  EXPECT_EQ(report().field, Field::kGoalMode);
}

}  // namespace
}  // namespace tern_test
