// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How much the certifier grants, and why. A grant is a distance that the planner allows itself, or it follows from the
// rounding of the compared numbers: a unit in the last place times a count of operations.
#ifndef TERN_PROVE_GRANTS_HPP
#define TERN_PROVE_GRANTS_HPP

#include "tern/grid.hpp"
#include "tern/trajectory.hpp"

namespace tern {

/// Metres, or parts of a voxel if voxels are larger than a metre. By this much a plan may lie outside the boundary or a
/// keep-in. It may be nearer than the radius by twice as much, because a control point may be outside a half-space of
/// the corridor, and the half-space too near. A start or a goal may be that much nearer than the radius, and a plan
/// begins and ends there.
constexpr double kCheckDistance = 1e-9;

/// kCheckDistance in metres, of this grid.
double check_distance(const Grid& grid) noexcept;
/// Metres by which putting a face of the boundary on the lattice may move what is compared with it.
double lattice_rounding(const Grid& grid) noexcept;

/// Relative excess over a limit: a stop may exceed a speed limit by kStopTolerance.
constexpr double kCheckRelative = 3e-8;

/// A unit in the last place, relative: 2^-52.
constexpr double kUlp = 1.0 / 4503599627370496.0;

/// The grant to a curve.
struct Grant {
  double near;     ///< metres by which it may be nearer than the radius to an obstacle or a keep-out
  double outside;  ///< metres by which it may be outside a keep-in
  Box boundary;    ///< where it may be, local frame, metres
  double excess;   ///< over a limit, relative
  bool is_cut;  ///< true: its control points are rounded, so its derivatives are granted derivative_rounding(). false:
                ///< the planner chose them, and hodograph_rounding() suffices.
};

/// For a plan, as the planner made it.
Grant grant_to_plan(const Grid& grid, const Trajectory& trajectory) noexcept;
/// For any other curve: a plan, a part of one, and a part with a brake appended. A little more than for a plan, so that
/// a checked plan is proven on the same map however it was cut.
Grant grant_to_curve(const Grid& grid, const Trajectory& trajectory) noexcept;

/// Metres between a point's places in the grid's frame and in the trajectory's: the rounding of local coordinates, and
/// of a world position relative to the grid's origin and to the plan's.
double place_rounding(const Grid& grid, const Trajectory& trajectory) noexcept;
constexpr double kGridUlps = 10.0;
constexpr double kOriginUlps = 2.0;
/// The corridor knows the corners of a keep-out to 1e-13 of the map's extent.
constexpr double kCornerUlps = 512.0;

/// Metres by which a plan may lie beyond the face of the boundary at that world coordinate. They are check_distance,
/// the movement of a face that is put on the lattice (kLatticeTolerance of a voxel), and the rounding of coordinates on
/// that axis. A start or goal on a face moves with the face. A request's start may lie at least as far beyond the face.
double face_grant(const Grid& grid, double face) noexcept;
constexpr double kFaceRoundingUlps = 4.0;

/// Metres that the ends of two segments may be apart, and by which any curve may be outside or too near. Rounding of
/// positions is in units in the last place of world coordinates and extents.
double curve_distance(const Grid& grid, const Trajectory& trajectory) noexcept;
constexpr double kPlaceUlps = 32.0;

/// Error of the derivative of this order (0 to 3) of a segment whose control points are rounded. A control point is the
/// sum of four products, or was cut by de Casteljau: exact to kPointUlps units in the last place of its coordinates.
/// The k-th derivative is a sum of 2^k control points at most, times 7! / (7 - k)! / duration^k.
double derivative_rounding(const Segment& segment, int order) noexcept;
constexpr double kPointUlps = 40.0;

/// Error of a hodograph's control point if the segment's control points are taken as exact. Their differences are
/// rounded by units in the last place of the segment's extent.
double hodograph_rounding(const Segment& segment, int order) noexcept;
constexpr double kDifferenceUlps = 8.0;

}  // namespace tern

#endif
