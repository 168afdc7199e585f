// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_YAW_YAW_CHECK_HPP
#define TERN_YAW_YAW_CHECK_HPP

#include "base/math.hpp"
#include "tern/yaw.hpp"

namespace tern {

/// Largest rate of a start, rad/s: no vehicle turns faster.
constexpr double kLargestYawRate = 100.0;

inline bool finite(const Heading& heading) {
  return finite(heading.cosine) && finite(heading.sine);
}

/// True for a heading of any length but 0.
inline bool has_direction(const Heading& heading) {
  return absolute(heading.cosine) > 0.0 || absolute(heading.sine) > 0.0;
}

/// True if the limits, in rad/s and rad/s^2, are in the ranges of YawRequest.
inline bool yaw_limits_valid(double rate, double acceleration) {
  return rate >= 0.01 && rate <= kLargestYawRate && acceleration >= 0.01 && acceleration <= 1000.0;
}

/// kNonFiniteInput; kInvalidArgument without a direction; kOk.
Status check_heading(const Heading& heading) noexcept;

/// kOk, or what is wrong with a request: see YawPlanner::plan().
Status check_yaw(const Trajectory& trajectory, const YawRequest& request) noexcept;

}  // namespace tern

#endif
