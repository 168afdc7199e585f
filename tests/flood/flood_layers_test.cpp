// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Cells and layers of the flood in time, against slow references that look at one cell after the other.
#include "flood/flood_layers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "flood/flood_lattice.hpp"
#include "flood/flood_marks.hpp"
#include "support/random.hpp"
#include "support/world.hpp"

namespace {

using namespace tern;
using tern_test::Random;
using tern_test::World;

using Layer = std::vector<std::uint64_t>;

World random_world(Random& random, const Voxel& dims) {
  World world(dims, 0.1, 0.05 * random.integer(0, 3));
  for (int n = random.integer(0, 12); n > 0; --n) {
    world.grid.mark_voxel(
        {random.integer(0, dims.x - 1), random.integer(0, dims.y - 1), random.integer(0, dims.z - 1)});
  }
  world.grid.inflate();
  return world;
}

template <typename Visit>
void for_cells(const FloodLattice& lattice, const Visit& visit) {
  for (std::int32_t z = 0; z < lattice.cells.z; ++z) {
    for (std::int32_t y = 0; y < lattice.cells.y; ++y) {
      for (std::int32_t x = 0; x < lattice.cells.x; ++x) visit(Voxel{x, y, z});
    }
  }
}

Layer free_layer(const FloodLattice& lattice, const Grid& grid) {
  Layer layer(static_cast<std::size_t>(lattice.words));
  for (std::int32_t z = 0; z < lattice.cells.z; ++z) {
    for (std::int32_t y = 0; y < lattice.cells.y; ++y) fill_free_row(lattice, grid, y, z, layer.data());
  }
  return layer;
}

TEST(FloodCells, AreFreeIfAllTheirVoxelsAre) {
  Random random(1);
  const int cases = tern_test::scaled(40);
  int free_cells = 0;
  int blocked_cells = 0;
  for (int n = 0; n < cases; ++n) {
    const World world = random_world(random, {random.integer(20, 200), random.integer(5, 30), random.integer(4, 20)});
    const Vec3 middle{random.real(0.0, 2.0), random.real(0.0, 0.5), random.real(0.0, 0.4)};
    const FloodLattice lattice = lay_out(world.grid, middle, random.integer(1, 5));
    const Layer layer = free_layer(lattice, world.grid);
    for_cells(lattice, [&](const Voxel& cell) {
      bool is_free = true;
      for (int k = 0; k < lattice.edge * lattice.edge * lattice.edge; ++k) {
        const Voxel at{lattice.low.x + lattice.edge * cell.x + k % lattice.edge,
                       lattice.low.y + lattice.edge * cell.y + k / lattice.edge % lattice.edge,
                       lattice.low.z + lattice.edge * cell.z + k / lattice.edge / lattice.edge};
        is_free = is_free && world.grid.free(at);
      }
      EXPECT_EQ(has_cell(lattice, layer.data(), cell), is_free);
      (is_free ? free_cells : blocked_cells) += 1;
      const Voxel back = cell_at(lattice, world.grid, middle_of(lattice, world.grid, cell));
      EXPECT_TRUE(back.x == cell.x && back.y == cell.y && back.z == cell.z);
    });
  }
  EXPECT_GT(free_cells, 100);
  EXPECT_GT(blocked_cells, 50);
}

/// Axis by axis through free cells, x first or y first; a cell is reached if both orders reach it.
bool is_reached(const FloodLattice& lattice, const Layer& free, const Layer& in, const FloodSteps& steps,
                const Voxel& to) {
  const auto has = [&](const Layer& layer, const Voxel& cell) {
    return is_cell(lattice, cell) && has_cell(lattice, layer.data(), cell);
  };
  if (!has(free, to)) return false;
  bool reached = false;
  for (int dz = steps.z ? -1 : 0; dz <= (steps.z ? 1 : 0); ++dz) {
    bool x_first = false;
    bool y_first = false;
    for (int dy = steps.y ? -1 : 0; dy <= (steps.y ? 1 : 0); ++dy) {
      for (int dx = steps.x ? -1 : 0; dx <= (steps.x ? 1 : 0); ++dx) {
        const Voxel level{to.x, to.y, to.z + dz};
        if (!has(in, {to.x + dx, to.y + dy, level.z}) || !has(free, level)) continue;
        x_first = x_first || has(free, {to.x, to.y + dy, level.z});
        y_first = y_first || has(free, {to.x + dx, to.y, level.z});
      }
    }
    reached = reached || (x_first && y_first);
  }
  return reached;
}

TEST(FloodLayers, SpreadByACellAlongEachAxis) {
  Random random(2);
  const int cases = tern_test::scaled(60);
  int reached = 0;
  for (int n = 0; n < cases; ++n) {
    FloodLattice lattice{};
    lattice.edge = 1;
    lattice.cells = {random.integer(1, 140), random.integer(1, 8), random.integer(1, 6)};
    lattice.row_words = (lattice.cells.x + 63) / 64;
    lattice.words = lattice.row_words * lattice.cells.y * lattice.cells.z;
    const std::size_t words = static_cast<std::size_t>(lattice.words);
    Layer free(words), in(words), out(words), scratch(2 * words);
    for_cells(lattice, [&](const Voxel& cell) {
      if (random.chance(0.7)) set_cell(lattice, cell, free.data());
      if (random.chance(0.05)) set_cell(lattice, cell, in.data());
    });
    const FloodSteps steps{random.chance(0.8), random.chance(0.8), random.chance(0.8)};
    spread_layer(lattice, steps, free.data(), in.data(), out.data(), scratch.data());
    for_cells(lattice, [&](const Voxel& cell) {
      const bool is_there = is_reached(lattice, free, in, steps, cell);
      EXPECT_EQ(has_cell(lattice, out.data(), cell), is_there);
      reached += is_there ? 1 : 0;
    });
  }
  EXPECT_GT(reached, 100);
}

TEST(FloodLayers, KeepABoxOrWhatTwoHave) {
  FloodLattice lattice{};
  lattice.cells = {130, 3, 2};
  lattice.row_words = 3;
  lattice.words = 18;
  Layer layer(18, ~std::uint64_t{0});
  keep_box(lattice, {60, -1, 1}, {70, 1, 5}, layer.data());
  for_cells(lattice, [&](const Voxel& cell) {
    EXPECT_EQ(has_cell(lattice, layer.data(), cell), cell.x >= 60 && cell.x <= 70 && cell.y <= 1 && cell.z == 1);
  });
  Layer other(18, 0);
  EXPECT_FALSE(keep_common(lattice, other.data(), layer.data()));
  Layer all(18, ~std::uint64_t{0});
  set_cell(lattice, {5, 2, 0}, other.data());
  EXPECT_TRUE(keep_common(lattice, all.data(), other.data()));
  EXPECT_TRUE(has_cell(lattice, other.data(), {5, 2, 0}));
}

TEST(FloodMarks, ClearWhatIsNearAThing) {
  Random random(3);
  const int cases = tern_test::scaled(60);
  int near = 0;
  World world({100, 30, 20}, 0.1, 0.0);
  world.grid.inflate();
  for (int n = 0; n < cases; ++n) {
    const FloodLattice lattice = lay_out(world.grid, {1.0, 1.0, 1.0}, random.integer(1, 4));
    Track track;
    track.shape = random.chance(0.5) ? TrackShape::kBall : TrackShape::kBox;
    track.position = {random.real(0.0, 10.0), random.real(0.0, 3.0), random.real(0.0, 2.0)};
    track.velocity = {random.real(-1.0, 1.0), random.real(-1.0, 1.0), 0.0};
    track.radius = 0.2;
    track.half = {0.3, 0.2, 0.4};
    track.error = 0.05;
    Things things;
    things.radius = 0.2;
    const double time = random.real(0.0, 2.0);
    Layer layer(static_cast<std::size_t>(lattice.words), ~std::uint64_t{0});
    clear_near_thing(lattice, world.grid, things, track, time, 0.1, layer.data());
    const double need = 0.2 + 0.05 + 0.1 + (track.shape == TrackShape::kBall ? 0.2 : 0.0);
    for_cells(lattice, [&](const Voxel& cell) {
      const Vec3 from = middle_of(lattice, world.grid, cell) - track.position - time * track.velocity;
      const double gap = distance(from, closest_in(Things{}, track, from));
      if (std::fabs(gap - need) < 1e-9) return;
      EXPECT_EQ(has_cell(lattice, layer.data(), cell), gap > need);
      near += gap < need ? 1 : 0;
    });
  }
  EXPECT_GT(near, 10);
}

/// A box that is given by corners and faces, turned about z or not.
struct Turned {
  Turned(const Vec3& half, double angle) {
    const Vec3 along{std::cos(angle), std::sin(angle), 0.0};
    const Vec3 across{-along.y, along.x, 0.0};
    for (int k = 0; k < 8; ++k) {
      corners[k] = ((k & 1) != 0 ? half.x : -half.x) * along + ((k & 2) != 0 ? half.y : -half.y) * across +
                   Vec3{0.0, 0.0, (k & 4) != 0 ? half.z : -half.z};
    }
    const Vec3 normals[3] = {along, across, {0.0, 0.0, 1.0}};
    for (int a = 0; a < 3; ++a) {
      faces[2 * a] = {normals[a], axis(half, a)};
      faces[2 * a + 1] = {-1.0 * normals[a], axis(half, a)};
    }
    solid = {{corners, 8}, faces, 6};
  }
  Vec3 corners[8];
  Halfspace faces[6];
  ConvexSolid solid;
};

/// The same cells as for a box where it is not turned; turned, all that are near, and none beyond a face.
TEST(FloodMarks, ClearWhatIsNearASolid) {
  Random random(4);
  World world({100, 30, 20}, 0.1, 0.0);
  world.grid.inflate();
  int near = 0;
  for (int n = 0; n < tern_test::scaled(60); ++n) {
    const FloodLattice lattice = lay_out(world.grid, {1.0, 1.0, 1.0}, random.integer(1, 3));
    const Vec3 half{random.real(0.1, 1.0), random.real(0.1, 1.0), random.real(0.1, 0.5)};
    const double angle = random.chance(0.5) ? 0.0 : random.real(-1.5, 1.5);
    const Turned turned(half, angle);
    Track track;
    track.shape = kConvex;
    track.position = {random.real(0.0, 10.0), random.real(0.0, 3.0), random.real(0.0, 2.0)};
    Things things;
    things.tracks = &track;
    things.count = 1;
    things.radius = 0.2;
    things.solids = &turned.solid;
    Layer layer(static_cast<std::size_t>(lattice.words), ~std::uint64_t{0});
    clear_near_thing(lattice, world.grid, things, track, 0.0, 0.1, layer.data());
    for_cells(lattice, [&](const Voxel& cell) {
      const Vec3 from = middle_of(lattice, world.grid, cell) - track.position;
      const Vec3 in{std::cos(angle) * from.x + std::sin(angle) * from.y,
                    std::cos(angle) * from.y - std::sin(angle) * from.x, from.z};
      double beyond = -1.0;
      Vec3 gap{};
      for (int a = 0; a < 3; ++a) {
        beyond = std::max(beyond, std::fabs(axis(in, a)) - axis(half, a));
        axis(gap, a) = std::max(0.0, std::fabs(axis(in, a)) - axis(half, a));
      }
      const bool is_clear = has_cell(lattice, layer.data(), cell);
      const bool is_near = length(gap) < 0.3 - 1e-9;
      const bool is_far = beyond > 0.3 + 1e-9 || (angle == 0.0 && length(gap) > 0.3 + 1e-9);
      EXPECT_FALSE(is_near && is_clear);
      EXPECT_TRUE(!is_far || is_clear);
      near += length(gap) < 0.3 ? 1 : 0;
      EXPECT_NEAR(distance(from, closest_in(things, track, from)), length(gap), 1e-9);
    });
  }
  EXPECT_GT(near, 10);
}

}  // namespace
