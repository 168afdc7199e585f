// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "flight/track_pieces.hpp"

namespace tern {

bool TrackPieces::keep(Track& track, const TrackTable* const* tables, int table_count) noexcept {
  bool taken[kMaxFlightPieces] = {};
  for (int i = 0; i < table_count; ++i) {
    for (std::int32_t k = 0; k < tables[i]->count; ++k) {
      const Track& held = tables[i]->tracks[k];
      for (std::int32_t p = 0; p < held.piece_count; ++p) taken[held.pieces - pieces + p] = true;
    }
  }
  std::int32_t in_a_row = 0;
  for (std::int32_t end = 1; end <= kMaxFlightPieces; ++end) {
    in_a_row = taken[end - 1] ? 0 : in_a_row + 1;
    if (in_a_row < track.piece_count) continue;
    TrackPiece* const first = pieces + (end - track.piece_count);
    for (std::int32_t p = 0; p < track.piece_count; ++p) first[p] = track.pieces[p];
    track.pieces = first;
    return true;
  }
  return false;
}

}  // namespace tern
