// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Whether a segment stays where and as slow as it should, exactly: what a plan must pass before the stage gives it out.
#ifndef TERN_CURVE_MOTION_LIMITS_HPP
#define TERN_CURVE_MOTION_LIMITS_HPP

#include "base/bounds.hpp"
#include "tern/corridor.hpp"
#include "tern/request.hpp"
#include "tern/trajectory.hpp"

namespace tern {

/// Accepted excess over a limit, relative, and accepted distance of a control point outside a half-space, metres.
constexpr double kLimitTolerance = 1e-9;
constexpr double kInsideTolerance = 1e-9;

/// The same for jerk, whose rounding is larger; and the part of its limit that plans leave free, so that what they
/// evaluate to is within it.
constexpr double kJerkTolerance = 2e-8;
constexpr double kJerkMargin = 1e-6;

/// How closely peaks are found, relative.
constexpr double kPeakTolerance = 1e-7;

/// The factor by which a segment between states at rest must be stretched in time to meet its limits exactly: the
/// largest over all t of the gauge of v, the root of the gauge of a and the cube root of the gauge of the jerk (see
/// base/bounds.hpp); below 1 where it could be faster. Never less than the truth, and more by kPeakTolerance at most,
/// or by kJerkMargin where the jerk decides.
double stretch_to_limits(const Segment& segment, const MotionLimits& limits) noexcept;

/// True where v and a are within (1 + tolerance) times the limits for all t, and the jerk within (1 + kJerkTolerance).
bool within_limits(const Segment& segment, const MotionLimits& limits, double tolerance = kLimitTolerance) noexcept;

/// True where all control points are inside, so that the segment is.
bool inside(const Segment& segment, const Polyhedron& polyhedron) noexcept;

}  // namespace tern

#endif
