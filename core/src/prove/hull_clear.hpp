// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Tells whether the hull of a few points keeps a distance from every obstacle cube of a grid. Local frame, metres.
#ifndef TERN_PROVE_HULL_CLEAR_HPP
#define TERN_PROVE_HULL_CLEAR_HPP

#include <cstdint>

#include "base/work.hpp"
#include "grid/bit_rows.hpp"
#include "tern/grid.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// The box around the points.
Box box_around(const Vec3* points, int count) noexcept;

/// Distance of a point from the closed cube of a voxel.
double distance_to_cube(const Grid& grid, const Voxel& voxel, const Vec3& point) noexcept;

/// Voxels of an axis that come within the distance of [lower, upper], and one more on either side to allow for
/// rounding.
IndexRange voxels_within(double lower, double upper, double distance, double cell, std::int32_t count) noexcept;

/// Obstacles that do not count: those in a range of voxels whose bit is also set in another layer.
struct Pardon {
  const std::uint64_t* layer = nullptr;  ///< with rows as in the grid's layers; null: all obstacles count
  IndexRange xs{0, 0}, ys{0, 0}, zs{0, 0};
};

/// The rule by which a hull must keep off obstacles.
struct Clearance {
  double distance;       ///< if it is negative, the hull may be inside an obstacle by so much
  const Vec3* departed;  ///< null, or a place that is left: an obstacle nearer to it than `distance` may be as near to
                         ///< the hull as to the place
  double tolerance;      ///< metres by which it may be nearer to the hull than to the place
  Pardon pardon;
  double ground = __builtin_inf();  ///< of `departed`: an obstacle that begins at this height or above it is not left
};

/// True only if the hull of the points keeps the clearance from all obstacle cubes. If false, `found` receives a voxel
/// that is too near. The answer may be false although the hull keeps the clearance, but hardly ever if the points lie
/// nearly on a line. Reads the voxels within the distance of the hull's box.
bool hull_clear(const Grid& grid, const Vec3* points, int count, const Clearance& clearance, Voxel& found,
                Work& work) noexcept;

}  // namespace tern

#endif
