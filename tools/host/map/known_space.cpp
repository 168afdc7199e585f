// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/map/known_space.hpp"

#include <algorithm>
#include <cmath>

#include "host/number.hpp"

namespace tern_host {
namespace {

/// Part of a cell by which a face may be beyond a cell's and count as on it.
constexpr double kSlack = 1e-6;
/// Cells from the world's origin that a number keeps its precision to.
constexpr double kFarthest = 1e9;
constexpr std::int64_t kHalfTree = 32768;

}  // namespace

/// The cells that an interval meets.
KnownSpace::Range KnownSpace::cells(double lower, double upper, double slack) const {
  const auto index = [](double cell) { return static_cast<std::int64_t>(std::clamp(cell, -kFarthest, kFarthest)); };
  return {index(std::floor(lower / resolution_ + slack)), index(std::ceil(upper / resolution_ - slack))};
}

std::size_t KnownSpace::row(std::int64_t y, std::int64_t z) const {
  return static_cast<std::size_t>(((z - origin_[2]) * counts_[1] + (y - origin_[1])) * counts_[0]);
}

KnownSpace::KnownSpace(const Octomap& map, const tern::Box& within, const Place& place) : resolution_(map.resolution) {
  const double lower[3] = {within.lower.x, within.lower.y, within.lower.z};
  const double upper[3] = {within.upper.x, within.upper.y, within.upper.z};
  double count = 1.0;
  for (int a = 0; a < 3; ++a) {
    const Range range = cells(lower[a], upper[a], -kSlack);
    origin_[a] = range.begin;
    counts_[a] = range.end - range.begin;
    count *= static_cast<double>(counts_[a]);
  }
  if (count > kMaxKnownCells) {
    throw RecordError(place, "the boundary has more than " + brief(kMaxKnownCells) + " cells of " + brief(resolution_) +
                                 " m: make it smaller, or the map coarser");
  }
  free_.assign(static_cast<std::size_t>(count), false);
  for (const OctomapLeaf& leaf : map.leaves) {
    if (!leaf.occupied) add(leaf);
  }
}

void KnownSpace::add(const OctomapLeaf& leaf) {
  Range ranges[3];
  for (int a = 0; a < 3; ++a) {
    const std::int64_t begin = static_cast<std::int64_t>(leaf.key[a]) - kHalfTree;
    ranges[a] = {std::max(begin, origin_[a]), std::min(begin + leaf.size, origin_[a] + counts_[a])};
    if (ranges[a].begin >= ranges[a].end) return;
  }
  for (std::int64_t z = ranges[2].begin; z < ranges[2].end; ++z) {
    for (std::int64_t y = ranges[1].begin; y < ranges[1].end; ++y) {
      const auto first = free_.begin() + static_cast<std::ptrdiff_t>(row(y, z)) - origin_[0];
      std::fill(first + ranges[0].begin, first + ranges[0].end, true);
    }
  }
}

bool KnownSpace::free(const tern::Box& box) const {
  const Range ranges[3] = {cells(box.lower.x, box.upper.x, kSlack), cells(box.lower.y, box.upper.y, kSlack),
                           cells(box.lower.z, box.upper.z, kSlack)};
  for (int a = 0; a < 3; ++a) {
    if (ranges[a].begin < origin_[a] || ranges[a].end > origin_[a] + counts_[a]) return false;
  }
  for (std::int64_t z = ranges[2].begin; z < ranges[2].end; ++z) {
    for (std::int64_t y = ranges[1].begin; y < ranges[1].end; ++y) {
      const auto first = free_.begin() + static_cast<std::ptrdiff_t>(row(y, z)) - origin_[0];
      const auto last = first + ranges[0].end;
      if (std::find(first + ranges[0].begin, last, false) != last) return false;
    }
  }
  return true;
}

}  // namespace tern_host
