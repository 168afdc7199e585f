// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A large ellipsoid inside a polyhedron, not tied to the segment: the Dikin ellipsoid of the logarithmic barrier at its
// analytic centre. Tangent to it, the next half-spaces leave more room than those around the segment's own ellipsoid;
// alternating the two is the idea of regional inflation, at a few dozen 3x3 steps instead of a conic programme.
#ifndef TERN_ELLIPSOID_BARRIER_ELLIPSOID_HPP
#define TERN_ELLIPSOID_BARRIER_ELLIPSOID_HPP

#include "ellipsoid/ellipsoid_metric.hpp"
#include "tern/corridor.hpp"

namespace tern {

/// The ellipsoid as a metric, and a stand-in for the polyhedron's size.
struct BarrierEllipsoid {
  EllipsoidMetric metric;
  double size;  ///< det(E^2) * planes^3: grows with the square of the volume
};

/// Damped Newton steps towards the analytic centre from `inside`, at most kBarrierSteps. Distances to planes count as
/// `least_slack` (metres, > 0) at least, so that a point on a plane is a valid beginning. An early end costs size,
/// never safety: the half-spaces made with a metric do not depend on what it is.
BarrierEllipsoid barrier_ellipsoid(const Polyhedron& polyhedron, const Vector& inside, double least_slack) noexcept;

}  // namespace tern

#endif
