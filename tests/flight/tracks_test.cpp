// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Flights among things that move. Contacts are found by samples of the commands, from the things' true places.

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <vector>

#include "flight/balls.hpp"
#include "support/flight_room.hpp"
#include "support/random.hpp"

namespace {

using namespace tern;
using tern_test::FlightRoom;
using tern_test::Hunter;
using tern_test::kBallRadius;
using tern_test::seen;

/// On the way to 12 m along x, at nearly 3 m/s.
struct TrackRoom : FlightRoom {
  TrackRoom() {
    flight.set_goal({12.125, 0.125, 1.125});
    EXPECT_TRUE(tick_until([&] { return speed() > 2.9; }, 400));
  }
  Track ball(double ahead, double aside) const {
    return seen(7, position() + Vec3{ahead, aside, 0.0}, {}, time - spec.tick, 0.0);
  }
};

/// What a flight among hunters came to.
struct Hunt {
  int in_motion = 0;
  int at_rest = 0;
  bool arrived = false;
};

/// Measured ten times a second, with errors of up to 3 cm and 0.1 m/s.
Hunt fly_among(std::vector<Hunter>& hunters, tern_test::Random& random, int ticks) {
  FlightRoom room;
  const auto noise = [&](double size) {
    return size * Vec3{random.real(-0.5, 0.5), random.real(-0.5, 0.5), random.real(-0.5, 0.5)};
  };
  room.flight.set_goal({12.125, 0.125, 1.125});
  Hunt hunt;
  bool touched = false;
  for (int k = 0; k < ticks && !hunt.arrived; ++k) {
    if (k % 10 == 0) {
      for (std::size_t i = 0; i < hunters.size(); ++i) {
        Track track = seen(static_cast<std::uint32_t>(i), hunters[i].position + noise(0.03),
                           hunters[i].velocity + noise(0.1), room.time, hunters[i].acceleration);
        track.reach = hunters[i].top;
        EXPECT_EQ(room.flight.update_track(track), Status::kOk);
      }
    }
    const std::int64_t before = room.time;
    room.tick();
    for (int part_of_tick = 0; part_of_tick < 5; ++part_of_tick) {
      const Command command = room.flight.command(before + part_of_tick * room.spec.tick / 5);
      bool touches = false;
      for (const Hunter& hunter : hunters) {
        touches =
            touches || distance(hunter.position, command.sample.position) < FlightRoom::kRadius + kBallRadius - 1e-6;
      }
      const bool moves = length(command.sample.velocity) > 1e-3;
      if (touches && !touched) ++(moves ? hunt.in_motion : hunt.at_rest);
      touched = touches;
      for (Hunter& hunter : hunters) hunter.move(command.sample.position, 0.2e-9 * static_cast<double>(room.spec.tick));
    }
    hunt.arrived = room.report.reason == FlightReason::kArrived;
  }
  return hunt;
}

// Ten hunters with accelerations of 1 to 6 m/s^2. None touches a vehicle that moves.
TEST(FlightTracks, NothingTouchesTheVehicleWhileItMoves) {
  tern_test::Random random(4201);
  const int flights = tern_test::scaled(20);
  for (int k = 0; k < flights; ++k) {
    std::vector<Hunter> hunters(10);
    for (Hunter& hunter : hunters) {
      hunter.position = {2.5 + 11.0 * random.unit(), -6.0 + 12.0 * random.unit(), 3.5 * random.unit()};
      hunter.acceleration = 1.0 + 5.0 * random.unit();
      hunter.top = 0.5 * hunter.acceleration;
    }
    const Hunt hunt = fly_among(hunters, random, 800);
    EXPECT_EQ(hunt.in_motion, 0) << k;
  }
}

// Ten balls that keep their velocities of up to 1.5 m/s, and cross the way. They could accelerate with 1 m/s^2.
TEST(FlightTracks, PassersByAreFlownAround) {
  tern_test::Random random(4202);
  const int flights = tern_test::scaled(20);
  int touched_at_rest = 0;
  for (int k = 0; k < flights; ++k) {
    std::vector<Hunter> passers(10);
    for (Hunter& passer : passers) {
      passer.position = {random.real(2.5, 13.0), random.real(-5.0, 5.0), random.real(0.0, 3.0)};
      passer.velocity = {random.real(-0.8, 0.8), random.real(-1.0, 1.0), random.real(-0.2, 0.2)};
      passer.acceleration = 1.0;
      passer.hunts = false;
      passer.top = 2.0;
    }
    const Hunt flown = fly_among(passers, random, 3000);
    EXPECT_EQ(flown.in_motion, 0) << k;
    EXPECT_TRUE(flown.arrived) << k;
    touched_at_rest += flown.at_rest > 0 ? 1 : 0;
  }
  EXPECT_LE(touched_at_rest, 1 + flights / 20);  // not promised
}

// The ball is noticed 3 m ahead. A brake from 3 m/s at 6 m/s^2 takes 0.75 m, and its ramps some more.
TEST(FlightTracks, AThingThatNobodyKnewOfIsAThreat) {
  TrackRoom room;
  const Track ball = room.ball(3.0, 0.0);
  EXPECT_EQ(room.flight.update_track(ball), Status::kOk);
  room.tick();
  EXPECT_EQ(room.report.mode, FlightMode::kThreat);
  EXPECT_GT(room.report.contact_time, room.time);
  double nearest = 1e9;
  EXPECT_TRUE(room.tick_until([&] {
    nearest = std::fmin(nearest, distance(room.position(), ball.position));
    return room.report.reason == FlightReason::kArrived;
  }));
  EXPECT_GE(nearest, FlightRoom::kRadius + kBallRadius);
}

// Nothing can be done about a ball 0.9 m ahead, but the vehicle brakes, and says when and how fast it meets the tube.
TEST(FlightTracks, AContactThatNoBrakePreventsIsReported) {
  TrackRoom room;
  EXPECT_EQ(room.flight.update_track(room.ball(0.9, 0.0)), Status::kOk);
  room.tick();
  EXPECT_EQ(room.report.mode, FlightMode::kThreat);
  EXPECT_GT(room.report.contact_speed, 2.5);
  EXPECT_LT(room.report.contact_time, room.time + 100000000);
  EXPECT_TRUE(room.tick_until([&] { return room.speed() < 0.01; }, 100));
}

// A thing beside the way is no threat. Once it is measured in the way, far from its tube, it is one.
TEST(FlightTracks, AMeasurementOutsideItsTubeIsAThreat) {
  TrackRoom room;
  EXPECT_EQ(room.flight.update_track(room.ball(3.0, 2.0)), Status::kOk);
  room.tick();
  EXPECT_EQ(room.report.mode, FlightMode::kFly);
  EXPECT_EQ(room.flight.update_track(room.ball(2.9, 2.03)), Status::kOk);  // the tube has an error of 3 cm
  room.tick();
  EXPECT_EQ(room.report.mode, FlightMode::kFly);
  EXPECT_EQ(room.flight.update_track(room.ball(2.8, 0.0)), Status::kOk);
  room.tick();
  EXPECT_EQ(room.report.mode, FlightMode::kThreat);
}

// At rest: a ball of 0.3 m comes at 1 m/s from 5 m away, without errors. It is 0.3 + 0.5 m away after 4.2 s.
TEST(FlightTracks, SaysUntilWhenTheRestIsClear) {
  FlightRoom room;
  room.tick();
  EXPECT_EQ(room.flight.rest_clear_until(), INT64_MAX);
  Track track = seen(1, room.start + Vec3{5.0, 0.0, 0.0}, {-1.0, 0.0, 0.0}, 0, 0.0);
  track.error = track.error_speed = 0.0;
  EXPECT_EQ(room.flight.update_track(track), Status::kOk);
  EXPECT_EQ(room.flight.rest_clear_until(), INT64_MAX);  // as the last tick knew it
  room.tick();
  const auto expect_clear_until = [&](double until) {
    // It may be too early by a piece of the proof: an hour, halved kTrackDepth times.
    EXPECT_LE(1e-9 * static_cast<double>(room.flight.rest_clear_until()), until);
    EXPECT_GE(1e-9 * static_cast<double>(room.flight.rest_clear_until()), until - kRestHorizon / (1 << kTrackDepth));
  };
  expect_clear_until(4.2);
  for (int k = 0; k < 98; ++k) room.tick();
  expect_clear_until(4.2);
  EXPECT_EQ(room.flight.set_clock(std::int64_t{100000000000}), Status::kOk);  // it shows 1 s later than so far
  expect_clear_until(100.0 + 4.2 - 1.0);
  EXPECT_EQ(room.flight.forget_track(1), Status::kOk);
  room.time = 100000000000;
  room.tick();
  EXPECT_EQ(room.flight.rest_clear_until(), INT64_MAX);
  EXPECT_EQ(Flight{}.rest_clear_until(), INT64_MAX);
}

// Sixteen balls that come from 5 m away, next to the way of the rest, take more than a quarter of a tick of 256 units:
// a few ticks. Until then nothing is said to be clear. The answer is then that of a flight with more work.
TEST(FlightTracks, SaysSoLaterIfTheProofTakesLong) {
  std::int64_t until[2];
  int ticks[2] = {0, 0};
  for (const int k : {0, 1}) {
    FlightRoom room(FlightRoom::flight_spec(k == 0 ? 4000 : 256));
    room.tick();
    for (std::uint32_t id = 1; id <= 16; ++id) {
      const Vec3 from{5.0, 0.05 * id, 0.0};
      Track track = seen(id, room.start + from, {-1.0, 0.0, 0.0}, 0, 0.0);
      track.reach = 1.5;
      EXPECT_EQ(room.flight.update_track(track), Status::kOk);
    }
    do {
      room.tick();
      EXPECT_LE(room.report.work, room.spec.work_per_tick);
      until[k] = room.flight.rest_clear_until();
    } while (++ticks[k] < 100 && room.state().rest.is_running);
    EXPECT_FALSE(room.state().rest.is_running);
  }
  EXPECT_EQ(ticks[0], 1);
  EXPECT_GT(ticks[1], 1);
  EXPECT_NEAR(1e-9 * static_cast<double>(until[0]), 3.7, 0.4);
  EXPECT_NEAR(1e-9 * static_cast<double>(until[1]), 1e-9 * static_cast<double>(until[0]),
              kRestHorizon / (1 << kTrackDepth));
}

TEST(FlightTracks, RefusesWhatItCannotUse) {
  FlightRoom room;
  room.tick();
  const Track good = seen(1, {9.0, 5.0, 1.0}, {}, 0, 1.0);
  const auto answer = [&](void (*spoil)(Track&)) {
    Track track = good;
    spoil(track);
    return room.flight.update_track(track);
  };
  EXPECT_EQ(Flight{}.update_track(good), Status::kInvalidArgument);
  EXPECT_EQ(Flight{}.forget_track(1), Status::kInvalidArgument);
  EXPECT_EQ(answer([](Track& t) { t.position.y = std::numeric_limits<double>::infinity(); }), Status::kNonFiniteInput);
  EXPECT_EQ(answer([](Track& t) { t.error = -1.0; }), Status::kInvalidArgument);
  EXPECT_EQ(answer([](Track& t) { t.measured = 10000001; }), Status::kInvalidArgument);
  EXPECT_EQ(room.flight.forget_track(1), Status::kInvalidArgument);
  EXPECT_EQ(answer([](Track& t) { t.measured = 10000000; }), Status::kOk);
  EXPECT_EQ(room.flight.update_track(good), Status::kClockBehind);
  for (std::uint32_t id = 2; id <= kMaxFlightTracks; ++id) {
    EXPECT_EQ(room.flight.update_track(seen(id, good.position, {}, 0, 1.0)), Status::kOk);
  }
  EXPECT_EQ(room.flight.update_track(seen(kMaxFlightTracks + 1, good.position, {}, 0, 1.0)), Status::kTracksFull);
}

}  // namespace
