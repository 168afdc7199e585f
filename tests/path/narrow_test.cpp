// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Points that keep the radius and the fences where no voxel is free: the answer says so, and at the resolution that it
// names, with the obstacles marked again, the same point is no longer refused.
#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "base/math.hpp"
#include "grid/distance.hpp"
#include "support/grid_storage.hpp"
#include "support/random.hpp"
#include "tern/tern.hpp"

namespace tern_test {
namespace {

using tern::Box;
using tern::Status;
using tern::Vec3;
using tern::Voxel;

/// A solid room with slits and shafts in it, a little wider than twice the radius; its boundary cuts voxels. Now and
/// then a slab of a fence, which need not be level.
struct NarrowRoom {
  tern::GridSpec spec;
  std::vector<Box> boxes;
  std::vector<tern::Halfspace> planes;
  Vec3 point{};

  /// Nothing but a slab with the point in its middle, askew along the axes but for one. Its width is in cells.
  NarrowRoom(const tern::GridSpec& grid, int level, double width) : spec(grid) {
    const double middle_cell = 0.5 * spec.dims.x + 0.1;
    point = spec.origin + spec.cell * Vec3{middle_cell, middle_cell, middle_cell};
    Vec3 normal{1.0, 1.0, 1.0};
    tern::axis(normal, level) = 0.0;
    const double middle = tern::dot(normal, point);
    const double half = 0.5 * width * spec.cell * tern::length(normal);
    planes = {{normal, middle + half}, {-1.0 * normal, half - middle}};
  }
  explicit NarrowRoom(Random& random) : spec(whole_grid({16, 16, 16}, 0.25, 0.0, {-1.0, 3.0, 0.5})) {
    spec.radius = random.chance(0.3) ? 0.25 * random.integer(1, 2) : random.real(0.1, 0.6);
    const Vec3 middle = spec.origin + Vec3{random.real(1.8, 2.2), random.real(1.8, 2.2), random.real(1.8, 2.2)};
    point = middle;
    for (int a = 0; a < 3; ++a) narrow_down(random, a, tern::axis(middle, a));
    if (random.chance(0.4)) add_slab(random, middle);
  }
  /// Walls to both sides of the point, or the boundary close by, or nothing.
  void narrow_down(Random& random, int a, double at) {
    const double room = spec.radius + random.real(0.0, 0.13);
    if (random.chance(0.5)) {
      Box low{spec.origin, spec.origin + Vec3{4.0, 4.0, 4.0}};
      Box high = low;
      tern::axis(low.upper, a) = at - room;
      tern::axis(high.lower, a) = at + room;
      boxes.push_back(low);
      boxes.push_back(high);
    } else if (random.chance(0.5)) {
      tern::axis(spec.boundary.lower, a) = at - random.real(0.0, 0.4);
      tern::axis(spec.boundary.upper, a) = at + random.real(0.0, 0.4);
    }
  }
  void add_slab(Random& random, const Vec3& at) {
    Vec3 normal{0.0, 0.0, 1.0};
    if (random.chance(0.7)) normal = {random.real(-1.0, 1.0), random.real(-1.0, 1.0), random.real(0.1, 1.0)};
    const double half = random.real(0.0, 0.2);
    const double middle = tern::dot(normal, at);
    planes = {{normal, middle + half}, {-1.0 * normal, half - middle}};
  }
};

/// The answer to a request that begins at the room's point, on a grid with voxels of this size.
tern::Report answer(tern::Planner& planner, const NarrowRoom& room, double cell) {
  tern::GridSpec spec = room.spec;
  const int parts = static_cast<int>(spec.cell / cell + 0.5);
  spec.cell = cell;
  spec.dims = {parts * spec.dims.x, parts * spec.dims.y, parts * spec.dims.z};
  OwnedGrid owned(spec);
  EXPECT_EQ(owned.status, Status::kOk);
  for (const Box& box : room.boxes) owned.grid.mark_box(box);
  owned.grid.inflate();
  const tern::Fence fence{room.planes.data(), static_cast<int>(room.planes.size()), tern::FenceKind::kKeepIn};
  tern::Request request{};
  request.limits = {{2.0, 2.0, 2.0}, {2.0, 2.0, 2.0}};
  request.start.position = room.point;
  request.goal.position = room.point + Vec3{4e-4 * room.spec.cell, 0.0, 0.0};
  request.fences = &fence;
  request.fence_count = room.planes.empty() ? 0 : 1;
  tern::Trajectory plan{};
  tern::Report report{};
  planner.plan(owned.grid, request, plan, report);
  return report;
}

TEST(PathNarrow, TheResolutionThatIsNamedWouldDo) {
  std::unique_ptr<unsigned char[]> memory(new unsigned char[tern::kWorkspaceBytes]);
  tern::Planner planner(memory.get(), tern::kWorkspaceBytes);
  Random random(611);
  int narrow = 0;
  int named = 0;
  int fenced = 0;
  for (int i = 0; i < scaled(8000); ++i) {
    const NarrowRoom room(random);
    const tern::Report report = answer(planner, room, room.spec.cell);
    if (report.status != Status::kStartTooNarrow) {
      EXPECT_TRUE(!(report.finer_cell > 0.0));
      continue;
    }
    ++narrow;
    fenced += report.fence != tern::kNoFence ? 1 : 0;
    if (!(report.finer_cell >= 0.25 / 8.0)) continue;  // finer ones take too long here
    ++named;
    const Status finer = answer(planner, room, report.finer_cell).status;
    EXPECT_NE(finer, Status::kStartTooNarrow) << "case " << i << " at " << report.finer_cell;
    EXPECT_NE(finer, Status::kStartOccupied) << "case " << i << " at " << report.finer_cell;
  }
  EXPECT_GT(narrow, scaled(300));
  EXPECT_GT(named, scaled(200));
  EXPECT_GT(fenced, scaled(100));
}

/// Voxels may not be smaller than a micrometre, nor so small that the radius is wider than any grid or that doubles do
/// not tell them apart. None is named either where a grid would have too many voxels, or where those of a 64th of the
/// size would not do.
TEST(PathNarrow, NoResolutionIsNamedThatNoGridCanHave) {
  std::unique_ptr<unsigned char[]> memory(new unsigned char[tern::kWorkspaceBytes]);
  tern::Planner planner(memory.get(), tern::kWorkspaceBytes);
  constexpr double kWidth = 0.6;
  const auto named = [&](double cell, double radius, const Vec3& origin, int level, double width) {
    const tern::GridSpec spec = whole_grid({16, 16, 16}, cell, radius, origin);
    const tern::Report report = answer(planner, NarrowRoom(spec, level, width), cell);
    EXPECT_EQ(report.status, Status::kStartTooNarrow) << report.finer_cell;
    return report.finer_cell;
  };
  EXPECT_GT(named(0.25, 0.1, {}, 0, kWidth), 0.0);
  EXPECT_EQ(named(0.25, 0.1, {}, 0, 1e-3), 0.0);
  const tern::GridSpec small = whole_grid({2, 2, 2}, 0.25, 0.1, {});
  EXPECT_EQ(answer(planner, NarrowRoom(small, 0, 0.05), 0.25).finer_cell, 0.25 / 64.0);
  EXPECT_EQ(answer(planner, NarrowRoom(small, 0, 1e-3), 0.25).finer_cell, 0.0);
  EXPECT_GT(named(0.25, 0.25 * tern::kMaxDimension / 8.0, {}, 0, kWidth), 0.0);
  EXPECT_EQ(named(0.25, 0.26 * tern::kMaxDimension / 2.0, {}, 0, kWidth), 0.0);
  EXPECT_GT(named(8e-6, 1e-6, {}, 0, kWidth), 0.0);
  EXPECT_EQ(named(1.9e-6, 1e-6, {}, 0, kWidth), 0.0);
  for (int a = 0; a < 3; ++a) {
    Vec3 origin{};
    tern::axis(origin, a) = 1e11;
    EXPECT_GT(named(0.25, 0.1, origin, a, kWidth), 0.0) << a;
    tern::axis(origin, a) = 8e11;
    EXPECT_EQ(named(0.25, 0.1, origin, a, kWidth), 0.0) << a;
  }
}

}  // namespace
}  // namespace tern_test
