// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "flight/track_table.hpp"

#include <gtest/gtest.h>

#include <memory>

namespace {

using namespace tern;

constexpr std::int64_t kTwoSeconds = 2000000000;

/// At 1 m/s along x, within 0.1 + 0.2 s + s^2 / 2: after 2 s within 2.5 m of (2, 0, 0).
Track walker() {
  Track track;
  track.id = 3;
  track.velocity = {1.0, 0.0, 0.0};
  track.radius = 0.3;
  track.error = 0.1;
  track.error_speed = 0.2;
  track.error_growth = 1.0;
  return track;
}

Track measured_at(double x, std::int64_t t) {
  Track track = walker();
  track.measured = t;
  track.position = {x, 0.0, 0.0};
  return track;
}

// The measurement is wrong by up to 0.1 m itself.
TEST(TrackTable, AMeasurementRefutesATubeThatItIsOutsideOf) {
  EXPECT_FALSE(refutes(measured_at(4.59, kTwoSeconds), walker()));
  EXPECT_TRUE(refutes(measured_at(4.61, kTwoSeconds), walker()));
  EXPECT_FALSE(refutes(measured_at(-0.59, kTwoSeconds), walker()));
  EXPECT_TRUE(refutes(measured_at(-0.61, kTwoSeconds), walker()));
}

// It reaches 0.1 + 2 * 1.5 = 3.1 m.
TEST(TrackTable, AMeasurementRefutesWhatTheThingCouldReach) {
  Track tube = walker();
  tube.reach = 1.5;
  Track late = measured_at(3.19, kTwoSeconds);
  late.reach = 1.5;
  EXPECT_FALSE(refutes(late, tube));
  late.position.x = 3.21;
  EXPECT_TRUE(refutes(late, tube));
}

// It stops after a second, at (1, 0, 0), with an error of 0.1 + 0.2 + 0.5 = 0.8 m.
TEST(TrackTable, TubesThatEndAreRefutedByTheirEnd) {
  Track tube = walker();
  tube.until = kTwoSeconds / 2;
  Track late = measured_at(1.89, kTwoSeconds);
  late.until = tube.until + kTwoSeconds;
  tube.end = late.end = TrackEnd::kStays;
  EXPECT_FALSE(refutes(late, tube));
  late.position.x = 1.91;
  EXPECT_TRUE(refutes(late, tube));
  tube.end = late.end = TrackEnd::kReach;  // 0.5 m more
  tube.reach = late.reach = 0.5;
  late.position.x = 1.19;  // it reaches 0.1 + 2 * 0.5 = 1.1 m
  EXPECT_FALSE(refutes(late, tube));
  late.position.x = 1.21;
  EXPECT_TRUE(refutes(late, tube));
  tube.end = late.end = TrackEnd::kGone;
  late.position.x = 1.0;
  EXPECT_TRUE(refutes(late, tube));
}

TEST(TrackTable, LargerThingsAndThoseThatMayDoMoreRefute) {
  const auto refuted = [](void (*change)(Track&)) {
    Track tube = walker();
    tube.reach = 2.0;
    Track now = tube;
    change(now);
    return refutes(now, tube);
  };
  EXPECT_FALSE(refuted([](Track&) {}));
  EXPECT_TRUE(refuted([](Track& t) { t.radius = 0.31; }));
  EXPECT_TRUE(refuted([](Track& t) { t.half.z = 0.01; }));
  EXPECT_TRUE(refuted([](Track& t) { t.shape = TrackShape::kBox; }));
  EXPECT_TRUE(refuted([](Track& t) { t.error_growth = 1.1; }));
  EXPECT_TRUE(refuted([](Track& t) { t.reach = 2.1; }));
  EXPECT_TRUE(refuted([](Track& t) { t.reach = 0.0; }));
  EXPECT_FALSE(refuted([](Track& t) { t.reach = 1.9; }));
}

TEST(TrackTable, KeepsTheLastMeasurementOfEach) {
  const auto table = std::make_unique<TrackTable>();
  EXPECT_EQ(table->update(measured_at(1.0, 10), 10), Status::kOk);
  EXPECT_EQ(table->update(measured_at(2.0, 9), 10), Status::kClockBehind);
  EXPECT_EQ(table->tracks[0].position.x, 1.0);
  EXPECT_EQ(table->update(measured_at(2.0, 10), 10), Status::kOk);
  EXPECT_EQ(table->count, 1);
  EXPECT_EQ(table->tracks[0].position.x, 2.0);
  EXPECT_FALSE(table->forget(4));
  EXPECT_TRUE(table->forget(3));
  EXPECT_EQ(table->count, 0);
}

TEST(TrackTable, WhatIsGoneMakesRoom) {
  const auto table = std::make_unique<TrackTable>();
  Track track = walker();
  track.until = 100;
  track.end = TrackEnd::kGone;
  for (int k = 0; k < kMaxFlightTracks; ++k) {
    track.id = static_cast<std::uint32_t>(k);
    if (k == 1) track.end = TrackEnd::kStays;
    EXPECT_EQ(table->update(track, 0), Status::kOk);
  }
  track.id = kMaxFlightTracks;
  EXPECT_EQ(table->update(track, 100), Status::kTracksFull);
  EXPECT_EQ(table->update(track, 101), Status::kOk);
  EXPECT_EQ(table->count, kMaxFlightTracks);
  EXPECT_EQ(table->tracks[0].id, 1u);
}

// A plan's tubes stay as they are until a measurement refutes one, or is of a thing that the plan does not know.
TEST(TrackTable, TakesOnlyNews) {
  const auto latest = std::make_unique<TrackTable>();
  const auto tubes = std::make_unique<TrackTable>();
  latest->update(measured_at(0.0, 0), 0);
  EXPECT_TRUE(tubes->take_news(*latest));
  EXPECT_FALSE(tubes->take_news(*latest));
  latest->update(measured_at(2.5, kTwoSeconds), kTwoSeconds);
  EXPECT_FALSE(tubes->take_news(*latest));
  EXPECT_EQ(tubes->tracks[0].measured, 0);
  latest->update(measured_at(6.0, kTwoSeconds), kTwoSeconds);
  EXPECT_TRUE(tubes->take_news(*latest));
  EXPECT_EQ(tubes->tracks[0].measured, kTwoSeconds);
  EXPECT_EQ(tubes->count, 1);
}

// The tubes of a plan may be of things that were forgotten since. Without room, the plan takes all that is known.
TEST(TrackTable, TakesAllWithoutRoom) {
  const auto latest = std::make_unique<TrackTable>();
  const auto tubes = std::make_unique<TrackTable>();
  Track track = walker();
  for (int k = 0; k < kMaxFlightTracks; ++k) {
    track.id = static_cast<std::uint32_t>(100 + k);
    latest->update(track, 0);
  }
  EXPECT_TRUE(tubes->take_news(*latest));
  latest->clear();
  track.id = 1;
  latest->update(track, 0);
  EXPECT_TRUE(tubes->take_news(*latest));
  EXPECT_EQ(tubes->count, 1);
  EXPECT_EQ(tubes->tracks[0].id, 1u);
}

// After 2 s: at (2, 0, 0), 2.5 m of error. It can reach 0.1 + 2 * 1.5 = 3.1 m, or 2.1 m if it does 1 m/s.
TEST(TrackTable, ExpectsThingsToGoOn) {
  const auto latest = std::make_unique<TrackTable>();
  const auto expected = std::make_unique<TrackTable>();
  Track track = walker();
  track.reach = 1.5;
  latest->update(track, 0);
  track.id = 4;
  track.reach = 1.0;
  latest->update(track, 0);
  track.id = 5;
  track.error_growth = 0.0;
  latest->update(track, 0);
  expected->expect(*latest, kTwoSeconds);
  const Track& goes_on = expected->tracks[0];
  EXPECT_EQ(goes_on.measured, kTwoSeconds);
  EXPECT_EQ(goes_on.position.x, 2.0);
  EXPECT_EQ(goes_on.velocity.x, 1.0);
  EXPECT_DOUBLE_EQ(goes_on.error, 2.5);
  EXPECT_DOUBLE_EQ(goes_on.error_speed, 0.2 + kExpectedDrift);
  EXPECT_EQ(goes_on.error_growth, 0.0);
  const Track& is_anywhere = expected->tracks[1];
  EXPECT_EQ(is_anywhere.position.x, 0.0);
  EXPECT_EQ(is_anywhere.velocity.x, 0.0);
  EXPECT_DOUBLE_EQ(is_anywhere.error, 2.1);
  EXPECT_EQ(is_anywhere.error_speed, 1.0);
  EXPECT_EQ(expected->tracks[2].measured, 0);  // as it was stated
}

}  // namespace
