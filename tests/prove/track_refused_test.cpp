// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Tracks, lists of them and trajectories that the proof refuses.

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "prove/track_answers.hpp"
#include "support/timed_proof.hpp"
#include "tern/track_proof.hpp"

namespace {

using namespace tern;
using tern_test::along_x;
using tern_test::ball_at;
using tern_test::prove;
using tern_test::refused;
using tern_test::TimedAnswer;

void expect_refused(const Track& track, Status status) {
  std::int32_t which = kNoTrack;
  EXPECT_EQ(refused(track, which), status);
  EXPECT_EQ(which, 1);
}

TEST(TrackProof, RefusesTracksThatAreNone) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::int32_t which = kNoTrack;
  EXPECT_EQ(refused(Track{}, which), Status::kRunning);
  Track track;
  track.position.y = kNan;
  expect_refused(track, Status::kNonFiniteInput);
  track = Track{};
  track.velocity.z = kInfinity;
  expect_refused(track, Status::kNonFiniteInput);
  track = Track{};
  track.position.x = 2e12;
  expect_refused(track, Status::kInvalidArgument);
  double Track::*const sizes[] = {&Track::radius, &Track::error, &Track::error_speed, &Track::error_growth,
                                  &Track::reach};
  for (double Track::*const size : sizes) {
    track = Track{};
    track.*size = -1e-300;
    expect_refused(track, Status::kInvalidArgument);
    track.*size = kNan;
    expect_refused(track, Status::kNonFiniteInput);
  }
  track = Track{};
  track.half.z = -1.0;
  expect_refused(track, Status::kInvalidArgument);
  track = Track{};
  track.shape = static_cast<TrackShape>(3);
  expect_refused(track, Status::kInvalidArgument);
  track = Track{};
  track.end = static_cast<TrackEnd>(4);
  expect_refused(track, Status::kInvalidArgument);
  track = Track{};
  track.until = -1;
  EXPECT_EQ(refused(track, which), Status::kRunning);
  track.end = TrackEnd::kGone;
  expect_refused(track, Status::kInvalidArgument);
  track = Track{};
  track.piece_count = 1;
  expect_refused(track, Status::kInvalidArgument);
  track.piece_count = -1;
  expect_refused(track, Status::kInvalidArgument);
  TrackPiece piece{};
  track.pieces = &piece;
  track.piece_count = 1;
  expect_refused(track, Status::kInvalidArgument);
  piece.duration = kNan;
  expect_refused(track, Status::kNonFiniteInput);
  piece.duration = 1.0;
  piece.points[7].x = kNan;
  expect_refused(track, Status::kNonFiniteInput);
}

TEST(TrackProof, RefusesListsAndGrounds) {
  const Trajectory plan = along_x();
  const std::vector<Track> many(kMaxTracks + 1);
  TrackGrounds grounds;
  TrackProof proof;
  grounds.count = 1;
  EXPECT_EQ(proof.begin(plan, 0.0, grounds), Status::kInvalidArgument);
  grounds.tracks = many.data();
  grounds.count = -1;
  EXPECT_EQ(proof.begin(plan, 0.0, grounds), Status::kInvalidArgument);
  grounds.count = kMaxTracks + 1;
  EXPECT_EQ(proof.begin(plan, 0.0, grounds), Status::kTracksFull);
  EXPECT_EQ(proof.report().track, kNoTrack);
  grounds.count = 1;
  grounds.radius = -1.0;
  EXPECT_EQ(proof.begin(plan, 0.0, grounds), Status::kInvalidArgument);
  grounds.radius = 0.0;
  grounds.rest = std::numeric_limits<double>::infinity();
  EXPECT_EQ(proof.begin(plan, 0.0, grounds), Status::kInvalidArgument);
  grounds.rest = 0.0;
  EXPECT_EQ(proof.begin(Trajectory{}, 0.0, grounds), Status::kInvalidArgument);
  const std::vector<TrackPiece> pieces(kMaxTrackPieces + 1, TrackPiece{1.0, {}});
  Track track;
  track.pieces = pieces.data();
  track.piece_count = kMaxTrackPieces + 1;
  grounds.tracks = &track;
  EXPECT_EQ(proof.begin(plan, 0.0, grounds), Status::kTrackPiecesFull);
  EXPECT_EQ(proof.report().track, 0);
  track.piece_count = kMaxTrackPieces;
  EXPECT_EQ(proof.begin(plan, 0.0, grounds), Status::kRunning);
}

TEST(TrackProof, MalformedTrajectory) {
  Trajectory plan = along_x();
  plan.segments[0].points[3].y = std::numeric_limits<double>::quiet_NaN();
  const TimedAnswer answer = prove(plan, {ball_at({9.0, 9.0, 9.0}, 0.1)});
  EXPECT_EQ(answer.report.finding, Finding::kMalformed);
  EXPECT_EQ(answer.until, 0.0);
}

}  // namespace
