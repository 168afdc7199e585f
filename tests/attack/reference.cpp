// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "attack/reference.hpp"

#include "attack/clearance.hpp"

namespace tern_attack {
namespace {

constexpr int kFarAway = 1 << 28;

/// For every voxel the least of `in` plus the squared gap along one axis: three passes give the squared distance
/// between cubes, in cells, which is a sum over the axes.
void pass(const World& world, int along, int reach, std::vector<int>& gaps) {
  const tern::Voxel d = world.spec.dims;
  const int stride = along == 0 ? 1 : (along == 1 ? d.x : d.x * d.y);
  const int count = axis(d, along);
  std::vector<int> row(static_cast<std::size_t>(count));
  for (int i = 0; i < world.count(); ++i) {
    if (axis(world.voxel(i), along) != 0) continue;
    for (int k = 0; k < count; ++k) row[static_cast<std::size_t>(k)] = gaps[static_cast<std::size_t>(i + k * stride)];
    for (int k = 0; k < count; ++k) {
      int least = kFarAway;
      for (int j = std::max(0, k - reach); j <= std::min(count - 1, k + reach); ++j) {
        const int gap = std::max(0, std::abs(j - k) - 1);
        least = std::min(least, row[static_cast<std::size_t>(j)] + gap * gap);
      }
      gaps[static_cast<std::size_t>(i + k * stride)] = least;
    }
  }
}

/// True where voxel index `i` lies within the boundary along one axis; a face is on the lattice but for rounding.
bool within(const World& world, int a, int i) {
  const Real cell = world.spec.cell;
  const Real origin = axis(world.spec.origin, a);
  const Real lower = (axis(world.spec.boundary.lower, a) - origin) / cell;
  const Real upper = (axis(world.spec.boundary.upper, a) - origin) / cell;
  const Real slack = 1e-9L + 4 * kUlp * (std::fabs(origin) / cell + axis(world.spec.dims, a));
  return i >= lower - slack && i + 1 <= upper + slack;
}

Space judge(int square_gap, Real square_radius) {
  if (square_gap >= square_radius * (1 - 1e-12L)) return Space::kFree;
  return square_gap < square_radius * (1 - 1e-8L) ? Space::kBlocked : Space::kEither;
}

}  // namespace

std::vector<Space> blocked_layer(const World& world) {
  const Real cells = world.radius() / static_cast<Real>(world.spec.cell);
  const bool touching = cells > 0;
  std::vector<int> gaps(world.solid.size());
  for (std::size_t i = 0; i < gaps.size(); ++i) gaps[i] = world.solid[i] != 0 ? 0 : kFarAway;
  const int reach = static_cast<int>(std::floor(cells)) + 2;
  for (int a = 0; a < 3 && touching; ++a) pass(world, a, reach, gaps);
  bool inside[3][1024];
  for (int a = 0; a < 3; ++a) {
    for (int i = 0; i < axis(world.spec.dims, a); ++i) inside[a][i] = within(world, a, i);
  }
  std::vector<Space> layer(gaps.size(), Space::kBlocked);
  for (int i = 0; i < world.count(); ++i) {
    const tern::Voxel v = world.voxel(i);
    if (!inside[0][v.x] || !inside[1][v.y] || !inside[2][v.z]) continue;
    const auto at = static_cast<std::size_t>(i);
    layer[at] = touching ? judge(gaps[at], cells * cells) : (gaps[at] == 0 ? Space::kBlocked : Space::kFree);
  }
  return layer;
}

std::vector<int> components(const World& world, const std::vector<std::uint8_t>& free) {
  std::vector<int> number(free.size(), -1);
  std::vector<int> open;
  const tern::Voxel d = world.spec.dims;
  const int stride[3] = {1, d.x, d.x * d.y};
  for (int seed = 0; seed < world.count(); ++seed) {
    if (free[static_cast<std::size_t>(seed)] == 0 || number[static_cast<std::size_t>(seed)] >= 0) continue;
    number[static_cast<std::size_t>(seed)] = seed;
    open.push_back(seed);
    while (!open.empty()) {
      const int at = open.back();
      open.pop_back();
      const tern::Voxel v = world.voxel(at);
      for (int k = 0; k < 6; ++k) {
        const int a = k / 2;
        const int to = axis(v, a) + (k % 2 == 0 ? -1 : 1);
        if (to < 0 || to >= axis(d, a)) continue;
        const auto next = static_cast<std::size_t>(at + (k % 2 == 0 ? -stride[a] : stride[a]));
        if (free[next] == 0 || number[next] >= 0) continue;
        number[next] = seed;
        open.push_back(static_cast<int>(next));
      }
    }
  }
  return number;
}

std::vector<tern::Voxel> homes(const World& world, const Point& p) {
  std::vector<tern::Voxel> found{{0, 0, 0}};
  for (int a = 0; a < 3; ++a) {
    const Real cells = p[a] / static_cast<Real>(world.spec.cell);
    const Real slack = 4 * kUlp * (1 + std::fabs(cells));
    const int low = static_cast<int>(std::ceil(cells - 1 - slack));
    const int high = static_cast<int>(std::floor(cells + slack));
    std::vector<tern::Voxel> grown;
    for (int i = std::max(0, low); i <= std::min(axis(world.spec.dims, a) - 1, high); ++i) {
      for (tern::Voxel v : found) {
        axis(v, a) = i;
        grown.push_back(v);
      }
    }
    found = grown;
  }
  return found;
}

namespace {

void add_number(std::vector<int>& numbers, int number) {
  if (std::find(numbers.begin(), numbers.end(), number) == numbers.end()) numbers.push_back(number);
}

Point center(const World& world, const tern::Voxel& v) {
  const Real cell = world.spec.cell;
  return {{(v.x + 0.5L) * cell, (v.y + 0.5L) * cell, (v.z + 0.5L) * cell}};
}

/// True where a voxel is at most two away from all voxels that may count as the point's own.
bool near_all(const std::vector<tern::Voxel>& own, const tern::Voxel& v) {
  for (const tern::Voxel& h : own) {
    if (std::abs(h.x - v.x) > 2 || std::abs(h.y - v.y) > 2 || std::abs(h.z - v.z) > 2) return false;
  }
  return true;
}

}  // namespace

std::vector<int> reachable(const World& world, const std::vector<int>& component, const Point& p) {
  const std::vector<tern::Voxel> own = homes(world, p);
  std::vector<int> numbers;
  for (const tern::Voxel& v : own) {
    const int number = component[static_cast<std::size_t>(world.index(v.x, v.y, v.z))];
    if (number >= 0) add_number(numbers, number);
  }
  if (!numbers.empty() || own.empty()) return numbers;
  const Real rounding = 16 * kUlp * largest(p);
  // The grid calls a line clear to 1e-9 m; a tenth of that is beyond doubt.
  const Real least = world.radius() - 1e-10L + rounding;
  for (int k = 0; k < 125; ++k) {
    const tern::Voxel v{own[0].x + k % 5 - 2, own[0].y + k / 5 % 5 - 2, own[0].z + k / 25 - 2};
    if (!world.inside(v.x, v.y, v.z) || !near_all(own, v)) continue;
    const int number = component[static_cast<std::size_t>(world.index(v.x, v.y, v.z))];
    if (number < 0 || std::find(numbers.begin(), numbers.end(), number) != numbers.end()) continue;
    if (clearance(world, line(p, center(world, v)), least).proof == Proof::kProven) add_number(numbers, number);
  }
  return numbers;
}

bool share_one(const std::vector<int>& a, const std::vector<int>& b) {
  return std::find_first_of(a.begin(), a.end(), b.begin(), b.end()) != a.end();
}

}  // namespace tern_attack
