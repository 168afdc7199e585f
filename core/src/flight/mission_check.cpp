// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What is wrong with a mission.
#include "base/capacity.hpp"
#include "base/math.hpp"
#include "flight/flight_state.hpp"
#include "planner/validate.hpp"

namespace tern {
namespace {

/// kOk if nothing is wrong with the point. Tolerance, stop and dwell of the goal mean nothing. A velocity cannot be
/// promised in unknown space.
Status check_point(const Via& point, bool is_goal) {
  if (!finite(point.position)) return Status::kNonFiniteInput;
  if (point.has_velocity) return Status::kInvalidArgument;
  if (is_goal) return Status::kOk;
  if (!finite(point.tolerance) || !finite(point.dwell)) return Status::kNonFiniteInput;
  return point.tolerance < 0.0 || !dwell_valid(point) ? Status::kInvalidArgument : Status::kOk;
}

}  // namespace

Status check_mission(const Via* points, std::int32_t count, ViaPolicy policy) noexcept {
  if (points == nullptr || count < 1) return Status::kInvalidArgument;
  if (policy != ViaPolicy::kEnd && policy != ViaPolicy::kSkip) return Status::kInvalidArgument;
  if (is_full(count > kMaxMissionPoints)) return Status::kViasFull;
  for (std::int32_t i = 0; i < count; ++i) {
    const Status status = check_point(points[i], i + 1 == count);
    if (status != Status::kOk) return status;
  }
  return Status::kOk;
}

}  // namespace tern
