// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_MAP_KNOWN_SPACE_HPP
#define TERN_HOST_MAP_KNOWN_SPACE_HPP

#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/map/octomap_file.hpp"
#include "tern/grid.hpp"

namespace tern_host {

/// Cells that the free space of one file takes at most: a bit each.
constexpr double kMaxKnownCells = 8.0 * 1024 * 1024 * 1024;

/// What one OctoMap says is free, within a box: its smallest cubes, a bit each.
class KnownSpace {
 public:
  /// Throws ScenarioError naming `place` where the box has more than kMaxKnownCells cells.
  KnownSpace(const Octomap& map, const tern::Box& within, const Place& place);

  /// True where no part of the box is occupied, unknown, or beyond what the map was cut to; but for rounding.
  bool free(const tern::Box& box) const;

 private:
  struct Range {
    std::int64_t begin;
    std::int64_t end;
  };
  Range cells(double lower, double upper, double slack) const;
  void add(const OctomapLeaf& leaf);
  std::size_t row(std::int64_t y, std::int64_t z) const;

  double resolution_;
  std::int64_t origin_[3];
  std::int64_t counts_[3];
  std::vector<bool> free_;
};

}  // namespace tern_host

#endif
