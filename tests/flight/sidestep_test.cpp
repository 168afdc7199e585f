// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A vehicle that rests in the way of a thing gives way.
#include "flight/sidestep.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "flight/branch.hpp"
#include "support/flight_room.hpp"
#include "support/random.hpp"

namespace {

using namespace tern;
using tern_test::FlightRoom;

constexpr double kWalker = 0.3;

double reached_by(const Trajectory& push) {
  return length(push.segments[push.count - 1].points[kDegree]);
}

TEST(FlightSidestep, APushKeepsTheLimitsAndEndsAtRest) {
  tern_test::Random random(4203);
  for (const double jerk : {0.0, 60.0, 20.0}) {
    Limits limits{{3.0, 3.0, 2.0}, {6.0, 6.0, 4.0}};
    limits.j_max = {jerk, jerk, jerk};
    for (int k = 0; k < tern_test::scaled(100); ++k) {
      const Vec3 way{random.real(-1.0, 1.0), random.real(-1.0, 1.0), random.real(-1.0, 1.0)};
      if (length(way) < 0.1) continue;
      const Vec3 side = (1.0 / length(way)) * way;
      Trajectory push{};
      ASSERT_TRUE(append_push({}, MotionLimits(limits), side, 1.0, push));
      EXPECT_GT(reached_by(push), 0.9);
      EXPECT_LT(reached_by(push), jerk > 0.0 ? 6.0 : 1.6);
      EXPECT_GT(dot(push.segments[push.count - 1].points[kDegree], side), 0.999 * reached_by(push));
      for (double t = 0.0; t <= duration(push); t += 0.01) {
        const Sample s = evaluate(push, t);
        EXPECT_LE(std::abs(s.velocity.x), 3.0 + 1e-6);
        EXPECT_LE(std::abs(s.acceleration.z), 4.0 + 1e-6);
        if (jerk > 0.0) {
          EXPECT_LE(std::abs(s.jerk.y), jerk * (1.0 + 1e-6));
        }
      }
      EXPECT_LT(length(evaluate(push, duration(push)).velocity), 1e-9);
    }
  }
}

TEST(FlightSidestep, AFastVehicleIsNotPushedBeyondItsSpeed) {
  const Limits limits{{3.0, 3.0, 2.0}, {6.0, 6.0, 4.0}};
  const JointState fast{{kZero, {2.9, 0.0, 0.0}, kZero, kZero}};
  Trajectory push{};
  EXPECT_FALSE(append_push(fast, MotionLimits(limits), {1.0, 0.0, 0.0}, 1.0, push));
  push.count = 0;
  EXPECT_TRUE(append_push(fast, MotionLimits(limits), {0.0, 1.0, 0.0}, 1.0, push));
  push.count = kMaxSegments - 1;
  EXPECT_FALSE(append_push(fast, MotionLimits(limits), {0.0, 1.0, 0.0}, 1.0, push));
}

/// The four free voxels whose centres are nearest, among obstacles at random.
TEST(FlightSidestep, StepsBackToTheNearestFreeVoxels) {
  tern_test::Random random(4210);
  int with_place = 0;
  for (int k = 0; k < tern_test::scaled(40); ++k) {
    FlightRoom room;
    Grid safe = room.map().safe();
    for (int n = 0; n < 30; ++n) {
      const Vec3 low{random.real(-3.0, 3.0), random.real(-3.0, 3.0), random.real(0.0, 2.0)};
      EXPECT_EQ(safe.mark_box({low, low + Vec3{0.2, 0.2, 0.2}}), Status::kOk);
    }
    safe.inflate();
    const Vec3 from = room.position();
    const Voxel at = safe.voxel_of(safe.to_local(from));
    std::vector<double> far;
    for (std::int32_t n = 0; n < kVoxelsBack; ++n) {
      const Voxel voxel{at.x + n % 9 - 4, at.y + n / 9 % 9 - 4, at.z + n / 81 - 4};
      if (safe.free(voxel)) far.push_back(distance(safe.spec().origin + safe.center(voxel), from));
    }
    std::sort(far.begin(), far.end());
    Sidesteps steps{};
    ASSERT_EQ(steps.begin_back(safe, from, 1), !far.empty());
    if (far.empty()) continue;
    ++with_place;
    ASSERT_EQ(steps.places, std::min(kPlacesBack, static_cast<int>(far.size())));
    for (int n = 0; n < steps.places; ++n) {
      EXPECT_DOUBLE_EQ(distance(steps.place[n], from), far[static_cast<std::size_t>(n)]);
      EXPECT_TRUE(safe.free(safe.voxel_of(safe.to_local(steps.place[n]))));
    }
  }
  EXPECT_GT(with_place, tern_test::scaled(40) / 2);
}

/// Rests so near to a post that its voxel is not free, after an attempt at a plan that failed, and without a lookout.
struct Stuck : FlightRoom {
  explicit Stuck(const FlightSpec& how = flight_spec()) : FlightRoom(how) {
    mark({{0.51, 0.51, -1.9}, {0.74, 0.74, 3.9}});
    for (int k = 0; k < 200; ++k) tick();
    EXPECT_EQ(flight.set_goal({8.125, 0.125, 1.125}), Status::kOk);
    tick();
    state().cycle.leave();
    state().search.idle_cycles = 1;
    state().lookouts.found_nothing = true;
    state().lookouts.stepped = map().learned() - kLearned;  // there is news
  }
  bool is_free_at(const Vec3& place) {
    const Grid& safe = map().safe();
    return safe.free(safe.voxel_of(safe.to_local(place)));
  }
  bool begins() {
    Work work;
    return state().cycle.begin_step_back(state().facts, state().search, state().lookouts, state().draft, work);
  }
};

TEST(FlightSidestep, AStuckVehicleStepsBackToAFreeVoxel) {
  Stuck room;
  ASSERT_FALSE(room.is_free_at(room.position()));
  const std::uint32_t committed = room.report.committed;
  for (int k = 0; k < 20 && room.report.committed == committed; ++k) room.tick();
  ASSERT_EQ(room.report.committed, committed + 1);
  const Commitment& step = room.state().facts.plans.latest();
  EXPECT_TRUE(room.is_free_at(step.end()));
  EXPECT_LT(distance(step.end(), room.position()), 1.0);
  EXPECT_EQ(step.trajectory.count, 1) << "straight";
  EXPECT_EQ(room.state().lookouts.stepped, room.map().learned());
  EXPECT_FALSE(room.state().lookouts.may_step_back(room.map())) << "the map has learned nothing since";
}

TEST(FlightSidestep, OnlyAStuckVehicleStepsBack) {
  Stuck room;
  room.state().draft.begin(room.state().facts, 10);
  EXPECT_TRUE(room.begins());
  room.state().cycle.leave();
  EXPECT_FALSE(room.state().cycle.is_sidestep());
  room.state().facts.plans.in_flight.lifts = true;
  EXPECT_FALSE(room.begins()) << "on its way up or down";
  room.state().facts.plans.in_flight.lifts = false;
  room.state().search.idle_cycles = 2;
  EXPECT_FALSE(room.begins()) << "another attempt's turn";
  room.state().search.idle_cycles = 1;
  room.state().lookouts.found_nothing = false;
  EXPECT_FALSE(room.begins()) << "a lookout may be found";
}

/// A keep-out begins around the vehicle: nowhere within reach of a step back is outside. These fail, and the next
/// attempt leads out in time.
TEST(FlightSidestep, StepsBackThatFailHoldNothingUp) {
  static const Halfspace kPlanes[6] = {{{1, 0, 0}, 2.125},  {{-1, 0, 0}, 1.875}, {{0, 1, 0}, 2.125},
                                       {{0, -1, 0}, 1.875}, {{0, 0, 1}, 10},     {{0, 0, -1}, 10}};
  for (const double from : {4.2, 5.4, 6.6}) {
    Fence fence{};
    fence.kind = FenceKind::kKeepOut;
    fence.planes = kPlanes;
    fence.count = 6;
    fence.from = static_cast<std::int64_t>(from * 1e9);
    fence.until = 100000000000;
    FlightSpec spec = FlightRoom::flight_spec();
    spec.fences = &fence;
    spec.fence_count = 1;
    Stuck room(spec);
    room.state().block = {BlockedBy::kFence, kZero, 0};
    int in_vain = 0;
    for (int k = 0; k < 1000; ++k) {
      room.state().lookouts.found_nothing = true;
      room.tick();
      in_vain += room.state().cycle.steps_back ? 1 : 0;
    }
    EXPECT_GT(room.position().x, 2.125) << from << ": step backs for " << in_vain << " ticks";
  }
}

/// Waits before a ball that covers its goal for good.
struct WaitingRoom : FlightRoom {
  explicit WaitingRoom(const FlightSpec& how = flight_spec()) : FlightRoom(how) {
    const Vec3 goal{6.125, 0.125, 1.125};
    flight.set_goal(goal);
    Track ball = thing(1, goal, kZero);
    ball.error_speed = ball.error_growth = ball.reach = 0.0;
    EXPECT_EQ(flight.update_track(ball), Status::kOk);
    for (int k = 0; k < 400; ++k) agree_and_tick();
  }
  /// Whatever needs a clearance gets it.
  void agree_and_tick() {
    Trajectory plan{};
    std::int64_t takeover = 0;
    const std::uint32_t question = spec.clearance > 0 ? flight.proposal(plan, takeover) : 0;
    if (question != 0 && question != answered) {
      EXPECT_EQ(flight.answer(question, true), Status::kOk);
    }
    answered = question;
    tick();
  }
  Track thing(std::uint32_t id, const Vec3& place, const Vec3& velocity) const {
    Track track;
    track.id = id;
    track.measured = time;
    track.position = place;
    track.velocity = velocity;
    track.radius = kWalker;
    track.error = 0.03;
    track.error_speed = 0.1;
    track.error_growth = 0.5;
    track.reach = 1.2;
    return track;
  }
  std::uint32_t answered = 0;
};

// Each walks at 0.8 m/s right over the place where the vehicle waits.
TEST(FlightSidestep, AVehicleThatWaitsGivesWay) {
  tern_test::Random random(4204);
  for (int k = 0; k < tern_test::scaled(6); ++k) {
    WaitingRoom room;
    const double angle = random.real(0.0, 6.283);
    const Vec3 way{std::cos(angle), std::sin(angle), 0.0};
    const Vec3 waits = room.position();
    Vec3 walker = waits - 5.0 * way;
    double nearest = 1e9;
    double moved = 0.0;
    for (int tick = 0; tick < 1000; ++tick) {
      if (tick % 10 == 0) {
        EXPECT_EQ(room.flight.update_track(room.thing(2, walker, 0.8 * way)), Status::kOk);
      }
      room.tick();
      walker = walker + 0.008 * way;
      nearest = std::min(nearest, distance(room.position(), walker));
      moved = std::max(moved, distance(room.position(), waits));
    }
    EXPECT_GE(nearest, FlightRoom::kRadius + kWalker - 1e-3) << k;
    EXPECT_GT(moved, 0.5) << k;
  }
}

// Plans that led nowhere do not count for a vehicle that gives way, also where it has to ask before it does.
TEST(FlightSidestep, GivingWayForgivesFruitlessPlansOnceItIsCleared) {
  FlightSpec spec = FlightRoom::flight_spec();
  spec.clearance = 100000000;
  WaitingRoom room(spec);
  const Vec3 waits = room.position();
  Vec3 walker = waits - Vec3{0.0, 5.0, 0.0};
  const Vec3 velocity{0.0, 0.8, 0.0};
  Itinerary& itinerary = room.state().facts.itinerary;
  const std::uint32_t committed = room.report.committed;
  for (int tick = 0; tick < 1000 && room.report.committed == committed; ++tick) {
    if (tick % 10 == 0) {
      EXPECT_EQ(room.flight.update_track(room.thing(2, walker, velocity)), Status::kOk);
    }
    itinerary.fruitless = 20;
    room.agree_and_tick();
    walker = walker + 0.01 * velocity;
  }
  EXPECT_GT(room.report.committed, committed);
  EXPECT_EQ(itinerary.fruitless, 0);
  for (int k = 0; k < 100; ++k) room.agree_and_tick();
  EXPECT_GT(distance(room.position(), waits), 0.1);
}

}  // namespace
