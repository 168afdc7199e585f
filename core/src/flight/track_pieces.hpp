// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The pieces of things that move along curves, for as long as a table names them. Tables are copied with every
// committed plan; pieces are not, and stay where they are.
#ifndef TERN_FLIGHT_TRACK_PIECES_HPP
#define TERN_FLIGHT_TRACK_PIECES_HPP

#include <cstddef>
#include <cstdint>

#include "flight/track_table.hpp"
#include "tern/flight.hpp"
#include "tern/track.hpp"

namespace tern {

struct TrackPieces {
  TrackPiece pieces[kMaxFlightPieces];

  /// Copies the track's pieces to where no table has any, and makes the track name the copy. False, and the track is
  /// untouched, if there are not enough in a row.
  bool keep(Track& track, const TrackTable* const* tables, int table_count) noexcept;
};

}  // namespace tern

#endif
