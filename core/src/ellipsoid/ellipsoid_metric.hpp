// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Distances measured by an ellipsoid: how far it must swell about its centre until it touches a box. What a point set
// gets by evaluating a norm, a solid box gets by a quadratic programme in three box-constrained variables, solved
// exactly.
#ifndef TERN_ELLIPSOID_ELLIPSOID_METRIC_HPP
#define TERN_ELLIPSOID_ELLIPSOID_METRIC_HPP

#include "base/math.hpp"
#include "grid/local_boxes.hpp"
#include "tern/corridor.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// An ellipsoid by its centre, orthonormal axes and semi-axes. Local frame, metres.
struct EllipsoidFrame {
  Vec3 center;
  Vec3 direction[3];
  double semi_axis[3];  ///< > 0
};

/// The same ellipsoid { p : (p - c)' M (p - c) <= 1 } ready for distances.
struct EllipsoidMetric {
  Vec3 center;
  double matrix[3][3];  ///< M = E^-2
  double shape[3][3];   ///< M^-1 = E^2
};

EllipsoidMetric metric_of(const EllipsoidFrame& frame) noexcept;

/// E, center: the paper's form { E q + c : |q| <= 1 }.
Ellipsoid ellipsoid_of(const EllipsoidFrame& frame) noexcept;

/// The point of the box that is nearest to `center` in the metric, as an offset from `center`. Zero where the box
/// holds `center`. Exact: the nearest point lies on a face that looks at the centre, within it on an edge that looks
/// at the face's free optimum, and there it is a clamp; at most three faces and two edges each are tried.
Vec3 nearest_offset(const EllipsoidMetric& metric, const Vec3& center, const LocalBox& box) noexcept;

/// Where the swelling ellipsoid meets a box grown by the radius (a ball at every point of it).
struct Contact {
  Vec3 point;    ///< relative to the ellipsoid's centre, on the grown box
  Vec3 normal;   ///< unit, away from the centre; zero where the box holds the centre
  double scale;  ///< the ellipsoid scaled by this touches the plane with `normal` that cuts off the grown box
};

/// For radius 0 the contact is exact. For a radius > 0 the normal is that of a fixed-point step or two, so that the
/// plane may stand up to a rounding of the grown box's edge in front of it; the scale belongs to the plane and never
/// says more room than there is.
Contact contact_of(const EllipsoidMetric& metric, const LocalBox& box, double radius) noexcept;

/// max of normal . p over the ellipsoid, relative to its centre.
double reach_along(const EllipsoidMetric& metric, const Vec3& normal) noexcept;

inline Vec3 multiply(const double (&m)[3][3], const Vec3& v) noexcept {
  return {(m[0][0] * v.x + m[0][1] * v.y) + m[0][2] * v.z, (m[1][0] * v.x + m[1][1] * v.y) + m[1][2] * v.z,
          (m[2][0] * v.x + m[2][1] * v.y) + m[2][2] * v.z};
}

/// min of normal . p over the box: the corner that the normal points away from.
inline double support(const Vec3& normal, const LocalBox& box) noexcept {
  const double x = normal.x * (normal.x < 0.0 ? box.upper[0] : box.lower[0]);
  const double y = normal.y * (normal.y < 0.0 ? box.upper[1] : box.lower[1]);
  const double z = normal.z * (normal.z < 0.0 ? box.upper[2] : box.lower[2]);
  return (x + y) + z;
}

}  // namespace tern

#endif
