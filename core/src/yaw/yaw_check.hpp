// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_YAW_YAW_CHECK_HPP
#define TERN_YAW_YAW_CHECK_HPP

#include "tern/yaw.hpp"

namespace tern {

/// Largest rate of a start, rad/s: no vehicle turns faster.
constexpr double kLargestYawRate = 100.0;

/// kOk, or what is wrong with a request: see YawPlanner::plan().
Status check_yaw(const Trajectory& trajectory, const YawRequest& request) noexcept;

}  // namespace tern

#endif
