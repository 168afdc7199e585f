// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "paper/random_map.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "baselines/route.hpp"
#include "draw.hpp"

namespace tern_bench {
namespace {

using tern::Vec3;
using tern::Voxel;

constexpr int kLeastWidth = 3;  // lattice cells
constexpr int kMostWidth = 12;
/// Pairs of points that are tried; the one furthest apart is taken where none is far enough.
constexpr int kPairs = 400;

class Lattice {
 public:
  explicit Lattice(const Vec3& size) : dims_{cells(size.x), cells(size.y), cells(size.z)} {
    full_.assign(static_cast<std::size_t>(dims_.x) * static_cast<std::size_t>(dims_.y * dims_.z), false);
  }

  const Voxel& dims() const { return dims_; }
  double part() const { return static_cast<double>(count_) / static_cast<double>(full_.size()); }

  void fill(const Voxel& low, const Voxel& high) {
    for (int z = low.z; z < high.z; ++z) {
      for (int y = low.y; y < high.y; ++y) {
        for (int x = low.x; x < high.x; ++x) {
          const std::size_t at = index({x, y, z});
          count_ += full_[at] ? 0 : 1;
          full_[at] = true;
        }
      }
    }
  }

  /// True where the cell and all around it, `reach` cells far, are empty.
  bool roomy(const Voxel& v, int reach) const {
    for (int z = std::max(0, v.z - reach); z <= std::min(dims_.z - 1, v.z + reach); ++z) {
      for (int y = std::max(0, v.y - reach); y <= std::min(dims_.y - 1, v.y + reach); ++y) {
        for (int x = std::max(0, v.x - reach); x <= std::min(dims_.x - 1, v.x + reach); ++x) {
          if (full_[index({x, y, z})]) return false;
        }
      }
    }
    return true;
  }

 private:
  static int cells(double metres) { return static_cast<int>(std::lround(metres / kLattice)); }
  std::size_t index(const Voxel& v) const { return static_cast<std::size_t>(v.x + dims_.x * (v.y + dims_.y * v.z)); }

  Voxel dims_;
  std::vector<bool> full_;
  std::size_t count_ = 0;
};

void add_cuboid(Draw& draw, Lattice& lattice, tern_host::Scenario& scenario) {
  const Voxel& dims = lattice.dims();
  const Voxel low{draw.integer(0, dims.x - kLeastWidth), draw.integer(0, dims.y - kLeastWidth),
                  draw.integer(0, 3) > 0 ? 0 : draw.integer(0, dims.z - kLeastWidth)};
  const Voxel high{std::min(dims.x, low.x + draw.integer(kLeastWidth, kMostWidth)),
                   std::min(dims.y, low.y + draw.integer(kLeastWidth, kMostWidth)),
                   std::min(dims.z, low.z + draw.integer(kLeastWidth, dims.z))};
  lattice.fill(low, high);
  scenario.blocks.push_back({{{low.x * kLattice, low.y * kLattice, low.z * kLattice},
                              {high.x * kLattice, high.y * kLattice, high.z * kLattice}},
                             false});
}

Vec3 roomy_point(Draw& draw, const Lattice& lattice, int reach) {
  const Voxel& dims = lattice.dims();
  Voxel v{};
  do {
    v = {draw.integer(0, dims.x - 1), draw.integer(0, dims.y - 1), draw.integer(0, dims.z - 1)};
  } while (!lattice.roomy(v, reach));
  return {(v.x + 0.5) * kLattice, (v.y + 0.5) * kLattice, (v.z + 0.5) * kLattice};
}

bool has_room(const Lattice& lattice, int reach) {
  const Voxel& dims = lattice.dims();
  for (int z = 0; z < dims.z; ++z) {
    for (int y = 0; y < dims.y; ++y) {
      for (int x = 0; x < dims.x; ++x) {
        if (lattice.roomy({x, y, z}, reach)) return true;
      }
    }
  }
  return false;
}

}  // namespace

tern_host::Scenario random_map(const MapKind& kind, std::uint64_t seed) {
  tern_host::Scenario scenario;
  scenario.name = std::string(kind.name) + " " + std::to_string(seed);
  scenario.boundary = {{0.0, 0.0, 0.0}, kind.size};
  scenario.resolution = kind.resolution;
  scenario.radius = kind.radius;
  Draw draw(seed);
  Lattice lattice(kind.size);
  while (lattice.part() < kind.density) add_cuboid(draw, lattice, scenario);
  const int reach = static_cast<int>(std::ceil(kind.radius / kLattice));
  if (!has_room(lattice, reach)) return random_map(kind, seed + 1000003);
  const double wanted = kind.least_way * std::max(kind.size.x, kind.size.y);
  double longest = -1.0;
  for (int k = 0; k < kPairs && longest <= wanted; ++k) {
    const Vec3 start = roomy_point(draw, lattice, reach);
    const Vec3 goal = roomy_point(draw, lattice, reach);
    if (distance(start, goal) <= longest) continue;
    longest = distance(start, goal);
    scenario.start.position = start;
    scenario.goal.position = goal;
  }
  return scenario;
}

}  // namespace tern_bench
