// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The start of a flight, and why it may be refused.
#include <new>

#include "base/fence_fault.hpp"
#include "base/math.hpp"
#include "base/verdict.hpp"
#include "flight/blocked.hpp"
#include "flight/flight_state.hpp"
#include "planner/validate.hpp"
#include "prove/hull_clear.hpp"
#include "tern/flight.hpp"

namespace tern {
namespace {

/// What a vehicle passes within this time, in seconds, its sensor will hardly show before the vehicle is there. With
/// more, slow vehicles keep away from doors that they have not seen through yet; more than kMostNear metres, and fast
/// ones see no way past a corner.
constexpr double kNearTime = 0.5;
constexpr double kMostNear = 2.5;

/// Ranges of the spec's numbers.
constexpr std::uint32_t kLeastWork = 256;
constexpr double kLeastYawRate = 1e-3;
constexpr double kFullTurn = 6.2831853071795865;  // 2 pi, rounded up
constexpr double kWidestVertical = 3.0;
constexpr double kSteepestPitch = 1.5;

std::size_t state_words() {
  return (sizeof(FlightState) + sizeof(std::uint64_t) - 1) / sizeof(std::uint64_t);
}

Verdict invalid(Field field) {
  return {Status::kInvalidArgument, field};
}

Verdict check_finite(const FlightSpec& spec) {
  if (!finite(spec.horizon)) return {Status::kNonFiniteInput, Field::kHorizon};
  if (!finite(spec.near)) return {Status::kNonFiniteInput, Field::kNear};
  if (!finite(spec.yaw_rate)) return {Status::kNonFiniteInput, Field::kYawRate};
  const FlightSensor& s = spec.sensor;
  const bool sees = finite({s.horizontal, s.vertical, s.nearest}) && finite({s.pitch_min, s.pitch_max, s.raised});
  return sees && finite(s.offset) ? kAccepted : Verdict{Status::kNonFiniteInput, Field::kSensor};
}

bool sensor_valid(const FlightSensor& sensor) {
  const bool sees = sensor.horizontal > 0.0 && sensor.horizontal <= kFullTurn && sensor.vertical > 0.0 &&
                    sensor.vertical <= kWidestVertical && sensor.nearest >= 0.0;
  return sees && sensor.pitch_min >= -kSteepestPitch && sensor.pitch_max <= kSteepestPitch &&
         sensor.pitch_min <= sensor.pitch_max && absolute(sensor.raised) <= kSteepestPitch;
}

Verdict check_ranges(const FlightSpec& spec) {
  if (spec.tick <= 0 || spec.tick > kLongestTick) return invalid(Field::kTick);
  if (spec.work_per_tick < kLeastWork || spec.plan_work == 0) return invalid(Field::kWork);
  if (!(spec.horizon > 0.0)) return invalid(Field::kHorizon);
  if (spec.near < 0.0) return invalid(Field::kNear);
  if (spec.yaw_rate < kLeastYawRate) return invalid(Field::kYawRate);
  if (!sensor_valid(spec.sensor)) return invalid(Field::kSensor);
  if (spec.clearance < 0 || spec.clearance > kLongestTick) return invalid(Field::kClearance);
  return spec.stale_after >= 0 ? kAccepted : invalid(Field::kStaleAfter);
}

Verdict check_spec(const FlightSpec& spec) {
  const Verdict numbers = check_finite(spec);
  if (numbers.status != Status::kOk) return numbers;
  const Verdict ranges = check_ranges(spec);
  if (ranges.status != Status::kOk) return ranges;
  const Verdict limits = validate_limits(spec.limits);
  if (limits.status != Status::kOk) return limits;
  if (!finite(spec.time_weight)) return {Status::kNonFiniteInput, Field::kTimeWeight};
  return valid_time_weight(spec.time_weight) ? kAccepted : Verdict{Status::kLimitsInvalid, Field::kTimeWeight};
}

/// Along x, where it moves by a word of voxels at a time, the window must be longer than the horizon to either side.
Verdict check_map(const FlightSpec& spec, const RollingMap& map, const std::uint64_t* words, std::size_t word_count) {
  if (!map.bound() || map.busy()) return invalid(Field::kMap);
  const GridSpec& window = map.safe().spec();
  if (!(window.clearance() > 0.0)) return invalid(Field::kRadius);
  const bool leads_too_far = !(spec.horizon < 0.5 * (window.boundary.upper.x - window.boundary.lower.x));
  if (leads_too_far) return invalid(Field::kHorizon);
  const bool has_words = words != nullptr && word_count >= flight_words(window.dims);
  return has_words ? kAccepted : invalid(Field::kStorage);
}

/// Writes into the refusal what is too near to the place where the vehicle would rest.
void find_too_near(const RollingMap& map, const Vec3& place, FlightRefusal& refusal) {
  const Grid& safe = map.safe();
  const GridSpec& window = safe.spec();
  const Vec3 local = safe.to_local(place);
  refusal.needed = window.clearance();
  refusal.distance = window.clearance() + window.cell;
  const NearestSolid solid = nearest_solid(safe, local, refusal.distance);
  if (solid.found) {
    const Blockage nearest_voxel = block_at(map, solid.voxel);
    refusal.blocked_by = nearest_voxel.by;
    refusal.blocked_at = nearest_voxel.at;
    refusal.distance = solid.distance;
  }
  const Box boundary = safe.local_boundary();
  for (int a = 0; a < 3; ++a) {
    const double below = axis(local, a) - axis(boundary.lower, a);
    const double above = axis(boundary.upper, a) - axis(local, a);
    const double apart = larger(0.0, smaller(below, above));
    if (apart >= refusal.distance) continue;
    refusal.blocked_by = BlockedBy::kWindow;
    refusal.blocked_at = place;
    axis(refusal.blocked_at, a) = axis(window.origin, a) + axis(below < above ? boundary.lower : boundary.upper, a);
    refusal.distance = apart;
  }
}

/// Writes into the refusal what is in the way of the vehicle where it stands, or of its way up.
void find_in_column(const FlightFacts& flight, const Draft& draft, FlightRefusal& refusal) {
  Blockage block = kNoBlockage;
  block.note_unproven(flight.map, draft);
  const Grid& safe = flight.map.safe();
  const Vec3& place = flight.plans.in_flight.place;
  refusal.needed = safe.spec().clearance();
  refusal.blocked_by = block.by;
  refusal.blocked_at = block.at;
  refusal.distance = block.is_voxel() ? distance_to_cube(safe, draft.proof.report().voxel, safe.to_local(place)) : 0.0;
}

/// kOk if the vehicle may stay where it is, otherwise why not. On stated ground it may stand, if it can climb.
Status prove_start(FlightFacts& flight, Draft& draft, FlightRefusal& refusal) {
  if (draft.prove_hover(flight)) return Status::kOk;
  const Vec3 place = flight.plans.in_flight.place;
  const GridSpec& window = flight.map.safe().spec();
  refusal.field = Field::kStartPosition;
  refusal.fence = draft.proof.report().fence;
  if (refusal.fence != kNoFence) return Status::kStartFenced;
  double ground = 0.0;
  if (!flight.map.ground_at(place, ground_needed(window), ground)) {
    find_too_near(flight.map, place, refusal);
    return Status::kStartOccupied;
  }
  flight.plans.stand_on(ground);
  draft.begin(flight, 0);
  draft.lift(flight, {place.x, place.y, larger(place.z, height_above(window, ground))}, kAnywhere, place, ground);
  draft.begin_proof(flight, draft.plan.planned, 0.0);
  draft.proof.step(~std::uint32_t{0});
  if (draft.proof.report().finding == Finding::kNone) return Status::kOk;
  refusal.fence = draft.proof.report().fence;
  if (refusal.fence != kNoFence) return Status::kStartFenced;
  find_in_column(flight, draft, refusal);
  return Status::kStartOccupied;
}

/// Checks the call's arguments before anything is written.
Status accept(const FlightSpec& spec, const RollingMap& map, const std::uint64_t* words, std::size_t word_count,
              const Vec3& position, FlightRefusal& refusal) {
  Verdict verdict{Status::kNonFiniteInput, Field::kStartPosition};
  if (finite(position)) verdict = check_spec(spec);
  if (verdict.status == Status::kOk) verdict = check_map(spec, map, words, word_count);
  refusal = FlightRefusal{};
  refusal.field = verdict.field;
  if (verdict.status != Status::kOk) return verdict.status;
  const FenceFault fault = find_fence_fault(spec.fences, spec.fence_count, map.safe().spec());
  if (fault.status == Status::kOk) return Status::kOk;
  refusal.field = Field::kFences;
  refusal.fence = fault.fence;
  return fault.status;
}

}  // namespace

FlightSpec flight_spec(const Limits& limits) noexcept {
  FlightSpec spec{};
  spec.limits = limits;
  spec.time_weight = 1000.0;
  spec.tick = 10000000;
  spec.work_per_tick = 4000;
  spec.plan_work = 16000;
  spec.horizon = 8.0;
  spec.near = smaller(kMostNear, kNearTime * larger(limits.v_max.x, limits.v_max.y));
  spec.yaw_rate = 2.5;
  return spec;
}

size_t flight_words(const Voxel& dims) noexcept {
  const std::size_t grid = grid_words(dims);
  return grid == 0 ? 0 : state_words() + grid + LookoutSearch::words(dims);
}

Status Flight::start(const FlightSpec& spec, const RollingMap& map, Planner& planner, uint64_t* words,
                     size_t word_count, const Vec3& position, int64_t t, FlightRefusal* refusal) noexcept {
  state_ = nullptr;
  FlightRefusal unread;
  FlightRefusal& why = refusal != nullptr ? *refusal : unread;
  const Status accepted = accept(spec, map, words, word_count, position, why);
  if (accepted != Status::kOk) return accepted;
  FlightState* const state = new (words) FlightState{};
  state->cycle.planner = &planner;
  state->facts.begin(spec, map, position, t);
  state->facts.itinerary.forget_goal();
  state->search.look_towards(position);
  const Status rests = prove_start(state->facts, state->draft, why);
  if (rests != Status::kOk) return rests;
  why = FlightRefusal{};
  const Voxel& dims = map.safe().spec().dims;
  state->lookouts.words = words + state_words() + grid_words(dims);
  state->lookouts.try_anew();
  const Status bound = state->cycle.route.bind(map, words + state_words(), grid_words(dims));
  if (bound == Status::kOk) state_ = state;
  return bound;
}

}  // namespace tern
