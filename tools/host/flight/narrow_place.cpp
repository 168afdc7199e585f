// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/narrow_place.hpp"

#include <cmath>

#include "host/number.hpp"

namespace tern_host {
namespace {

using tern::Grid;
using tern::Voxel;

constexpr double kVoxelRounding = 1e-9;  // voxels

bool is_free(const Grid& grid, const Voxel& voxel) {
  return grid.inside(voxel) && !grid.obstacle(voxel);
}

Voxel neighbour(const Voxel& voxel, int axis, int sign) {
  return {voxel.x + (axis == 0 ? sign : 0), voxel.y + (axis == 1 ? sign : 0), voxel.z + (axis == 2 ? sign : 0)};
}

/// Free voxels in a row, from the one beside `voxel` on; as many as `most`, at most.
int free_beside(const Grid& grid, Voxel voxel, int axis, int sign, int most) {
  int count = 0;
  for (; count < most; ++count) {
    voxel = neighbour(voxel, axis, sign);
    if (!is_free(grid, voxel)) break;
  }
  return count;
}

}  // namespace

std::string NarrowPlace::text() const {
  if (axis == 0) return "";
  return std::string("along ") + axis + ", " + fixed(free, 2) + " m are known to be free " +
         (at_vehicle ? "where the vehicle rests" : "beside that") + "; the vehicle needs " + fixed(vehicle, 2) +
         " m, and with voxels of " + brief(cell) + " m " + fixed(plan, 2) + " m";
}

NarrowPlace narrow_place(const Grid& safe, const tern::FlightReport& report, const tern::Vec3& rest) {
  const bool is_voxel =
      report.blocked_by == tern::BlockedBy::kUnseen || report.blocked_by == tern::BlockedBy::kObstacle;
  if (!is_voxel || !safe.bound()) return {};
  const double keeps = safe.spec().clearance();
  const double cell = safe.spec().cell;
  const int needed = 2 * static_cast<int>(std::ceil(keeps / cell - kVoxelRounding)) + 1;
  const Voxel here = safe.voxel_of(safe.to_local(rest));
  const Voxel there = safe.voxel_of(safe.to_local(report.blocked_at));
  NarrowPlace best;
  int count = needed;
  const auto take = [&](int axis, bool at_vehicle, int row) {
    count = row;
    best = {"xyz"[axis], at_vehicle, row * cell, 2.0 * keeps, needed * cell, cell};
  };
  for (int axis = 0; axis < 3 && is_free(safe, here); ++axis) {
    const int row = 1 + free_beside(safe, here, axis, 1, needed) + free_beside(safe, here, axis, -1, needed);
    if (row < count) take(axis, true, row);
  }
  if (best.at_vehicle) return best;
  count = 0;
  for (int k = 0; k < 6; ++k) {
    const int row = free_beside(safe, there, k / 2, k % 2 == 0 ? 1 : -1, needed);
    if (row > count && row < needed) take(k / 2, false, row);
  }
  return best;
}

}  // namespace tern_host
