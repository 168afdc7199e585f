// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Whether the hull of a few points keeps a distance from every obstacle cube of a grid. Local frame, metres.
#ifndef TERN_PROOF_HULL_CLEAR_HPP
#define TERN_PROOF_HULL_CLEAR_HPP

#include <cstdint>

#include "grid/bit_rows.hpp"
#include "tern/grid.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// The box around the points.
Box box_around(const Vec3* points, int count) noexcept;

/// Obstacles that do not count: those of a range of voxels that are set in another layer, too.
struct Pardon {
  const std::uint64_t* layer = nullptr;  ///< with the rows of the grid's; null: all count
  IndexRange xs{0, 0}, ys{0, 0}, zs{0, 0};
};

/// What a hull keeps from obstacles.
struct Clearance {
  double distance;   ///< > 0
  const Vec3* left;  ///< null, or a place: obstacles nearer to it than the distance may stay as near as they are to it,
  double tolerance;  ///< but for this
  Pardon pardon;
};

/// True only where the hull of the points keeps the clearance from all obstacle cubes. `found` gets a voxel for which
/// it is false. The answer may be false although the hull keeps it, but hardly where the points lie nearly on a line.
/// Reads the voxels within the distance of the hull's box. `effort` grows by what that took (see Work).
bool hull_clear(const Grid& grid, const Vec3* points, int count, const Clearance& clearance, Voxel& found,
                std::uint32_t& effort) noexcept;

}  // namespace tern

#endif
