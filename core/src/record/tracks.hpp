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

/// A track without pieces.
inline Track read_track(WordReader& words) {
  Track track;
  list_track(words, track);
  return track;
}

template <typename Words, typename AnyPiece>
void list_track_piece(Words& words, AnyPiece& piece) {
  words(piece.duration);
  for (auto& point : piece.points) words(point);
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
  for (std::int32_t t = 0; t < count; ++t) {
    list_track(words, tracks[t]);
    words(tracks[t].piece_count);
    for (std::int32_t p = 0; p < tracks[t].piece_count; ++p) list_track_piece(words, tracks[t].pieces[p]);
  }
}

/// Reads the tracks that write_tracks wrote, into arrays of kMaxTracks and kMaxTrackPieces. The tracks point into
/// `pieces`.
inline Status read_tracks(WordReader& words, Track* tracks, TrackPiece* pieces, std::int32_t& count) {
  Status status = read_count(words, kMaxTracks, Status::kTracksFull, count);
  std::int32_t left = kMaxTrackPieces;
  for (std::int32_t t = 0; t < count && status == Status::kOk; ++t) {
    Track& track = tracks[t];
    list_track(words, track);
    status = read_count(words, left, Status::kTrackPiecesFull, track.piece_count);
    if (status != Status::kOk) return status;
    TrackPiece* const first = pieces + (kMaxTrackPieces - left);
    track.pieces = track.piece_count > 0 ? first : nullptr;
    for (std::int32_t p = 0; p < track.piece_count; ++p) list_track_piece(words, first[p]);
    left -= track.piece_count;
  }
  return status;
}

}  // namespace tern

#endif
