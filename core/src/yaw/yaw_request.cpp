// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/math.hpp"
#include "tern/yaw.hpp"
#include "yaw/yaw_check.hpp"

namespace tern {
namespace {

Status check_timed(const YawRequest& request) {
  if (request.timed == nullptr || request.timed_count < 1) return Status::kInvalidArgument;
  double last = 0.0;
  for (int i = 0; i < request.timed_count; ++i) {
    const TimedHeading& next = request.timed[i];
    if (!finite(next.time)) return Status::kNonFiniteInput;
    const Status status = check_heading(next.heading);
    if (status != Status::kOk) return status;
    if (next.time < last || (i > 0 && !(next.time > last))) return Status::kInvalidArgument;
    last = next.time;
  }
  return Status::kOk;
}

Status check_mode(const YawRequest& request) {
  switch (request.mode) {
    case YawMode::kFixed:
      return check_heading(request.heading);
    case YawMode::kAlongMotion:
      if (!finite(request.least_speed)) return Status::kNonFiniteInput;
      return request.least_speed > 0.0 ? Status::kOk : Status::kInvalidArgument;
    case YawMode::kTowardsPoint:
      if (!finite(request.point) || !finite(request.least_distance)) return Status::kNonFiniteInput;
      return request.least_distance > 0.0 ? Status::kOk : Status::kInvalidArgument;
    case YawMode::kTimed:
      return check_timed(request);
  }
  return Status::kInvalidArgument;
}

}  // namespace

Status check_heading(const Heading& heading) noexcept {
  if (!finite(heading)) return Status::kNonFiniteInput;
  return has_direction(heading) ? Status::kOk : Status::kInvalidArgument;
}

Status check_yaw(const Trajectory& trajectory, const YawRequest& request) noexcept {
  const double numbers[] = {request.rate_max, request.acceleration_max, request.start_rate, request.start_acceleration};
  for (const double number : numbers) {
    if (!finite(number)) return Status::kNonFiniteInput;
  }
  if (!yaw_limits_valid(request.rate_max, request.acceleration_max)) return Status::kLimitsInvalid;
  if (trajectory.count < 1 || trajectory.count > kMaxSegments) return Status::kInvalidArgument;
  const double length = duration(trajectory);
  if (!finite(length)) return Status::kNonFiniteInput;
  const Status start = check_heading(request.start);
  if (start != Status::kOk) return start;
  const bool is_brisk = absolute(request.start_acceleration) > request.acceleration_max * (1.0 + 1e-9);
  if (is_brisk || absolute(request.start_rate) > kLargestYawRate) return Status::kStartExceedsLimits;
  return check_mode(request);
}

YawRequest yaw_request(const Heading& start, double rate_max, double acceleration_max) noexcept {
  YawRequest request{};
  request.mode = YawMode::kAlongMotion;
  request.rate_max = rate_max;
  request.acceleration_max = acceleration_max;
  request.start = start;
  request.heading = start;
  request.least_speed = 0.3;
  request.least_distance = 0.5;
  return request;
}

}  // namespace tern
