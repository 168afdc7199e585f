// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A large ellipsoid inside a polyhedron: the Dikin ellipsoid of the logarithmic barrier at the analytic centre. It need
// not contain the segment. Half-spaces tangent to it leave more room than those tangent to the segment's own ellipsoid.
// Alternating between ellipsoid and half-spaces is the idea of regional inflation. Here it takes a few dozen steps with
// 3x3 matrices instead of a conic programme.
#ifndef TERN_ELLIPSOID_BARRIER_ELLIPSOID_HPP
#define TERN_ELLIPSOID_BARRIER_ELLIPSOID_HPP

#include "base/work.hpp"
#include "ellipsoid/ellipsoid_metric.hpp"
#include "tern/corridor.hpp"

namespace tern {

/// The ellipsoid as a metric, and a stand-in for the polyhedron's size.
struct BarrierEllipsoid {
  EllipsoidMetric metric;
  double size;  ///< det(E^2) * planes^3: grows like the square of the volume
};

/// Takes at most kBarrierSteps damped Newton steps from `inside` towards the analytic centre. A distance to a plane
/// counts as at least `least_slack` (metres, > 0), so a point on a plane is a valid start. If the steps run out early,
/// the ellipsoid is smaller, but nothing becomes unsafe: half-spaces are safe whatever metric they are made with.
BarrierEllipsoid barrier_ellipsoid(const Polyhedron& polyhedron, const Vector& inside, double least_slack,
                                   Work& work) noexcept;

}  // namespace tern

#endif
