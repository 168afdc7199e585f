// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where pictures draw things that move, and that they do.
#include "host/track_sample.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

#include "host/page/page.hpp"
#include "host/picture/picture.hpp"
#include "host/scenario.hpp"
#include "host/session.hpp"
#include "tern/track_class.hpp"

namespace {

using tern_host::sample_of;
using tern_host::TrackSample;

constexpr std::int64_t kSecond = 1000000000;

tern::Track ball() {
  tern::Track track;
  track.measured = 2 * kSecond;
  track.position = {1.0, 2.0, 3.0};
  track.velocity = {0.5, 0.0, -1.0};
  track.radius = 0.25;
  track.error = 0.1;
  track.error_speed = 0.2;
  track.error_growth = 0.4;
  return track;
}

void expect_at(const TrackSample& sample, const tern::Vec3& place, double error) {
  EXPECT_TRUE(sample.is_there);
  EXPECT_DOUBLE_EQ(sample.place.x, place.x);
  EXPECT_DOUBLE_EQ(sample.place.y, place.y);
  EXPECT_DOUBLE_EQ(sample.place.z, place.z);
  EXPECT_DOUBLE_EQ(sample.error, error);
}

TEST(TrackSample, AlongAVelocity) {
  const tern::Track track = ball();
  EXPECT_FALSE(sample_of(track, 1.9).is_there);
  expect_at(sample_of(track, 2.0), {1.0, 2.0, 3.0}, 0.1);
  expect_at(sample_of(track, 4.0), {2.0, 2.0, 1.0}, 0.1 + 2.0 * 0.2 + 0.8);
}

TEST(TrackSample, PastItsEnd) {
  tern::Track track = ball();
  track.until = 3 * kSecond;
  track.reach = 0.0;
  track.end = tern::TrackEnd::kGone;
  EXPECT_TRUE(sample_of(track, 3.0).is_there);
  EXPECT_FALSE(sample_of(track, 3.1).is_there);
  track.end = tern::TrackEnd::kStays;
  expect_at(sample_of(track, 9.0), {1.5, 2.0, 2.0}, 0.1 + 0.2 + 0.2);
}

/// The ball that it can reach is the smaller tube from the beginning on.
TEST(TrackSample, TheSmallerTube) {
  tern::Track track = ball();
  track.reach = 0.25;
  expect_at(sample_of(track, 4.0), {1.0, 2.0, 3.0}, 0.1 + 0.5);
}

TEST(TrackSample, AlongPieces) {
  tern::Track track = ball();
  tern::TrackPiece piece{};
  piece.duration = 2.0;
  for (int k = 0; k < tern::kControlPoints; ++k) piece.points[k] = {k / 7.0, 0.0, 0.0};
  track.pieces = &piece;
  track.piece_count = 1;
  EXPECT_NEAR(sample_of(track, 3.0).place.x, 1.5, 1e-12);
  EXPECT_DOUBLE_EQ(sample_of(track, 30.0).place.x, 2.0);
}

/// The surface of a ball, a cylinder and a box is as far from the centre as it should be.
TEST(TrackSample, Surfaces) {
  tern::Track track = ball();
  TrackSample sample{true, {1.0, 1.0, 1.0}, 0.5};
  for (const tern::Vec3& p : surface_of(track, sample)) {
    EXPECT_NEAR(std::hypot(std::hypot(p.x - 1.0, p.y - 1.0), p.z - 1.0), 0.75, 1e-12);
  }
  track.shape = tern::TrackShape::kCylinder;
  track.half.z = 2.0;
  double top = 0.0;
  for (const tern::Vec3& p : surface_of(track, sample)) {
    EXPECT_NEAR(std::hypot(p.x - 1.0, p.y - 1.0), 0.75, 1e-12);
    top = std::max(top, p.z);
  }
  EXPECT_DOUBLE_EQ(top, 3.5);
  track.shape = tern::TrackShape::kBox;
  track.half = {0.5, 1.0, 2.0};
  EXPECT_EQ(surface_of(track, sample).size(), 8u);
  EXPECT_DOUBLE_EQ(surface_of(track, sample).back().y, 2.5);
}

/// The table of docs/tracks.md: what a thing of a class may be off 1, 2, 4 and 8 s after a measurement without error.
TEST(TrackSample, ClassesGrowAsThePageSays) {
  constexpr double kTimes[] = {1.0, 2.0, 4.0, 8.0};
  constexpr double kOff[][4] = {{1.5, 6, 12, 24},   {3, 12, 48, 100},   {4.5, 18, 72, 160}, {4, 16, 64, 224},
                                {7.5, 30, 92, 184}, {5.5, 22, 80, 160}, {8.5, 34, 136, 544}};
  static_assert(std::size(kOff) == tern::kTrackClasses);
  for (std::size_t c = 0; c < std::size(kOff); ++c) {
    tern::Track track;
    ASSERT_EQ(tern::track_of_class(static_cast<tern::TrackClass>(c), track), tern::Status::kOk);
    for (std::size_t k = 0; k < std::size(kTimes); ++k) EXPECT_DOUBLE_EQ(sample_of(track, kTimes[k]).error, kOff[c][k]);
  }
}

int count_of(const std::string& text, const std::string& part) {
  int count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(TrackSample, PicturesAndPagesShowThem) {
  const tern_host::Scenario scenario = tern_host::parse_scenario(
      "boundary 0 0 0 12 8 3\nradius 0.3\nstart 1 4 1.5\ngoal 11 4 1.5\n"
      "track man cylinder 0.3 1.8 at 6 8 0.9 velocity 0 -1 0 error 0.05 0.05 0\n"
      "keepout 3 6 0 5 8 3 during 1 4\nkeepin 0 0 0 12 8 2.5 during -1 100\n",
      "test");
  tern_host::Session session;
  const tern_host::PlanResult result = session.plan(scenario);
  ASSERT_TRUE(result.ok());
  const std::string svg = tern_host::plan_svg(result);
  EXPECT_EQ(count_of(svg, "class=\"thing\""), 3);                // two views and the legend
  EXPECT_EQ(count_of(svg, "class=\"keepout-for-a-while\""), 3);  // likewise
  EXPECT_GT(count_of(svg, "class=\"sweep\""), 60);
  const std::string run = tern_host::plan_run(result);
  EXPECT_NE(run.find("\"things\":[{\"name\":\"man\",\"fence\":false,\"shape\":\"cylinder\""), std::string::npos);
  EXPECT_NE(run.find("\"windows\":[[-1.0,100.0]]"), std::string::npos);
  EXPECT_GT(count_of(run, "null"), 5);  // the keep-out is there from 1 s to 4 s
}

}  // namespace
