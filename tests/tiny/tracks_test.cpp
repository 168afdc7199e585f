// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Tracks that exceed a capacity of the tiny profile.
#include <gtest/gtest.h>

#include "support/world.hpp"

namespace tern_test {
namespace {

using tern::Status;
using tern::Track;
using tern::TrackPiece;

class TinyTracks : public testing::Test {
 protected:
  Status plan(int count) {
    world_.request.tracks = tracks_;
    world_.request.track_count = count;
    return world_.plan();
  }

  World world_ = open_world();
  Track tracks_[tern::kMaxTracks + 1];
  TrackPiece pieces_[tern::kMaxTrackPieces + 1] = {};
};

TEST_F(TinyTracks, MoreThanFitAreRefused) {
  EXPECT_EQ(plan(tern::kMaxTracks + 1), Status::kTracksFull);
  EXPECT_EQ(world_.report.field, tern::Field::kTracks);
  EXPECT_EQ(world_.report.track, tern::kNoTrack);
  EXPECT_TRUE(world_.trajectory_untouched());
  EXPECT_EQ(plan(tern::kMaxTracks), Status::kOk);
}

TEST_F(TinyTracks, MorePiecesThanFitAreRefused) {
  for (TrackPiece& piece : pieces_) piece.duration = 1.0;
  for (Track& track : tracks_) track.pieces = pieces_;
  tracks_[0].piece_count = tern::kMaxTrackPieces;
  tracks_[1].piece_count = 1;
  EXPECT_EQ(plan(2), Status::kTrackPiecesFull);
  EXPECT_EQ(world_.report.field, tern::Field::kTracks);
  EXPECT_EQ(world_.report.track, 1);
  tracks_[1].piece_count = 0;
  EXPECT_EQ(plan(2), Status::kOk);
}

/// Each segment comes near both tracks, and needs a plane for each.
TEST_F(TinyTracks, MorePlanesThanFitAreAReason) {
  for (Track& track : tracks_) {
    track.position = {0.5 * (world_.request.start.position.x + world_.request.goal.position.x),
                      world_.request.start.position.y, world_.request.start.position.z};
    track.shape = tern::TrackShape::kBox;
    track.half = {1.0, 50.0, 50.0};
  }
  EXPECT_EQ(plan(2), Status::kSeparationsFull);
  EXPECT_TRUE(world_.trajectory_untouched());
  EXPECT_EQ(plan(1), Status::kNoClearTime);
}

}  // namespace
}  // namespace tern_test
