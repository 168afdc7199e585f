// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_TESTS_SUPPORT_REFERENCE_SEARCH_HPP
#define TERN_TESTS_SUPPORT_REFERENCE_SEARCH_HPP

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <queue>
#include <vector>

#include "tern/grid.hpp"

namespace tern_test {

/// A plain A* over flat arrays: 26 neighbours, no corner cutting, the octile heuristic, doubles. Shares no code with
/// the core's search.
class ReferenceSearch {
 public:
  explicit ReferenceSearch(const tern::Grid& grid) : grid_(grid), dims_(grid.spec().dims) {
    const auto cells = static_cast<std::size_t>(dims_.x) * static_cast<std::size_t>(dims_.y * dims_.z);
    cost_.assign(cells, -1.0);
    closed_.assign(cells, false);
  }

  /// Cost of a cheapest path between two voxels, in voxels; -1 where there is none.
  double cost(const tern::Voxel& start, const tern::Voxel& goal) {
    std::fill(cost_.begin(), cost_.end(), -1.0);
    std::fill(closed_.begin(), closed_.end(), false);
    if (!grid_.free(start) || !grid_.free(goal)) return -1.0;
    std::priority_queue<Entry> open;
    cost_[index(start)] = 0.0;
    open.push({octile(start, goal), 0.0, start});
    while (!open.empty()) {
      const tern::Voxel at = open.top().voxel;
      open.pop();
      if (closed_[index(at)]) continue;
      closed_[index(at)] = true;
      if (index(at) == index(goal)) return cost_[index(at)];
      for (int d = 0; d < 27; ++d) {
        const tern::Voxel step{d % 3 - 1, d / 3 % 3 - 1, d / 9 - 1};
        if (!allowed(at, step)) continue;
        const tern::Voxel next{at.x + step.x, at.y + step.y, at.z + step.z};
        const double g = cost_[index(at)] + std::sqrt(step.x * step.x + step.y * step.y + step.z * step.z);
        double& known = cost_[index(next)];
        if (known >= 0.0 && known <= g) continue;
        known = g;
        open.push({g + octile(next, goal), g, next});
      }
    }
    return -1.0;
  }

  /// True where a step cuts no corner: its whole box of voxels is free.
  bool allowed(const tern::Voxel& at, const tern::Voxel& step) const {
    if (step.x == 0 && step.y == 0 && step.z == 0) return false;
    for (int part = 0; part < 8; ++part) {
      const tern::Voxel v{at.x + ((part & 1) != 0 ? step.x : 0), at.y + ((part & 2) != 0 ? step.y : 0),
                          at.z + ((part & 4) != 0 ? step.z : 0)};
      if (!grid_.free(v)) return false;
    }
    return true;
  }

 private:
  struct Entry {
    double f;
    double g;
    tern::Voxel voxel;
    bool operator<(const Entry& other) const { return f != other.f ? f > other.f : g < other.g; }
  };

  std::size_t index(const tern::Voxel& v) const {
    return static_cast<std::size_t>(v.x) +
           static_cast<std::size_t>(dims_.x) * static_cast<std::size_t>(v.y + dims_.y * v.z);
  }

  static double octile(const tern::Voxel& a, const tern::Voxel& b) {
    int d[3] = {std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)};
    std::sort(d, d + 3);
    return d[0] * std::sqrt(3.0) + (d[1] - d[0]) * std::sqrt(2.0) + (d[2] - d[1]);
  }

  const tern::Grid& grid_;
  tern::Voxel dims_;
  std::vector<double> cost_;
  std::vector<bool> closed_;
};

}  // namespace tern_test

#endif
