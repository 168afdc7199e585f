// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// From where the vehicle may see what blocks its way and cannot be seen from where it rests.
#include "base/math.hpp"
#include "base/work.hpp"
#include "flight/flight_state.hpp"
#include "grid/distance.hpp"

namespace tern {
namespace {

/// Lookouts to fly to before the vehicle gives up.
constexpr int kLookouts = 8;
/// How far a lookout is from what is to be seen, and how far the vehicle goes away from that, in radii.
constexpr int kMostRadii = 10;
constexpr int kLeastRadii = 3;
constexpr int kRanges = kMostRadii - kLeastRadii + 1;
/// Heights of lookouts at one place, half a radius apart: that of what is to be seen, then above and below it in turn.
constexpr int kHeights = 21;
/// A place that is less than so many radii away is the same.
constexpr double kSamePlaceRadii = 4.0;
/// The steepest line of sight: how far it drops or climbs across a voxel, in voxels.
constexpr double kSteepest = 1.0;
/// Instructions of a row of voxels around a place, and of a line of sight.
constexpr std::uint32_t kRowEffort = 60;
constexpr std::uint32_t kSightEffort = 4000;

/// Instructions of finding out whether the vehicle may rest at a place.
std::uint32_t rest_effort(const GridSpec& window) {
  const int rows = 2 * static_cast<int>(window.clearance() / window.cell) + 2;
  return effort_of(kRowEffort, rows * rows);
}

}  // namespace

void FlightState::forget_lookouts() noexcept {
  lookouts = 0;
  sought = 0;
  turned = false;
}

/// What was tried counts near the place where it was tried.
void FlightState::note_place() noexcept {
  const Vec3 at = sample_at(time).position;
  if (distance(at, stuck_at) <= kSamePlaceRadii * map.safe().spec().clearance()) return;
  stuck_at = at;
  sought = 0;
  turned = false;
}

/// True where the next plan leads to a lookout. A look around comes first: it shows more, sooner.
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
  lookout = {kZero, kSteepest, -1};
  job = Job::kLookout;
}

Progress FlightState::run_lookout(Work& work) noexcept {
  if (goes_away()) {
    go_away();
    return Progress::kDone;
  }
  for (; searched < kDirections * kRanges; ++searched) {
    if (work.left == 0) return Progress::kMore;
    look_from(searched / kRanges, kMostRadii - searched % kRanges);
    owe(0, work);
  }
  end_lookout();
  return Progress::kDone;
}

/// Looks for a lookout in a direction from what is to be seen. A flat line of sight is best, because what is right
/// below or above a voxel hides it from steep ones; and one along the grid's axes, which crosses the voxel on the
/// shortest way. Of equal ones, the one nearest to the vehicle.
void FlightState::look_from(std::int32_t direction, int radii) noexcept {
  if ((sought >> direction & 1) != 0) return;
  const Grid& safe = map.safe();
  const double radius = safe.spec().clearance();
  const Vec3 way = offset_of(direction);
  const double across = absolute(way.x) + absolute(way.y);
  for (int n = 0; n < kHeights; ++n) {
    const int steps = (n + 1) / 2;
    const double up = 0.5 * steps * radius;
    const double drop = across * up / (radii * radius);
    if (drop > lookout.drop) return;
    const Vec3 place = block.at + (radii * radius) * way + Vec3{0.0, 0.0, n % 2 == 0 ? up : -up};
    const double far = distance(start.d[0], place);
    const bool is_better = drop < lookout.drop || (lookout.direction >= 0 && far < distance(start.d[0], lookout.place));
    if (!is_better || far < radius) continue;
    owed += rest_effort(safe.spec());
    if (!point_clear(safe, safe.to_local(place), radius)) continue;
    owed += kSightEffort;
    if (!segment_clear(map.route(), safe.to_local(place), safe.to_local(block.at), 0.0)) continue;
    lookout = {place, drop, direction};
    return;
  }
}

void FlightState::end_lookout() noexcept {
  if (lookout.direction < 0) {
    sought |= kAround;
    return choose_draft(false);
  }
  sought |= 1u << lookout.direction;
  aim = lookout.place;
  aims_at_goal = false;
  way_length(start.d[0], aim) > spec.horizon ? ask_route() : ask_planner();
}

/// A plan is committed. One that leads straight away is the first part of the way to a lookout.
void FlightState::note_lookout() noexcept {
  if (!seeks || extends || same(draft.aim, now.aim)) return;
  seeks = goes_away();
  ++lookouts;
  if (!seeks) return;
  sought = 0;
  turned = false;
}

/// What the sensor should see next: what a lookout is for; after one, the voxel that ended the proof at hand; and
/// otherwise the point where it ended.
Vec3 FlightState::place_to_see() const noexcept {
  if (draft.looks_out) return draft.hidden;
  const Grid& safe = map.safe();
  const bool at_voxel = lookouts > 0 && proof.report().end == ProofEnd::kObstacle;
  return at_voxel ? safe.spec().origin + safe.center(proof.report().voxel) : evaluate(draft.wished, reached).position;
}

/// Straight away, as far as that is known to be free: where the vehicle touches what it cannot see, no plan may lead
/// elsewhere.
void FlightState::go_away() noexcept {
  const Grid& safe = map.safe();
  const double radius = safe.spec().clearance();
  const Vec3 away = start.d[0] - block.at;
  const Vec3 step = (0.5 * radius / larger(kSamePlace, length(away))) * away;
  aim = start.d[0];
  aims_at_goal = false;
  owed += effort_of(rest_effort(safe.spec()), 2 * kMostRadii);
  for (int n = 0; n < 2 * kMostRadii && point_clear(safe, safe.to_local(aim + step), radius); ++n) aim = aim + step;
  ask_planner();
}

}  // namespace tern
