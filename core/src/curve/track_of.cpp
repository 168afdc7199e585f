// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdint>

#include "base/capacity.hpp"
#include "tern/track.hpp"

namespace tern {

Status track_of(const Trajectory& trajectory, double radius, TrackPiece* pieces, std::int32_t room,
                Track& track) noexcept {
  const std::int32_t count = trajectory.count;
  if (pieces == nullptr || count < 1 || count > kMaxSegments) return Status::kInvalidArgument;
  if (is_full(count > room)) return Status::kTrackPiecesFull;
  for (std::int32_t p = 0; p < count; ++p) {
    pieces[p].duration = trajectory.segments[p].duration;
    for (int i = 0; i < kControlPoints; ++i) pieces[p].points[i] = trajectory.segments[p].points[i];
  }
  track = Track{};
  track.measured = trajectory.begin;
  track.position = trajectory.origin;
  track.pieces = pieces;
  track.piece_count = count;
  track.radius = radius;
  return Status::kOk;
}

}  // namespace tern
