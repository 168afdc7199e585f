// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <vector>

#include "base/math.hpp"
#include "path/search_stage.hpp"
#include "path/shortcut_stage.hpp"
#include "planner/attempts.hpp"
#include "planner/end_stop.hpp"
#include "support/world.hpp"

namespace tern_test {
namespace {

using tern::EndStop;
using tern::Status;
using tern::Vec3;

double distance_from(const tern::Box& box, const Vec3& p) {
  const Vec3 nearest{tern::clamp(p.x, box.lower.x, box.upper.x), tern::clamp(p.y, box.lower.y, box.upper.y),
                     tern::clamp(p.z, box.lower.z, box.upper.z)};
  return tern::distance(p, nearest);
}

/// A wall at y >= 2.6 along the whole map, radius 0.25: y <= 2.35 is free.
class StopFirstPlan : public testing::Test {
 protected:
  StopFirstPlan() : world_({80, 40, 20}, 0.1, 0.25) {
    world_.block(wall_.lower, wall_.upper);
    // Stop-and-go only: it needs the straight braking that there is no room for.
    world_.request.budget.trajectory = 0;
  }
  void expect_stopped_first() {
    ASSERT_EQ(world_.plan(), Status::kOk);
    EXPECT_EQ(world_.report.diagnostics.detours, tern::detours_of(tern::Attempt::kStopFirst));
    EXPECT_GT(world_.report.diagnostics.stages[static_cast<int>(tern::Stage::kStopFirst)].work, 0u);
    for (const tern::StageReport& stage : world_.report.diagnostics.stages) EXPECT_LE(stage.work, stage.bound);
    const double end = tern::duration(world_.trajectory);
    const int steps = 4000;
    for (int k = 0; k <= steps; ++k) {
      const tern::Sample sample = tern::evaluate(world_.trajectory, end * k / steps);
      ASSERT_GE(distance_from(wall_, sample.position), 0.25 - 2e-9) << k;
      for (int a = 0; a < 3; ++a) {
        ASSERT_LE(std::fabs(tern::axis(sample.velocity, a)), 2.0 * (1.0 + 1e-7));
        ASSERT_LE(std::fabs(tern::axis(sample.acceleration, a)), 2.0 * (1.0 + 1e-7));
      }
    }
    expect_end(tern::evaluate(world_.trajectory, 0.0), world_.request.start);
    expect_end(tern::evaluate(world_.trajectory, std::nextafter(end, 0.0)), world_.request.goal);
  }
  static void expect_end(const tern::Sample& sample, const tern::State& state) {
    for (int a = 0; a < 3; ++a) {
      EXPECT_NEAR(tern::axis(sample.position, a), tern::axis(state.position, a), 1e-9);
      EXPECT_NEAR(tern::axis(sample.velocity, a), tern::axis(state.velocity, a), 1e-9);
      EXPECT_NEAR(tern::axis(sample.acceleration, a), tern::axis(state.acceleration, a), 1e-7);
    }
  }

  tern::Box wall_{{0.0, 2.6, 0.0}, {8.0, 4.0, 2.0}};
  World world_;
};

TEST_F(StopFirstPlan, StartThatCannotBrakeStraightAhead) {
  // Straight ahead takes 1.05 s, in which it comes 0.525 m nearer; each axis on its own 0.275 m; there are 0.35 m.
  world_.from({2.0, 2.0, 1.0}).to({6.0, 1.0, 1.0});
  world_.request.start.velocity = {2.0, 1.0, 0.0};
  expect_stopped_first();
}

/// Each unit counts for the stage that was said before it.
TEST_F(StopFirstPlan, ThePlannerSaysItsStage) {
  world_.from({2.0, 2.0, 1.0}).to({6.0, 1.0, 1.0});
  world_.request.start.velocity = {2.0, 1.0, 0.0};
  EXPECT_EQ(tern::Planner(nullptr, 0).stage(), tern::Stage::kRequest);
  world_.grid.inflate();
  ASSERT_EQ(world_.planner.begin(world_.grid, world_.request), Status::kRunning);
  std::uint32_t units[tern::kStageCount] = {};
  Status status = Status::kRunning;
  while (status == Status::kRunning) {
    ++units[static_cast<int>(world_.planner.stage())];
    status = world_.planner.step(1);
  }
  EXPECT_EQ(status, Status::kOk);
  world_.planner.finish(world_.trajectory, world_.report);
  const int stop = static_cast<int>(tern::Stage::kStopFirst);
  EXPECT_GT(units[stop], 0u);
  EXPECT_GT(world_.report.diagnostics.stages[stop].work, 0u);
  EXPECT_EQ(world_.planner.stage(), tern::Stage::kCheck);
}

TEST_F(StopFirstPlan, GoalThatCannotBeLedUpToStraight) {
  world_.from({1.0, 1.0, 1.0}).to({6.0, 2.0, 1.0});
  world_.request.goal.velocity = {2.0, -1.0, 0.0};
  expect_stopped_first();
}

TEST_F(StopFirstPlan, BothAtOnce) {
  world_.from({2.0, 2.0, 1.0}).to({6.0, 2.0, 1.0});
  world_.request.start.velocity = {2.0, 1.0, 0.0};
  world_.request.goal.velocity = {2.0, -1.0, 0.0};
  expect_stopped_first();
}

TEST_F(StopFirstPlan, NoneWhereTheMotionCannotStopAtAll) {
  world_.from({2.0, 2.2, 1.0}).to({6.0, 1.0, 1.0});  // 0.15 m; 0.25 m at full deceleration
  world_.request.start.velocity = {2.0, 1.0, 0.0};
  EXPECT_EQ(world_.plan(), Status::kNoTrajectory);
  EXPECT_TRUE(world_.trajectory_untouched());
}

TEST_F(StopFirstPlan, ArrivesAtAGoalInMotionThatThereIsNoRoomToStopBefore) {
  // 2 m/s towards the wall, which is 0.25 m away: the goal is 0.06 s ahead, and all that is asked for.
  world_.request.limits = {{2, 2, 2}, {2, 2, 2}};
  world_.from({2.0, 2.1, 1.0}).to({2.0, 2.22, 1.0});
  world_.request.start.velocity = world_.request.goal.velocity = {0.0, 2.0, 0.0};
  expect_stopped_first();
  EXPECT_EQ(world_.report.quality, tern::Quality::kStopAndGo);
  EXPECT_EQ(world_.report.optimiser, Status::kOk) << "it was not asked for this curve";
  EXPECT_NEAR(tern::duration(world_.trajectory), 0.06, 1e-12);
}

TEST_F(StopFirstPlan, ArrivesInSlicesOfOneToo) {
  world_.from({2.0, 2.1, 1.0}).to({2.0, 2.22, 1.0});
  world_.request.start.velocity = world_.request.goal.velocity = {0.0, 2.0, 0.0};
  ASSERT_EQ(world_.plan(), Status::kOk);
  const tern::Trajectory whole = world_.trajectory;
  ASSERT_EQ(world_.planner.begin(world_.grid, world_.request), Status::kRunning);
  while (world_.planner.step(1) == Status::kRunning) {
  }
  ASSERT_EQ(world_.planner.finish(world_.trajectory, world_.report), Status::kOk);
  EXPECT_EQ(std::memcmp(&whole, &world_.trajectory, sizeof whole), 0);
}

/// A plan may search four times for each of its legs.
TEST_F(StopFirstPlan, BoundsGrowWithTheLegs) {
  world_.from({1.0, 1.0, 1.0}).to({6.0, 1.0, 1.0});
  world_.request.start.velocity = {0.5, 0.0, 0.0};
  const auto bound_of = [&](tern::Stage stage) {
    return world_.report.diagnostics.stages[static_cast<int>(stage)].bound;
  };
  ASSERT_EQ(world_.plan(), Status::kOk);
  const std::uint64_t search = bound_of(tern::Stage::kSearch);
  const std::uint64_t shortcut = bound_of(tern::Stage::kShortcut);
  std::vector<tern::Via> vias(tern::kMaxVias);
  for (tern::Via& via : vias) via.position = {3.0, 1.0, 1.0};
  world_.request.vias = vias.data();
  world_.request.via_count = tern::kMaxVias;
  ASSERT_EQ(world_.plan(), Status::kOk);
  const double legs = tern::kMaxVias + 1.0;
  EXPECT_NEAR(static_cast<double>(bound_of(tern::Stage::kSearch)) / static_cast<double>(search), legs, 1e-3);
  EXPECT_NEAR(static_cast<double>(bound_of(tern::Stage::kShortcut)) / static_cast<double>(shortcut), legs, 1e-3);
}

/// Empty space, 4 m wide, the plan's origin in its middle.
class EndStopTry : public testing::Test {
 protected:
  EndStopTry() : world_({40, 40, 40}, 0.1, 0.2) {
    world_.grid.inflate();
    curve_->origin = {2.0, 2.0, 2.0};
    stop_->next_choice = 0;
    stop_->count = -1;
  }
  tern::RoomProof room() { return {world_.grid, nullptr, *stage_, *curve_, tern::World(world_.grid)}; }
  bool arrive(const tern::State& start, const tern::State& goal, int choice = 0) {
    tern::Work all{0xFFFFFFFFu};
    stop_->is_tried = false;
    return tern::arrive_advance(room(), start, goal, world_.request.limits, choice, *stop_, all) ==
           tern::Progress::kDone;
  }
  World world_;
  std::unique_ptr<tern::CheckStage> stage_ = std::make_unique<tern::CheckStage>();
  std::unique_ptr<tern::Trajectory> curve_ = std::make_unique<tern::Trajectory>();
  std::unique_ptr<EndStop> stop_ = std::make_unique<EndStop>();
};

TEST_F(EndStopTry, ArrivesWhereTheMotionIsTheGoals) {
  // 0.06 s on at 1 m/s and 1 m/s^2.
  const tern::State start{{0, 0, 0}, {1, 0, 0}, {1, 0, 0}};
  const tern::State goal{{0.0618, 0, 0}, {1.06, 0, 0}, {1, 0, 0}};
  ASSERT_TRUE(arrive(start, goal));
  ASSERT_EQ(stop_->count, 1);
  const tern::Segment& segment = stop_->segments[0];
  EXPECT_NEAR(segment.duration, 0.06, 1e-12);
  EXPECT_EQ(segment.polyhedron, tern::kNoPolyhedron);
  EXPECT_EQ(segment.points[0].x, 0.0);
  EXPECT_EQ(segment.points[tern::kDegree].x, 0.0618);
  // Control points of t + t^2 / 2: p_k = k/7 T + k (k - 1) / 42 T^2 / 2.
  for (int k = 0; k <= tern::kDegree; ++k) {
    EXPECT_NEAR(segment.points[k].x, k / 7.0 * 0.06 + k * (k - 1) / 42.0 * 0.0018, 1e-14) << k;
  }
}

TEST_F(EndStopTry, ArrivalKeepsLimitsAndClearance) {
  const tern::State start{{0, 0, 0}, {1, 0, 0}, {0, 0, 0}};
  EXPECT_FALSE(arrive(start, {{0.06, 0.02, 0}, {1, 0, 0}, {0, 0, 0}})) << "to the side in no time";
  EXPECT_EQ(stop_->count, 0);
  EXPECT_FALSE(arrive(start, {{0, 0, 0}, {1, 0, 0}, {0, 0, 0}})) << "no way to go";
  EXPECT_FALSE(arrive(start, {{0.06, 0, 0}, {-1, 0, 0}, {0, 0, 0}})) << "no speed on the mean";
  const tern::State goal{{0.5, 0, 0}, {1, 0, 0}, {0, 0, 0}};
  ASSERT_TRUE(arrive(start, goal));
  world_.block({2.2, 2.1, 1.9}, {2.3, 2.2, 2.0});
  world_.grid.inflate();
  EXPECT_FALSE(arrive(start, goal)) << "0.1 m beside an obstacle";
  EXPECT_EQ(stop_->count, 0);
}

TEST_F(EndStopTry, GoalsAreFlownBackwards) {
  const tern::State goal{{0.5, 0, 0}, {1, 0.5, 0}, {0, 0, 0}};
  tern::Work all{0xFFFFFFFFu};
  stop_->is_tried = false;
  ASSERT_EQ(tern::stop_advance(room(), goal, true, world_.request.limits, *stop_, all), tern::Progress::kDone);
  EXPECT_EQ(stop_->next_choice, 1);
  ASSERT_GT(stop_->count, 0);
  const tern::Segment& last = stop_->segments[stop_->count - 1];
  EXPECT_EQ(last.points[tern::kDegree].x, 0.5);
  EXPECT_NEAR(7.0 * (last.points[7].y - last.points[6].y) / last.duration, 0.5, 1e-12);
  EXPECT_EQ(stop_->segments[0].points[0].x, stop_->place.x);
  EXPECT_LT(stop_->place.x, 0.5) << "it begins behind the goal";
  EXPECT_EQ(stop_->segments[0].points[3].x, stop_->place.x) << "at rest";
}

/// Down onto an obstacle's top, without a radius. Other plans sink in by two billionths of a voxel at most, here 2 um.
TEST(EndStopDepth, AStopUsesHalfOfWhatIsGranted) {
  World world({8, 8, 8}, 1000.0, 0.0);
  world.block({3000.0, 3000.0, 3000.0}, {4000.0, 4000.0, 4000.0});
  world.grid.inflate();
  const auto stage = std::make_unique<tern::CheckStage>();
  const auto curve = std::make_unique<tern::Trajectory>();
  const auto stop = std::make_unique<EndStop>();
  curve->origin = {3500.0, 3500.0, 4000.0};
  const tern::RoomProof room{world.grid, nullptr, *stage, *curve, tern::World(world.grid)};
  double deepest = 0.0;
  int refused = 0;
  for (int k = 1; k <= 60; ++k) {
    tern::Work all{0xFFFFFFFFu};
    reset(*stop);
    const tern::State state{{0, 0, 0}, {0, 0, -1e-6 * k}, {0, 0, 0}};
    const bool stops = stop_advance(room, state, false, world.request.limits, *stop, all) == tern::Progress::kDone;
    if (stops) deepest = std::max(deepest, -stop->place.z);
    refused += stops ? 0 : 1;
  }
  EXPECT_GT(deepest, 1.5e-6);
  EXPECT_LE(deepest, 2.0e-6 + 1e-9);
  EXPECT_GT(refused, 10);
}

class AddStops : public testing::Test {
 protected:
  AddStops() {
    std::memset(static_cast<void*>(trajectory_.get()), 0, sizeof *trajectory_);
    fill(*start_, 2, 100.0);
    fill(*goal_, 1, 200.0);
  }
  /// Durations tell the segments apart.
  static void fill(EndStop& stop, int count, double mark) {
    stop.count = count;
    for (int i = 0; i < count; ++i) stop.segments[i].duration = mark + i;
  }
  void plan(int segments) {
    trajectory_->count = segments;
    for (int i = 0; i < segments; ++i) trajectory_->segments[i].duration = i;
  }
  bool add() { return tern::add_stops(*start_, *goal_, *trajectory_); }

  std::unique_ptr<tern::Trajectory> trajectory_ = std::make_unique<tern::Trajectory>();
  std::unique_ptr<EndStop> start_ = std::make_unique<EndStop>();
  std::unique_ptr<EndStop> goal_ = std::make_unique<EndStop>();
};

TEST_F(AddStops, OneBeforeAndOneBehind) {
  plan(3);
  ASSERT_TRUE(add());
  ASSERT_EQ(trajectory_->count, 6);
  const double durations[] = {100, 101, 0, 1, 2, 200};
  for (int i = 0; i < 6; ++i) EXPECT_EQ(trajectory_->segments[i].duration, durations[i]) << i;
}

TEST_F(AddStops, FillsTheCapacityAndNoMore) {
  plan(tern::kMaxSegments - 3);
  EXPECT_TRUE(add());
  EXPECT_EQ(trajectory_->count, tern::kMaxSegments);
  plan(tern::kMaxSegments - 2);
  const auto before = std::make_unique<tern::Trajectory>(*trajectory_);
  EXPECT_FALSE(add());
  EXPECT_EQ(std::memcmp(before.get(), trajectory_.get(), sizeof *before), 0);
}

}  // namespace
}  // namespace tern_test
