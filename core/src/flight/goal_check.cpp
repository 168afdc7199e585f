// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What is known of a goal before anything is flown.
#include "base/math.hpp"
#include "flight/flight_state.hpp"
#include "prove/fences.hpp"
#include "tern/flight.hpp"

namespace tern {
namespace {

/// The first fence that always holds and that a vehicle at this place would break; kNoFence if there is none.
std::int32_t fence_broken(const FlightFacts& flight, const Vec3& place) {
  const double clearance = flight.map.safe().spec().clearance();
  Work work;
  for (std::int32_t k = 0; k < flight.spec.fence_count; ++k) {
    if (is_timed(flight.spec.fences[k])) continue;
    if (!fence_clear(flight.spec.fences[k], {place, clearance, 0.0}, &kZero, 1, work)) return k;
  }
  return kNoFence;
}

/// Writes into `found` what is nearer to the place than the radius: the stated ground, or a voxel that was hit or
/// marked. False if nothing is.
bool find_near(const FlightFacts& flight, const Vec3& place, FlightRefusal& found) {
  const Grid& route = flight.map.route();
  found.needed = found.distance = route.spec().clearance();
  double ground = 0.0;
  if (flight.map.ground_at(place, 0.0, ground) && place.z - ground < found.distance) {
    found.blocked_by = BlockedBy::kObstacle;
    found.blocked_at = {place.x, place.y, ground};
    found.distance = larger(0.0, place.z - ground);
  }
  if (!route.bound()) return found.blocked_by != BlockedBy::kNothing;
  const NearestSolid solid = nearest_solid(route, route.to_local(place), found.distance);
  if (solid.found) {
    found.blocked_by = BlockedBy::kObstacle;
    found.blocked_at = block_at(flight.map, solid.voxel).at;
    found.distance = solid.distance;
  }
  return found.blocked_by != BlockedBy::kNothing;
}

}  // namespace

Status Flight::check_goal(const Vec3& goal, FlightRefusal* why) const noexcept {
  FlightRefusal unread;
  FlightRefusal& found = why != nullptr ? *why : unread;
  found = FlightRefusal{};
  if (state_ == nullptr) return Status::kInvalidArgument;
  found.field = Field::kGoalPosition;
  if (!finite(goal)) return Status::kNonFiniteInput;
  found.fence = fence_broken(state_->facts, goal);
  if (found.fence != kNoFence) return Status::kGoalFenced;
  if (find_near(state_->facts, goal, found)) return Status::kGoalOccupied;
  found = FlightRefusal{};
  return Status::kOk;
}

}  // namespace tern
