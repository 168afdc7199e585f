// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The solid voxel nearest to a place: what keeps a vehicle from being there.
#ifndef TERN_FLIGHT_BLOCKED_HPP
#define TERN_FLIGHT_BLOCKED_HPP

#include <cstdint>

#include "tern/grid.hpp"
#include "tern/vec3.hpp"

namespace tern {

struct NearestSolid {
  bool found;
  Voxel voxel;
  double distance;      ///< of the place from the voxel's cube, metres
  std::uint32_t words;  ///< words of the obstacle layer that were read, plus rows
};

/// The marked voxel whose cube is nearest to a place of the local frame, of those less than `reach` away. Of equal
/// ones, the one with the least z, then y. Reads the rows within the reach.
NearestSolid nearest_solid(const Grid& grid, const Vec3& local, double reach) noexcept;

}  // namespace tern

#endif
