// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "baselines/any_angle.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <queue>
#include <tuple>

namespace tern_bench {
namespace {

using tern::Grid;
using tern::Vec3;
using tern::Voxel;

constexpr int kFarthest = 3;

Vec3 plus(const Vec3& a, const Vec3& b, double s = 1.0) {
  return {a.x + s * b.x, a.y + s * b.y, a.z + s * b.z};
}

double between(const Vec3& a, const Vec3& b) {
  return std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y) + (a.z - b.z) * (a.z - b.z));
}

/// The parameters at which a segment leaves one voxel for the next along an axis; coordinates in voxels.
void add_crossings(double from, double to, std::vector<double>& out) {
  const double high = std::max(from, to);
  for (double plane = std::floor(std::min(from, to)) + 1.0; plane < high; plane += 1.0) {
    out.push_back((plane - from) / (to - from));
  }
}

/// The voxels that a segment passes through, coordinates in voxels; of a point on a face or an edge, the upper ones.
void add_voxels(const Vec3& a, const Vec3& b, std::vector<Voxel>& voxels) {
  std::vector<double> crossings{0.0, 1.0};
  add_crossings(a.x, b.x, crossings);
  add_crossings(a.y, b.y, crossings);
  add_crossings(a.z, b.z, crossings);
  std::sort(crossings.begin(), crossings.end());
  for (std::size_t k = 1; k < crossings.size(); ++k) {
    if (crossings[k] - crossings[k - 1] < 1e-12) continue;
    const Vec3 p = plus(a, plus(b, a, -1.0), 0.5 * (crossings[k - 1] + crossings[k]));
    voxels.push_back(
        {static_cast<int>(std::floor(p.x)), static_cast<int>(std::floor(p.y)), static_cast<int>(std::floor(p.z))});
  }
}

/// Half the width of the rod that has to fit, in voxels: none fits between two voxels that share an edge.
constexpr double kRod = 1e-6;

/// The voxels that a thin rod around the segment passes through.
std::vector<Voxel> voxels_along(const Vec3& a, const Vec3& b) {
  std::vector<Voxel> voxels;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 aside{(corner & 1) != 0 ? kRod : -kRod, (corner & 2) != 0 ? kRod : -kRod,
                     (corner & 4) != 0 ? kRod : -kRod};
    add_voxels(plus(a, aside), plus(b, aside), voxels);
  }
  const auto order = [](const Voxel& v) { return std::make_tuple(v.z, v.y, v.x); };
  std::sort(voxels.begin(), voxels.end(), [&](const Voxel& v, const Voxel& w) { return order(v) < order(w); });
  const auto same = [&](const Voxel& v, const Voxel& w) { return order(v) == order(w); };
  voxels.erase(std::unique(voxels.begin(), voxels.end(), same), voxels.end());
  return voxels;
}

struct Move {
  Voxel step;
  double length;              ///< voxels
  std::vector<Voxel> passed;  ///< relative to the voxel that it begins in
};

std::vector<Move> all_moves() {
  std::vector<Move> moves;
  for (int z = -kFarthest; z <= kFarthest; ++z) {
    for (int y = -kFarthest; y <= kFarthest; ++y) {
      for (int x = -kFarthest; x <= kFarthest; ++x) {
        if (std::gcd(std::gcd(x, y), z) != 1) continue;
        const Vec3 to{x + 0.5, y + 0.5, z + 0.5};
        moves.push_back({{x, y, z}, std::sqrt(1.0 * x * x + y * y + z * z), voxels_along({0.5, 0.5, 0.5}, to)});
      }
    }
  }
  return moves;
}

bool can(const Grid& grid, const Voxel& at, const Move& move) {
  return std::all_of(move.passed.begin(), move.passed.end(), [&](const Voxel& v) {
    return grid.free({at.x + v.x, at.y + v.y, at.z + v.z});
  });
}

/// A* over voxel centres; the voxels from start to goal, empty where there is no way.
std::vector<Voxel> search(const Grid& grid, const Voxel& start, const Voxel& goal) {
  const Voxel dims = grid.spec().dims;
  const auto index = [&](const Voxel& v) { return v.x + dims.x * (v.y + dims.y * v.z); };
  const auto voxel = [&](int i) { return Voxel{i % dims.x, i / dims.x % dims.y, i / dims.x / dims.y}; };
  const auto rest = [&](const Voxel& v) { return std::hypot(v.x - goal.x, v.y - goal.y, v.z - goal.z); };
  const std::vector<Move> moves = all_moves();
  std::vector<double> cost(static_cast<std::size_t>(dims.x) * dims.y * dims.z, 1e30);
  std::vector<int> parent(cost.size(), -1);
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> open;
  cost[index(start)] = 0.0;
  open.push({rest(start), index(start)});
  while (!open.empty()) {
    const auto [f, at] = open.top();
    open.pop();
    const Voxel from = voxel(at);
    if (at == index(goal)) break;
    if (f > cost[at] + rest(from) + 1e-9) continue;
    for (const Move& move : moves) {
      const Voxel to{from.x + move.step.x, from.y + move.step.y, from.z + move.step.z};
      if (!grid.free(to) || cost[index(to)] <= cost[at] + move.length + 1e-12 || !can(grid, from, move)) continue;
      cost[index(to)] = cost[at] + move.length;
      parent[index(to)] = at;
      open.push({cost[index(to)] + rest(to), index(to)});
    }
  }
  std::vector<Voxel> chain;
  if (cost[index(goal)] > 1e29) return chain;
  for (int at = index(goal); at >= 0; at = parent[at]) chain.push_back(voxel(at));
  std::reverse(chain.begin(), chain.end());
  return chain;
}

/// Coordinates in voxels.
bool sees(const Grid& grid, const Vec3& a, const Vec3& b) {
  const std::vector<Voxel> voxels = voxels_along(a, b);
  return std::all_of(voxels.begin(), voxels.end(), [&](const Voxel& v) { return grid.free(v); });
}

void drop_points(const Grid& grid, std::vector<Vec3>& path) {
  for (std::size_t k = 1; k + 1 < path.size();) {
    if (sees(grid, path[k - 1], path[k + 1])) {
      path.erase(path.begin() + static_cast<std::ptrdiff_t>(k));
    } else {
      ++k;
    }
  }
}

/// True where some point moved by the step in one of 26 directions.
bool move_points(const Grid& grid, double step, std::vector<Vec3>& path) {
  bool moved = false;
  for (std::size_t k = 1; k + 1 < path.size(); ++k) {
    for (int d = 0; d < 27; ++d) {
      const Vec3 at = plus(path[k], {d % 3 - 1.0, d / 3 % 3 - 1.0, d / 9 - 1.0}, step);
      const double gain = between(path[k - 1], path[k]) + between(path[k], path[k + 1]) - between(path[k - 1], at) -
                          between(at, path[k + 1]);
      if (gain < 1e-6 || !sees(grid, path[k - 1], at) || !sees(grid, at, path[k + 1])) continue;
      path[k] = at;
      moved = true;
    }
  }
  return moved;
}

void pull_tight(const Grid& grid, std::vector<Vec3>& path) {
  for (double step = 2.0; step > 0.005; step *= 0.5) {
    drop_points(grid, path);
    for (int k = 0; k < 200 && move_points(grid, step, path); ++k) {
    }
  }
}

}  // namespace

double path_length(const std::vector<Vec3>& path) {
  double sum = 0.0;
  for (std::size_t k = 1; k < path.size(); ++k) sum += between(path[k - 1], path[k]);
  return sum;
}

std::vector<Vec3> any_angle_path(const Grid& grid, const Vec3& start, const Vec3& goal) {
  const Vec3 origin = grid.spec().origin;
  const double cell = grid.spec().cell;
  const Vec3 from = plus(start, origin, -1.0);
  const Vec3 to = plus(goal, origin, -1.0);
  std::vector<Vec3> path;
  const auto in_voxels = [&](const Vec3& p) { return Vec3{p.x / cell, p.y / cell, p.z / cell}; };
  if (!grid.free(grid.voxel_of(from)) || !grid.free(grid.voxel_of(to))) return path;
  const std::vector<Voxel> voxels = search(grid, grid.voxel_of(from), grid.voxel_of(to));
  if (voxels.empty()) return path;
  path.push_back(in_voxels(from));
  for (const Voxel& v : voxels) path.push_back({v.x + 0.5, v.y + 0.5, v.z + 0.5});
  path.push_back(in_voxels(to));
  pull_tight(grid, path);
  for (Vec3& p : path) p = plus(origin, p, cell);
  return path;
}

}  // namespace tern_bench
