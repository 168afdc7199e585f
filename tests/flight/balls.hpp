// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Balls that are measured, and some that hunt the vehicle.
#ifndef TERN_TESTS_FLIGHT_BALLS_HPP
#define TERN_TESTS_FLIGHT_BALLS_HPP

#include <gtest/gtest.h>

#include <cstdint>

#include "support/flight_room.hpp"
#include "support/random.hpp"

namespace tern_test {

inline constexpr double kBallRadius = 0.3;

/// A ball that was measured here, with an error of 3 cm and 0.1 m/s.
inline tern::Track seen(std::uint32_t id, const tern::Vec3& position, const tern::Vec3& velocity, std::int64_t t,
                        double acceleration) {
  tern::Track track;
  track.id = id;
  track.measured = t;
  track.position = position;
  track.velocity = velocity;
  track.radius = kBallRadius;
  track.error = 0.03;
  track.error_speed = 0.1;
  track.error_growth = acceleration;
  return track;
}

/// A ball that rests far from all that is flown in the room: with it, time matters.
inline void add_far_ball(FlightRoom& room) {
  ASSERT_EQ(room.flight.update_track(seen(1, {-10.0, 9.0, 0.5}, {}, room.time, 0.0)), tern::Status::kOk);
}

/// A ball that flies towards the vehicle as well as its bounds allow, from where it keeps its velocity.
struct Hunter {
  tern::Vec3 position;
  tern::Vec3 velocity{};
  double acceleration;
  double top;
  bool hunts = true;

  void move(const tern::Vec3& prey, double time) {
    const tern::Vec3 way = prey - position;
    const double far = tern::length(way);
    const tern::Vec3 wanted = velocity + (time * acceleration / std::fmax(far, 1e-9)) * way;
    const double fast = tern::length(wanted);
    const tern::Vec3 next = fast > top ? (top / fast) * wanted : wanted;
    const bool can = tern::length(next - velocity) <= time * acceleration * (1.0 + 1e-9);
    const tern::Vec3 after = can && hunts ? next : velocity;
    position = position + (0.5 * time) * (velocity + after);
    velocity = after;
  }
};

}  // namespace tern_test

#endif
