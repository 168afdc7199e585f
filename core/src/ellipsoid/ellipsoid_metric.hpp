// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Distances measured by an ellipsoid: how far it must swell about its centre until it touches a box. What a point set
// gets by evaluating a norm, a solid box gets by a quadratic programme in three box-constrained variables, solved
// exactly.
#ifndef TERN_ELLIPSOID_ELLIPSOID_METRIC_HPP
#define TERN_ELLIPSOID_ELLIPSOID_METRIC_HPP

#include "base/linear.hpp"
#include "grid/local_boxes.hpp"
#include "tern/corridor.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// An ellipsoid by its centre, orthonormal axes and semi-axes. Local frame, metres.
struct EllipsoidFrame {
  Vector center;
  Matrix direction;  ///< axes as columns
  Vector semi_axis;  ///< > 0
};

/// The same ellipsoid { p : (p - c)' M (p - c) <= 1 } ready for distances.
struct EllipsoidMetric {
  Vector center;
  Matrix matrix;  ///< M = E^-2
  Matrix shape;   ///< M^-1 = E^2
};

EllipsoidMetric metric_of(const EllipsoidFrame& frame) noexcept;

/// E, center: the paper's form { E q + c : |q| <= 1 }.
Ellipsoid ellipsoid_of(const EllipsoidFrame& frame) noexcept;

/// The point of the box that is nearest to `center` in the metric, as an offset from `center`. Zero where the box
/// holds `center`. Exact: the nearest point lies on a face that looks at the centre, within it on an edge that looks
/// at the face's free optimum, and there it is a clamp; at most three faces and two edges each are tried.
Vector nearest_offset(const EllipsoidMetric& metric, const Vector& center, const LocalBox& box) noexcept;

/// Where the swelling ellipsoid meets a box grown by the radius (a ball at every point of it).
struct Contact {
  Vector point;   ///< relative to the ellipsoid's centre, on the grown box
  Vector normal;  ///< unit, away from the centre; zero where the box holds the centre
  double scale;   ///< the ellipsoid scaled by this touches the plane with `normal` that cuts off the grown box
};

/// For radius 0 the contact is exact. For a radius > 0 the normal is that of a fixed-point step or two, so that the
/// plane may stand up to a rounding of the grown box's edge in front of it; the scale belongs to the plane and never
/// says more room than there is.
Contact contact_of(const EllipsoidMetric& metric, const LocalBox& box, double radius) noexcept;

/// max of normal . p over the ellipsoid, relative to its centre.
double reach_along(const EllipsoidMetric& metric, const Vector& normal) noexcept;

/// min of normal . p over the box: the corner that the normal points away from.
inline double support(const Vec3& normal, const LocalBox& box) noexcept {
  const double x = normal.x * (normal.x < 0.0 ? box.upper[0] : box.lower[0]);
  const double y = normal.y * (normal.y < 0.0 ? box.upper[1] : box.lower[1]);
  const double z = normal.z * (normal.z < 0.0 ? box.upper[2] : box.lower[2]);
  return (x + y) + z;
}

}  // namespace tern

#endif
