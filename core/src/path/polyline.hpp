// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_PATH_POLYLINE_HPP
#define TERN_PATH_POLYLINE_HPP

#include "base/capacity.hpp"
#include "base/math.hpp"
#include "tern/path.hpp"
#include "tern/status.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// Length, in metres, of the polyline through `count` points, summed from the first to the last; 0 for fewer than two.
inline double polyline_length(const Vec3* points, int count) noexcept {
  double sum = 0.0;
  for (int k = 1; k < count; ++k) sum += distance(points[k - 1], points[k]);
  return sum;
}

/// Empties the path.
inline void clear_way(Path& way) noexcept {
  way.raw_count = 0;
  way.count = 0;
  way.raw_length = 0.0;
  way.grid_length = 0.0;
  way.length = 0.0;
}

/// Appends a path that begins where the way ends. The waypoint at which they meet is kept only once. kOk, or
/// kJumpPointsFull or kSegmentsFull with the way unchanged.
inline Status append_to_way(const Path& part, Path& way) noexcept {
  const int shared = way.count > 0 ? 1 : 0;
  if (is_full(way.raw_count + part.raw_count - shared > kMaxJumpPoints)) return Status::kJumpPointsFull;
  if (is_full(way.count + part.count - shared > kMaxWaypoints)) return Status::kSegmentsFull;
  for (int i = shared; i < part.raw_count; ++i) way.raw[way.raw_count++] = part.raw[i];
  for (int i = shared; i < part.count; ++i) way.points[way.count++] = part.points[i];
  way.raw_length += part.raw_length;
  way.grid_length += part.grid_length;
  way.length += part.length;
  return Status::kOk;
}

}  // namespace tern

#endif
