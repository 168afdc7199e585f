// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The certifier's own measure of body rates: |jerk x thrust| / |thrust|^2 over a piece of a segment.
#ifndef TERN_PROVE_TURNING_HPP
#define TERN_PROVE_TURNING_HPP

#include "base/work.hpp"
#include "tern/trajectory.hpp"

namespace tern {

/// What is allowed the body rates of a segment.
struct TurningRule {
  double most;      ///< rad/s, with what is granted
  double rounding;  ///< of the jerk's components, m/s^3
};

/// True if the rate keeps the rule for all parameters of [begin, end]. It compares the control points of jerk x thrust
/// with the coefficients of the squared thrust, both of degree 10.
bool turning_allowed(const Segment& segment, double begin, double end, const TurningRule& rule) noexcept;
/// The cuts, and the products of all pairs of control points.
constexpr Operations kTurningOperations = 8 * ops::kCurve;

/// The rate at one parameter of the segment, rad/s.
double turning_at(const Segment& segment, double u) noexcept;

}  // namespace tern

#endif
