// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Straight up from the ground, and down to it: between the place where the vehicle stands and the lowest place above it
// from which it may fly anywhere.
#ifndef TERN_FLIGHT_LIFT_HPP
#define TERN_FLIGHT_LIFT_HPP

#include "base/bounds.hpp"
#include "tern/grid.hpp"
#include "tern/trajectory.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// Where the vehicle is to land.
struct Landing {
  bool is_asked;
  Vec3 place;     ///< where its centre rests once it stands, world frame
  double ground;  ///< the height that the ground there does not exceed, metres
  double speed;   ///< of the descent, at most, m/s
};

/// Voxels from the radius to how far around a place the ground must be known: a voxel's diagonal, seen from above, and
/// a little more.
constexpr double kGroundVoxels = 1.5;

/// The height from which a vehicle flies on: it keeps the radius and a voxel from all voxels that hold ground.
inline double height_above(const GridSpec& window, double ground) noexcept {
  return ground + window.clearance() + 2.0 * window.cell;
}

/// How far around a place the ground must be known, metres.
inline double ground_needed(const GridSpec& window) noexcept {
  return window.clearance() + kGroundVoxels * window.cell;
}

/// Appends a segment straight along `way`, from rest to rest, within the limits and no faster than `speed`. False if
/// there is no room.
bool append_lift(const Vec3& way, double speed, const MotionLimits& limits, Trajectory& out) noexcept;

}  // namespace tern

#endif
