// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How things move in truth: places computed by hand, and bounds that sampled motions keep.
#include "host/things/thing_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "host/flight/flight_world.hpp"
#include "host/flight/vectors.hpp"
#include "host/things/python_random.hpp"
#include "support/random.hpp"

namespace {

using tern_host::Hunt;
using tern_host::Thing;
using tern_host::ThingMotion;
using tern_host::ThingState;
using tern_host::Trefoil;
using tern_host::Walk;

constexpr double kQuarter = 1.57079632679489662;  // turn

Thing moving(const std::variant<Trefoil, Walk, Hunt>& motion) {
  Thing thing;
  thing.motion = motion;
  return thing;
}

void expect_near(const tern::Vec3& a, const tern::Vec3& b, double room = 1e-12) {
  EXPECT_NEAR(a.x, b.x, room);
  EXPECT_NEAR(a.y, b.y, room);
  EXPECT_NEAR(a.z, b.z, room);
}

// At t = 0 with a phase of a quarter turn, all sines are 1 and all cosines 0. A phase that were multiplied would give
// sin(pi) in the second term.
TEST(ThingMotion, TrefoilsDoNotMultiplyTheirPhase) {
  const ThingMotion knot(moving(Trefoil{{10.0, 20.0, 30.0}, {1.0, 2.0, 4.0}, 2.0, kQuarter, 0.0}));
  expect_near(knot.at(0.0).position, {13.0, 20.0, 26.0});
  // d/dt: (cos + 4 cos, -sin + 4 sin, -3 cos) / 2, times the scale.
  expect_near(knot.at(0.0).velocity, {0.0, 3.0, 0.0});
  // A quarter turn later: sin(pi) + 2 sin(3 pi / 2), cos(pi) - 2 cos(3 pi / 2), -sin(2 pi).
  expect_near(knot.at(2.0 * kQuarter).position, {8.0, 18.0, 30.0});
  const ThingMotion ahead(moving(Trefoil{{10.0, 20.0, 30.0}, {1.0, 2.0, 4.0}, 2.0, kQuarter, 2.0 * kQuarter}));
  expect_near(ahead.at(0.0).position, {8.0, 18.0, 30.0});
}

// With 1 m/s and 2 m/s^2, it sets off and stops in half a second and a quarter of a metre.
TEST(ThingMotion, WalksStopAndGoOn) {
  Walk walk{1.0, 2.0, 0.0, false, {{{0.0, 0.0, 0.0}, 0.0}, {{3.0, 0.0, 0.0}, 1.0}, {{3.0, 4.0, 0.0}, 0.0}}};
  const ThingMotion motion(moving(walk));
  expect_near(motion.at(0.25).position, {0.0625, 0.0, 0.0});
  expect_near(motion.at(0.5).velocity, {1.0, 0.0, 0.0});
  expect_near(motion.at(2.0).position, {1.75, 0.0, 0.0});
  expect_near(motion.at(3.25).velocity, {0.5, 0.0, 0.0});
  for (const double t : {3.5, 4.0, 4.5}) expect_near(motion.at(t).position, {3.0, 0.0, 0.0});
  expect_near(motion.at(6.0).position, {3.0, 1.25, 0.0});
  expect_near(motion.at(100.0).position, {3.0, 4.0, 0.0});
  expect_near(motion.at(100.0).velocity, {0.0, 0.0, 0.0});
  walk.ahead = 4.0;
  expect_near(ThingMotion(moving(walk)).at(2.0).position, {3.0, 1.25, 0.0});
}

// A right angle at 1 m/s: the velocity changes by the root of 2, in one second, centred at the corner. There, the walk
// is off it by the change of velocity times 1/8 s.
TEST(ThingMotion, WalksCutCorners) {
  const double root = std::sqrt(2.0);
  const Walk walk{1.0, root, 0.0, false, {{{0.0, 0.0, 0.0}, 0.0}, {{4.0, 0.0, 0.0}, 0.0}, {{4.0, 4.0, 0.0}, 0.0}}};
  expect_near(ThingMotion(moving(walk)).at(0.5 / root + 4.0).position, {3.875, 0.125, 0.0});
}

TEST(ThingMotion, LoopsBeginAnew) {
  // 0.25 + 3 + 0.25 s there, the same back.
  const Walk walk{1.0, 2.0, 0.0, true, {{{0.0, 0.0, 0.0}, 0.0}, {{3.0, 0.0, 0.0}, 1.0}}};
  const ThingMotion motion(moving(walk));
  const double period = 2.0 * 3.5 + 1.0;
  expect_near(motion.at(2.0).position, {1.75, 0.0, 0.0});
  expect_near(motion.at(period + 2.0).position, {1.75, 0.0, 0.0});
  expect_near(motion.at(7.0 * period + 6.5).position, {1.25, 0.0, 0.0});
}

TEST(ThingMotion, WalksNeedRoomForTheirTurns) {
  // To set off and to stop takes 0.5 m each.
  EXPECT_EQ(tern_host::walk_fault({1.0, 1.0, 0.0, false, {{{0.0, 0.0, 0.0}, 0.0}, {{1.01, 0.0, 0.0}, 0.0}}}), "");
  EXPECT_NE(tern_host::walk_fault({1.0, 1.0, 0.0, false, {{{0.0, 0.0, 0.0}, 0.0}, {{0.99, 0.0, 0.0}, 0.0}}}), "");
  EXPECT_NE(tern_host::walk_fault({1.0, 1.0, 0.0, true, {{{0.0, 0.0, 0.0}, 0.0}}}), "");
  EXPECT_NE(tern_host::walk_fault({1.0, 1.0, 0.0, false, {}}), "");
}

// From rest with 2 m/s^2 and at most 1 m/s, towards a vehicle that stays 10 m away.
TEST(ThingMotion, HuntersComeAtTheirBounds) {
  ThingMotion hunter(moving(Hunt{{0.0, 0.0, 0.0}, 2.0, 1.0, 20.0}));
  const auto hunt_until = [&hunter](double from, double to, const tern::Vec3& prey) {
    for (double t = from; t < to - 1e-9; t += 0.125) hunter.hunt(t, 0.125, prey);
  };
  hunt_until(0.0, 0.5, {10.0, 0.0, 0.0});
  expect_near(hunter.at(0.5).velocity, {1.0, 0.0, 0.0});
  expect_near(hunter.at(0.5).position, {0.25, 0.0, 0.0});
  hunt_until(0.5, 1.5, {10.0, 0.0, 0.0});
  expect_near(hunter.at(1.5).position, {1.25, 0.0, 0.0});
  hunt_until(1.5, 2.5, {100.0, 50.0, 0.0});  // out of sight: it keeps its velocity
  expect_near(hunter.at(2.5).position, {2.25, 0.0, 0.0});
  hunt_until(2.5, 3.5, {-10.0, 0.0, 0.0});  // back: as fast again after a second
  expect_near(hunter.at(3.5).velocity, {-1.0, 0.0, 0.0});
}

/// Steps a motion by `step` seconds and holds it to its bounds, and its velocity to its places.
void expect_bounds(ThingMotion motion, const std::string& name) {
  constexpr double kStep = 1.0 / 128.0;
  const tern_host::ThingBounds& bounds = motion.bounds();
  tern_test::Random random(77);
  motion.hunt(0.0, kStep, {0.0, 0.0, 1.0});
  ThingState before = motion.at(0.0);
  for (int k = 1; k <= 4000; ++k) {
    const double t = kStep * k;
    const ThingState now = motion.at(t);
    const tern::Vec3 way = tern_host::along(now.position, -1.0, before.position);
    const tern::Vec3 change = tern_host::along(now.velocity, -1.0, before.velocity);
    ASSERT_LE(tern_host::length(now.velocity), bounds.speed * (1.0 + 1e-9)) << name << " at " << t;
    ASSERT_LE(tern_host::length(way), bounds.speed * kStep * (1.0 + 1e-9)) << name << " at " << t;
    ASSERT_LE(tern_host::length(change), bounds.acceleration * kStep * (1.0 + 1e-6)) << name << " at " << t;
    // What it moves is its velocity, but for what it accelerates in the step.
    const tern::Vec3 off = tern_host::along(way, -kStep, before.velocity);
    ASSERT_LE(tern_host::length(off), 0.5 * bounds.acceleration * kStep * kStep * (1.0 + 1e-6)) << name << " at " << t;
    before = now;
    motion.hunt(t, kStep, {10.0 * random.unit(), 10.0 * random.unit(), 1.0});
  }
}

TEST(ThingMotion, NothingExceedsItsBounds) {
  for (const char* const family : {"T1-50", "T4", "T5-50", "CW", "RX", "MF", "HU", "B50"}) {
    const tern_host::FlightWorld world = tern_host::read_flight_world(std::string(family) + ":1", {});
    ASSERT_FALSE(world.things.empty());
    const std::size_t most = static_cast<std::size_t>(tern_test::scaled(20));
    for (std::size_t k = 0; k < world.things.size() && k < most; ++k) {
      expect_bounds(ThingMotion(world.things[k]), family + (":1 " + world.things[k].name));
    }
  }
}

// Literature: up to 4.8 to 5.3 m/s in MADER's corridor; 0.31 to 0.69 m/s in SANDO's.
TEST(ThingMotion, PublishedScenesHaveTheirSpeeds) {
  const auto check = [](const std::string& name, double least, double most) {
    for (const Thing& thing : tern_host::read_flight_world(name, {}).things) {
      if (!(std::get<Trefoil>(thing.motion).scale.x > 0.0)) continue;  // a bar
      const double speed = ThingMotion(thing).bounds().speed;
      EXPECT_GT(speed, least) << name << " " << thing.name;
      EXPECT_LT(speed, most) << name << " " << thing.name;
    }
  };
  check("T1-50:1", 4.7, 5.4);
  check("T5-200:0", 0.3, 0.72);
}

// By python3 -c "import random; random.seed(0); print(random.random())", and so on.
TEST(PythonRandom, GivesPythonsNumbers) {
  tern_host::PythonRandom zero(0);
  for (const double number : {0.8444218515250481, 0.7579544029403025, 0.420571580830845}) {
    EXPECT_EQ(zero.unit(), number);
  }
  tern_host::PythonRandom other(12345);
  for (const double number : {0.41661987254534116, 0.010169169457068361}) EXPECT_EQ(other.unit(), number);
}

// Python: random.seed(0), then round(random.uniform(...), 2) in the script's order; random.seed(3) without rounding.
TEST(PublishedScenes, HaveTheScriptsNumbers) {
  const Trefoil first = std::get<Trefoil>(tern_host::read_flight_world("T4:0", {}).things[0].motion);
  expect_near(first.center, {-20.0, 3.44, 5.03}, 0.0);
  expect_near(first.scale, {2.84 / 6.0, 2.52 / 5.0, 1.02 / 2.0}, 0.0);
  EXPECT_EQ(first.phase, 0.81);
  EXPECT_EQ(first.slower, 5.57);
  const Trefoil other = std::get<Trefoil>(tern_host::read_flight_world("T5-50:3", {}).things[0].motion);
  expect_near(other.center, {28.796462709189136, 0.5307507035514227, 1.979820666192317}, 0.0);
  expect_near(other.scale, {3.207840077192389 / 6.0, 3.2514406082161083 / 5.0, 2.131057718479626 / 2.0}, 0.0);
  EXPECT_EQ(other.phase, 0.03950397466462241);
  EXPECT_EQ(other.slower, 11.67493816419292);
}

}  // namespace
