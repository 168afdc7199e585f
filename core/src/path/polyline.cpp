// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "path/polyline.hpp"

#include "base/capacity.hpp"

namespace tern {

void clear_way(Path& way) noexcept {
  way.raw_count = 0;
  way.count = 0;
  way.raw_length = 0.0;
  way.grid_length = 0.0;
  way.length = 0.0;
}

Status append_to_way(const Path& part, Path& way) noexcept {
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
