// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_NEAREST_FENCE_HPP
#define TERN_HOST_NEAREST_FENCE_HPP

#include <cstdint>

#include "host/scenario.hpp"
#include "tern/trajectory.hpp"

namespace tern_host {

/// By how much the least gap may be overstated, metres.
constexpr double kGapError = 0.01;

/// The fence that a plan comes nearest to while it holds, and how near, m, to kGapError.
struct NearestFence {
  std::int32_t index = -1;  ///< -1: no fence holds during the plan
  double gap = 0.0;
};

NearestFence nearest_fence(const tern::Trajectory& plan, const Scenario& scenario);

}  // namespace tern_host

#endif
