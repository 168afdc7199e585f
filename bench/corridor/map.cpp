// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "map.hpp"

#include <algorithm>
#include <cmath>

#include "corridor/grow.hpp"
#include "volume.hpp"

namespace tern_bench {
namespace {

using tern::Box;
using tern::Grid;
using tern::Vec3;
using tern::Voxel;
using tern_test::CorridorCase;

constexpr double kCell = 0.1;

/// Calls `visit(voxel)` for every obstacle voxel whose cube meets the box.
template <typename Visit>
void for_obstacles(const Grid& grid, const Box& box, Visit visit) {
  const auto low = [](double v) { return std::max(0, static_cast<int>(std::floor(v / kCell))); };
  const auto high = [](double v, int dim) { return std::min(dim, static_cast<int>(std::ceil(v / kCell))); };
  const Voxel& dims = grid.spec().dims;
  for (int z = low(box.lower.z); z < high(box.upper.z, dims.z); ++z) {
    for (int y = low(box.lower.y); y < high(box.upper.y, dims.y); ++y) {
      for (int x = low(box.lower.x); x < high(box.upper.x, dims.x); ++x) {
        if (grid.obstacle({x, y, z})) visit(Voxel{x, y, z});
      }
    }
  }
}

bool on_surface(const Grid& grid, const Voxel& v) {
  return !(grid.obstacle({v.x - 1, v.y, v.z}) && grid.obstacle({v.x + 1, v.y, v.z}) &&
           grid.obstacle({v.x, v.y - 1, v.z}) && grid.obstacle({v.x, v.y + 1, v.z}) &&
           grid.obstacle({v.x, v.y, v.z - 1}) && grid.obstacle({v.x, v.y, v.z + 1}));
}

Box cube_of(const Voxel& v) {
  return {{v.x * kCell, v.y * kCell, v.z * kCell}, {(v.x + 1) * kCell, (v.y + 1) * kCell, (v.z + 1) * kCell}};
}

bool cut_off(const std::vector<tern::Halfspace>& planes, const Box& cube) {
  return std::any_of(planes.begin(), planes.end(), [&](const tern::Halfspace& h) {
    const double x = std::min(h.normal.x * cube.lower.x, h.normal.x * cube.upper.x);
    const double y = std::min(h.normal.y * cube.lower.y, h.normal.y * cube.upper.y);
    const double z = std::min(h.normal.z * cube.lower.z, h.normal.z * cube.upper.z);
    return x + y + z >= h.offset;
  });
}

}  // namespace

std::unique_ptr<Map> lay_out(const CorridorCase& c) {
  auto map = std::make_unique<Map>();
  tern::GridSpec spec{};
  spec.cell = kCell;
  const Vec3& upper = c.boundary.upper;
  spec.dims = {static_cast<int>(std::lround(upper.x / kCell)), static_cast<int>(std::lround(upper.y / kCell)),
               static_cast<int>(std::lround(upper.z / kCell))};
  spec.boundary = c.boundary;
  map->words.resize(tern::grid_words(spec.dims));
  map->grid.bind(spec, map->words.data(), map->words.size());
  for (const Box& block : c.blocks) map->grid.mark_box(block);
  for_obstacles(map->grid, c.boundary, [&](const Voxel& v) {
    if (on_surface(map->grid, v)) map->surface.push_back(map->grid.center(v));
  });
  return map;
}

Box around(const Vec3& a, const Vec3& b, double margin) {
  return {{std::min(a.x, b.x) - margin, std::min(a.y, b.y) - margin, std::min(a.z, b.z) - margin},
          {std::max(a.x, b.x) + margin, std::max(a.y, b.y) + margin, std::max(a.z, b.z) + margin}};
}

double count_surface(const Map& map, const Box& box) {
  return static_cast<double>(std::count_if(map.surface.begin(), map.surface.end(), [&](const Vec3& p) {
    return p.x >= box.lower.x && p.x <= box.upper.x && p.y >= box.lower.y && p.y <= box.upper.y && p.z >= box.lower.z &&
           p.z <= box.upper.z;
  }));
}

double unsafe_volume(const Map& map, const tern::Polyhedron& polyhedron) {
  const std::vector<tern::Halfspace> planes = bounding_planes(polyhedron);
  double total = 0.0;
  for_obstacles(map.grid, around(polyhedron.from, polyhedron.to, tern::kLocalMargin), [&](const Voxel& v) {
    if (cut_off(planes, cube_of(v))) return;
    std::vector<tern::Halfspace> both = planes_of(cube_of(v));
    both.insert(both.end(), planes.begin(), planes.end());
    total += volume(both);
  });
  return total;
}

}  // namespace tern_bench
