// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How much the check tolerates, and why. A tolerance is a distance that the planner allows itself, or it follows from
// the rounding of the compared numbers: a unit in the last place times a count of operations.
#ifndef TERN_CHECK_TOLERANCE_HPP
#define TERN_CHECK_TOLERANCE_HPP

#include "tern/grid.hpp"
#include "tern/trajectory.hpp"

namespace tern {

/// Metres, or parts of a voxel if voxels are larger than a metre. By this much a control point may lie outside a
/// half-space or the boundary, and a polyhedron may be too near to an obstacle. A start or a goal may be that much
/// nearer than the radius, and a plan begins and ends there.
constexpr double kCheckDistance = 1e-9;

/// kCheckDistance in metres, of this grid.
double check_distance(const Grid& grid) noexcept;

/// Relative excess over a limit: a stop may exceed a speed limit by kStopTolerance.
constexpr double kCheckRelative = 3e-8;

/// A unit in the last place, relative: 2^-52.
constexpr double kUlp = 1.0 / 4503599627370496.0;

/// Metres by which a half-space of the corridor may miss a voxel's corner. Its offset is a sum of three products of
/// local coordinates, each rounded to half a unit in the last place. The corridor computes the sum once, and the check
/// once more. A start that the half-space touches was rounded when the grid's origin was subtracted from it.
double grid_rounding(const Grid& grid) noexcept;
constexpr double kGridUlps = 10.0;
constexpr double kOriginUlps = 2.0;

/// Metres by which a fence may be too near: the corridor knows the corners of a keep-out to 1e-13 of the map's extent.
double fence_tolerance(const Grid& grid) noexcept;
constexpr double kCornerUlps = 512.0;

/// Metres between a point's places in the corridor and in the trajectory: grid_rounding, and the rounding of a world
/// position relative to the grid's origin and to the plan's.
double place_rounding(const Grid& grid, const Trajectory& trajectory) noexcept;

/// Metres by which a face of the boundary moves when it is put on the lattice (kLatticeTolerance of a voxel). A start
/// or goal on the face moves with it.
double lattice_rounding(const Grid& grid) noexcept;

/// Metres by which a control point may lie beyond the face of the boundary at that world coordinate: check_distance,
/// lattice_rounding, and the rounding of coordinates on that axis. A request's start may lie at least as far beyond the
/// face.
double face_tolerance(const Grid& grid, double face) noexcept;
constexpr double kFaceRoundingUlps = 4.0;

/// Error of the derivative of this order (0 to 3) at an end of a segment whose control points are rounded. A control
/// point is the sum of four products, exact to kPointUlps units in the last place of the segment's largest coordinate.
/// The k-th derivative is a k-th difference, a sum of 2^k control points at most, times 7! / (7 - k)! / duration^k.
double derivative_rounding(const Segment& segment, int order) noexcept;
constexpr double kPointUlps = 32.0;

/// Error of a hodograph's control point if the segment's control points are taken as exact. Their differences are
/// rounded by units in the last place of the segment's extent.
double hodograph_rounding(const Segment& segment, int order) noexcept;
constexpr double kDifferenceUlps = 8.0;

}  // namespace tern

#endif
