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

/// For each voxel index along one axis, whether it lies within the boundary; a face is on the lattice but for rounding.
/// Where none does, the voxels that the boundary meets count, and those on both sides of a plane (docs/grid.md).
std::vector<bool> within(const World& world, int a) {
  const Real cell = world.spec.cell;
  const Real origin = axis(world.spec.origin, a);
  const Real lower = (axis(world.spec.boundary.lower, a) - origin) / cell;
  const Real upper = (axis(world.spec.boundary.upper, a) - origin) / cell;
  const Real slack = 1e-9L + 4 * kUlp * (std::fabs(origin) / cell + axis(world.spec.dims, a));
  const auto holding = [&](const auto& counts) {
    std::vector<bool> found;
    for (int i = 0; i < axis(world.spec.dims, a); ++i) found.push_back(counts(i));
    return found;
  };
  const auto none = [](const std::vector<bool>& found) { return std::count(found.begin(), found.end(), true) == 0; };
  std::vector<bool> found = holding([&](int i) { return i >= lower - slack && i + 1 <= upper + slack; });
  if (none(found)) found = holding([&](int i) { return i + 1 > lower + slack && i < upper - slack; });
  if (none(found)) found = holding([&](int i) { return i + 1 >= lower - slack && i <= upper + slack; });
  return found;
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
  const std::vector<bool> inside[3] = {within(world, 0), within(world, 1), within(world, 2)};
  std::vector<Space> layer(gaps.size(), Space::kBlocked);
  for (int i = 0; i < world.count(); ++i) {
    const tern::Voxel v = world.voxel(i);
    bool may_be_free = true;
    for (int a = 0; a < 3; ++a) may_be_free = may_be_free && inside[a][static_cast<std::size_t>(axis(v, a))];
    if (!may_be_free) continue;
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
    const Real cell = world.spec.cell;
    const Real origin = axis(world.spec.origin, a);
    const Real cells = p[a] / cell;
    const Real slack = 2e-9L + 4 * kUlp * (std::fabs(origin) / cell + std::fabs(cells));
    const Real upper = (axis(world.spec.boundary.upper, a) - origin) / cell;
    const int last = std::max(0, static_cast<int>(std::ceil(upper - slack)) - 1);
    const int low = std::max(0, std::min(last, static_cast<int>(std::floor(cells))));
    const int high = std::max(0, std::min(last, static_cast<int>(std::floor(cells + slack))));
    std::vector<tern::Voxel> grown;
    for (int i = low; i <= high; ++i) {
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

bool holds(const std::vector<int>& numbers, int number) {
  return std::find(numbers.begin(), numbers.end(), number) != numbers.end();
}

/// The centre, or the point of a thin boundary nearest to it.
Point center(const World& world, const tern::Voxel& v) {
  Point p;
  for (int a = 0; a < 3; ++a) {
    const Real origin = axis(world.spec.origin, a);
    const Real lower = axis(world.spec.boundary.lower, a) - origin;
    const Real upper = axis(world.spec.boundary.upper, a) - origin;
    p[a] = std::max(lower, std::min(upper, (axis(v, a) + 0.5L) * world.spec.cell));
  }
  return p;
}

bool is_thin(const World& world) {
  bool thin = false;
  for (int a = 0; a < 3; ++a) {
    const double across = axis(world.spec.boundary.upper, a) - axis(world.spec.boundary.lower, a);
    thin = thin || across < 2.0 * world.spec.cell;
  }
  return thin;
}

int number_of(const World& world, const std::vector<int>& component, const tern::Voxel& v) {
  return world.inside(v.x, v.y, v.z) ? component[static_cast<std::size_t>(world.index(v.x, v.y, v.z))] : -1;
}

std::vector<int> reachable_from(const World& world, const std::vector<int>& component, const Point& p,
                                const tern::Voxel& home) {
  const int own = number_of(world, component, home);
  if (own >= 0) return {own};
  std::vector<int> numbers;
  // Along a face between two solids there is no way, but each of the two is no nearer than 0.
  if (!(world.radius() > 0) && is_thin(world)) return numbers;
  // The grid calls a line clear to 1e-9 m; a tenth of that is beyond doubt.
  const Real least = world.radius() - 1e-10L + 16 * kUlp * largest(p);
  for (int k = 0; k < 125; ++k) {
    const tern::Voxel v{home.x + k % 5 - 2, home.y + k / 5 % 5 - 2, home.z + k / 25 - 2};
    const int number = number_of(world, component, v);
    if (number < 0 || holds(numbers, number)) continue;
    if (clearance(world, line(p, center(world, v)), least).proof == Proof::kProven) numbers.push_back(number);
  }
  return numbers;
}

}  // namespace

tern::Voxel free_voxel_at(const World& world, const tern::Vec3& at) {
  const tern::Voxel own = world.grid.voxel_of(world.grid.to_local(at));
  if (world.grid.free(own)) return own;
  const Point p = world.local(at);
  for (int k = 0; k < 8; ++k) {
    tern::Voxel v{};
    for (int a = 0; a < 3; ++a) {
      const Real cells = p[a] / static_cast<Real>(world.spec.cell);
      const Real slack =
          1e-8L + 16 * kUlp * (std::fabs(axis(world.spec.origin, a)) / world.spec.cell + std::fabs(cells));
      axis(v, a) = static_cast<int>(std::floor((k >> a & 1) != 0 ? cells + slack : cells - slack));
    }
    if (world.grid.free(v)) return v;
  }
  return {-1, -1, -1};
}

std::vector<int> reachable(const World& world, const std::vector<int>& component, const Point& p) {
  std::vector<int> common;
  bool first = true;
  for (const tern::Voxel& home : homes(world, p)) {
    const std::vector<int> numbers = reachable_from(world, component, p, home);
    std::vector<int> both;
    for (const int number : numbers) {
      if (first || holds(common, number)) both.push_back(number);
    }
    common = both;
    first = false;
  }
  return common;
}

bool share_one(const std::vector<int>& a, const std::vector<int>& b) {
  return std::find_first_of(a.begin(), a.end(), b.begin(), b.end()) != a.end();
}

}  // namespace tern_attack
