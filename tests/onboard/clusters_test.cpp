// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Flights that track what their own sensors see move, with the parameter `clusters`.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "onboard/onboard_lookout.hpp"

namespace {

using tern::Vec3;
using tern_onboard::Settings;
using tern_test::kCentisecond;
using tern_test::kTenth;
using tern_test::Lookout;
using tern_test::Told;

/// Of each tick in which a thing was new or measured anew, after its first second: how it was measured.
void expect_the_man(const Lookout& lookout, const std::vector<Told>& told) {
  ASSERT_FALSE(told.empty());
  EXPECT_LE(told.front().t - Lookout::kBegin, 10 * kTenth) << "he has walked by his width";
  std::int64_t last = 0;
  int measured = 0;
  for (const Told& one : told) {
    const tern::Track& track = one.track;
    if (track.measured == last) continue;
    last = track.measured;
    ++measured;
    EXPECT_EQ((track.measured + lookout.late) % kTenth, 0) << "the stamp of a frame";
    EXPECT_LE(one.t - track.measured, lookout.late + kCentisecond) << "in the tick in which the frame enters the map";
    const double t = 1e-9 * static_cast<double>(track.measured - Lookout::kBegin);
    const Vec3 man = lookout.scene.man_at(t);
    const double off = std::hypot(track.position.x - man.x, track.position.y - man.y);
    EXPECT_LE(off + std::hypot(0.2, 0.25), track.radius + track.error) << t;
    EXPECT_GE(track.position.z + track.half.z, 1.8);
    EXPECT_NEAR(track.position.z - track.half.z, 0.0, 0.05) << "he stands on the ground";
    EXPECT_EQ(track.kind, static_cast<std::uint32_t>(tern::TrackClass::kPerson));
    if (one.t - told.front().t < 10 * kTenth) continue;
    EXPECT_LT(off, 0.3) << t;
    EXPECT_LT(std::hypot(track.velocity.x, track.velocity.y + 1.0), 0.2) << t;
  }
  EXPECT_GE(measured, 20);
}

TEST(OnboardClusters, TrackAManInDepthImages) {
  Lookout lookout;
  lookout.add_camera();
  lookout.scene.noise = 0.01;
  lookout.late = 5 * kCentisecond;
  lookout.fly(3.0);
  EXPECT_EQ(lookout.most, 1u);
  expect_the_man(lookout, lookout.told());
}

TEST(OnboardClusters, TrackAManInScans) {
  Lookout lookout;
  lookout.add_lidar();
  lookout.scene.noise = 0.01;
  lookout.fly(3.0);
  EXPECT_EQ(lookout.most, 1u);
  expect_the_man(lookout, lookout.told());
}

TEST(OnboardClusters, AreOffByDefault) {
  EXPECT_EQ(Settings{}.things.clusters, "none");
  EXPECT_EQ(tern_tracker::detector_of({}), nullptr);
  Lookout lookout("none");
  lookout.add_camera();
  lookout.fly(2.0);
  EXPECT_EQ(lookout.most, 0u);
  EXPECT_TRUE(lookout.told().empty());
}

/// Nor does the ground in the ball that was stated to be free.
TEST(OnboardClusters, AreNoneWhereAllStandsStill) {
  for (const bool is_scan : {false, true}) {
    Lookout lookout("person", [](Settings& s) { s.map.free_radius = 4.0; });
    is_scan ? lookout.add_lidar() : lookout.add_camera();
    lookout.scene.has_man = false;
    lookout.scene.noise = 0.015;
    lookout.fly(2.0);
    EXPECT_EQ(lookout.most, 0u) << is_scan;
    EXPECT_GT(lookout.onboard->status(lookout.now).sensors[0].taken, 15u);
  }
}

TEST(OnboardClusters, SayThatTheyAreOnAndThatTheGroundIsNotKnown) {
  for (const bool is_known : {true, false}) {
    const Lookout lookout("drone", [is_known](Settings& s) { s.fly.ground = is_known ? 0.0 : -1000.0; });
    const auto notices = lookout.onboard->take_notices();
    ASSERT_EQ(notices.size(), 1u);
    EXPECT_EQ(notices[0].text.find("what the sensors see move is tracked, as of class drone"), 0u);
    EXPECT_EQ(notices[0].text.find("ground is not set") == std::string::npos, is_known);
    EXPECT_EQ(notices[0].bad, !is_known);
  }
}

/// The flight's frame does not jump, and the tracker works in that.
TEST(OnboardClusters, GoOnAroundAJumpOfTheEstimate) {
  Lookout lookout;
  lookout.add_camera();
  lookout.fly(1.5);
  lookout.jump({0.7, -0.9, 0.0});
  lookout.fly(1.5);
  EXPECT_EQ(lookout.onboard->status(lookout.now).offset.x, 0.7);
  EXPECT_EQ(lookout.most, 1u);
  expect_the_man(lookout, lookout.told());
}

TEST(OnboardClusters, AreRememberedForAsLongAsOtherThings) {
  Lookout lookout("person", [](Settings& s) { s.things.memory = 1.0; });
  lookout.add_camera();
  lookout.fly(2.0);
  lookout.scene.has_man = false;
  lookout.fly(0.9);
  EXPECT_EQ(lookout.things(), 1u);
  lookout.fly(0.3);
  EXPECT_EQ(lookout.things(), 0u);
}

TEST(OnboardClusters, BeginAnewWithAFlightAndAClock) {
  Lookout lookout;
  lookout.add_camera();
  lookout.fly(1.5);
  EXPECT_EQ(lookout.things(), 1u);
  lookout.onboard->set_following(false);
  lookout.onboard->set_following(true);
  lookout.begun = lookout.now;
  lookout.fly(1.0);
  EXPECT_EQ(lookout.things(), 2u) << "who was seen in the first flight may be elsewhere now";
  lookout.now -= 5 * kTenth;
  lookout.begun = lookout.now + kCentisecond;
  lookout.fly(0.5);
  EXPECT_EQ(lookout.things(), 3u) << "nor is a name of before the clock was set used again";
}

TEST(OnboardClusters, AreThoseOfEachSensor) {
  Lookout lookout;
  lookout.add_camera();
  lookout.add_camera();
  lookout.add_lidar();
  lookout.fly(2.0);
  EXPECT_EQ(lookout.things(), 3u) << "all with the same stamps";
}

}  // namespace
