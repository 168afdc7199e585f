// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A false alarm behind the vehicle, which brakes before a wall that is known, with a plan about to take over: the
// radius is kept from the wall all the same, and the limits hold.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/flight_room.hpp"
#include "support/random.hpp"

namespace {

using namespace tern;
using tern_test::FlightRoom;
using tern_test::Random;

/// 1 where the alarm could be raised.
int fly(std::uint64_t seed) {
  Random random(seed);
  FlightSpec spec = FlightRoom::flight_spec();
  const double v = random.real(1.5, 4.0);
  const double a = random.real(3.0, 8.0);
  spec.limits = Limits{{v, v, 2.0}, {a, a, 6.0}};
  const double wall = 0.25 * random.integer(12, 26);
  FlightRoom room(spec, {{{wall, -4.0, -2.0}, {wall + 0.5, 4.0, 4.0}}});
  FlightState& state = room.state();
  const double goal = wall - 0.5 - random.real(0.0, 0.4);
  room.flight.set_goal({goal, 0.125, 1.125});
  const int wait = random.integer(20, 160);
  bool raised = false;
  for (int t = 0; t < 600; ++t) {
    room.tick();
    const Sample now = room.flight.command(room.time).sample;
    EXPECT_LE(now.position.x, wall - 0.5 + 1e-6) << seed << ": tick " << t;
    EXPECT_LE(std::hypot(now.acceleration.x, now.acceleration.y), std::sqrt(2.0) * a + 1e-6) << seed;
    EXPECT_LE(std::max(std::fabs(now.acceleration.x), std::fabs(now.acceleration.y)), a + 1e-6) << seed << ": " << t;
    if (raised) continue;
    if (t >= wait && !state.facts.plans.has_waiting && t % 12 == 0) {
      room.flight.set_goal({goal, 0.125 + random.real(-0.3, 0.3), 1.125});
    }
    if (t < wait || !state.facts.plans.has_waiting || state.facts.plans.waiting.evades || now.velocity.x < 0.4)
      continue;
    const double face = (std::floor(now.position.x / 0.25) - 1.0) * 0.25;
    const double gap = now.position.x - face;
    if (gap >= 0.5 - 0.012 * now.velocity.x || gap <= 0.5 - 0.028 * now.velocity.x) continue;
    room.mark({{face - 0.5, -0.5, 0.5}, {face - 0.01, 0.5, 1.5}});  // seen free before, so an alarm
    raised = true;
  }
  return raised ? 1 : 0;
}

TEST(FlightThreats, AlarmBehindTheVehicleLeadsNoNearerToAWall) {
  int raised = 0;
  for (const std::uint64_t seed : {223, 734, 819, 1293, 3238, 3856}) raised += fly(seed);
  EXPECT_EQ(raised, 6);
}

}  // namespace
