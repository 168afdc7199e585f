// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Scenes among things that move: each has an answer that is known, to within what a planner may lose.
#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "support/world.hpp"

namespace tern_test {
namespace {

using tern::Status;
using tern::Track;
using tern::TrackEnd;
using tern::TrackShape;
using tern::Vec3;

constexpr std::int64_t kSecond = 1000000000;

/// 20 x 10 x 3 m, 16 m along the middle at 2.5 m/s: 7.8 s without things.
class Scenes : public testing::Test {
 protected:
  Scenes() : world_({100, 50, 15}, 0.2, 0.3) {
    world_.from({2.0, 5.0, 1.5}).to({18.0, 5.0, 1.5});
    world_.request.limits = {{2.5, 2.5, 1.5}, {4.0, 4.0, 3.0}};
    world_.request.rest_clear = 1.0;
  }

  static Track ball(const Vec3& place, const Vec3& velocity) {
    Track track;
    track.position = place;
    track.velocity = velocity;
    track.radius = 0.3;
    track.error = 0.05;
    track.error_speed = 0.02;
    return track;
  }

  static Track box(const Vec3& place, const Vec3& velocity, const Vec3& half) {
    Track track = ball(place, velocity);
    track.shape = TrackShape::kBox;
    track.half = half;
    return track;
  }

  /// A box without errors that is there until then, s.
  static Track standing(const Vec3& place, const Vec3& half, double until) {
    Track track;
    track.shape = TrackShape::kBox;
    track.position = place;
    track.half = half;
    track.end = TrackEnd::kGone;
    track.until = static_cast<std::int64_t>(until * 1e9);
    return track;
  }

  /// What the proof of the plan against the request's things finds, from a time of it on.
  tern::Finding finding_from(double time) const {
    tern::TrackGrounds grounds;
    grounds.tracks = world_.request.tracks;
    grounds.count = world_.request.track_count;
    grounds.radius = world_.spec.radius;
    grounds.rest = 1.0;
    grounds.leaves = true;
    tern::ProofReport found;
    tern::clear_until(world_.trajectory, time, grounds, &found);
    return found.finding;
  }

  /// How long the plan takes; it is proven by code that knows nothing of the planner. 0: there is none.
  double plan(const std::vector<Track>& tracks) {
    world_.request.tracks = tracks.data();
    world_.request.track_count = static_cast<std::int32_t>(tracks.size());
    if (world_.plan() != Status::kOk) return 0.0;
    EXPECT_EQ(finding_from(0.0), tern::Finding::kNone);
    for (const tern::StageReport& stage : world_.report.diagnostics.stages) EXPECT_LE(stage.work, stage.bound);
    return tern::duration(world_.trajectory);
  }

  /// A tunnel 1.6 m wide and 1.4 m high from x = 4 to 16.
  void dig_tunnel() {
    world_.block({4.0, 0.0, 0.0}, {16.0, 4.2, 3.0});
    world_.block({4.0, 5.8, 0.0}, {16.0, 10.0, 3.0});
    world_.block({4.0, 4.0, 2.2}, {16.0, 6.0, 3.0});
    world_.block({4.0, 4.0, 0.0}, {16.0, 6.0, 0.8});
  }

  World world_;
};

TEST_F(Scenes, WhatComesHeadOnIsPassed) {
  const double alone = plan({});
  ASSERT_GT(alone, 7.0);
  EXPECT_EQ(world_.report.diagnostics.seed, 0);
  EXPECT_EQ(world_.report.diagnostics.high_water.separations, 0);
  const double passed = plan({ball({18.0, 5.0, 1.5}, {-1.0, 0.0, 0.0})});
  EXPECT_GT(passed, 0.0);
  EXPECT_EQ(world_.report.diagnostics.seed, 1);
  EXPECT_GT(world_.report.diagnostics.high_water.separations, 0);
  EXPECT_EQ(world_.report.diagnostics.high_water.flood_words, 0);
  EXPECT_LT(passed, 1.02 * alone);
  Track stops = ball({18.0, 5.0, 1.5}, {-1.0, 0.0, 0.0});
  stops.end = TrackEnd::kStays;
  stops.until = 9 * kSecond;
  const double beside = plan({stops});
  EXPECT_GT(beside, 0.0);
  EXPECT_LT(beside, 1.02 * alone);
}

/// An optimiser that takes long, with a budget that ends it early: there is enough left to lead a plan around a thing.
TEST_F(Scenes, ABudgetLastsForTheWayAround) {
  world_.request.limits.j_max = {8.0, 8.0, 8.0};
  world_.request.time_weight = 1000.0;
  world_.request.budget.trajectory = 1200;
  EXPECT_GT(plan({}), 7.0);
  EXPECT_EQ(world_.report.optimiser, Status::kBudgetOptimise);
  EXPECT_GT(plan({ball({18.0, 5.0, 1.5}, {-1.0, 0.0, 0.0})}), 7.0);
  EXPECT_GE(world_.report.diagnostics.seed, 1);
}

TEST_F(Scenes, WhatOvertakesIsLetPast) {
  const double let_past = plan({ball({-2.0, 5.0, 1.5}, {2.2, 0.0, 0.0})});
  EXPECT_GT(let_past, 7.0);
  EXPECT_LT(let_past, 10.6);
}

TEST_F(Scenes, AGapThatMovesIsMet) {
  const double met = plan({box({10.0, -5.0, 1.5}, {0.0, 1.0, 0.0}, {0.3, 4.5, 3.0}),
                           box({10.0, 6.6, 1.5}, {0.0, 1.0, 0.0}, {0.3, 5.0, 3.0})});
  EXPECT_GT(met, 7.0);
  EXPECT_LT(met, 8.5);
}

TEST_F(Scenes, AGoalThatIsCoveredIsReachedAfterwards) {
  Track parked = ball({18.0, 5.0, 1.5}, {0.0, 0.0, 0.0});
  parked.end = TrackEnd::kGone;
  parked.until = 15 * kSecond;
  const double arrives = plan({parked});
  EXPECT_GE(arrives, 15.0);
  EXPECT_LT(arrives, 17.0);
  EXPECT_GE(world_.report.diagnostics.seed, 2);
  EXPECT_GT(world_.report.diagnostics.high_water.flood_words, 0);
  EXPECT_LE(world_.report.diagnostics.high_water.flood_words, tern::kMaxFloodWords);
}

TEST_F(Scenes, AWayThatClosesForAWhileIsWaitedFor) {
  Track closed = box({10.0, 5.0, 1.5}, {0.0, 0.0, 0.0}, {1.0, 6.0, 3.0});
  closed.end = TrackEnd::kGone;
  closed.measured = 2 * kSecond;
  closed.until = 9 * kSecond;
  const double short_wait = plan({closed});
  EXPECT_GT(short_wait, 12.0);
  EXPECT_LT(short_wait, 14.5);
  closed.measured = 0;
  closed.until = 30 * kSecond;
  const double long_wait = plan({closed});
  EXPECT_GT(long_wait, 33.0);
  EXPECT_LT(long_wait, 37.0);
}

/// The flood's cells are too coarse for a lane of 1 m beside what is closed; the search is not. Whatever closes it, for
/// whatever time, the plan is about the one around what always stands there.
TEST_F(Scenes, ANarrowWayAroundWhatStandsIsTaken) {
  const double alone = plan({});
  world_.block({9.0, 8.0, 0.0}, {11.0, 10.0, 3.0});
  for (const double seconds : {15.0, 60.0, 300.0}) {
    const Track closed = standing({10.0, 3.0, 1.5}, {1.0, 4.0, 3.0}, seconds);
    const double around = plan({closed});
    EXPECT_GT(around, alone) << seconds;
    EXPECT_LT(around, 8.5) << seconds;
    EXPECT_EQ(world_.report.waits, 0.0);
    tern::Halfspace planes[tern::kBoxPlanes];
    tern::box_planes({{9.0, -1.0, -1.5}, {11.0, 7.0, 4.5}}, planes);
    const tern::Fence zone{planes, tern::kBoxPlanes, tern::FenceKind::kKeepOut, 0, closed.until};
    world_.request.fences = &zone;
    world_.request.fence_count = 1;
    EXPECT_NEAR(plan({}), around, 0.05) << seconds;
    world_.request.fence_count = 0;
  }
}

/// Each is closed once a plan has met it.
TEST_F(Scenes, ANarrowWayBetweenTwoThatStandIsTaken) {
  const double between = plan({standing({10.0, 3.0, 1.5}, {1.0, 4.0, 3.0}, 60.0),  //
                               standing({10.0, 9.0, 1.5}, {1.0, 1.0, 3.0}, 60.0)});
  EXPECT_GT(between, 7.0);
  EXPECT_LT(between, 8.5);
}

/// No way leads around what is closed, and the start is in motion: the plan stops first, and waits as it did before the
/// search was tried.
TEST_F(Scenes, WhatWasClosedIsOpenAgainForOtherAttempts) {
  world_.request.start.velocity = {1.0, 0.0, 0.0};
  const double waits = plan({standing({10.0, 5.0, 1.5}, {1.0, 6.0, 3.0}, 30.0)});
  EXPECT_GT(waits, 33.0);
  EXPECT_LT(waits, 40.0);
}

TEST_F(Scenes, ATunnelIsLeftToWhatComesThroughIt) {
  dig_tunnel();
  const double after = plan({ball({15.0, 5.0, 1.5}, {-1.0, 0.0, 0.0})});
  EXPECT_GT(after, 15.0);
  EXPECT_LT(after, 22.0);
  world_.from({8.0, 5.0, 1.5});
  const double back_out = plan({ball({15.0, 5.0, 1.5}, {-1.0, 0.0, 0.0})});
  EXPECT_GT(back_out, 15.0);
  EXPECT_LT(back_out, 25.0);
  world_.from({2.0, 5.0, 1.5});
  const double behind = plan({ball({15.0, 5.0, 1.5}, {1.0, 0.0, 0.0})});
  EXPECT_GT(behind, 7.0);
  EXPECT_LT(behind, 8.5);
  EXPECT_EQ(plan({ball({10.0, 5.0, 1.5}, {0.0, 0.0, 0.0})}), 0.0);
  EXPECT_EQ(world_.report.status, Status::kNoClearTime);
}

TEST_F(Scenes, TheNearestPointIsReachedAmongThings) {
  world_.block({17.0, 4.0, 0.4}, {19.0, 6.0, 2.6});
  world_.request.goal_mode = tern::GoalMode::kNearest;
  EXPECT_GT(plan({ball({10.0, 1.0, 1.5}, {0.0, 1.0, 0.0})}), 6.0);
  EXPECT_EQ(world_.report.goal_missed, Status::kGoalOccupied);
}

TEST_F(Scenes, ViasArePassedAmongThings) {
  std::vector<tern::Via> vias(1);
  vias[0].position = {10.0, 7.0, 1.5};
  vias[0].tolerance = 0.3;
  vias[0].dwell = 2.0;
  vias[0].stop = true;
  world_.request.vias = vias.data();
  world_.request.via_count = 1;
  const double alone = plan({});
  ASSERT_GT(alone, 8.0);
  // The second one crosses after the dwell.
  const double among = plan({ball({10.0, 2.0, 1.5}, {0.0, 1.2, 0.0}), ball({14.0, 10.6, 1.5}, {0.0, -0.6, 0.0})});
  EXPECT_GT(among, 0.0);
  EXPECT_LT(among, 1.3 * alone);
}

/// A plan around things, replanned on its way: it arrives no later, whether the rest of it is kept or not.
TEST_F(Scenes, ReplansArriveNoLater) {
  std::vector<Track> tracks{ball({10.0, 1.0, 1.5}, {0.0, 1.0, 0.0}), ball({18.0, 5.0, 1.5}, {-1.0, 0.0, 0.0}),
                            ball({14.0, 9.0, 1.5}, {0.0, -0.6, 0.0})};
  Track parked = ball({18.0, 5.0, 1.5}, {0.0, 0.0, 0.0});
  parked.end = TrackEnd::kGone;
  int kept = 0;
  for (const int covered : {0, 12}) {
    parked.until = covered * kSecond;
    if (covered > 0) tracks = {parked};
    world_.from({2.0, 5.0, 1.5});
    world_.request.begin = 0;
    const double whole = plan(tracks);
    ASSERT_GT(whole, 0.0);
    const auto previous = std::make_unique<tern::Trajectory>(world_.trajectory);
    for (int step = 1; step < 6; ++step) {
      const double time = 1.0 * step;
      const tern::Sample now = tern::evaluate(*previous, time);
      world_.request.start = {now.position, now.velocity, now.acceleration, now.jerk};
      world_.request.previous = previous.get();
      world_.request.previous_time = time;
      world_.request.begin = step * kSecond;
      world_.request.tracks = tracks.data();
      world_.request.track_count = static_cast<std::int32_t>(tracks.size());
      ASSERT_EQ(world_.plan(), Status::kOk) << covered << " " << step;
      const double left = tern::duration(world_.trajectory) - world_.report.entered;
      EXPECT_LE(left, whole - time + 1e-6) << covered << " " << step;
      kept += world_.report.quality == tern::Quality::kPrevious ? 1 : 0;
      EXPECT_EQ(finding_from(world_.report.entered), tern::Finding::kNone) << covered << " " << step;
    }
    world_.request.previous = nullptr;
    world_.request.start = {};
  }
  EXPECT_GT(kept, 0);
}

/// A tunnel that a ball comes out of: only the flood knows to wait in front of it. With less work than that takes,
/// there is no plan, or a worse one; the work never exceeds the budget by more than a piece.
TEST_F(Scenes, TheBudgetOfTracksEndsTheSearch) {
  dig_tunnel();
  const std::vector<Track> tracks{ball({16.0, 5.0, 1.5}, {-1.0, 0.0, 0.0})};
  const double best = plan(tracks);
  ASSERT_GT(best, 0.0);
  constexpr int kTracks = static_cast<int>(tern::Stage::kTracks);
  const auto need = static_cast<std::uint32_t>(world_.report.diagnostics.stages[kTracks].work);
  ASSERT_GT(need, 10u);
  int refused = 0;
  for (std::uint32_t k = 0; k <= 20; ++k) {
    world_.request.budget.tracks = k * need / 20;
    const Status status = world_.replan();
    const tern::StageReport& stage = world_.report.diagnostics.stages[kTracks];
    EXPECT_LE(stage.work, stage.bound);
    EXPECT_TRUE(status == Status::kOk || status == Status::kBudgetTracks) << k << ' ' << static_cast<int>(status);
    if (status == Status::kOk) {
      EXPECT_EQ(finding_from(0.0), tern::Finding::kNone);
    } else {
      EXPECT_EQ(world_.report.track, 0);
      ++refused;
    }
  }
  EXPECT_GT(refused, 0);
  world_.request.budget.tracks = need;
  EXPECT_EQ(world_.replan(), Status::kOk);
  EXPECT_EQ(tern::duration(world_.trajectory), best);
}

}  // namespace
}  // namespace tern_test
