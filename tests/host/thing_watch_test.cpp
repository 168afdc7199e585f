// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The watch over things that move: it finds contacts between ticks, and says which of them break a promise.
#include "host/things/thing_watch.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "host/flight/flight_world.hpp"
#include "host/flight/simulated_flight.hpp"
#include "host/flight/vectors.hpp"
#include "host/things/surface_distance.hpp"
#include "host/things/thing_record.hpp"
#include "support/random.hpp"

namespace {

using tern_host::MovingBody;
using tern_host::Thing;
using tern_host::ThingMotion;
using tern_host::ThingWatch;

constexpr std::int64_t kTick = 10000000;

struct Watched {
  explicit Watched(const std::vector<std::string>& lines) {
    for (const std::string& line : lines) {
      things.push_back(tern_host::read_thing(tern_host::split_words("thing " + line, false), {"world.txt", 1}));
    }
    for (const Thing& thing : things) motions.emplace_back(thing);
  }
  /// From 0 to `end`, looking when the watch asks for it, and at every tick. Returns the number of looks.
  int fly(std::int64_t end, const tern::Vec3& from, const tern::Vec3& velocity) {
    ThingWatch watch(things, motions);
    int looks = 0;
    for (std::int64_t t = 0; t < end;) {
      const MovingBody body{tern_host::along(from, 1e-9 * static_cast<double>(t), velocity),
                            tern_host::length(velocity), 60.0, 0.05};
      watch.look(t, body, tern_host::length(velocity));
      ++looks;
      t = watch.next(t, kTick * (t / kTick + 1));
    }
    contacts = watch.contacts();
    return looks;
  }

  std::vector<Thing> things;
  std::vector<ThingMotion> motions;
  std::vector<tern_host::ThingContact> contacts;
};

// At 20 m/s, a ball of 1 cm crosses a body of 5 cm within 6 ms, between two ticks: at 0.105 + 0.5 * 20 / 1e6 s it is
// 2.1 m on its way.
TEST(ThingWatch, FindsContactsBetweenTicks) {
  Watched watched({"bullet ball 0.01 walk 20 1e6 0 0 0 0 0 100 0 0 0"});
  watched.fly(20 * kTick, {2.1, 0.0, 0.0}, {0.0, 0.0, 0.0});
  ASSERT_EQ(watched.contacts.size(), 1u);
  EXPECT_FALSE(watched.contacts[0].in_motion);
  EXPECT_NEAR(watched.contacts[0].time, 0.102, 1e-4);  // when it is 6 cm away
  EXPECT_GT(std::fmod(watched.contacts[0].time, 0.01), 1e-4);
}

// Beside the body by 7 mm more than both radii, and by 2 mm less.
TEST(ThingWatch, TellsNearFromTouching) {
  Watched watched({"bullet ball 0.01 walk 20 1e6 0 0 0 0 0 100 0 0 0"});
  watched.fly(20 * kTick, {2.1, 0.067, 0.0}, {0.0, 0.0, 0.0});
  EXPECT_TRUE(watched.contacts.empty());
  watched.fly(20 * kTick, {2.1, 0.058, 0.0}, {0.0, 0.0, 0.0});
  EXPECT_EQ(watched.contacts.size(), 1u);
}

TEST(ThingWatch, TellsMotionFromRest) {
  Watched watched({"wall box 0.1 5 5 hunt 1 0 0 1 1 0"});
  watched.fly(60 * kTick, {0.0, 0.0, 0.0}, {2.0, 0.0, 0.0});
  ASSERT_EQ(watched.contacts.size(), 1u);
  EXPECT_TRUE(watched.contacts[0].in_motion);
  EXPECT_EQ(watched.contacts[0].speed, 2.0);
  EXPECT_NEAR(watched.contacts[0].time, 0.425, 1e-3);
  EXPECT_FALSE(watched.contacts[0].in_tube);  // nobody had told of it
}

// Random passes: the watch finds the contacts that a thousand samples a tick find, with far fewer looks.
TEST(ThingWatch, AgreesWithFineSamples) {
  tern_test::Random random(11);
  int found = 0;
  for (int k = 0; k < tern_test::scaled(200); ++k) {
    const auto number = [&random](double lower, double upper) {
      return " " + std::to_string(random.real(lower, upper));
    };
    Watched watched({"t box 0.02 0.03 0.04 trefoil" + number(0.5, 1.5) + number(-0.5, 0.5) + " 0" + number(0.1, 1.0) +
                     number(0.1, 1.0) + " 0" + number(0.1, 0.5) + number(0.0, 6.0) + " 0"});
    const tern::Vec3 velocity{random.real(0.5, 8.0), random.real(-1.0, 1.0), 0.0};
    const int looks = watched.fly(30 * kTick, {0.0, 0.0, 0.0}, velocity);
    EXPECT_LT(looks, 3000);
    bool touches = false;
    for (std::int64_t t = 0; t < 30 * kTick; t += kTick / 1000) {
      const double s = 1e-9 * static_cast<double>(t);
      const tern::Vec3 body = tern_host::along({0.0, 0.0, 0.0}, s, velocity);
      touches = touches || surface_distance(watched.things[0], watched.motions[0].at(s).position, body) < 0.05 - 1e-5;
    }
    EXPECT_TRUE(!touches || !watched.contacts.empty()) << k;
    found += touches ? 1 : 0;
  }
  EXPECT_GT(found, 0);
}

// A wall that claims not to move comes at the vehicle: the contact is none of the flight's.
TEST(ThingWatch, AThingThatBreaksItsBoundsIsACollision) {
  const tern_host::FlightResult result = tern_host::simulate_flight(
      tern_host::read_flight_world("HU:1", {"thing_bounds=0.01", "time_limit=20", "detection_hz=1"}));
  EXPECT_EQ(result.status, "collision") << result.reason;
  EXPECT_EQ(result.contact.broken_assumption, "tube");
  EXPECT_GT(result.contact.speed, 0.0);
  EXPECT_EQ(result.things.in_motion(), 1);
}

}  // namespace
