// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "flight/rest_search.hpp"

#include "base/math.hpp"
#include "grid/distance.hpp"

namespace tern {
namespace {

/// Lookouts to fly to before the vehicle gives up.
constexpr int kLookouts = 8;
/// The largest and the least distance of a lookout from the hidden voxel, in radii. A vehicle that moves straight away
/// moves at most by the largest.
constexpr int kMostRadii = 10;
constexpr int kLeastRadii = 3;
constexpr int kRanges = kMostRadii - kLeastRadii + 1;
/// Heights of lookouts at one place, half a radius apart: level with the hidden voxel first, then above and below it in
/// turn.
constexpr int kHeights = 21;
/// Places that are fewer radii apart than this count as the same.
constexpr double kSamePlaceRadii = 4.0;
/// The steepest line of sight: how far it drops or climbs across a voxel, in voxels.
constexpr double kSteepest = 1.0;

/// True if `one` is a better lookout than `other` for a vehicle that rests at `at`. A free straight way to it counts
/// most, because the vehicle can fly that from wherever it rests. The next criterion is a small drop of the line of
/// sight across a voxel, because the voxels right below or above a voxel hide it from steep lines. Lines along the
/// grid's axes drop least, because they cross a voxel on the shortest way. Of equal lookouts, the one nearest to the
/// vehicle is better.
bool is_better(const Lookout& one, const Lookout& other, const Vec3& at) {
  if (other.direction < 0) return true;
  if (one.is_straight != other.is_straight) return one.is_straight;
  if (one.drop < other.drop || one.drop > other.drop) return one.drop < other.drop;
  return distance(at, one.place) < distance(at, other.place);
}

/// One of the kDirections level unit vectors of a full turn.
Vec3 offset_of(int direction) {
  constexpr double kHalfRoot = 0.70710678118654752;  // sqrt(1 / 2)
  constexpr double kCosines[kDirections] = {1.0, kHalfRoot, 0.0, -kHalfRoot, -1.0, -kHalfRoot, 0.0, kHalfRoot};
  return {kCosines[direction], kCosines[(direction + 6) % kDirections], 0.0};
}

/// The furthest place straight away from the hidden voxel in space that is known to be free. If the vehicle touches
/// that voxel, no plan may lead elsewhere.
Vec3 place_away(const Grid& safe, const Blockage& block, const Vec3& start, Work& work) {
  const double radius = safe.spec().clearance();
  const Vec3 away = start - block.at;
  const Vec3 step = (0.5 * radius / larger(kSamePlace, length(away))) * away;
  Vec3 place = start;
  work.spend(2 * kMostRadii * clear_operations(safe.spec(), kZero, radius));
  for (int n = 0; n < 2 * kMostRadii && point_clear(safe, safe.to_local(place + step), radius); ++n) {
    place = place + step;
  }
  return place;
}

}  // namespace

void RestSearch::try_anew() noexcept {
  is_looking = seeks = false;
  idle_cycles = 0;
  forget_lookouts();
}

void RestSearch::forget_lookouts() noexcept {
  lookouts = 0;
  sought = 0;
  turned = false;
}

void RestSearch::note_place(const FlightFacts& flight) noexcept {
  const Vec3 at = flight.position();
  if (distance(at, stuck_at) <= kSamePlaceRadii * flight.map.safe().spec().clearance()) return;
  stuck_at = at;
  sought = 0;
  turned = false;
}

/// If the goal is still cut off after a look around, the vehicle is as near to it as it gets. If the goal is in an
/// obstacle that was seen, and the vehicle is right before it, a look around would show no way. A stare shows whether
/// the obstacle is only a wrong pixel.
FlightReason RestSearch::after_failed_cycle(const FlightFacts& flight, const Blockage& block, bool hemmed_in,
                                            bool is_cut_off, const Nose& nose) noexcept {
  note_place(flight);
  if (is_looking) {
    if (sector_at(flight, nose, flight.time) <= kDirections + kStares) return FlightReason::kNone;
    is_looking = false;
    turned = true;
    sought &= kWentAway;
  }
  const bool is_before_goal = flight.itinerary.is_right_before(flight);
  const bool is_nearest = (is_cut_off || is_before_goal) && !hemmed_in;
  if (!is_nearest && seek_lookout(flight, block, hemmed_in)) return FlightReason::kNone;
  if (turned && hemmed_in) return FlightReason::kHemmedIn;
  if (turned) return is_nearest ? FlightReason::kNearest : FlightReason::kNoProgress;
  is_looking = true;
  look_since = flight.time;
  if (is_before_goal) look_since -= nanoseconds((kDirections + 1) * nose.seconds_per_direction(flight.spec)) + 1;
  return FlightReason::kNone;
}

bool RestSearch::seek_lookout(const FlightFacts& flight, const Blockage& block, bool hemmed_in) noexcept {
  seeks = false;
  if (!turned || hemmed_in || flight.is_stale() || !block.is_voxel() || lookouts >= kLookouts) return false;
  if ((sought & kAround) == kAround) {
    if ((sought & (kAway | kWentAway)) != 0) return false;
    sought |= kAway;
  }
  seeks = true;
  return true;
}

void RestSearch::begin_lookout() noexcept {
  searched = 0;
  lookout = {kZero, 0.0, -1, false};
}

/// If no lookout was found, the next plan leads to the goal as usual.
Progress RestSearch::find_lookout(const FlightFacts& flight, const Blockage& block, std::int64_t takeover,
                                  Work& work) noexcept {
  if (!flight.map.safe().bound()) return Progress::kMore;
  const Vec3 at = flight.plans.sample_at(takeover).position;
  for (; searched < kDirections * kRanges * kHeights; ++searched) {
    if (!work.left()) return Progress::kMore;
    look_from(flight, block, at, work);
    work.spend(ops::kPiece);
  }
  seeks = lookout.direction >= 0;
  sought |= seeks ? 1u << lookout.direction : kAround;
  return Progress::kDone;
}

/// Looks at place `searched`: in a direction from the hidden voxel, at a range and a height. Keeps it if it is the best
/// lookout so far for a vehicle that rests at `at`.
void RestSearch::look_from(const FlightFacts& flight, const Blockage& block, const Vec3& at, Work& work) noexcept {
  const Grid& safe = flight.map.safe();
  const double radius = safe.spec().clearance();
  const std::int32_t ring = searched / kHeights;
  const std::int32_t direction = ring / kRanges;
  const int radii = kMostRadii - ring % kRanges;
  const int height = searched % kHeights;
  const Vec3 way = offset_of(direction);
  const int steps = (height + 1) / 2;
  const double up = 0.5 * steps * radius;
  const double drop = (absolute(way.x) + absolute(way.y)) * up / (radii * radius);
  const Vec3 sight = (radii * radius) * way + Vec3{0.0, 0.0, height % 2 == 0 ? up : -up};
  const Vec3 place = block.at + sight;
  Lookout found{place, drop, direction, true};
  const bool was_sought = (sought >> direction & 1) != 0;
  if (was_sought || drop >= kSteepest || distance(at, place) < radius || !is_better(found, lookout, at)) return;
  work.spend(clear_operations(safe.spec(), kZero, radius));
  if (!point_clear(safe, safe.to_local(place), radius)) return;
  work.spend(clear_operations(safe.spec(), place - at, radius));
  found.is_straight = segment_clear(safe, safe.to_local(at), safe.to_local(place), radius);
  if (!is_better(found, lookout, at)) return;
  work.spend(clear_operations(safe.spec(), sight, 0.0));
  if (segment_clear(flight.map.route(), safe.to_local(place), safe.to_local(block.at), 0.0)) lookout = found;
}

Vec3 RestSearch::lookout_place(const RollingMap& map, const Blockage& block, const Vec3& start,
                               Work& work) const noexcept {
  return goes_away() ? place_away(map.safe(), block, start, work) : lookout.place;
}

/// A plan straight away is the first part of the way to a lookout. If none is found there either, the vehicle comes
/// back, and does not go away again.
void RestSearch::note_commit(const Draft& draft, const Commitment& in_flight) noexcept {
  idle_cycles = 0;
  is_looking = false;
  if (!seeks || draft.extends || same(draft.plan.place, in_flight.place)) return;
  seeks = goes_away();
  ++lookouts;
  if (!seeks) return;
  sought = kWentAway;
  turned = false;
}

/// On the way to a lookout, the sensor looks at the hidden voxel. After a lookout, it looks at the voxel that ended the
/// proof, as it does at rest. Otherwise, it looks at the point where the proof ended.
void RestSearch::look_at_end(const FlightFacts& flight, const Draft& draft, double until) noexcept {
  if (draft.plan.looks_out) {
    look_at = draft.plan.hidden;
    return;
  }
  const Grid& safe = flight.map.safe();
  const ProofReport& found = draft.proof.report();
  const bool at_voxel = found.finding == Finding::kObstacle;
  look_at = lookouts > 0 && at_voxel ? safe.spec().origin + safe.center(found.voxel)
                                     : evaluate(draft.plan.planned, until).position;
  if (at_voxel && flight.rests_at(draft.takeover)) look_at_voxel(flight, found.voxel);
}

/// Looks towards the voxel, at a point 1 m away at least: it may be so near that only its direction means anything.
void RestSearch::look_at_voxel(const FlightFacts& flight, const Voxel& voxel) noexcept {
  const Vec3 at = flight.position();
  const Grid& safe = flight.map.safe();
  const Vec3 way = safe.spec().origin + safe.center(voxel) - at;
  const double flat = square_root(way.x * way.x + way.y * way.y);
  if (flat > 0.0) look_at = at + (larger(1.0, flat) / flat) * way;
}

Vec3 RestSearch::looking_at(const FlightFacts& flight, const Nose& nose, std::int64_t t) const noexcept {
  if (!is_looking) return look_at;
  const int sector = sector_at(flight, nose, t);
  if (sector < 1 || sector > kDirections) return look_at;
  return flight.plans.sample_at(t).position + flight.spec.horizon * offset_of(sector - 1);
}

int RestSearch::sector_at(const FlightFacts& flight, const Nose& nose, std::int64_t t) const noexcept {
  const double sector = seconds_between(look_since, t) / nose.seconds_per_direction(flight.spec);
  constexpr int kLast = kDirections + kStares + 1;
  return sector < kLast ? static_cast<int>(sector) : kLast;
}

}  // namespace tern
