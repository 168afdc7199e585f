// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/nearest_fence.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host/nanoseconds.hpp"
#include "tern/tern.hpp"

namespace tern_host {
namespace {

/// Samples of a stretch that is as near as any are so far apart, metres: between two, a gap is less by half of that.
constexpr double kStep = 2.0 * kGapError;

/// A part of a plan without a joint, seconds since its beginning, and a speed that it keeps.
struct Stretch {
  double from, until;
  double speed;
};

/// The derivative's control points bound the speed.
double speed_of(const tern::Segment& segment) {
  double most = 0.0;
  for (int i = 0; i + 1 < tern::kControlPoints; ++i) {
    const tern::Vec3 &a = segment.points[i], &b = segment.points[i + 1];
    most = std::max(most, std::hypot(std::hypot(b.x - a.x, b.y - a.y), b.z - a.z));
  }
  return most * (tern::kControlPoints - 1) / segment.duration;
}

/// The part at which the fence holds; empty if it does not.
Stretch while_held(const Stretch& part, const tern::Fence& fence, double start_time) {
  if (!tern::is_timed(fence)) return part;
  const double from = seconds_of(fence.from) - fence.clock_error - start_time;
  const double until = seconds_of(fence.until) + fence.clock_error - start_time;
  return {std::max(part.from, from), std::min(part.until, until), part.speed};
}

/// The least gap of samples on the stretch, if that is less than `least`. No gap falls faster than the vehicle is fast.
double least_gap(const tern::Trajectory& plan, const Stretch& part, const FenceRecord& fence, double least) {
  const bool keeps_in = fence.fence.kind == tern::FenceKind::kKeepIn;
  for (double t = part.from; t <= part.until;) {
    const tern::Vec3 at = tern::evaluate(plan, t).position;
    // No plane of a keep-out is farther away than the keep-out: most need no more than this.
    double gap = keeps_in ? fence_gap(fence, at) : beyond_planes(fence, at);
    if (!keeps_in && gap < least) gap = fence_gap(fence, at);
    least = std::min(least, gap);
    if (t >= part.until) break;
    const double way = gap - least + kStep;
    t = way < part.speed * (part.until - t) ? t + way / part.speed : part.until;
  }
  return least;
}

}  // namespace

NearestFence nearest_fence(const tern::Trajectory& plan, const Scenario& scenario) {
  NearestFence nearest;
  nearest.gap = std::numeric_limits<double>::infinity();
  double begin = 0.0;
  for (int s = 0; s < plan.count; ++s) {
    const tern::Segment& segment = plan.segments[s];
    const Stretch part{begin, begin + segment.duration, speed_of(segment)};
    begin = part.until;
    for (std::size_t i = 0; i < scenario.fences.size(); ++i) {
      const FenceRecord& fence = scenario.fences[i];
      // A plan may leave a keep-in for a while into the next one, so its faces are no bounds.
      if (tern::is_timed(fence.fence) && fence.fence.kind == tern::FenceKind::kKeepIn) continue;
      const double gap = least_gap(plan, while_held(part, fence.fence, scenario.start_time), fence, nearest.gap);
      if (gap < nearest.gap) nearest = {static_cast<std::int32_t>(i), gap};
    }
  }
  return nearest;
}

}  // namespace tern_host
