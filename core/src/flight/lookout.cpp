// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Finds places from where the vehicle may see what blocks its way, if that is hidden from where it rests.
#include "base/math.hpp"
#include "base/work.hpp"
#include "flight/flight_state.hpp"
#include "grid/distance.hpp"

namespace tern {
namespace {

/// Lookouts to fly to before the vehicle gives up.
constexpr int kLookouts = 8;
/// The largest and the least distance of a lookout from what is to be seen, in radii. A vehicle that moves straight
/// away moves at most by the largest.
constexpr int kMostRadii = 10;
constexpr int kLeastRadii = 3;
constexpr int kRanges = kMostRadii - kLeastRadii + 1;
/// Heights of lookouts at one place, half a radius apart: level with what is to be seen first, then above and below it
/// in turn.
constexpr int kHeights = 21;
/// Places that are fewer radii apart than this count as the same.
constexpr double kSamePlaceRadii = 4.0;
/// The steepest line of sight: how far it drops or climbs across a voxel, in voxels.
constexpr double kSteepest = 1.0;
/// Instructions for a row of voxels near a way.
constexpr std::uint32_t kRowEffort = 60;
/// How often a check of a line of sight reads the rows: it also makes sure that no gap of width zero between obstacles
/// counts as an opening.
constexpr int kSightPasses = 4;

/// Instructions to find out whether a straight way is free with a radius around it.
std::uint32_t way_effort(const GridSpec& window, const Vec3& way, double radius) {
  const int rows = static_cast<int>((absolute(way.y) + 2.0 * radius) / window.cell) + 2;
  const int planes = static_cast<int>((absolute(way.z) + 2.0 * radius) / window.cell) + 2;
  return effort_of(kRowEffort, rows * planes);
}

/// Is `one` a better lookout than `other` for a vehicle that rests at `at`? A free straight way to it counts most,
/// because it can be flown wherever the vehicle rests. The next criterion is a small drop of the line of sight across a
/// voxel, because what is right below or above a voxel hides it from steep lines. Lines along the grid's axes drop
/// least, because they cross a voxel on the shortest way. Of equal lookouts, the one nearest to the vehicle is better.
bool is_better(const Lookout& one, const Lookout& other, const Vec3& at) {
  if (other.direction < 0) return true;
  if (one.is_straight != other.is_straight) return one.is_straight;
  if (one.drop < other.drop || one.drop > other.drop) return one.drop < other.drop;
  return distance(at, one.place) < distance(at, other.place);
}

}  // namespace

void FlightState::forget_lookouts() noexcept {
  lookouts = 0;
  sought = 0;
  turned = false;
}

/// Forgets what was tried once the vehicle is no longer near the place where it was tried.
void FlightState::note_place() noexcept {
  const Vec3 at = sample_at(time).position;
  if (distance(at, stuck_at) <= kSamePlaceRadii * map.safe().spec().clearance()) return;
  stuck_at = at;
  sought = 0;
  turned = false;
}

/// True if the next plan leads to a lookout. A look around comes first: it shows more, sooner.
bool FlightState::seek_lookout() noexcept {
  seeks = false;
  const bool is_voxel = block.by == BlockedBy::kUnseen || block.by == BlockedBy::kObstacle;
  if (!turned || leaves || is_stale() || !is_voxel || lookouts >= kLookouts) return false;
  if ((sought & kAround) == kAround) {
    if ((sought & kAway) != 0) return false;
    sought |= kAway;
  }
  seeks = true;
  return true;
}

void FlightState::begin_lookout() noexcept {
  searched = 0;
  lookout = {kZero, 0.0, -1, false};
  job = Job::kLookout;
}

/// Waits while the map slides, because nothing is known of it then.
Progress FlightState::run_lookout(Work& work) noexcept {
  if (!map.safe().bound()) return Progress::kMore;
  for (; searched < kDirections * kRanges * kHeights; ++searched) {
    if (work.left == 0) return Progress::kMore;
    const std::int32_t ring = searched / kHeights;
    look_from(ring / kRanges, kMostRadii - ring % kRanges, searched % kHeights);
    owe(kRowEffort, work);
  }
  end_lookout();
  return Progress::kDone;
}

/// Looks at the place in a direction from what is to be seen, and keeps it if it is the best lookout so far.
void FlightState::look_from(std::int32_t direction, int radii, int height) noexcept {
  const Grid& safe = map.safe();
  const double radius = safe.spec().clearance();
  const Vec3 at = sample_at(takeover).position;
  const Vec3 way = offset_of(direction);
  const int steps = (height + 1) / 2;
  const double up = 0.5 * steps * radius;
  const double drop = (absolute(way.x) + absolute(way.y)) * up / (radii * radius);
  const Vec3 sight = (radii * radius) * way + Vec3{0.0, 0.0, height % 2 == 0 ? up : -up};
  const Vec3 place = block.at + sight;
  Lookout found{place, drop, direction, true};
  const bool was_sought = (sought >> direction & 1) != 0;
  if (was_sought || drop >= kSteepest || distance(at, place) < radius || !is_better(found, lookout, at)) return;
  owed += way_effort(safe.spec(), kZero, radius);
  if (!point_clear(safe, safe.to_local(place), radius)) return;
  owed += way_effort(safe.spec(), place - at, radius);
  found.is_straight = segment_clear(safe, safe.to_local(at), safe.to_local(place), radius);
  if (!is_better(found, lookout, at)) return;
  owed += kSightPasses * way_effort(safe.spec(), sight, 0.0);
  if (segment_clear(map.route(), safe.to_local(place), safe.to_local(block.at), 0.0)) lookout = found;
}

/// If no lookout was found, the next plan leads to the goal as usual.
void FlightState::end_lookout() noexcept {
  seeks = lookout.direction >= 0;
  sought |= seeks ? 1u << lookout.direction : kAround;
  begin_copy();
}

/// Aims at the lookout, or straight away from what is to be seen, instead of at the goal.
void FlightState::aim_at_lookout() noexcept {
  aims_at_goal = false;
  aim = goes_away() ? place_away() : lookout.place;
}

/// Notes a commit: counts the lookouts that plans lead to. A plan straight away is the first part of the way to one.
void FlightState::note_lookout() noexcept {
  if (!seeks || extends || same(draft.aim, now.aim)) return;
  seeks = goes_away();
  ++lookouts;
  if (!seeks) return;
  sought = 0;
  turned = false;
}

/// What the sensor should see next. On the way to a lookout, it is what the lookout is for. After a lookout, it is the
/// voxel that ended the last proof. Otherwise, it is the point where that proof ended.
Vec3 FlightState::place_to_see() const noexcept {
  if (draft.looks_out) return draft.hidden;
  const Grid& safe = map.safe();
  const bool at_voxel = lookouts > 0 && proof.report().end == ProofEnd::kObstacle;
  return at_voxel ? safe.spec().origin + safe.center(proof.report().voxel) : evaluate(draft.wished, reached).position;
}

/// The place straight away from what is to be seen, as far as the space is known to be free. If the vehicle touches
/// what it cannot see, no plan may lead elsewhere.
Vec3 FlightState::place_away() noexcept {
  const Grid& safe = map.safe();
  const double radius = safe.spec().clearance();
  const Vec3 away = start.d[0] - block.at;
  const Vec3 step = (0.5 * radius / larger(kSamePlace, length(away))) * away;
  Vec3 place = start.d[0];
  owed += 2 * kMostRadii * way_effort(safe.spec(), kZero, radius);
  for (int n = 0; n < 2 * kMostRadii && point_clear(safe, safe.to_local(place + step), radius); ++n) {
    place = place + step;
  }
  return place;
}

}  // namespace tern
