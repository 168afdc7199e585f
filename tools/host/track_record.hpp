// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Things that move in a scenario: `track`, `track_piece`, and `keepout` with `during`, which is a box that is there for
// a while. docs/formats.md has the words.
#ifndef TERN_HOST_TRACK_RECORD_HPP
#define TERN_HOST_TRACK_RECORD_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "host/earth_frame.hpp"
#include "host/fence_record.hpp"
#include "host/text_records.hpp"
#include "host/word_queue.hpp"
#include "tern/grid.hpp"
#include "tern/track.hpp"

namespace tern_host {

struct TrackRecord {
  std::string id;
  tern::Track track;                     ///< without its pieces and their number
  std::vector<tern::TrackPiece> pieces;  ///< relative to track.position
  std::string plan;                      ///< the file with another vehicle's plan; empty: none
  bool has_place = false;
  bool has_from = false;  ///< else it is measured when the scenario begins
  bool is_fence = false;  ///< a keep-out box for a while
  Place place;
};

/// ball RADIUS, cylinder RADIUS HEIGHT or box HALF_X HALF_Y HALF_Z, into the track. Throws RecordError.
void read_shape(WordQueue& queue, tern::Track& track);

/// track ID SHAPE ... Throws RecordError.
TrackRecord read_track(const Words& words, const Place& place);

/// track_piece ID DURATION x0 y0 z0 ... x7 y7 z7, added to the track of that name. Throws RecordError.
void add_track_piece(const Words& words, const Place& place, std::vector<TrackRecord>& tracks);

/// "keepout 2 (Lake)": which of the file's `keepout` records it is, counted from 1, and its zone, if it has one.
std::string keepout_name(std::size_t number, const std::string& zone);

/// keepout x0 y0 z0 x1 y1 z1, for a while. Throws RecordError.
TrackRecord read_timed_keepout(const Words& words, const FenceEnd& end, const std::string& name, const Place& place);

/// Checks what only the whole scenario shows: pieces and places, capacities. Tracks without a `from` are measured at
/// `start`. Throws RecordError.
void complete_tracks(double start, std::vector<TrackRecord>& tracks);

/// Reads the plans of other vehicles, in files relative to `folder`. Throws RecordError.
void load_plans(const std::string& folder, const EarthFrame& earth, std::vector<TrackRecord>& tracks);

/// The tracks for a request. They point into the records.
std::vector<tern::Track> tracks_of(const std::vector<TrackRecord>& records);

}  // namespace tern_host

#endif
