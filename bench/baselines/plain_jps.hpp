// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Jump point search as textbooks have it, on the grid that Tern searches: what Tern's own search is without its scans
// of 64 voxels a word, its limit on sweeps and its fixed capacities.
#ifndef TERN_BENCH_PLAIN_JPS_HPP
#define TERN_BENCH_PLAIN_JPS_HPP

#include <cstdint>
#include <queue>
#include <vector>

#include "base/direction.hpp"
#include "tern/grid.hpp"

namespace tern_bench {

/// Optimal: 26 neighbours, no corner cutting, the octile heuristic, Tern's pruning rules (docs/search.md). Every jump
/// walks voxel by voxel until it meets a jump point or an obstacle, however far that is.
class PlainJps {
 public:
  explicit PlainJps(const tern::Grid& grid);

  /// True where a path was found between two free voxels.
  bool run(const tern::Voxel& start, const tern::Voxel& goal);

  /// Of the last run: nodes expanded; cost of the path in 2^-36 voxels, with sqrt(2) and sqrt(3) rounded down.
  std::uint64_t expanded() const { return expanded_; }
  tern::Cost cost() const { return cost_; }
  /// Jump points of the last run's path, start and goal included.
  std::vector<tern::Voxel> path() const;

 private:
  struct Node {
    tern::Cost g;
    std::uint32_t parent;
    tern::CellMask arrivals;  ///< moves by which a way of cost g arrives
    tern::CellMask followed;  ///< moves followed at that cost
  };
  struct Entry {
    tern::Cost f;
    tern::Cost h;
    std::uint32_t index;
    bool operator>(const Entry& o) const { return f != o.f ? f > o.f : (h != o.h ? h > o.h : index > o.index); }
  };

  std::uint32_t index_of(const tern::Voxel& v) const;
  tern::Voxel voxel_of(std::uint32_t index) const;
  bool jump(tern::Voxel from, int move, tern::Voxel& found) const;
  void expand(std::uint32_t index);
  void relax(std::uint32_t from, const tern::Voxel& to, int arrival);

  const tern::Grid& grid_;
  std::vector<Node> nodes_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> open_;
  tern::Voxel goal_{};
  std::uint64_t expanded_ = 0;
  tern::Cost cost_ = 0;
};

}  // namespace tern_bench

#endif
