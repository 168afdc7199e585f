// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "flight/closing.hpp"

#include "base/bounds.hpp"
#include "base/math.hpp"
#include "flight/chain.hpp"
#include "flight/fence_hours.hpp"
#include "grid/lattice.hpp"
#include "prove/fences.hpp"

namespace tern {
namespace {

/// To leave takes so many times as long as the straight way at full speed, and so many seconds more: to find the way,
/// to speed up and to come to rest.
constexpr double kDetour = 2.0;
constexpr double kPlanTime = 3.0;

/// Ways that lead less than so far through a fence end at its face, metres.
constexpr double kAtFace = 1e-9;
/// A plane is not passed on a way that is nearly along it.
constexpr double kLeastSlope = 1e-3;
/// Straight ways out that are told apart, the quickest ones.
constexpr std::int32_t kWaysOut = 4;

struct WaysOut {
  std::int32_t count = 0;
  Vec3 to[kWaysOut];
  double seconds[kWaysOut];  ///< at full speed; in rising order
  double longest = 0.0;      ///< seconds of the longest way, whatever is in it

  /// Of ways that take as long, the one that was added first comes first.
  void add(const Vec3& place, double time) noexcept {
    std::int32_t at = count;
    while (at > 0 && time < seconds[at - 1]) --at;
    if (at == kWaysOut) return;
    if (count < kWaysOut) ++count;
    for (std::int32_t k = count - 1; k > at; --k) {
      to[k] = to[k - 1];
      seconds[k] = seconds[k - 1];
    }
    to[at] = place;
    seconds[at] = time;
  }
};

/// Metres to go along a unit vector from a place in the fence, or too near to it, until the vehicle keeps what it must;
/// 0 if it does there; kAnywhere if that way never ends.
double way_through(const FlightFacts& flight, const Fence& fence, const Vec3& place, const Vec3& way) {
  const GridSpec& window = flight.map.safe().spec();
  const double kept = window.clearance() + kAimVoxels * window.cell;
  double least = kAnywhere;
  for (std::int32_t k = 0; k < fence.count; ++k) {
    const Vec3 normal = (1.0 / length(fence.planes[k].normal)) * fence.planes[k].normal;
    const double depth = fence.planes[k].offset / length(fence.planes[k].normal) - dot(normal, place) + kept;
    if (!(depth > kAtFace)) return 0.0;
    const double slope = dot(normal, way);
    if (slope > kLeastSlope) least = smaller(least, depth / slope);
  }
  return least;
}

/// True for a keep-out that holds now or later, and begins before `fence` ends.
bool holds_meanwhile(const FlightFacts& flight, const Fence& other, const Fence& fence) {
  const FenceHours hours = hours_of(other, flight.time);
  return other.kind == FenceKind::kKeepOut && !hours.is_over() && hours.begin < hours_of(fence, flight.time).end;
}

/// The same until the vehicle is out of all keep-outs that hold meanwhile: zones often come as pieces side by side.
/// Each turn leaves one of them for good, because they are convex.
double way_beyond(const FlightFacts& flight, const Fence& fence, const Vec3& place, const Vec3& way, Work& work) {
  double far = 0.0;
  bool goes_on = true;
  for (std::int32_t turn = 0; goes_on && turn <= flight.spec.fence_count; ++turn) {
    goes_on = false;
    for (std::int32_t k = 0; k < flight.spec.fence_count; ++k) {
      const Fence& other = flight.fences[k];
      if (!holds_meanwhile(flight, other, fence)) continue;
      work.spend(4 * ops::kDot * other.count);
      const double more = way_through(flight, other, place + far * way, way);
      if (!(more > 0.0)) continue;
      far += more;
      goes_on = true;
    }
  }
  return far;
}

/// False if something that was seen is in the way, as far as the window reaches. What climbs or descends must have been
/// seen free, or it would lead through a floor or a ceiling.
bool seems_free(const FlightFacts& flight, const Vec3& from, const Vec3& to, Work& work) {
  const Vec3 way = to - from;
  const GridSpec& window = flight.map.safe().spec();
  const bool is_level = absolute(way.z) < window.cell;
  const Grid& grid = is_level ? flight.map.route() : flight.map.safe();
  const double far = length(way);
  const std::int32_t most = window.dims.x + window.dims.y + window.dims.z;
  work.spend(4 * ops::kDot * most);
  for (std::int32_t k = 1; k <= most && (k - 1) * window.cell < far; ++k) {
    const Vec3 local = grid.to_local(from + (smaller(k * window.cell, far) / far) * way);
    const Voxel v{floor_index(local.x / window.cell, -1, window.dims.x),
                  floor_index(local.y / window.cell, -1, window.dims.y),
                  floor_index(local.z / window.cell, -1, window.dims.z)};
    if (!grid.inside(v)) return is_level;
    if (grid.obstacle(v)) return false;
  }
  return true;
}

/// The straight ways out of a keep-out, square to its faces.
WaysOut ways_out(const FlightFacts& flight, const Fence& fence, const Vec3& place, Work& work) {
  WaysOut ways;
  for (std::int32_t k = 0; k < fence.count; ++k) {
    const Vec3 way = (1.0 / length(fence.planes[k].normal)) * fence.planes[k].normal;
    const double far = way_beyond(flight, fence, place, way, work);
    if (!(far < kAnywhere)) continue;
    const double time = gauge(flight.limits.velocity, far * way);
    ways.longest = larger(ways.longest, time);
    if (seems_free(flight, place, place + far * way, work)) ways.add(place + far * way, time);
  }
  return ways;
}

/// Seconds that it takes to leave a keep-out from a place in it. If no straight way seems free, a way back may be as
/// long as the longest.
double time_to_leave(const FlightFacts& flight, const Fence& fence, const Vec3& place, Work& work) {
  const WaysOut ways = ways_out(flight, fence, place, work);
  return kDetour * (ways.count > 0 ? ways.seconds[0] : ways.longest) + kPlanTime;
}

/// The link that a vehicle must leave before it ends, so that it can stay in the chain.
std::int32_t closing_link(const FlightFacts& flight, const Vec3& place, std::int64_t rests, double spare, Work& work) {
  const WaysOn ways = ways_on(flight, place, rests, work);
  Vec3 to;
  if (ways.count == 0 || !place_on(flight, ways.way[0], place, to, work)) return kNoFence;
  const double time = kDetour * gauge(flight.limits.velocity, to - place) + kPlanTime;
  return ways.way[0].until < time + spare ? ways.way[0].from : kNoFence;
}

}  // namespace

bool is_clear_of(const FlightFacts& flight, const Fence& fence, const Vec3& place, Work& work) noexcept {
  return fence_clear(fence, {place, flight.map.safe().spec().clearance(), 0.0}, &kZero, 1, work);
}

bool is_closed(const Fence& fence, std::int64_t time, double ahead) noexcept {
  if (fence.kind != FenceKind::kKeepOut || !is_timed(fence)) return false;
  const FenceHours hours = hours_of(fence, time);
  return hours.begin < ahead && !hours.is_over();
}

std::int32_t closing_fence(const FlightFacts& flight, const Vec3& place, std::int64_t rests, double spare,
                           Work& work) noexcept {
  for (std::int32_t k = 0; flight.has_windows && k < flight.spec.fence_count; ++k) {
    const Fence& fence = flight.fences[k];
    if (!is_closed(fence, rests, kAnywhere) || is_clear_of(flight, fence, place, work)) continue;
    if (is_closed(fence, rests, time_to_leave(flight, fence, place, work) + spare)) return k;
  }
  return flight.has_chain ? closing_link(flight, place, rests, spare, work) : kNoFence;
}

Vec3 way_on_from(const FlightFacts& flight, const Vec3& place, std::int64_t rests, std::int32_t number,
                 Work& work) noexcept {
  const WaysOn ways = ways_on(flight, place, rests, work);
  const Vec3& next = flight.itinerary.points[flight.itinerary.leg].position;
  Vec3 to;
  if (ways.count == 0) return place;
  const WayOn& way = ways.way[number / 2 % ways.count];
  return place_on(flight, way, number % 2 == 0 ? place : next, to, work) ? to : place;
}

Vec3 way_out_of(const FlightFacts& flight, const Fence& fence, const Vec3& place, std::int32_t number,
                Work& work) noexcept {
  const WaysOut ways = ways_out(flight, fence, place, work);
  return ways.count == 0 ? place : ways.to[number % ways.count];
}

}  // namespace tern
