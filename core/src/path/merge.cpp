// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "path/merge.hpp"

#include "base/capacity.hpp"
#include "base/math.hpp"
#include "base/work.hpp"
#include "path/polyline.hpp"
#include "path/sight.hpp"

namespace tern {
namespace {

/// The unit vector from a to b; zero if they are equal.
Vec3 unit(const Vec3& a, const Vec3& b) {
  const double way = distance(a, b);
  return way > 0.0 ? (1.0 / way) * (b - a) : kZero;
}

/// The pair that may be merged, with a waypoint on either side.
const Vec3* last_pair(const Path& path) {
  return path.points + path.count - 3;
}

bool has_trial(const Merge& merge, const Path& path) {
  return path.count >= 4 && merge.trial < kMergeTrials;
}

/// A place for one waypoint instead of two. Seen from the middle between them, it lies where the legs before and after
/// them would meet if they went on.
Vec3 place(const Merge& merge, const Vec3* pair) {
  double out = kMergeNearest * distance(pair[0], pair[1]);
  for (int k = 0; k < merge.trial; ++k) out *= 2.0;
  return 0.5 * (pair[0] + pair[1]) + out * (unit(pair[-1], pair[0]) + unit(pair[2], pair[1]));
}

void try_place(Merge& merge, const Grid& grid, Path& path) {
  const Vec3* const pair = last_pair(path);
  const Vec3 at = place(merge, pair);
  ++merge.trial;
  if (!line_of_sight(grid, pair[-1], at) || !line_of_sight(grid, at, pair[2])) return;
  path.points[path.count - 3] = at;
  path.points[path.count - 2] = path.points[path.count - 1];
  --path.count;
  merge.trial = 0;
}

}  // namespace

void merge_begin(Merge& merge, Shortcut& shortcut, Path& path) noexcept {
  std::int32_t after = -1;
  for (std::int32_t i = path.raw_count - 1; i > 0;) {
    const std::int32_t before = shortcut.ends[i].from;
    shortcut.ends[i].from = after;
    after = i;
    i = before;
  }
  path.points[0] = path.raw[0];
  path.count = 1;
  merge.next = after;
  merge.trial = 0;
}

Operations merge_operations(const Merge& merge, const Grid& grid, const Path& path) noexcept {
  if (!has_trial(merge, path)) return ops::kPiece;
  const Vec3* const pair = last_pair(path);
  return ops::kPiece + sight_operations(grid, pair[-1], pair[1]) + sight_operations(grid, pair[0], pair[2]);
}

Status merge_step(Merge& merge, const Shortcut& shortcut, const Grid& grid, Path& path) noexcept {
  if (has_trial(merge, path)) {
    try_place(merge, grid, path);
    return Status::kRunning;
  }
  if (merge.next < 0) {
    path.length = polyline_length(path.points, path.count);
    return Status::kOk;
  }
  if (is_full(path.count == kMaxWaypoints)) return Status::kSegmentsFull;
  path.points[path.count++] = path.raw[merge.next];
  merge.next = shortcut.ends[merge.next].from;
  merge.trial = 0;
  return Status::kRunning;
}

}  // namespace tern
