// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The yardstick: a plain A* on the grid that Tern searches, by the same rules. Host only; allocates once a map.
#ifndef TERN_BENCH_PLAIN_ASTAR_HPP
#define TERN_BENCH_PLAIN_ASTAR_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "tern/grid.hpp"

namespace tern_bench {

/// A* with 26 neighbours and no corner cutting: a byte a voxel in an array padded with blocked voxels, node state in a
/// flat array that epochs clear, a binary heap that may hold a node twice, the octile heuristic, ties for the greater
/// g. What a careful programmer writes without jump points; it shares no code with the core.
class PlainAStar {
 public:
  /// Copies the grid's blocked layer.
  explicit PlainAStar(const tern::Grid& grid);

  /// True where a path was found between two free voxels.
  bool run(const tern::Voxel& start, const tern::Voxel& goal);

  /// Of the last run: voxels expanded; cost of the path in 2^-36 voxels, with sqrt(2) and sqrt(3) rounded down.
  std::uint64_t expanded() const { return expanded_; }
  std::uint64_t cost() const { return cost_; }
  /// Voxels of the last run's path, start and goal included; empty where there was none.
  std::vector<tern::Voxel> path() const;

 private:
  struct Node {
    std::uint64_t g;
    std::uint32_t epoch;  ///< of the run that reached the voxel: 2 * run, or 2 * run + 1 once it is closed
    std::int32_t parent;
  };
  struct Entry {
    std::uint64_t f;
    std::uint64_t g;
    std::int32_t index;
  };
  struct Move {
    tern::Voxel step;
    std::int32_t offset;
    std::uint64_t cost;
    std::uint32_t box;  ///< cells of the 3x3x3 neighbourhood that must be free
  };

  std::int32_t index_of(const tern::Voxel& voxel) const;
  tern::Voxel voxel_of(std::int32_t index) const;
  std::uint32_t free_around(std::int32_t index) const;
  void expand(const Entry& entry, const tern::Voxel& goal);
  void push(const Entry& entry);
  Entry pop();

  std::int32_t width_;  ///< of the padded array along x, and along x and y together
  std::int32_t slice_;
  std::vector<std::uint8_t> free_;
  std::vector<Node> nodes_;
  std::vector<Entry> open_;
  std::array<Move, 26> moves_;
  std::uint32_t epoch_ = 0;
  std::uint64_t expanded_ = 0;
  std::uint64_t cost_ = 0;
  std::int32_t goal_ = -1;
};

}  // namespace tern_bench

#endif
