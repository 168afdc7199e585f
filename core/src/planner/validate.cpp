// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planner/validate.hpp"

#include "base/bounds.hpp"
#include "base/capacity.hpp"
#include "curve/body_rate.hpp"
#include "grid/lattice.hpp"
#include "planner/previous.hpp"

namespace tern {
namespace {

/// A limit of the vehicle's own, which 0 leaves out, and its range.
struct ScalarLimit {
  double value;
  double least;
  double most;
  Field field;
};

struct VehicleLimits {
  ScalarLimit of[4];
};

VehicleLimits vehicle_limits(const Limits& limits) {
  return {{{limits.thrust_max, kGravity + kMinLimit, kMaxLimit, Field::kThrustMax},
           {limits.thrust_min, kMinLimit, kGravity - kMinLimit, Field::kThrustMin},
           {limits.tilt_tangent, kMinLimit, kMaxLimit, Field::kTiltTangent},
           {limits.rate_max, kMinLimit, kMaxLimit, Field::kRateMax}}};
}

Verdict check_finite(const Limits& limits) {
  const struct {
    const Vec3& value;
    Field field;
  } fields[] = {{limits.v_max, Field::kVMax},
                {limits.a_max, Field::kAMax},
                {limits.v_min, Field::kVMin},
                {limits.a_min, Field::kAMin},
                {limits.j_max, Field::kJMax}};
  for (const auto& entry : fields) {
    if (!finite(entry.value)) return {Status::kNonFiniteInput, entry.field};
  }
  if (!finite(limits.v_horizontal)) return {Status::kNonFiniteInput, Field::kVHorizontal};
  if (!finite(limits.a_horizontal)) return {Status::kNonFiniteInput, Field::kAHorizontal};
  if (!finite(limits.j_horizontal)) return {Status::kNonFiniteInput, Field::kJHorizontal};
  for (const ScalarLimit& limit : vehicle_limits(limits).of) {
    if (!finite(limit.value)) return {Status::kNonFiniteInput, limit.field};
  }
  return kAccepted;
}

Verdict check_finite(const Request& request) {
  const struct {
    const Vec3& value;
    Field field;
  } fields[] = {
      {request.start.position, Field::kStartPosition},         {request.start.velocity, Field::kStartVelocity},
      {request.start.acceleration, Field::kStartAcceleration}, {request.start.jerk, Field::kStartJerk},
      {request.goal.position, Field::kGoalPosition},           {request.goal.velocity, Field::kGoalVelocity},
      {request.goal.acceleration, Field::kGoalAcceleration},   {request.goal.jerk, Field::kGoalJerk},
  };
  for (const auto& entry : fields) {
    if (!finite(entry.value)) return {Status::kNonFiniteInput, entry.field};
  }
  const Verdict limits = check_finite(request.limits);
  if (limits.status != Status::kOk) return limits;
  if (!finite(request.time_weight)) return {Status::kNonFiniteInput, Field::kTimeWeight};
  if (request.previous != nullptr && !finite(request.previous_time)) return {Status::kNonFiniteInput, Field::kPrevious};
  return kAccepted;
}

bool in_range(double limit) {
  return limit >= kMinLimit && limit <= kMaxLimit;
}

/// A limit of zero, on an axis or on the horizontal norm, was not given.
bool is_given(double limit) {
  return limit < 0.0 || limit > 0.0;
}

bool valid_upper(const Vec3& limit) {
  return in_range(limit.x) && in_range(limit.y) && in_range(limit.z);
}

bool valid_lower(const Vec3& limit) {
  for (int a = 0; a < 3; ++a) {
    if (is_given(axis(limit, a)) && !in_range(-axis(limit, a))) return false;
  }
  return true;
}

bool valid_jerk(double limit) {
  return !is_given(limit) || (limit >= kMinLimit && limit <= kMaxJerk);
}

bool valid_horizontal(double limit) {
  return !is_given(limit) || in_range(limit);
}

Verdict check_limits(const Limits& limits) {
  if (!valid_upper(limits.v_max)) return {Status::kLimitsInvalid, Field::kVMax};
  if (!valid_upper(limits.a_max)) return {Status::kLimitsInvalid, Field::kAMax};
  if (!valid_lower(limits.v_min)) return {Status::kLimitsInvalid, Field::kVMin};
  if (!valid_lower(limits.a_min)) return {Status::kLimitsInvalid, Field::kAMin};
  if (!valid_horizontal(limits.v_horizontal)) return {Status::kLimitsInvalid, Field::kVHorizontal};
  if (!valid_horizontal(limits.a_horizontal)) return {Status::kLimitsInvalid, Field::kAHorizontal};
  const Vec3& jerk = limits.j_max;
  if (!valid_jerk(jerk.x) || !valid_jerk(jerk.y) || !valid_jerk(jerk.z)) return {Status::kLimitsInvalid, Field::kJMax};
  if (!valid_jerk(limits.j_horizontal)) return {Status::kLimitsInvalid, Field::kJHorizontal};
  for (const ScalarLimit& limit : vehicle_limits(limits).of) {
    const bool valid = !is_given(limit.value) || (limit.value >= limit.least && limit.value <= limit.most);
    if (!valid) return {Status::kLimitsInvalid, limit.field};
  }
  const bool lacks_thrust = limits.rate_max > 0.0 && !(limits.thrust_min > 0.0);
  if (lacks_thrust) return {Status::kLimitsInvalid, Field::kThrustMin};
  return kAccepted;
}

bool within_limit(const Vec3& value, const Bounds& bounds) {
  return gauge(bounds, value) <= 1.0 + kLimitSlack;
}

bool within_jerk(const Vec3& jerk, const Bounds& bounds) {
  for (int a = 0; a < 3; ++a) {
    if (absolute(axis(jerk, a)) > kMaxJerk) return false;
  }
  return within_limit(jerk, bounds);
}

/// Fields of one end.
struct EndFields {
  Status status;
  Field velocity;
  Field acceleration;
  Field jerk;
};

Verdict check_state(const State& state, const MotionLimits& limits, const EndFields& fields) {
  if (!within_limit(state.velocity, limits.velocity)) return {fields.status, fields.velocity};
  if (!within_limit(state.acceleration, limits.acceleration)) return {fields.status, fields.acceleration};
  const bool turns_too_fast =
      limits.rate > 0.0 && body_rate(state.acceleration, state.jerk) > (1.0 + kLimitSlack) * limits.rate;
  const bool within = within_jerk(state.jerk, limits.jerk) && !turns_too_fast;
  return within ? kAccepted : Verdict{fields.status, fields.jerk};
}

Verdict check_states(const Request& request, const MotionLimits& limits) {
  constexpr EndFields kStart{Status::kStartExceedsLimits, Field::kStartVelocity, Field::kStartAcceleration,
                             Field::kStartJerk};
  constexpr EndFields kGoal{Status::kGoalExceedsLimits, Field::kGoalVelocity, Field::kGoalAcceleration,
                            Field::kGoalJerk};
  const Verdict start = check_state(request.start, limits, kStart);
  return start.status != Status::kOk ? start : check_state(request.goal, limits, kGoal);
}

/// True if the mode is one of the enumeration: a caller in C can pass any byte.
bool known(GoalMode mode) {
  return mode == GoalMode::kExact || mode == GoalMode::kNearest;
}

bool known(SearchMode mode) {
  return mode == SearchMode::kFast || mode == SearchMode::kOptimal;
}

bool in_map(const Grid& grid, const Vec3& world) {
  const Vec3 local = to_local(grid, world);
  const Box boundary = grid.local_boundary();
  for (int a = 0; a < 3; ++a) {
    if (axis(local, a) < axis(boundary.lower, a) || axis(local, a) > axis(boundary.upper, a)) return false;
  }
  return true;
}

/// s: a previous plan is at most this far from the clock that the tracks have.
constexpr double kClockSlack = 1e-6;

Status check_via(const Grid& grid, const Via& via, const MotionLimits& limits) {
  if (!finite(via.position) || !finite(via.tolerance) || !finite(via.dwell)) return Status::kNonFiniteInput;
  if (via.has_velocity && !finite(via.velocity)) return Status::kNonFiniteInput;
  if (via.tolerance < 0.0 || (via.stop && via.has_velocity) || !dwell_valid(via)) return Status::kInvalidArgument;
  if (!in_map(grid, via.position)) return Status::kOutOfMap;
  const bool within = !via.has_velocity || within_limit(via.velocity, limits.velocity);
  return within ? Status::kOk : Status::kViaExceedsLimits;
}

}  // namespace

bool valid_time_weight(double weight) noexcept {
  return weight >= kMinTimeWeight && weight <= kMaxTimeWeight;
}

Verdict validate_limits(const Limits& limits) noexcept {
  const Verdict numbers = check_finite(limits);
  return numbers.status != Status::kOk ? numbers : check_limits(limits);
}

Verdict validate(const Grid& grid, const Request& request, MotionLimits& limits) noexcept {
  const Verdict numbers = check_finite(request);
  if (numbers.status != Status::kOk) return numbers;
  const Verdict ranges = check_limits(request.limits);
  if (ranges.status != Status::kOk) return ranges;
  limits = MotionLimits(request.limits);
  if (!valid_time_weight(request.time_weight)) return {Status::kLimitsInvalid, Field::kTimeWeight};
  if (!known(request.search)) return {Status::kInvalidArgument, Field::kSearch};
  if (!known(request.goal_mode)) return {Status::kInvalidArgument, Field::kGoalMode};
  if (request.previous != nullptr && !previous_fits(request)) return {Status::kInvalidArgument, Field::kPrevious};
  if (!in_map(grid, request.start.position)) return {Status::kOutOfMap, Field::kStartPosition};
  if (!in_map(grid, request.goal.position)) return {Status::kOutOfMap, Field::kGoalPosition};
  return check_states(request, limits);
}

Verdict validate_tracks(const Request& request) noexcept {
  if (!finite(request.rest_clear)) return {Status::kNonFiniteInput, Field::kRestClear};
  const bool fits = request.rest_clear >= 0.0 && request.rest_clear <= kRestHorizon;
  if (!fits) return {Status::kInvalidArgument, Field::kRestClear};
  return request.track_count == 0 ? kAccepted : validate_clock(request);
}

Verdict validate_clock(const Request& request) noexcept {
  if (request.previous == nullptr) return kAccepted;
  const double apart = request.previous_time - time_on(*request.previous, request.begin);
  return absolute(apart) <= kClockSlack ? kAccepted : Verdict{Status::kInvalidArgument, Field::kPrevious};
}

Verdict validate_vias(const Grid& grid, const Request& request, const MotionLimits& limits,
                      std::int32_t& via) noexcept {
  via = kNoVia;
  if (request.via_count == 0) return kAccepted;
  if (request.via_count < 0 || request.vias == nullptr) return {Status::kInvalidArgument, Field::kVias};
  if (is_full(request.via_count > kMaxVias)) return {Status::kViasFull, Field::kVias};
  if (request.goal_mode != GoalMode::kExact) return {Status::kInvalidArgument, Field::kGoalMode};
  if (request.previous != nullptr) return {Status::kInvalidArgument, Field::kPrevious};
  for (std::int32_t v = 0; v < request.via_count; ++v) {
    const Status status = check_via(grid, request.vias[v], limits);
    if (status == Status::kOk) continue;
    via = v;
    return {status, Field::kVias};
  }
  return kAccepted;
}

Vec3 to_local(const Grid& grid, const Vec3& position) noexcept {
  Vec3 local = grid.to_local(position);
  for (int a = 0; a < 3; ++a) axis(local, a) = onto_boundary(grid, axis(local, a), a);
  return local;
}

Request to_local(const Grid& grid, const Request& request) noexcept {
  Request local = request;
  local.start.position = to_local(grid, request.start.position);
  local.goal.position = to_local(grid, request.goal.position);
  return local;
}

}  // namespace tern
