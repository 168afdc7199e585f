// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Distances measured by an ellipsoid: how far it must grow about its centre until it touches a box. For a point, that
// is a norm. For a solid box, it is a quadratic programme in three variables with bounds, which is solved exactly.
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

/// The same ellipsoid { p : (p - c)' M (p - c) <= 1 }, in the form that distances need.
struct EllipsoidMetric {
  Vec3 center;
  double matrix[3][3];  ///< M = E^-2
  double shape[3][3];   ///< M^-1 = E^2
};

EllipsoidMetric metric_of(const EllipsoidFrame& frame) noexcept;

/// E, center: the paper's form { E q + c : |q| <= 1 }.
Ellipsoid ellipsoid_of(const EllipsoidFrame& frame) noexcept;

/// The point of the box that is nearest to `center` in the metric, as an offset from `center`. Zero if the box contains
/// `center`. The result is exact. The nearest point lies on a face that faces the centre. If the optimum on the plane
/// of that face is outside the face, the nearest point lies on an edge that faces this optimum, where clamping finds
/// it. At most three faces with two edges each are tried.
Vec3 nearest_offset(const EllipsoidMetric& metric, const Vec3& center, const LocalBox& box) noexcept;

/// Where the growing ellipsoid meets a box grown by the radius (the box with a ball at each of its points).
struct Contact {
  Vec3 point;    ///< relative to the ellipsoid's centre, on the grown box
  Vec3 normal;   ///< unit, away from the centre; zero if the box contains the centre
  double scale;  ///< scaled by this, the ellipsoid touches the plane with `normal` that cuts off the grown box
};

/// For radius 0 the contact is exact. For a radius > 0 the normal comes from a few fixed-point steps, so the plane may
/// lie slightly in front of the rounded edge of the grown box. The scale is that of the plane, so it never overstates
/// the room.
Contact contact_of(const EllipsoidMetric& metric, const LocalBox& box, double radius) noexcept;

/// max of normal . p over the ellipsoid, relative to its centre.
double reach_along(const EllipsoidMetric& metric, const Vec3& normal) noexcept;

inline Vec3 multiply(const double (&m)[3][3], const Vec3& v) noexcept {
  return {(m[0][0] * v.x + m[0][1] * v.y) + m[0][2] * v.z, (m[1][0] * v.x + m[1][1] * v.y) + m[1][2] * v.z,
          (m[2][0] * v.x + m[2][1] * v.y) + m[2][2] * v.z};
}

/// min of normal . p over the box, reached at the corner that the normal points away from.
inline double support(const Vec3& normal, const LocalBox& box) noexcept {
  const double x = normal.x * (normal.x < 0.0 ? box.upper[0] : box.lower[0]);
  const double y = normal.y * (normal.y < 0.0 ? box.upper[1] : box.lower[1]);
  const double z = normal.z * (normal.z < 0.0 ? box.upper[2] : box.lower[2]);
  return (x + y) + z;
}

}  // namespace tern

#endif
