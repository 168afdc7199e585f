// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "flight/track_table.hpp"

#include "base/capacity.hpp"
#include "base/math.hpp"
#include "flight/flight_clock.hpp"

namespace tern {
namespace {

bool is_gone(const Track& track, std::int64_t now) {
  return track.end == TrackEnd::kGone && now > track.until;
}

/// For so many of the `since` seconds after it was measured, the thing moves.
double time_in_motion(const Track& track, double since) {
  return track.end == TrackEnd::kGoesOn ? since : smaller(since, seconds_between(track.measured, track.until));
}

/// The error after `moved` seconds in motion.
double error_after(const Track& track, double moved) {
  return track.error + moved * (track.error_speed + 0.5 * moved * track.error_growth);
}

bool is_larger(const Track& a, const Track& b) {
  return a.shape != b.shape || a.radius > b.radius || a.half.x > b.half.x || a.half.y > b.half.y || a.half.z > b.half.z;
}

/// It may do more than before. A reach of 0 says that nothing is known.
bool may_do_more(const Track& a, const Track& b) {
  const bool reaches_further = b.reach > 0.0 && (a.reach > b.reach || !(a.reach > 0.0));
  return a.error_growth > b.error_growth || reaches_further || a.end != b.end ||
         (a.end == TrackEnd::kGone && a.until > b.until);
}

/// A thing is expected to keep its velocity, but for a drift. If its tube has grown larger than the ball that it can
/// reach, it may be anywhere in the ball.
Track expected_of(const Track& track, std::int64_t now) {
  Track expected = track;
  if (track.pieces != nullptr || track.end != TrackEnd::kGoesOn || now < track.measured || !(track.error_growth > 0.0))
    return expected;
  const double since = seconds_between(track.measured, now);
  const double error = error_after(track, since);
  const double reached = track.error + track.reach * since;
  const bool is_anywhere = track.reach > 0.0 && reached < error;
  expected.measured = now;
  expected.error = is_anywhere ? reached : error;
  expected.error_speed = is_anywhere ? track.reach : track.error_speed + kExpectedDrift;
  expected.error_growth = expected.reach = 0.0;
  if (is_anywhere) expected.velocity = kZero;
  if (!is_anywhere) expected.position = track.position + since * track.velocity;
  return expected;
}

}  // namespace

bool refutes(const Track& measured, const Track& tube) noexcept {
  if (measured.pieces != tube.pieces) return true;
  if (measured.pieces != nullptr) return false;
  if (is_larger(measured, tube) || may_do_more(measured, tube) || is_gone(tube, measured.measured)) return true;
  const double since = seconds_between(tube.measured, measured.measured);
  const double moved = time_in_motion(tube, since);
  double error = error_after(tube, moved);
  if (tube.end == TrackEnd::kReach) error += tube.reach * (since - moved);
  const double off = distance(measured.position, tube.position + moved * tube.velocity) - measured.error;
  const double away = distance(measured.position, tube.position) - measured.error;
  return off > error || (tube.reach > 0.0 && away > tube.error + tube.reach * since);
}

Track* TrackTable::find(std::uint32_t id) noexcept {
  for (std::int32_t k = 0; k < count; ++k) {
    if (tracks[k].id == id) return &tracks[k];
  }
  return nullptr;
}

/// Plans and proofs take no more pieces than a request.
bool TrackTable::pieces_fit(const Track& added, const Track* replaced) const noexcept {
  std::int32_t sum = added.piece_count - (replaced != nullptr ? replaced->piece_count : 0);
  for (std::int32_t k = 0; k < count; ++k) sum += tracks[k].piece_count;
  return !is_full(sum > kMaxTrackPieces);
}

void TrackTable::take(const TrackTable& other) noexcept {
  count = other.count;
  for (std::int32_t k = 0; k < count; ++k) tracks[k] = other.tracks[k];
}

Status TrackTable::update(const Track& measured, std::int64_t now) noexcept {
  Track* const known = find(measured.id);
  if (known != nullptr) {
    if (measured.measured < known->measured) return Status::kClockBehind;
    if (!pieces_fit(measured, known)) return Status::kTrackPiecesFull;
    *known = measured;
    return Status::kOk;
  }
  std::int32_t kept = 0;
  for (std::int32_t k = 0; k < count; ++k) {
    if (!is_gone(tracks[k], now)) tracks[kept++] = tracks[k];
  }
  count = kept;
  if (is_full(count == kMaxFlightTracks)) return Status::kTracksFull;
  if (!pieces_fit(measured, nullptr)) return Status::kTrackPiecesFull;
  tracks[count++] = measured;
  return Status::kOk;
}

bool TrackTable::forget(std::uint32_t id) noexcept {
  Track* const known = find(id);
  if (known == nullptr) return false;
  *known = tracks[--count];
  return true;
}

bool TrackTable::take_news(const Track& measured, const TrackTable& latest) noexcept {
  Track* const tube = find(measured.id);
  if (tube != nullptr && !refutes(measured, *tube)) return false;
  if (!pieces_fit(measured, tube) || (tube == nullptr && is_full(count == kMaxFlightTracks))) {
    take(latest);
  } else if (tube != nullptr) {
    *tube = measured;
  } else {
    tracks[count++] = measured;
  }
  return true;
}

bool TrackTable::take_news(const TrackTable& latest, bool curves_count) noexcept {
  bool has_news = false;
  for (std::int32_t k = 0; k < latest.count; ++k) {
    if (!curves_count && latest.tracks[k].piece_count > 0) continue;
    has_news = take_news(latest.tracks[k], latest) || has_news;
  }
  return has_news;
}

void TrackTable::expect(const TrackTable& latest, std::int64_t now) noexcept {
  count = latest.count;
  for (std::int32_t k = 0; k < count; ++k) tracks[k] = expected_of(latest.tracks[k], now);
}

}  // namespace tern
