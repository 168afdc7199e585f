// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planner/request.hpp"

#include "base/math.hpp"

namespace tern {
namespace {

/// Relative excess of a boundary state over a limit that still counts as the limit.
constexpr double kLimitSlack = 1e-9;

constexpr Verdict kAccepted{Status::kOk, Field::kNone};

Verdict check_finite(const Request& request) {
  const struct {
    const Vec3& value;
    Field field;
  } fields[] = {
      {request.start.position, Field::kStartPosition},
      {request.start.velocity, Field::kStartVelocity},
      {request.start.acceleration, Field::kStartAcceleration},
      {request.goal.position, Field::kGoalPosition},
      {request.goal.velocity, Field::kGoalVelocity},
      {request.goal.acceleration, Field::kGoalAcceleration},
      {request.limits.v_max, Field::kVMax},
      {request.limits.a_max, Field::kAMax},
  };
  for (const auto& entry : fields) {
    if (!finite(entry.value)) return {Status::kNonFiniteInput, entry.field};
  }
  return kAccepted;
}

bool valid_limit(const Vec3& limit) {
  for (int a = 0; a < 3; ++a) {
    if (axis(limit, a) < kMinLimit || axis(limit, a) > kMaxLimit) return false;
  }
  return true;
}

bool within_limit(const Vec3& value, const Vec3& limit) {
  for (int a = 0; a < 3; ++a) {
    if (absolute(axis(value, a)) > axis(limit, a) * (1.0 + kLimitSlack)) return false;
  }
  return true;
}

bool in_map(const Grid& grid, const Vec3& world) {
  const Vec3 local = grid.to_local(world);
  const Box boundary = grid.local_boundary();
  const double slack = kLatticeTolerance * grid.spec().cell;
  for (int a = 0; a < 3; ++a) {
    if (axis(local, a) < axis(boundary.lower, a) - slack || axis(local, a) > axis(boundary.upper, a) + slack)
      return false;
  }
  return true;
}

State state_to_local(const Grid& grid, const State& state) {
  State local = state;
  local.position = grid.to_local(state.position);
  const Box boundary = grid.local_boundary();
  for (int a = 0; a < 3; ++a) {
    axis(local.position, a) = clamp(axis(local.position, a), axis(boundary.lower, a), axis(boundary.upper, a));
  }
  return local;
}

}  // namespace

Verdict validate(const Grid& grid, const Request& request) noexcept {
  const Verdict numbers = check_finite(request);
  if (numbers.status != Status::kOk) return numbers;
  if (!valid_limit(request.limits.v_max)) return {Status::kLimitsInvalid, Field::kVMax};
  if (!valid_limit(request.limits.a_max)) return {Status::kLimitsInvalid, Field::kAMax};
  if (!in_map(grid, request.start.position)) return {Status::kOutOfMap, Field::kStartPosition};
  if (!in_map(grid, request.goal.position)) return {Status::kOutOfMap, Field::kGoalPosition};
  if (!within_limit(request.start.velocity, request.limits.v_max)) {
    return {Status::kStartExceedsLimits, Field::kStartVelocity};
  }
  if (!within_limit(request.start.acceleration, request.limits.a_max)) {
    return {Status::kStartExceedsLimits, Field::kStartAcceleration};
  }
  if (!within_limit(request.goal.velocity, request.limits.v_max)) {
    return {Status::kGoalExceedsLimits, Field::kGoalVelocity};
  }
  if (!within_limit(request.goal.acceleration, request.limits.a_max)) {
    return {Status::kGoalExceedsLimits, Field::kGoalAcceleration};
  }
  return kAccepted;
}

Request to_local(const Grid& grid, const Request& request) noexcept {
  Request local = request;
  local.start = state_to_local(grid, request.start);
  local.goal = state_to_local(grid, request.goal);
  return local;
}

}  // namespace tern
