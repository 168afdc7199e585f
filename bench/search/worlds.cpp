// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "search/worlds.hpp"

#include <cmath>
#include <fstream>
#include <stdexcept>

#include "draw.hpp"
#include "host/grid_layout.hpp"

namespace tern_bench {
namespace {

using tern::Voxel;

void require(tern::Status status) {
  if (status != tern::Status::kOk) throw std::runtime_error(tern::status_name(status));
}

void bind(const tern::GridSpec& spec, World& world) {
  world.words.resize(tern::grid_words(spec.dims));
  require(world.grid.bind(spec, world.words.data(), world.words.size()));
}

/// The free voxel that is nearest in rings around `at`; the first by z, y, x in its ring.
Voxel nearest_free(const tern::Grid& grid, const Voxel& at) {
  for (int ring = 0; ring < tern::kMaxDimension; ++ring) {
    for (int z = at.z - ring; z <= at.z + ring; ++z) {
      for (int y = at.y - ring; y <= at.y + ring; ++y) {
        for (int x = at.x - ring; x <= at.x + ring; ++x) {
          if (grid.free({x, y, z})) return {x, y, z};
        }
      }
    }
  }
  throw std::runtime_error("a map without a free voxel");
}

constexpr double kLattice = 0.2;

int lattice_count(double metres) {
  return static_cast<int>(std::lround(metres / kLattice));
}

/// Counts the voxels of a lattice that boxes have filled.
class Filled {
 public:
  explicit Filled(const Voxel& dims)
      : dims_(dims), full_(static_cast<std::size_t>(dims.x) * static_cast<std::size_t>(dims.y * dims.z)) {}

  void add(const Voxel& low, const Voxel& high) {
    for (int z = low.z; z < high.z; ++z) {
      for (int y = low.y; y < high.y; ++y) {
        for (int x = low.x; x < high.x; ++x) {
          const auto at = static_cast<std::size_t>(x + dims_.x * (y + dims_.y * z));
          count_ += full_[at] ? 0 : 1;
          full_[at] = true;
        }
      }
    }
  }
  double part() const { return static_cast<double>(count_) / static_cast<double>(full_.size()); }

 private:
  Voxel dims_;
  std::vector<bool> full_;
  std::size_t count_ = 0;
};

void fill_with_cuboids(const ForestKind& kind, Draw& draw, World& world) {
  const Voxel dims{lattice_count(kind.size.x), lattice_count(kind.size.y), lattice_count(kind.size.z)};
  Filled filled(dims);
  while (filled.part() < kind.density) {
    const Voxel low{draw.integer(0, dims.x - 2), draw.integer(0, dims.y - 2), draw.integer(0, dims.z - 2)};
    const Voxel high{std::min(dims.x, low.x + draw.integer(2, 10)), std::min(dims.y, low.y + draw.integer(2, 10)),
                     std::min(dims.z, low.z + draw.integer(2, dims.z))};
    filled.add(low, high);
    require(world.grid.mark_box({{low.x * kLattice, low.y * kLattice, low.z * kLattice},
                                 {high.x * kLattice, high.y * kLattice, high.z * kLattice}}));
  }
}

tern::Vec3 random_free_point(const ForestKind& kind, Draw& draw, const tern::Grid& grid) {
  // A map that is 30 % full at most has a free point soon.
  for (;;) {
    const tern::Vec3 point{(draw.integer(0, lattice_count(kind.size.x) - 1) + 0.25) * kLattice,
                           (draw.integer(0, lattice_count(kind.size.y) - 1) + 0.25) * kLattice,
                           (draw.integer(0, lattice_count(kind.size.z) - 1) + 0.25) * kLattice};
    if (grid.free(grid.voxel_of(point))) return point;
  }
}

double distance(const tern::Vec3& a, const tern::Vec3& b) {
  return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
}

}  // namespace

Query build(const tern_host::Scenario& scenario, World& world) {
  bind(tern_host::lay_out_grid(scenario), world);
  for (const tern_host::Block& block : scenario.blocks) require(world.grid.mark_box(block.box));
  world.grid.inflate();
  const tern::Grid& grid = world.grid;
  return {nearest_free(grid, grid.voxel_of(grid.to_local(scenario.start.position))),
          nearest_free(grid, grid.voxel_of(grid.to_local(scenario.goal.position)))};
}

Query build(const ForestKind& kind, std::uint64_t seed, double cell, World& world) {
  tern_host::Scenario scenario;
  scenario.boundary = {{0.0, 0.0, 0.0}, kind.size};
  scenario.resolution = cell;
  scenario.radius = 0.0;
  bind(tern_host::lay_out_grid(scenario), world);
  Draw draw(seed);
  fill_with_cuboids(kind, draw, world);
  world.grid.inflate();
  tern::Vec3 start{};
  tern::Vec3 goal{};
  do {
    start = random_free_point(kind, draw, world.grid);
    goal = random_free_point(kind, draw, world.grid);
  } while (distance(start, goal) <= 0.3 * kind.size.x);
  return {world.grid.voxel_of(start), world.grid.voxel_of(goal)};
}

std::vector<Query> build_voxel_benchmark(const std::string& map_file, World& world) {
  std::ifstream map(map_file);
  std::ifstream scenario(map_file + ".3dscen");
  std::string word;
  tern::GridSpec spec{};
  if (!(map >> word >> spec.dims.x >> spec.dims.y >> spec.dims.z)) throw std::runtime_error(map_file + ": no map");
  spec.cell = 1.0;
  spec.boundary.upper = {spec.dims.x * 1.0, spec.dims.y * 1.0, spec.dims.z * 1.0};
  bind(spec, world);
  for (Voxel v{}; map >> v.x >> v.y >> v.z;) require(world.grid.mark_voxel(v));
  world.grid.inflate();
  // "version 1" and the map's name come before the queries; a length and a ratio end each.
  scenario >> word >> word >> word;
  std::vector<Query> queries;
  double ignored = 0.0;
  for (Query q{};
       scenario >> q.start.x >> q.start.y >> q.start.z >> q.goal.x >> q.goal.y >> q.goal.z >> ignored >> ignored;) {
    queries.push_back(q);
  }
  return queries;
}

}  // namespace tern_bench
