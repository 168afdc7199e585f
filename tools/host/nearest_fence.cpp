// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/nearest_fence.hpp"

#include <algorithm>
#include <limits>

#include "tern/tern.hpp"

namespace tern_host {
namespace {

constexpr int kSamples = 400;

bool holds(const tern::Fence& fence, double time) {
  const double ns = 1e9 * time, off = 1e9 * fence.clock_error;
  return !tern::is_timed(fence) ||
         (ns >= static_cast<double>(fence.from) - off && ns <= static_cast<double>(fence.until) + off);
}

}  // namespace

NearestFence nearest_fence(const tern::Trajectory& plan, const Scenario& scenario) {
  NearestFence nearest;
  nearest.gap = std::numeric_limits<double>::infinity();
  for (int k = 0; k <= kSamples; ++k) {
    const double t = tern::duration(plan) * k / kSamples;
    const tern::Vec3 at = tern::evaluate(plan, t).position;
    for (std::size_t i = 0; i < scenario.fences.size(); ++i) {
      const FenceRecord& fence = scenario.fences[i];
      if (!holds(fence.fence, scenario.start_time + t)) continue;
      // No plane of a keep-out is farther away than the keep-out: most need no more than this.
      const bool keeps_in = fence.fence.kind == tern::FenceKind::kKeepIn;
      if (!keeps_in && beyond_planes(fence, at) >= nearest.gap) continue;
      const double gap = fence_gap(fence, at);
      if (gap < nearest.gap) nearest = {static_cast<std::int32_t>(i), gap};
    }
  }
  return nearest;
}

}  // namespace tern_host
