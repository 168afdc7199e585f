// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Things that move, by their numbers: the last measurement of each. The flight has one table. Each committed plan keeps
// a copy, the tubes that it was proven with. Times are those of the flight.
#ifndef TERN_FLIGHT_TRACK_TABLE_HPP
#define TERN_FLIGHT_TRACK_TABLE_HPP

#include <cstdint>

#include "tern/flight.hpp"
#include "tern/status.hpp"
#include "tern/track.hpp"

namespace tern {

/// How much faster than its measured velocity may be wrong, the error of a thing is expected to grow, m/s. Plans keep
/// clear of what is expected; proofs keep clear of all that a thing may do.
constexpr double kExpectedDrift = 0.2;

struct TrackTable {
  Track tracks[kMaxFlightTracks];
  std::int32_t count;

  void clear() noexcept { count = 0; }
  /// Becomes a copy. Copies only what there is.
  void take(const TrackTable& other) noexcept;
  /// Takes a measurement in place of the last one of that thing. kOk; kClockBehind if it is older than that;
  /// kTracksFull; kTrackPiecesFull if all things together then have more pieces than a request may have. What is gone
  /// before `now` makes room.
  Status update(const Track& measured, std::int64_t now) noexcept;
  /// False if there is no such thing.
  bool forget(std::uint32_t id) noexcept;
  /// Takes the measurement if its thing is not here yet, or is not where its tube says. False if it tells nothing new.
  /// Without room, takes all of `latest`, which has the measurement.
  bool take_news(const Track& measured, const TrackTable& latest) noexcept;
  /// Takes all news of a table, those of curves only if `curves_count`. False if there are none.
  bool take_news(const TrackTable& latest, bool curves_count = true) noexcept;
  /// Becomes what is expected of the things of a table from `now` on.
  void expect(const TrackTable& latest, std::int64_t now) noexcept;

 private:
  Track* find(std::uint32_t id) noexcept;
  bool pieces_fit(const Track& added, const Track* replaced) const noexcept;
};

/// True if a thing that was measured so is not in its tube: no place that the measurement allows is in the tube, or it
/// is larger, or may do more, than the tube takes it for. The measurement is no older than the tube. A curve always
/// refutes another one.
bool refutes(const Track& measured, const Track& tube) noexcept;

}  // namespace tern

#endif
