// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_PATH_POLYLINE_HPP
#define TERN_PATH_POLYLINE_HPP

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
void clear_way(Path& way) noexcept;

/// Appends a path that begins where the way ends. The waypoint at which they meet is kept only once. kOk, or
/// kJumpPointsFull or kSegmentsFull with the way unchanged.
Status append_to_way(const Path& part, Path& way) noexcept;

}  // namespace tern

#endif
