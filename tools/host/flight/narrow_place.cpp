// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/narrow_place.hpp"

#include <cmath>

#include "host/flight/vectors.hpp"
#include "host/flight/widest_way.hpp"
#include "host/number.hpp"

namespace tern_host {
namespace {

using tern::Grid;
using tern::Voxel;

constexpr double kVoxelRounding = 1e-9;  // voxels

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
  if (!found) return "";
  const std::string where = "at " + fixed(at.x, 2) + " " + fixed(at.y, 2) + " " + fixed(at.z, 2) + ", ";
  const std::string takes = brief(cell) + " m, that takes " + fixed(width, 2) + " m";
  if (axis == 0) {
    return where + "the widest way passes " + fixed(gap, 2) +
           " m from what is not known to be free; the vehicle keeps " + fixed(0.5 * vehicle, 2) +
           " m from it; with voxels of " + takes + " along each axis";
  }
  return where + fixed(free, 2) + " m are known to be free along " + axis + "; the vehicle needs " + fixed(vehicle, 2) +
         " m; with voxels of " + takes;
}

NarrowPlace narrow_place(const Grid& safe, const tern::Vec3& rest, const tern::Vec3& goal) {
  if (!safe.bound()) return {};
  const WidestWay way = widest_way(safe, safe.to_local(rest), safe.to_local(goal));
  if (way.voxels.empty()) return {};
  const double keeps = safe.spec().clearance();
  const double cell = safe.spec().cell;
  const int needed = 2 * static_cast<int>(std::ceil(keeps / cell - kVoxelRounding)) + 1;
  NarrowPlace place{true, {}, 0.0, 0, 0.0, 2.0 * keeps, needed * cell, cell};
  std::size_t narrowest = way.narrowest;
  int count = needed;
  for (std::size_t k = 0; k < way.voxels.size(); ++k) {
    const Voxel& voxel = way.voxels[k];
    for (int axis = 0; axis < 3; ++axis) {
      const int row = 1 + free_beside(safe, voxel, axis, 1, needed) + free_beside(safe, voxel, axis, -1, needed);
      if (row >= count) continue;
      count = row;
      narrowest = k;
      place.axis = "xyz"[axis];
      place.free = row * cell;
    }
  }
  place.at = along(safe.spec().origin, 1.0, safe.center(way.voxels[narrowest]));
  place.gap = way.gaps[narrowest];
  return place;
}

}  // namespace tern_host
