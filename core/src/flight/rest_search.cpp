// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "flight/rest_search.hpp"

#include "base/math.hpp"

namespace tern {
namespace {

/// Places that are fewer radii apart than this count as the same.
constexpr double kSamePlaceRadii = 4.0;

/// So many plans in a row that led no nearer to the goal take the place of a survey: a vehicle that moves about its
/// start never rests for one.
constexpr int kSurveyPlans = 6;

/// One of the kLookDirections level unit vectors of a full turn.
Vec3 offset_of(int direction) {
  constexpr double kCosines[kLookDirections] = {1.0, 0.0, -1.0, 0.0};
  return {kCosines[direction], kCosines[(direction + 3) % kLookDirections], 0.0};
}

bool is_same_place(const FlightFacts& flight, const Vec3& a, const Vec3& b) {
  return distance(a, b) <= kSamePlaceRadii * flight.map.safe().spec().clearance();
}

}  // namespace

void RestSearch::try_anew(const Vec3& at) noexcept {
  began_at = at;
  is_looking = surveyed = turned = false;
  idle_cycles = 0;
}

void RestSearch::note_place(const FlightFacts& flight) noexcept {
  const Vec3 at = flight.position();
  if (is_same_place(flight, stuck_at, at)) return;
  stuck_at = at;
  turned = false;
}

/// If the goal is still cut off after a look around, the vehicle is as near to it as it gets. If the goal is in an
/// obstacle that was seen, and the vehicle is right before it, a look around would show no way. A stare shows whether
/// the obstacle is only a wrong pixel.
FlightReason RestSearch::after_failed_cycle(const FlightFacts& flight, bool hemmed_in, bool is_cut_off,
                                            const Nose& nose) noexcept {
  note_place(flight);
  if (is_looking) {
    const int last = surveys ? kLookDirections - 1 : kLookDirections;
    if (sector_at(flight, nose, flight.time) <= last) return FlightReason::kNone;
    is_looking = false;
    surveyed = true;
    turned = !surveys;
    if (surveys) return FlightReason::kNone;
  }
  const bool is_before_goal = flight.itinerary.is_right_before(flight);
  const bool is_nearest = (is_cut_off || is_before_goal) && !hemmed_in;
  if (turned && hemmed_in) return FlightReason::kHemmedIn;
  if (turned) return is_nearest ? FlightReason::kNearest : FlightReason::kNoProgress;
  is_looking = true;
  surveys = wants_survey(flight) && !is_nearest && !hemmed_in;
  look_since = flight.time;
  if (is_before_goal) look_since -= nanoseconds(kLookDirections * nose.seconds_per_direction(flight.spec)) + 1;
  return FlightReason::kNone;
}

bool RestSearch::wants_survey(const FlightFacts& flight) const noexcept {
  const Vec3 at = flight.position();
  const bool is_far = distance(at, flight.itinerary.points[flight.itinerary.leg].position) > flight.spec.horizon;
  const bool has_wandered = flight.itinerary.wandering >= kSurveyPlans;
  return is_far && !surveyed && !has_wandered && is_same_place(flight, began_at, at);
}

void RestSearch::note_commit() noexcept {
  idle_cycles = 0;
  is_looking = false;
}

/// At rest, the sensor looks at the voxel that ended the proof; in flight, at the point where the proof ended.
void RestSearch::look_at_end(const FlightFacts& flight, const Draft& draft, double until) noexcept {
  const ProofReport& found = draft.proof.report();
  look_at = evaluate(draft.plan.planned, until).position;
  if (found.finding == Finding::kObstacle && flight.rests_at(draft.takeover)) look_at_voxel(flight, found.voxel);
}

/// Looks towards the voxel, at a point 1 m away at least: it may be so near that only its direction means anything.
void RestSearch::look_at_voxel(const FlightFacts& flight, const Voxel& voxel) noexcept {
  const Vec3 at = flight.position();
  const Grid& safe = flight.map.safe();
  const Vec3 way = safe.spec().origin + safe.center(voxel) - at;
  const double flat = horizontal_length(way);
  if (flat > 0.0) look_at = at + (larger(1.0, flat) / flat) * way;
}

Vec3 RestSearch::looking_at(const FlightFacts& flight, const Nose& nose, std::int64_t t) const noexcept {
  if (!is_looking) return look_at;
  const int sector = sector_at(flight, nose, t);
  if (sector >= kLookDirections) return look_at;
  return flight.plans.sample_at(t).position + flight.spec.horizon * offset_of(sector);
}

int RestSearch::sector_at(const FlightFacts& flight, const Nose& nose, std::int64_t t) const noexcept {
  const double each = nose.seconds_per_direction(flight.spec);
  const double since = seconds_between(look_since, t);
  if (since < kLookDirections * each) return static_cast<int>(since / each);
  return since < kLookDirections * each + seconds_between(0, kStare) ? kLookDirections : kLookDirections + 1;
}

}  // namespace tern
