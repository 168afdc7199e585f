// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a flight is told of things: errors and delays within what its tracks say, and what is left out.
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "host/flight/flight_specs.hpp"
#include "host/flight/vectors.hpp"
#include "host/things/detector.hpp"
#include "host/things/thing_record.hpp"
#include "host/things/thing_watch.hpp"
#include "host/vehicle/vehicle.hpp"
#include "support/flight_room.hpp"
#include "support/random.hpp"

namespace {

using tern_host::Detector;
using tern_host::FlightWorld;
using tern_host::Thing;
using tern_host::ThingMotion;

/// It stays where it is.
struct Onlooker : tern_host::Vehicle {
  void fly_to(double, const tern_host::Setpoints&) override {}
  tern::Vec3 position() const override { return place; }
  tern::Vec3 velocity() const override { return {0.0, 0.0, 0.0}; }
  std::array<double, 4> attitude() const override { return {1.0, 0.0, 0.0, 0.0}; }
  tern::Vec3 estimate() const override { return tern_host::along(place, 1.0, pose_error); }
  tern::Vec3 place{0.125, 0.125, 1.125};
  tern::Vec3 pose_error{0.0, 0.0, 0.0};
};

/// A flight at rest in a room that is told of things.
struct ToldFlight {
  explicit ToldFlight(const std::vector<std::string>& lines, const std::vector<std::string>& settings = {}) {
    world.settings = tern_host::flight_settings(settings);
    for (const std::string& line : lines) {
      world.things.push_back(tern_host::read_thing(tern_host::split_words("thing " + line, false), {"world.txt", 1}));
    }
    for (const Thing& thing : world.things) motions.emplace_back(thing);
    detector = std::make_unique<Detector>(world, motions);
  }
  void tick() {
    detector->take(room.time, vehicle.position(), vehicle.estimate());
    detector->deliver(room.time, room.flight, tape);
    room.tick();
  }
  void ticks(int count) {
    for (int k = 0; k < count; ++k) tick();
  }

  FlightWorld world;
  std::vector<ThingMotion> motions;
  std::unique_ptr<Detector> detector;
  Onlooker vehicle;
  tern_test::FlightRoom room;
  tern_host::FlightTape tape{nullptr, 0};
};

const std::string kKnot = "knot box 0.4 0.4 0.4 trefoil 6 0 1 0.5 0.5 0.2 2 0.3 0";

TEST(ThingDetector, MeasuresAtItsRateAndLate) {
  ToldFlight told({kKnot}, {"detection_hz=10", "detection_latency=0.05"});
  told.ticks(5);
  EXPECT_EQ(told.detector->known(0), nullptr);
  told.tick();  // at 0.05 s
  ASSERT_NE(told.detector->known(0), nullptr);
  EXPECT_EQ(told.detector->known(0)->measured, 0);
  told.ticks(100);
  EXPECT_EQ(told.detector->counts().measured, 11u);
  EXPECT_EQ(told.detector->known(0)->measured, 1000000000);
}

// The thing is in the tube of each measurement, of which the error of the vehicle's own place is a part, for as long as
// one likes; and not in one that claims less.
TEST(ThingDetector, TubesHoldTheTruth) {
  ToldFlight told(
      {kKnot, "walker ball 0.3 walk 1.3 3 0 loop 3 3 1 0 8 3 1 2 8 -3 1 0", "hunter ball 0.3 hunt 5 5 1 2 4 20"},
      {"detection_error=0.05,0.2", "detection_latency=0.12", "pose_margin=0.1"});
  told.vehicle.pose_error = {0.06, -0.08, 0.0};
  tern_test::Random random(5);
  double farthest = 0.0;
  for (int k = 0; k < tern_test::scaled(2000); ++k) {
    for (ThingMotion& motion : told.motions)
      motion.hunt(1e-9 * static_cast<double>(told.room.time), 0.01, {0.0, 0.0, 1.0});
    told.tick();
    const double now = 1e-9 * static_cast<double>(told.room.time);
    for (std::size_t i = 0; i < told.motions.size(); ++i) {
      const tern::Track* const track = told.detector->known(i);
      if (track == nullptr) continue;
      const tern::Vec3 place = told.motions[i].at(now).position;
      EXPECT_TRUE(tern_host::is_in_tube(*track, told.world.things[i], place, told.room.time))
          << told.world.things[i].name << " at " << now;
      const double s = now - 1e-9 * static_cast<double>(track->measured);
      const tern::Vec3 expected = tern_host::along(track->position, s, track->velocity);
      farthest = std::fmax(farthest, tern_host::length(tern_host::along(expected, -1.0, place)));
    }
  }
  EXPECT_GT(farthest, 0.1);
}

// The things began to move half a second after the flight's clock.
TEST(ThingDetector, MeasuresOnTheFlightsClock) {
  ToldFlight told({"walker ball 0.3 walk 1.3 3 0 loop 3 3 1 0 8 3 1 2 8 -3 1 0"}, {"detection_latency=0"});
  constexpr std::int64_t kBegin = 500000000;
  told.detector = std::make_unique<Detector>(told.world, told.motions, kBegin, 70);
  while (told.room.time < kBegin) told.room.tick();
  for (int k = 0; k <= 100; ++k) {
    told.tick();
    const tern::Track* const track = told.detector->known(0);
    ASSERT_NE(track, nullptr);
    EXPECT_EQ(track->id, 70u);
    const tern::Vec3 place = told.motions[0].at(1e-9 * static_cast<double>(told.room.time - kBegin)).position;
    EXPECT_TRUE(tern_host::is_in_tube(*track, told.world.things[0], place, told.room.time)) << k;
  }
  EXPECT_EQ(told.detector->counts().measured, 11u);
}

TEST(ThingDetector, TubesAreComputedByHand) {
  const Thing point;
  tern::Track track;
  track.measured = 1000000000;
  track.position = {1.0, 0.0, 0.0};
  track.velocity = {2.0, 0.0, 0.0};
  track.error = 0.1;
  track.error_speed = 0.2;
  track.error_growth = 1.0;
  // A second later: 0.1 + 0.2 + 0.5 about (3, 0, 0).
  EXPECT_TRUE(tern_host::is_in_tube(track, point, {3.0, 0.79, 0.0}, 2000000000));
  EXPECT_FALSE(tern_host::is_in_tube(track, point, {3.0, 0.81, 0.0}, 2000000000));
  EXPECT_FALSE(tern_host::is_in_tube(track, point, {1.0, 0.0, 0.0}, 999999999));
  track.reach = 2.0;  // and within 2.1 of (1, 0, 0)
  EXPECT_TRUE(tern_host::is_in_tube(track, point, {3.05, 0.0, 0.0}, 2000000000));
  EXPECT_FALSE(tern_host::is_in_tube(track, point, {3.15, 0.0, 0.0}, 2000000000));
}

// A man of 0.3 x 1.8 m is in a track's cylinder of 0.5 x 2.4 m as long as all of him is.
TEST(ThingDetector, AThingIsInTheTubeOfALargerTrack) {
  Thing man;
  man.shape = tern::TrackShape::kCylinder;
  man.radius = 0.3;
  man.half.z = 0.9;
  tern::Track track;
  track.shape = tern::TrackShape::kCylinder;
  track.radius = 0.5;
  track.half.z = 1.2;
  track.error = 0.1;
  EXPECT_TRUE(tern_host::is_in_tube(track, man, {0.29, 0.0, 0.3}, 0));  // 0.2 m of room, and the error
  EXPECT_FALSE(tern_host::is_in_tube(track, man, {0.31, 0.0, 0.3}, 0));
  EXPECT_TRUE(tern_host::is_in_tube(track, man, {0.2, 0.0, -0.39}, 0));
  EXPECT_FALSE(tern_host::is_in_tube(track, man, {0.2, 0.0, -0.41}, 0));
  EXPECT_FALSE(tern_host::is_in_tube(track, man, {0.28, 0.0, 0.38}, 0)) << "0.08 m off twice";
  man.radius = 0.55;  // wider than the track, and within its error
  EXPECT_TRUE(tern_host::is_in_tube(track, man, {0.04, 0.0, 0.0}, 0));
  EXPECT_FALSE(tern_host::is_in_tube(track, man, {0.06, 0.0, 0.0}, 0));
}

// The clearance is 0.25 + 0.1 m.
TEST(ThingDetector, AVehicleMeetsATubeWithinItsClearance) {
  ToldFlight told({"ball ball 0.3 hunt 5 0 1 1 1 0"}, {"detection_latency=0", "detection_error=0.05,0"});
  told.tick();
  const tern::Track& track = *told.detector->known(0);
  const double x = track.position.x - 0.3 - 0.05 - 0.35;
  EXPECT_TRUE(told.detector->meets({x + 1e-3, track.position.y, track.position.z}, 0));
  EXPECT_FALSE(told.detector->meets({x - 1e-3, track.position.y, track.position.z}, 0));
  // A second later the tube is half a metre wider: it may accelerate with 1 m/s^2.
  EXPECT_TRUE(told.detector->meets({x - 0.499, track.position.y, track.position.z}, 1000000000));
  EXPECT_FALSE(told.detector->meets({x - 0.501, track.position.y, track.position.z}, 1000000000));
}

// A column with a radius of 0.3 m, 2 m high, measured without error at (2, 0, 1), and 0.2 m of room: 0.5 m beside
// and 1.2 m above its centre.
TEST(ThingDetector, HitsAtTheEdgeOfAGrownColumnAreItsOwn) {
  ToldFlight told({"column cylinder 0.3 2 hunt 2 0 1 1 1 0"}, {"detection_latency=0", "detection_error=0,0"});
  told.tick();
  EXPECT_TRUE(told.detector->explains({1.501, 0.0, 2.199}, 0, 0.2));
  EXPECT_FALSE(told.detector->explains({1.499, 0.0, 2.199}, 0, 0.2));
  EXPECT_FALSE(told.detector->explains({1.501, 0.0, 2.201}, 0, 0.2));
  EXPECT_FALSE(told.detector->explains({1.7, 0.0, 2.0}, 600000000, 0.2)) << "0.6 s after the measurement";
}

TEST(ThingDetector, SeesNeitherTooFarNorThroughWalls) {
  const std::string near = "near ball 0.3 hunt 5 0 1 1 1 0";
  const std::string far = "far ball 0.3 hunt 9 0 1 1 1 0";
  ToldFlight ranged({near, far}, {"detection_range=7", "detection_latency=0"});
  ranged.tick();
  EXPECT_NE(ranged.detector->known(0), nullptr);
  EXPECT_EQ(ranged.detector->known(1), nullptr);
  ToldFlight walled({near, far}, {"detection_occlusion=1", "detection_latency=0"});
  walled.world.blocks.push_back({{7.0, -1.0, 0.0}, {7.5, 1.0, 3.0}});
  walled.tick();
  EXPECT_NE(walled.detector->known(0), nullptr);
  EXPECT_EQ(walled.detector->known(1), nullptr);
  ToldFlight missing({near}, {"detection_misses=1", "detection_latency=0"});
  missing.ticks(50);
  EXPECT_EQ(missing.detector->known(0), nullptr);
}

// A ball that leaves the range of 7 m at 2 m/s is forgotten once it is expected to be outside.
TEST(ThingDetector, ForgetsWhatHasLeft) {
  ToldFlight told({"leaver ball 0.3 walk 2 100 0 5.125 0.125 1.125 0 50 0.125 1.125 0"},
                  {"detection_range=7", "detection_latency=0", "detection_error=0,0"});
  told.ticks(91);
  EXPECT_NE(told.detector->known(0), nullptr);
  told.ticks(20);
  EXPECT_EQ(told.detector->known(0), nullptr);
  EXPECT_EQ(told.room.flight.forget_track(0), tern::Status::kInvalidArgument);
}

TEST(ThingDetector, KeepsTheNearestOnes) {
  std::vector<std::string> lines;
  for (int k = 0; k < tern::kMaxFlightTracks + 10; ++k) {
    lines.push_back("t" + std::to_string(k) + " ball 0.1 hunt " + std::to_string(12.0 - 0.1 * k) + " 0 1 1 1 0");
  }
  ToldFlight told(lines, {"detection_latency=0"});
  told.tick();
  EXPECT_EQ(told.detector->counts().most_known, std::size_t{tern::kMaxFlightTracks});
  EXPECT_EQ(told.detector->counts().left_out, 10u);
  EXPECT_EQ(told.detector->known(9), nullptr);
  EXPECT_NE(told.detector->known(10), nullptr);
  told.vehicle.place = {13.0, 0.0, 1.0};  // now the others are the near ones
  told.ticks(11);
  EXPECT_NE(told.detector->known(0), nullptr);
  EXPECT_EQ(told.detector->known(lines.size() - 1), nullptr);
}

// Names change, what is measured does not.
TEST(ThingDetector, SwapsNamesAlone) {
  ToldFlight told({"a ball 0.3 hunt 5 1 1 1 1 0", "b ball 0.4 hunt 5 -1 1 1 1 0"},
                  {"detection_swaps=0.5", "detection_latency=0", "detection_error=0,0"});
  int swapped = 0;
  const int scans = tern_test::scaled(100);
  for (int k = 0; k < scans; ++k) {
    told.ticks(10);
    ASSERT_NE(told.detector->known(0), nullptr);
    ASSERT_NE(told.detector->known(1), nullptr);
    EXPECT_EQ(told.detector->known(0)->radius, 0.3);
    EXPECT_EQ(told.detector->known(0)->position.y, 1.0);
    EXPECT_EQ(told.detector->known(0)->id + told.detector->known(1)->id, 1u);
    swapped += told.detector->known(0)->id == 1 ? 1 : 0;
  }
  EXPECT_GT(swapped, 0);
  EXPECT_LT(swapped, scans);
}

TEST(ThingDetector, TellsWhatIsClaimed) {
  ToldFlight told({"a ball 0.3 hunt 5 1 1 2 4 0 claims 1 3", "b ball 0.3 hunt 5 -1 1 2 4 0"},
                  {"thing_bounds=0.5", "detection_latency=0"});
  told.tick();
  EXPECT_EQ(told.detector->known(0)->reach, 0.5);
  EXPECT_EQ(told.detector->known(0)->error_growth, 1.5);
  EXPECT_EQ(told.detector->known(1)->reach, 1.0);
  EXPECT_EQ(told.detector->known(1)->error_growth, 2.0);
}

/// The speed of flights that must stop for what comes from beyond the detector's range.
TEST(ThingDetector, SpeedIsLimitedByTheRange) {
  const auto speed = [](const std::vector<std::string>& settings) {
    return flight_spec_of(tern_host::flight_settings(settings)).limits.v_max.x;
  };
  const double fast = speed({});
  EXPECT_EQ(speed({"from_beyond=3,0.5", "detection_range=200"}), fast);
  const double slow = speed({"from_beyond=3,0.5", "detection_range=4"});
  EXPECT_LT(slow, fast);
  EXPECT_LT(speed({"from_beyond=3,0.5", "detection_range=4", "detection_latency=0.5"}), slow);
  EXPECT_LT(speed({"from_beyond=3,0.5", "detection_range=4", "detection_error=0.5,0.1"}), slow);
  EXPECT_THROW(speed({"from_beyond=3,0.5", "detection_range=1"}), std::runtime_error);
}

}  // namespace
