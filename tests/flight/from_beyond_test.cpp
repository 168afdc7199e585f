// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Things that come from beyond the range of a detector, faster than the vehicle, right towards it.
#include "tern/from_beyond.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/flight_room.hpp"
#include "support/random.hpp"

namespace {

using namespace tern;
using tern_test::FlightRoom;

constexpr double kComerBall = 0.3;
constexpr double kComerError = 0.05;
constexpr FromBeyond kComer{3.2, 0.1, 4.0, kComerBall + kComerError};

Status slow_down(const FromBeyond& what, const FlightSpec& spec, double clearance, Limits& limits) {
  Trajectory room;
  return limit_speed(what, spec, clearance, limits, room);
}

/// What a ball did that came from beyond.
struct Met {
  bool in_motion = false;
  bool braked = false;
};

/// The ball comes into range when the vehicle is fast, from `side`, and homes in on it. It is measured ten times a
/// second, and told at once; the first time as late as `delay` allows.
Met meet(const Limits& limits, double angle, double rise, int wait) {
  FlightSpec spec = FlightRoom::flight_spec();
  spec.limits = limits;
  FlightRoom room(spec);
  room.flight.set_goal({12.125, 0.125, 1.125});
  for (int k = 0; k < wait; ++k) room.tick();
  const Vec3 side{std::cos(angle) * std::cos(rise), std::sin(angle) * std::cos(rise), std::sin(rise)};
  Vec3 ball = room.position() + kComer.range * side;
  Met met;
  for (int k = 0; k < 150; ++k) {
    if (k % 10 == 9) {
      Track track;
      track.id = 1;
      track.measured = room.time;
      track.position = ball;
      track.radius = kComerBall;
      track.error = kComerError;
      track.error_growth = 1000.0;
      track.reach = kComer.speed;
      EXPECT_EQ(room.flight.update_track(track), Status::kOk);
    }
    room.tick();
    met.braked = met.braked || room.state().facts.plans.latest().evades;
    const Sample now = room.flight.command(room.time).sample;
    const Vec3 way = now.position - ball;
    const double far = length(way);
    const bool moves = length(now.velocity) > 1e-6;
    met.in_motion = met.in_motion || (moves && far < FlightRoom::kRadius + kComerBall);
    ball = ball + (std::fmin(1.0, 1e-9 * static_cast<double>(spec.tick) * kComer.speed / std::fmax(far, 1e-9))) * way;
  }
  return met;
}

TEST(FlightFromBeyond, NothingTouchesAVehicleThatIsSlowEnough) {
  tern_test::Random random(4205);
  int touched_fast = 0;
  int braked = 0;
  const int flights = tern_test::scaled(24);
  for (int k = 0; k < flights; ++k) {
    Limits fast = FlightRoom::flight_spec().limits;
    if (k % 2 == 1) fast.j_max = {120.0, 120.0, 120.0};
    if (k % 3 == 2) fast.thrust_max = 14.0;
    Limits slow = fast;
    ASSERT_EQ(slow_down(kComer, FlightRoom::flight_spec(), FlightRoom::kRadius, slow), Status::kOk);
    EXPECT_LT(slow.v_max.x, 0.8 * fast.v_max.x);
    EXPECT_GT(slow.v_max.x, 0.1 * fast.v_max.x);
    EXPECT_DOUBLE_EQ(slow.v_max.z / fast.v_max.z, slow.v_max.x / fast.v_max.x);
    EXPECT_EQ(slow.a_max.x, fast.a_max.x);
    const double angle = random.real(-1.0, 1.0);
    const double rise = random.real(-0.2, 0.2);
    const int wait = random.integer(60, 200);
    const Met met = meet(slow, angle, rise, wait);
    EXPECT_FALSE(met.in_motion) << k;
    braked += met.braked ? 1 : 0;
    touched_fast += meet(fast, angle, rise, wait).in_motion ? 1 : 0;
  }
  EXPECT_GT(braked, flights / 2);
  EXPECT_GT(touched_fast, 0);
}

TEST(FlightFromBeyond, LeavesLimitsThatAreLowEnough) {
  Limits limits = FlightRoom::flight_spec().limits;
  FromBeyond far = kComer;
  far.range = 30.0;
  EXPECT_EQ(slow_down(far, FlightRoom::flight_spec(), 0.5, limits), Status::kOk);
  EXPECT_EQ(limits.v_max.x, FlightRoom::flight_spec().limits.v_max.x);
  limits.v_horizontal = 3.0;
  limits.v_min.z = -1.0;
  EXPECT_EQ(slow_down(kComer, FlightRoom::flight_spec(), 0.5, limits), Status::kOk);
  EXPECT_DOUBLE_EQ(limits.v_horizontal, limits.v_max.x);
  EXPECT_DOUBLE_EQ(limits.v_min.z, -limits.v_max.x / 3.0);
}

TEST(FlightFromBeyond, RefusesWhatNoSpeedHelpsAgainst) {
  const Limits before = FlightRoom::flight_spec().limits;
  const auto answer = [&](FromBeyond what, double clearance) {
    Limits limits = before;
    const Status status = slow_down(what, FlightRoom::flight_spec(), clearance, limits);
    EXPECT_EQ(limits.v_max.x, before.v_max.x);
    return status;
  };
  const auto with = [](double FromBeyond::*part, double value) {
    FromBeyond what = kComer;
    what.*part = value;
    return what;
  };
  EXPECT_EQ(answer(with(&FromBeyond::range, 1.0), 0.5), Status::kLimitsInvalid);
  EXPECT_EQ(answer(with(&FromBeyond::range, 0.0), 0.5), Status::kInvalidArgument);
  EXPECT_EQ(answer(with(&FromBeyond::delay, -0.1), 0.5), Status::kInvalidArgument);
  EXPECT_EQ(answer(with(&FromBeyond::speed, -1.0), 0.5), Status::kInvalidArgument);
  EXPECT_EQ(answer(with(&FromBeyond::size, -1.0), 0.5), Status::kInvalidArgument);
  EXPECT_EQ(answer(kComer, -0.5), Status::kInvalidArgument);
  Limits limits = before;
  limits.a_max.x = 0.0;
  EXPECT_EQ(slow_down(kComer, FlightRoom::flight_spec(), 0.5, limits), Status::kLimitsInvalid);
  limits = before;
  limits.thrust_min = 2.0;
  limits.rate_max = 3.0;
  EXPECT_EQ(slow_down(kComer, FlightRoom::flight_spec(), 0.5, limits), Status::kInvalidArgument);
  EXPECT_EQ(answer(with(&FromBeyond::speed, std::numeric_limits<double>::quiet_NaN()), 0.5), Status::kNonFiniteInput);
}

}  // namespace
