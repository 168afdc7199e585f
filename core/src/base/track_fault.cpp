// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/track_fault.hpp"

#include "base/capacity.hpp"
#include "base/math.hpp"
#include "tern/config.hpp"

namespace tern {
namespace {

/// kOk, or why a number is none that a track may have.
Status check_number(double number) {
  if (!finite(number)) return Status::kNonFiniteInput;
  return absolute(number) <= kMaxTrackNumber ? Status::kOk : Status::kInvalidArgument;
}

Status check_point(const Vec3& point) {
  for (int a = 0; a < 3; ++a) {
    const Status status = check_number(axis(point, a));
    if (status != Status::kOk) return status;
  }
  return Status::kOk;
}

/// Numbers that may not be negative.
Status check_sizes(const Track& track) {
  const double sizes[] = {track.radius, track.half.x,      track.half.y,       track.half.z,
                          track.error,  track.error_speed, track.error_growth, track.reach};
  for (const double size : sizes) {
    const Status status = check_number(size);
    if (status != Status::kOk) return status;
    if (size < 0.0) return Status::kInvalidArgument;
  }
  return Status::kOk;
}

Status check_piece(const TrackPiece& piece) {
  const Status status = check_number(piece.duration);
  if (status != Status::kOk) return status;
  if (!(piece.duration > 0.0)) return Status::kInvalidArgument;
  for (const Vec3& point : piece.points) {
    const Status of_point = check_point(point);
    if (of_point != Status::kOk) return of_point;
  }
  return Status::kOk;
}

/// True if the enumerations have values of theirs, and the pieces are there: a caller in C can pass any byte.
bool is_formed(const Track& track) {
  const bool has_shape =
      track.shape == TrackShape::kBall || track.shape == TrackShape::kCylinder || track.shape == TrackShape::kBox;
  const bool goes_on = track.end == TrackEnd::kGoesOn;
  const bool ends = track.end == TrackEnd::kGone || track.end == TrackEnd::kStays || track.end == TrackEnd::kReach;
  const bool has_pieces = track.piece_count == 0 || (track.piece_count > 0 && track.pieces != nullptr);
  return has_shape && has_pieces && (goes_on || (ends && track.until >= track.measured));
}

/// Checks one track by itself. There is room for `left` pieces.
Status check_track(const Track& track, std::int32_t left) {
  if (!is_formed(track)) return Status::kInvalidArgument;
  if (is_full(track.piece_count > left)) return Status::kTrackPiecesFull;
  Status status = check_point(track.position);
  if (status == Status::kOk && track.piece_count == 0) status = check_point(track.velocity);
  if (status == Status::kOk) status = check_sizes(track);
  for (std::int32_t p = 0; p < track.piece_count && status == Status::kOk; ++p) status = check_piece(track.pieces[p]);
  return status;
}

}  // namespace

TrackFault find_track_fault(const Track* list, std::int32_t count) noexcept {
  if (count < 0 || (count > 0 && list == nullptr)) return {Status::kInvalidArgument, kNoTrack};
  if (is_full(count > kMaxTracks)) return {Status::kTracksFull, kNoTrack};
  std::int32_t left = kMaxTrackPieces;
  for (std::int32_t i = 0; i < count; ++i) {
    const Status status = check_track(list[i], left);
    if (status != Status::kOk) return {status, i};
    left -= list[i].piece_count;
  }
  return {Status::kOk, kNoTrack};
}

}  // namespace tern
