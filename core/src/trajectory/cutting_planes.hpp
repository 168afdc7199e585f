// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What programmes that were abandoned say about durations. The multipliers of such a programme are a lower bound of the
// snap at its durations, and its prices say how that bound falls where durations grow. So each one is a plane over the
// logarithms of the durations, and the least snap lies above all of them: Kelley's cutting planes. A step of the search
// bends away from where they are too high. It gives time back to the segments at which a limit presses, and goes on
// with the others.
#ifndef TERN_TRAJECTORY_CUTTING_PLANES_HPP
#define TERN_TRAJECTORY_CUTTING_PLANES_HPP

#include "trajectory/curvature.hpp"

namespace tern {

/// Planes that are kept: the last ones.
constexpr int kMaxCuttingPlanes = 8;

/// A bound of the snap, by the logarithms of the durations, m^2/s^7.
struct CuttingPlane {
  double prices[kMaxSegments];  ///< by how much it falls for each part by which a segment lasts longer
  double snap;                  ///< where it was found
  double at_base;               ///< at the durations from which steps begin
};

struct CuttingPlanes {
  int found;  ///< since the search began; the last kMaxCuttingPlanes are kept
  CuttingPlane list[kMaxCuttingPlanes];
};

/// Adds a plane, instead of the oldest one where there is no room. `step`: the logarithms of its durations over the
/// base's.
void add_plane(CuttingPlanes& planes, double snap, const double* prices, const double* step, int count) noexcept;

/// The base has moved by `step`, in the logarithms of its durations.
void move_base(CuttingPlanes& planes, const double* step, int count) noexcept;

/// Changes Newton's step so that it also minimises by how much the planes rise above the snap at the base. The
/// curvature is as newton_step left it.
void bend_step(const CuttingPlanes& planes, const Curvature& curvature, double base_snap, int count,
               double* step) noexcept;

}  // namespace tern

#endif
