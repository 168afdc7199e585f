// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The check of as many polyhedra with as many half-spaces as there may be, in a comb of obstacles whose every run is
// cut off by another half-space than the one before.
#include <cstddef>

#include "base/math.hpp"
#include "caps/cap.hpp"
#include "check/check_stage.hpp"

namespace tern_caps {
namespace {

/// A local box of the longest leg: 8 m and 2 m on every side, in voxels of 0.1 m.
constexpr double kCell = 0.1;
constexpr tern::Voxel kDims{120, 40, 40};
constexpr tern::Vec3 kHover{11.0, 2.0, 2.0};
constexpr int kBoxFaces = 6;
constexpr int kTeeth = tern::kMaxPlanes - kBoxFaces;
constexpr std::size_t kTrajectoryOffset = std::size_t{1} << 20;
constexpr std::size_t kCheckOffset = std::size_t{2} << 20;

/// Every second voxel along x, as many as there are half-spaces for them.
tern::Grid comb() {
  tern::Grid grid = make_grid(kDims, kCell, 0.0);
  for (int tooth = 0; tooth < kTeeth; ++tooth) {
    tern::Box plate = grid.spec().boundary;
    plate.lower.x = (2 * tooth + 1) * kCell;
    plate.upper.x = (2 * tooth + 2) * kCell;
    grid.mark_box(plate);
  }
  grid.inflate();
  return grid;
}

/// The box's faces, then a half-space behind each tooth, the first tooth's first. Their normals lean a little, for
/// upright ones would make the box smaller.
void add_planes(const tern::Grid& grid, tern::Polyhedron& polyhedron) {
  const tern::Box box = grid.local_boundary();
  constexpr double kLean = 1e-3;
  const double length = tern::square_root(1.0 + kLean * kLean);
  polyhedron.count = polyhedron.redundant = 0;
  for (int a = 0; a < 3; ++a) {
    tern::Vec3 normal{0.0, 0.0, 0.0};
    tern::axis(normal, a) = 1.0;
    polyhedron.planes[polyhedron.count++] = {normal, tern::axis(box.upper, a)};
    tern::axis(normal, a) = -1.0;
    polyhedron.planes[polyhedron.count++] = {normal, -tern::axis(box.lower, a)};
  }
  for (int tooth = 0; tooth < kTeeth; ++tooth) {
    const double x = (2 * tooth + 2.5) * kCell;
    polyhedron.planes[polyhedron.count++] = {{-1.0 / length, kLean / length, 0.0}, -x / length};
  }
}

tern::Segment hover() {
  tern::Segment segment{};
  segment.duration = 1.0;
  for (tern::Vec3& point : segment.points) point = kHover;
  return segment;
}

}  // namespace

void check_caps() {
  auto& corridor = state_at<tern::Corridor>(0);
  auto& trajectory = state_at<tern::Trajectory>(kTrajectoryOffset);
  auto& stage = state_at<tern::CheckStage>(kCheckOffset);
  const tern::Grid grid = comb();
  corridor.count = trajectory.count = tern::kMaxSegments;
  trajectory.origin = {0.0, 0.0, 0.0};
  for (int i = 0; i < tern::kMaxSegments; ++i) {
    add_planes(grid, corridor.polyhedra[i]);
    trajectory.segments[i] = hover();
    trajectory.segments[i].polyhedron = i;
  }
  const tern::Request request = request_between(kHover, kHover);
  const tern::CheckQuery query{request.start, request.goal, request.limits};
  tern::Work work{tern::kCheckBound + 1};
  tern::Progress progress = tern::Progress::kMore;
  tern::check_begin(stage);
  const std::uint64_t instructions =
      count([&] { progress = tern::check_advance(stage, grid, corridor, trajectory, query, work); });
  report({"segments_checked", "check", instructions, progress == tern::Progress::kDone ? stage.units : 0,
          tern::kCheckBound, stage.units, 1});
}

}  // namespace tern_caps
