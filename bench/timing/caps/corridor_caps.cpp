// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// One polyhedron among as many solid boxes as its local box may hold, so strewn that its half-spaces run out and the
// local box shrinks several times.
#include <cstddef>

#include "base/math.hpp"
#include "caps/cap.hpp"
#include "corridor/corridor_stage.hpp"
#include "support/random.hpp"

namespace tern_caps {
namespace {

constexpr double kCell = 0.025;
constexpr tern::Voxel kDims{320, 320, 320};
constexpr tern::Vec3 kFrom{3.8, 4.0, 4.0};
constexpr tern::Vec3 kTo{4.2, 4.0, 4.0};
/// Distances of the boxes from the segment, metres: from this to the local box's margin.
constexpr double kNearest = 0.5;
constexpr std::size_t kPolyhedronOffset = std::size_t{16} << 20;

/// True where none of the voxels around is an obstacle: marked here, it is a solid box of its own.
bool stands_alone(const tern::Grid& grid, const tern::Voxel& v) {
  for (std::int32_t k = 0; k < 27; ++k) {
    if (grid.obstacle({v.x + k % 3 - 1, v.y + k / 3 % 3 - 1, v.z + k / 9 - 1})) return false;
  }
  return true;
}

/// A point beside the segment, denser near it than far: every shrunk local box has many obstacles, too.
tern::Vec3 random_point(tern_test::Random& random) {
  tern::Vec3 direction;
  double squared;
  do {
    direction = {random.real(-1.0, 1.0), random.real(-1.0, 1.0), random.real(-1.0, 1.0)};
    squared = tern::dot(direction, direction);
  } while (squared > 1.0 || squared < 0.01);
  const double part = random.unit();
  const double away = kNearest + (tern::kLocalMargin - kNearest) * part * part;
  const tern::Vec3& end = direction.x < 0.0 ? kFrom : kTo;
  return end + (away / tern::square_root(squared)) * direction;
}

tern::Grid crowded_grid() {
  tern::Grid grid = make_grid(kDims, kCell, 0.0);
  tern_test::Random random(1);
  for (int boxes = 0; boxes < tern::kMaxLocalBoxes;) {
    const tern::Voxel voxel = grid.voxel_of(random_point(random));
    if (!stands_alone(grid, voxel)) continue;
    grid.mark_voxel(voxel);
    ++boxes;
  }
  grid.inflate();
  return grid;
}

}  // namespace

void corridor_caps() {
  auto& scratch = state_at<tern::GrowScratch>(0);
  auto& polyhedron = state_at<tern::Polyhedron>(kPolyhedronOffset);
  const tern::Grid grid = crowded_grid();
  tern::reset_counters(scratch);
  tern::Work work{kUnlimited};
  tern::Growth growth;
  const tern::World world(grid);
  tern::grow_begin(growth, world, kFrom, kTo);
  const std::uint64_t instructions = count([&] { tern::grow_advance(growth, world, scratch, polyhedron, work); });
  const std::uint64_t tries = tern::kCorridorTries;
  const auto planes = static_cast<std::uint64_t>(scratch.planes_high);
  const auto boxes = static_cast<std::uint64_t>(scratch.boxes_high);
  report({"planes", "corridor", instructions, planes, tern::kMaxPlanes, units_of(work), tries});
  report({"local_boxes", "corridor", instructions, boxes, tern::kMaxLocalBoxes, units_of(work), tries});
}

}  // namespace tern_caps
