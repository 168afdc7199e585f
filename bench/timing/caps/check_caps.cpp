// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The check of as many segments as there may be, each with as many hints as there may be, across a map that is full of
// obstacles but for a lane. Only the last two hints are of use, and every row of the map has to be looked at.
#include <cstddef>

#include "base/math.hpp"
#include "caps/cap.hpp"
#include "prove/check_stage.hpp"

namespace tern_caps {
namespace {

/// The longest leg, 8 m, in a map of voxels of 0.1 m that is 2 m larger on every side.
constexpr double kCell = 0.1;
constexpr tern::Voxel kDims{120, 60, 40};
constexpr tern::Vec3 kFrom{2.0, 1.0, 2.0};
constexpr tern::Vec3 kTo{9.0, 4.8, 2.0};
/// Metres from the lane's middle to its sides.
constexpr double kLane = 0.3;
constexpr std::size_t kTrajectoryOffset = std::size_t{1} << 20;
constexpr std::size_t kCheckOffset = std::size_t{2} << 20;

tern::Vec3 side_of_lane() {
  const tern::Vec3 along = kTo - kFrom;
  const double length = tern::length(along);
  return {-along.y / length, along.x / length, 0.0};
}

/// Everything but the lane, whose sides are stairs.
tern::Grid lane() {
  tern::Grid grid = make_grid(kDims, kCell, 0.05);
  const tern::Vec3 side = side_of_lane();
  for (int y = 0; y < kDims.y; ++y) {
    for (int x = 0; x < kDims.x; ++x) {
      const tern::Vec3 center{(x + 0.5) * kCell, (y + 0.5) * kCell, kFrom.z};
      if (tern::absolute(tern::dot(side, center - kFrom)) < kLane) continue;
      tern::Box column = grid.spec().boundary;
      column.lower.x = column.upper.x = center.x;
      column.lower.y = column.upper.y = center.y;
      grid.mark_box(column);
    }
  }
  grid.inflate();
  return grid;
}

/// All lean along the lane, so that they cut nothing off; the last two look at its sides.
void add_hints(tern::Polyhedron& polyhedron) {
  const tern::Vec3 side = side_of_lane();
  const tern::Vec3 along{side.y, -side.x, 0.0};
  constexpr double kLean = 1e-3;
  const double scale = 1.0 / tern::square_root(1.0 + kLean * kLean);
  polyhedron.count = tern::kMaxPlanes;
  for (int p = 0; p < tern::kMaxPlanes; ++p) {
    const double lean = p % 3 == 0 ? kLean : -kLean;
    polyhedron.planes[p] = {scale * ((p % 2 == 0 ? 1.0 : -1.0) * along + lean * tern::Vec3{0.0, 0.0, 1.0}), 0.0};
  }
  polyhedron.planes[tern::kMaxPlanes - 2].normal = side;
  polyhedron.planes[tern::kMaxPlanes - 1].normal = -1.0 * side;
}

/// From rest to rest.
tern::Segment straight(const tern::Vec3& from, const tern::Vec3& to) {
  tern::Segment segment{};
  segment.duration = 60.0;
  for (int i = 0; i < tern::kControlPoints; ++i) segment.points[i] = 2 * i < tern::kControlPoints ? from : to;
  return segment;
}

}  // namespace

void check_caps() {
  auto& corridor = state_at<tern::Corridor>(0);
  auto& trajectory = state_at<tern::Trajectory>(kTrajectoryOffset);
  auto& stage = state_at<tern::CheckStage>(kCheckOffset);
  const tern::Grid grid = lane();
  corridor.count = trajectory.count = tern::kMaxSegments;
  trajectory.origin = {0.0, 0.0, 0.0};
  for (int i = 0; i < tern::kMaxSegments; ++i) {
    add_hints(corridor.polyhedra[i]);
    trajectory.segments[i] = i % 2 == 0 ? straight(kFrom, kTo) : straight(kTo, kFrom);
    trajectory.segments[i].polyhedron = i;
  }
  const tern::Request request = request_between(kFrom, tern::kMaxSegments % 2 == 0 ? kFrom : kTo);
  const tern::CheckQuery query{request.start, request.goal, request.limits};
  tern::Work work{kUnlimited};
  tern::Progress progress = tern::Progress::kMore;
  tern::check_begin(stage);
  const std::uint64_t instructions =
      count([&] { progress = tern::check_advance(stage, grid, corridor, trajectory, query, work); });
  const auto reached = static_cast<std::uint64_t>(stage.next);
  report({"segments_checked", "check", instructions, progress == tern::Progress::kDone ? reached : 0,
          tern::kMaxSegments, units_of(work), 1});
}

}  // namespace tern_caps
