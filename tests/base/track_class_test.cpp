// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Classes of things, with the figures of docs/tracks.md, which the test reads there.
#include "tern/track_class.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <string>

#include "base/track_fault.hpp"
#include "tern/tern.h"

namespace tern {
namespace {

/// A row of the page's table: | `kPerson` | cylinder | 0.4 m | 2 m | 3 m/s | 3 m/s² | why |.
struct Row {
  std::string name, shape;
  double radius = 0.0, height = 0.0, speed = 0.0, acceleration = 0.0;
};

std::vector<Row> rows_of_page() {
  std::ifstream page(TERN_SOURCE_DIR "/docs/tracks.md");
  std::vector<Row> rows;
  for (std::string line; std::getline(page, line);) {
    char name[40], shape[40];
    Row row;
    const int read = std::sscanf(line.c_str(), "| `%39[A-Za-z]` | %39[a-z] | %lf m | %lf m | %lf m/s | %lf m/s", name,
                                 shape, &row.radius, &row.height, &row.speed, &row.acceleration);
    if (read != 6) continue;
    row.name = name;
    row.shape = shape;
    rows.push_back(row);
  }
  return rows;
}

TEST(TrackClasses, AreThoseOfThePage) {
  const std::vector<Row> rows = rows_of_page();
  ASSERT_EQ(rows.size(), static_cast<std::size_t>(kTrackClasses));
  for (std::uint32_t k = 0; k < rows.size(); ++k) {
    const Row& row = rows[k];
    Track track;
    ASSERT_EQ(track_of_class(static_cast<TrackClass>(k), track), Status::kOk);
    EXPECT_EQ(track.kind, k) << row.name;
    EXPECT_EQ(track.shape, row.shape == "ball" ? TrackShape::kBall : TrackShape::kCylinder) << row.name;
    EXPECT_EQ(track.radius, row.radius) << row.name;
    EXPECT_EQ(track.shape == TrackShape::kBall ? 2.0 * track.radius : 2.0 * track.half.z, row.height) << row.name;
    EXPECT_EQ(track.reach, row.speed) << row.name;
    EXPECT_EQ(track.error_growth, row.acceleration) << row.name;
    EXPECT_EQ(find_track_fault(&track, 1).status, Status::kOk) << row.name;
  }
}

TEST(TrackClasses, LeaveNothingOfWhatWasThere) {
  Track track;
  track.measured = 5;
  track.velocity = {1.0, 2.0, 3.0};
  track.half = {4.0, 5.0, 6.0};
  track.error = track.error_speed = 7.0;
  track.id = 8;
  track.end = TrackEnd::kGone;
  ASSERT_EQ(track_of_class(TrackClass::kBird, track), Status::kOk);
  EXPECT_EQ(track.measured, 0);
  EXPECT_EQ(track.velocity.x, 0.0);
  EXPECT_EQ(track.half.x + track.half.y + track.half.z, 0.0);
  EXPECT_EQ(track.error + track.error_speed, 0.0);
  EXPECT_EQ(track.id, 0u);
  EXPECT_EQ(track.end, TrackEnd::kGoesOn);
}

TEST(TrackClasses, RefuseNumbersThatAreNone) {
  Track track;
  track.radius = 0.25;
  EXPECT_EQ(track_of_class(static_cast<TrackClass>(kTrackClasses), track), Status::kInvalidArgument);
  EXPECT_EQ(track_of_class(static_cast<TrackClass>(255), track), Status::kInvalidArgument);
  EXPECT_EQ(track.radius, 0.25);
}

TEST(TrackClasses, AreTheSameInC) {
  const std::uint8_t invalid = static_cast<std::uint8_t>(Status::kInvalidArgument);
  const int classes[] = {TERN_TRACK_PERSON, TERN_TRACK_CYCLIST, TERN_TRACK_CAR,     TERN_TRACK_TRUCK,
                         TERN_TRACK_BIRD,   TERN_TRACK_DRONE,   TERN_TRACK_AIRCRAFT};
  ASSERT_EQ(sizeof classes / sizeof *classes, static_cast<std::size_t>(kTrackClasses));
  for (int k = 0; k < kTrackClasses; ++k) {
    EXPECT_EQ(classes[k], k);
    tern_track of_c{};
    Track track;
    ASSERT_EQ(tern_track_of_class(static_cast<std::uint8_t>(k), &of_c), 0);
    ASSERT_EQ(track_of_class(static_cast<TrackClass>(k), track), Status::kOk);
    EXPECT_EQ(of_c.radius, track.radius);
    EXPECT_EQ(of_c.half.z, track.half.z);
    EXPECT_EQ(of_c.reach, track.reach);
    EXPECT_EQ(of_c.error_growth, track.error_growth);
    EXPECT_EQ(of_c.shape, track.shape);
    EXPECT_EQ(of_c.kind, track.kind);
  }
  EXPECT_EQ(tern_track_of_class(0, nullptr), invalid);
  tern_track untouched{};
  EXPECT_EQ(tern_track_of_class(7, &untouched), invalid);
}

}  // namespace
}  // namespace tern
