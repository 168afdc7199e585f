// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What docs/proof.md forgives, section by section. Nothing else is forgiven.
#ifndef TERN_VERIFY_TOLERANCE_HPP
#define TERN_VERIFY_TOLERANCE_HPP

#include "verify/plan.hpp"
#include "verify/solids.hpp"

namespace tern_verify {

/// Of the three coordinates.
Rational largest_gap(const Point& a, const Point& b);

struct Tolerance {
  Rational half_space;  ///< metres that a half-space may be nearer to a solid voxel than the clearance
  Rational point;       ///< metres that a control point may be outside a half-space or the boundary
  Rational fence;       ///< metres that a half-space may be nearer to a keep-out, or a control point outside a keep-in
  Rational via;         ///< metres
  Rational place;       ///< metres between an end of the plan and where it was asked to be
};

Tolerance tolerance_of(const Problem& problem, const Lattice& lattice, const Plan& plan);

/// Of derivative k (0 to 3) at an end of a segment.
Rational joint_tolerance(const Segment& segment, int derivative);

/// Of a bound that holds for all t on a segment.
Rational bound_tolerance(const Segment& segment, const Bound& bound);
/// What docs/proof.md grants the vertical thrust on a cone of this slope, and the rate at which the thrust turns.
Rational tilt_tolerance(const Segment& segment, const Rational& slope);
Rational turn_tolerance(const Segment& segment, const Rational& rate, const Rational& least_thrust);

}  // namespace tern_verify

#endif
