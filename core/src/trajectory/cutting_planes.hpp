// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the search learns about durations from abandoned programmes. The multipliers of an abandoned programme give a
// lower bound of the snap at its durations. Its prices tell how that bound falls as durations grow. So each such
// programme gives a plane over the logarithms of the durations, and the least snap lies above all planes: Kelley's
// cutting planes. A step of the search bends away from durations at which the planes are too high. It gives time back
// to segments that press against a limit, and keeps shortening the others.
#ifndef TERN_TRAJECTORY_CUTTING_PLANES_HPP
#define TERN_TRAJECTORY_CUTTING_PLANES_HPP

#include "trajectory/curvature.hpp"

namespace tern {

/// The most planes that are kept; the last ones are.
constexpr int kMaxCuttingPlanes = 8;

/// A lower bound of the snap, m^2/s^7, linear in the logarithms of the durations.
struct CuttingPlane {
  double prices[kMaxSegments];  ///< by how much the bound falls for a unit of the logarithm of each segment's duration
  double snap;                  ///< the bound at the durations of the programme that it came from
  double at_base;               ///< the bound at the base, the durations from which steps begin
};

struct CuttingPlanes {
  int found;  ///< planes found since the search began; the last kMaxCuttingPlanes are kept
  CuttingPlane list[kMaxCuttingPlanes];
};

/// Adds a plane; it replaces the oldest one if there is no room. `step`: the logarithms of its durations divided by the
/// base's.
void add_plane(CuttingPlanes& planes, double snap, const double* prices, const double* step, int count) noexcept;

/// Moves the base by `step`, in the logarithms of its durations.
void move_base(CuttingPlanes& planes, const double* step, int count) noexcept;

/// Changes Newton's step so that it also minimises by how much the planes rise above the snap at the base. The
/// curvature is as newton_step left it.
void bend_step(const CuttingPlanes& planes, const Curvature& curvature, double base_snap, int count,
               double* step) noexcept;

}  // namespace tern

#endif
