// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which sightings of things that move a vehicle takes, and what a flight is told of them.
#include "tern_onboard/things.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "host/flight/flight_replay.hpp"
#include "onboard/onboard_sky.hpp"
#include "tern_onboard/map_spec.hpp"
#include "tern_onboard/onboard.hpp"

namespace {

using tern_onboard::Fault;
using tern_onboard::Sighting;
using tern_onboard::Things;
using tern_test::kMs;
using tern_test::Sky;

constexpr std::int64_t kSecond = 1000 * kMs;

Sighting sighting_of(const std::string& name, double x, std::int64_t stamp) {
  Sighting sighting;
  sighting.name = name;
  sighting.position = {x, 0.0, 1.0};
  sighting.stamp = stamp;
  return sighting;
}

class Book {
 public:
  explicit Book(const tern_onboard::ThingSettings& settings = {}) : things(settings) {}
  void add(const Sighting& sighting) { things.add(sighting, &here, now, notices); }
  std::uint64_t count(Fault fault) const { return notices.counts()[static_cast<std::size_t>(fault)]; }

  Things things;
  tern_onboard::Notices notices;
  tern::Vec3 here{};
  std::int64_t now = 100 * kSecond;
};

TEST(OnboardThings, RefuseWhatIsNoSighting) {
  Book book;
  book.add(sighting_of("", 1.0, book.now));
  Sighting bad = sighting_of("a", std::nan(""), book.now);
  book.add(bad);
  bad = sighting_of("a", 1.0, book.now);
  bad.deviation = -0.1;
  book.add(bad);
  bad.deviation = std::nan("");
  book.add(bad);
  bad = sighting_of("a", 1.0, book.now);
  bad.has_velocity = true;
  bad.velocity.z = INFINITY;
  book.add(bad);
  EXPECT_EQ(book.count(Fault::kThingInvalid), 5u);
  EXPECT_EQ(book.notices.take().size(), 1u) << "said once";
  book.add(sighting_of("a", 1.0, book.now + 21 * kMs));
  EXPECT_EQ(book.count(Fault::kThingAhead), 1u);
  book.add(sighting_of("a", 1.0, book.now - 10001 * kMs));
  EXPECT_EQ(book.count(Fault::kThingOld), 1u);
  EXPECT_EQ(book.things.count(), 0u);
  book.add(sighting_of("a", 1.0, book.now - 9999 * kMs));
  book.add(sighting_of("a", 1.0, book.now - 9999 * kMs));
  EXPECT_EQ(book.count(Fault::kThingBackward), 1u);
  EXPECT_EQ(book.things.count(), 1u);
}

TEST(OnboardThings, AreForgottenAfterTheirMemoryAndBeyondTheirRange) {
  Book book;
  book.add(sighting_of("a", 10.0, book.now));
  book.add(sighting_of("b", 1002.0, book.now));  // 0.4 m of it are beyond
  EXPECT_EQ(book.things.count(), 1u);
  book.add(sighting_of("b", 1000.3, book.now));
  EXPECT_EQ(book.things.count(), 2u);
  book.now += 6 * kSecond;
  book.add(sighting_of("b", 5000.0, book.now));
  EXPECT_EQ(book.things.count(), 1u) << "it went away";
  book.now += 5 * kSecond;
  book.add(sighting_of("c", 1.0, book.now));
  EXPECT_EQ(book.things.count(), 1u) << "nobody reports a";
  tern_onboard::ThingSettings none;
  none.range = 0.0;
  Book blind(none);
  blind.add(sighting_of("a", 1.0, blind.now));
  blind.add(sighting_of("b", 0.1, blind.now));  // the vehicle is within it
  EXPECT_EQ(blind.things.count(), 0u);
}

TEST(OnboardThings, OfTooManyTheNearestCount) {
  Book book;
  const int most = tern::kMaxFlightTracks;
  for (int k = 0; k < most; ++k) book.add(sighting_of("t" + std::to_string(k), 100.0 + k, book.now));
  book.add(sighting_of("far", 500.0, book.now));
  EXPECT_EQ(book.count(Fault::kThingsFull), 1u);
  EXPECT_EQ(book.things.count(), static_cast<std::size_t>(most));
  book.add(sighting_of("near", 5.0, book.now));
  EXPECT_EQ(book.count(Fault::kThingsFull), 1u);
  EXPECT_EQ(book.things.count(), static_cast<std::size_t>(most));
  // The last of them gave way.
  book.add(sighting_of("t" + std::to_string(most - 1), 100.0 + most - 1, book.now + kMs));
  EXPECT_EQ(book.count(Fault::kThingsFull), 2u);
}

/// A forest, and a person who walks across the way at 1.2 m/s.
struct Crossing {
  bool is_reported = true;
  tern::Vec3 meet{}, ahead{};  // where, and along which way of the vehicle
  double at = 0.0;             // s since the flight begins
  // What came of it.
  double least = 1e9;  // m, between the body's centre and the person's axis
  bool arrived = false;
  std::vector<tern::Vec3> way;  // of the vehicle, every 10 ms
  std::string record;

  void fly() {
    Sky sky("P49:20001", [](tern_onboard::Settings& s) { s.fly.ceiling = 2.2; });
    sky.onboard.record_flights();
    ASSERT_TRUE(sky.begin().ok);
    for (int k = 0; k < 6000 && !arrived; ++k) {
      const double side = 1.2 * (0.01 * k - at);
      const tern::Vec3 person{meet.x - side * ahead.y, meet.y + side * ahead.x, 1.0};
      if (is_reported && k % 10 == 0) sky.onboard.add_sighting(seen(person, sky.now), sky.now);
      least = std::min(least, std::hypot(sky.position.x - person.x, sky.position.y - person.y));
      sky.step();
      way.push_back(sky.position);
      const tern::FlightReport report = sky.onboard.status(sky.now).report;
      arrived = report.mode == tern::FlightMode::kRest && report.reason == tern::FlightReason::kArrived;
    }
    for (const tern_onboard::RecordPart& part : sky.onboard.take_record()) {
      if (!record.empty()) record.resize(record.size() - tern_onboard::kRecordEnd);
      record.append(part.bytes.begin(), part.bytes.end());
    }
  }
  Sighting seen(const tern::Vec3& person, std::int64_t stamp) const {
    Sighting sighting;
    sighting.name = "person";
    sighting.stamp = stamp;
    sighting.position = person;
    sighting.has_velocity = true;
    sighting.velocity = {-1.2 * ahead.y, 1.2 * ahead.x, 0.0};
    sighting.deviation = sighting.speed_deviation = 0.02;
    return sighting;
  }
};

TEST(OnboardThings, AFlightKeepsClearOfAPersonAndItsRecordReplays) {
  Crossing alone;
  alone.is_reported = false;
  alone.fly();
  ASSERT_TRUE(alone.arrived);
  // Where the vehicle is after 5 s of it, the person is then.
  Crossing blind, seeing;
  const tern::Vec3 step = tern_onboard::minus(alone.way[520], alone.way[500]);
  blind.meet = seeing.meet = alone.way[500];
  blind.ahead = seeing.ahead = tern_onboard::times(step, 1.0 / std::hypot(step.x, step.y));
  blind.at = seeing.at = 5.0;
  blind.is_reported = false;
  blind.fly();
  EXPECT_LT(blind.least, 0.4) << "the person does cross the way";
  seeing.fly();
  EXPECT_TRUE(seeing.arrived);
  EXPECT_GT(seeing.least, 0.4 + 0.3);
  EXPECT_EQ(tern_host::replay_flight(seeing.record).difference, "");
}

TEST(OnboardThings, AFlightForgetsWhatNobodyReports) {
  Sky sky("P49:20001", [](tern_onboard::Settings& s) { s.things.memory = 2.0; });
  Sighting wall = sighting_of("truck", 0.0, sky.now);
  wall.kind = tern::TrackClass::kTruck;
  wall.position = sky.world.goal;
  sky.onboard.add_sighting(wall, sky.now);  // before the flight begins
  ASSERT_TRUE(sky.begin().ok);
  EXPECT_EQ(sky.onboard.status(sky.now).things, 1u);
  EXPECT_NE(sky.fly(1.9), tern::FlightReason::kArrived);
  EXPECT_EQ(sky.onboard.status(sky.now).report.blocked_by, tern::BlockedBy::kTrack);
  EXPECT_EQ(sky.fly(60.0), tern::FlightReason::kArrived) << "the truck is gone";
  EXPECT_EQ(sky.onboard.status(sky.now).things, 0u);
}

TEST(OnboardThings, SurviveAClockThatIsSetBackAndAJump) {
  Sky sky("P49:20001");
  ASSERT_TRUE(sky.begin().ok);
  for (int k = 0; k < 100; ++k) sky.step();
  sky.onboard.add_sighting(sighting_of("a", sky.position.x + 30.0, sky.now), sky.now);
  sky.step();
  sky.now -= 4000 * kMs;
  sky.step();
  EXPECT_EQ(sky.onboard.status(sky.now).things, 1u);
  sky.onboard.add_sighting(sighting_of("a", sky.position.x + 30.0, sky.now), sky.now);
  sky.step();
  sky.jump({0.5, 0.0, 0.0});
  sky.onboard.add_sighting(sighting_of("a", sky.position.x + 30.5, sky.now), sky.now);
  sky.step();
  const tern_onboard::Status status = sky.onboard.status(sky.now);
  EXPECT_EQ(status.things, 1u);
  EXPECT_EQ(status.faults[static_cast<std::size_t>(Fault::kThingBackward)], 0u);
  EXPECT_EQ(status.faults[static_cast<std::size_t>(Fault::kThingInvalid)], 0u);
}

/// The nearer a detector sees, the slower the vehicle flies; where no speed is slow enough, it does not.
TEST(OnboardThings, SpeedIsLimitedByTheDetectorsRange) {
  tern_onboard::Settings settings;
  const double fast = flight_spec_of(settings).limits.v_max.x;
  const auto slowed = [&](double range) {
    settings.things.detector_range = range;
    tern::FlightSpec spec = flight_spec_of(settings);
    const tern::Status status = slow_for_beyond(settings, spec);
    return status == tern::Status::kOk ? spec.limits.v_max.x : -1.0;
  };
  EXPECT_EQ(slowed(0.5), fast);
  settings.things.beyond_speed = 3.0;
  EXPECT_EQ(slowed(200.0), fast);
  EXPECT_LT(slowed(8.0), fast);
  EXPECT_LT(slowed(6.0), slowed(8.0));
  EXPECT_EQ(slowed(0.5), -1.0);
  EXPECT_THROW(tern_onboard::Onboard{settings}, std::invalid_argument);
}

}  // namespace
