// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Exact tests of whether a segment stays inside its polyhedron and within the limits. A plan must pass them before a
// stage returns it.
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

/// Accepted excess over a limit on jerk, relative. It is larger, because the rounding of jerk is. Plans leave
/// kJerkMargin of the limit free, so that the jerk that they evaluate to keeps the limit.
constexpr double kJerkTolerance = 2e-8;
constexpr double kJerkMargin = 1e-6;

/// Relative accuracy of a peak.
constexpr double kPeakTolerance = 1e-7;

/// The factor by which a segment between states at rest must be stretched in time to meet its limits exactly; below 1
/// if the segment could be faster. It is the largest, over all t, of the gauge of v, the root of the gauge of a and the
/// cube root of the gauge of the jerk (see base/bounds.hpp). Never less than the exact factor. More by at most
/// kPeakTolerance, or by kJerkMargin if the jerk decides.
double stretch_to_limits(const Segment& segment, const MotionLimits& limits) noexcept;

/// True if v and a are within (1 + tolerance) times the limits for all t, and the jerk within (1 + kJerkTolerance).
bool within_limits(const Segment& segment, const MotionLimits& limits, double tolerance = kLimitTolerance) noexcept;

/// True if all control points are inside the polyhedron; the whole segment then is.
bool inside(const Segment& segment, const Polyhedron& polyhedron) noexcept;

}  // namespace tern

#endif
