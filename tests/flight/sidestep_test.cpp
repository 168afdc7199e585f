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
    ASSERT_EQ(steps.begin_back(safe, from), !far.empty());
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
