// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The tracks of a request in a record.
#ifndef TERN_RECORD_TRACKS_HPP
#define TERN_RECORD_TRACKS_HPP

#include "record/words.hpp"
#include "tern/config.hpp"
#include "tern/track.hpp"

namespace tern {

template <typename Words, typename AnyTrack>
void list_track(Words& words, AnyTrack& track) {
  words(track.measured);
  words(track.until);
  words(track.position);
  words(track.velocity);
  words(track.id);
  words(track.kind);
  words(track.shape);
  words(track.end);
  words(track.radius);
  words(track.half);
  words(track.error);
  words(track.error_speed);
  words(track.error_growth);
  words(track.reach);
}

template <typename Words, typename AnyPiece>
void list_track_piece(Words& words, AnyPiece& piece) {
  words(piece.duration);
  for (auto& point : piece.points) words(point);
}

/// One track with its pieces.
inline void write_track(const Track& track, WordWriter& words) {
  list_track(words, track);
  words(track.piece_count);
  for (std::int32_t p = 0; p < track.piece_count; ++p) list_track_piece(words, track.pieces[p]);
}

/// Reads what write_track() wrote. The track points into `pieces`, which has room for `room`.
inline Status read_track(WordReader& words, TrackPiece* pieces, std::int32_t room, Track& track) {
  list_track(words, track);
  const Status status = read_count(words, room, Status::kTrackPiecesFull, track.piece_count);
  if (status != Status::kOk) return status;
  track.pieces = track.piece_count > 0 ? pieces : nullptr;
  for (std::int32_t p = 0; p < track.piece_count; ++p) list_track_piece(words, pieces[p]);
  return status;
}

/// The most fields of all tracks, with their number.
constexpr std::size_t kTracksFields =
    1 + std::size_t{21} * kMaxTracks + std::size_t{1 + 3 * kControlPoints} * kMaxTrackPieces;

/// True if there are no more tracks and pieces than capacities allow, and no null pointers.
inline bool tracks_fit(const Track* tracks, std::int32_t count) {
  if (!is_count(count, kMaxTracks, tracks)) return false;
  std::int32_t left = kMaxTrackPieces;
  for (std::int32_t t = 0; t < count; ++t) {
    if (!is_count(tracks[t].piece_count, left, tracks[t].pieces)) return false;
    left -= tracks[t].piece_count;
  }
  return true;
}

inline void write_tracks(const Track* tracks, std::int32_t count, WordWriter& words) {
  words(count);
  for (std::int32_t t = 0; t < count; ++t) write_track(tracks[t], words);
}

/// Reads the tracks that write_tracks wrote, into arrays of kMaxTracks and kMaxTrackPieces. The tracks point into
/// `pieces`.
inline Status read_tracks(WordReader& words, Track* tracks, TrackPiece* pieces, std::int32_t& count) {
  Status status = read_count(words, kMaxTracks, Status::kTracksFull, count);
  std::int32_t left = kMaxTrackPieces;
  for (std::int32_t t = 0; t < count && status == Status::kOk; ++t) {
    status = read_track(words, pieces + (kMaxTrackPieces - left), left, tracks[t]);
    left -= tracks[t].piece_count;
  }
  return status;
}

}  // namespace tern

#endif
