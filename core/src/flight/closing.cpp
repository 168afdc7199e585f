// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "flight/closing.hpp"

#include "base/bounds.hpp"
#include "base/math.hpp"
#include "prove/fences.hpp"

namespace tern {
namespace {

/// To leave takes so many times as long as the straight way at full speed, and so many seconds more: to find the way,
/// to speed up and to come to rest.
constexpr double kDetour = 2.0;
constexpr double kPlanTime = 3.0;

/// Metres to go from a place until it is behind the plane by what a vehicle keeps; <= 0 if it is.
double way_through(const FlightFacts& flight, const Halfspace& plane, const Vec3& place) {
  const GridSpec& window = flight.map.safe().spec();
  const double depth = (plane.offset - dot(plane.normal, place)) / length(plane.normal);
  return depth + window.clearance() + kAimVoxels * window.cell;
}

/// Seconds that it takes to leave a keep-out from a place in it.
double time_to_leave(const FlightFacts& flight, const Fence& fence, const Vec3& place) {
  double least = kAnywhere;
  for (std::int32_t k = 0; k < fence.count; ++k) {
    const Halfspace& plane = fence.planes[k];
    const Vec3 way = (larger(0.0, way_through(flight, plane, place)) / length(plane.normal)) * plane.normal;
    least = smaller(least, gauge(flight.limits.velocity, way));
  }
  return kDetour * least + kPlanTime;
}

}  // namespace

bool is_clear_of(const FlightFacts& flight, const Fence& fence, const Vec3& place, Work& work) noexcept {
  return fence_clear(fence, {place, flight.map.safe().spec().clearance(), 0.0}, &kZero, 1, work);
}

bool is_closed(const Fence& fence, std::int64_t time, double ahead) noexcept {
  if (fence.kind != FenceKind::kKeepOut || !is_timed(fence)) return false;
  return seconds_between(time, fence.from) - fence.clock_error < ahead &&
         seconds_between(time, fence.until) + fence.clock_error > 0.0;
}

std::int32_t closing_fence(const FlightFacts& flight, const Vec3& place, std::int64_t rests, double spare,
                           Work& work) noexcept {
  for (std::int32_t k = 0; flight.has_windows && k < flight.spec.fence_count; ++k) {
    const Fence& fence = flight.fences[k];
    work.spend(ops::kPiece + 4 * ops::kDot * fence.count);
    if (!is_closed(fence, rests, time_to_leave(flight, fence, place) + spare)) continue;
    if (!is_clear_of(flight, fence, place, work)) return k;
  }
  return kNoFence;
}

Vec3 way_out_of(const FlightFacts& flight, const Fence& fence, const Vec3& place, std::int32_t number,
                Work& work) noexcept {
  work.spend(ops::kPiece + 4 * ops::kDot * fence.count * fence.count);
  for (std::int32_t k = 0; k < fence.count; ++k) {
    const Halfspace& plane = fence.planes[k];
    const double way = way_through(flight, plane, place);
    std::int32_t before = 0;
    for (std::int32_t other = 0; other < fence.count; ++other) {
      const double its = way_through(flight, fence.planes[other], place);
      if (its < way || (!(way < its) && other < k)) ++before;
    }
    // The face of this number has as many faces nearer than it; of equally near ones, the earlier counts as nearer.
    if (before == number % fence.count) return place + (way / length(plane.normal)) * plane.normal;
  }
  return place;
}

}  // namespace tern
