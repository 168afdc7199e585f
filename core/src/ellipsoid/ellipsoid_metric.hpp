// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Distances measured by an ellipsoid: how far it must grow about its centre until it touches a box. For a point, that
// is a norm. For a solid box, it is a quadratic programme in three variables with bounds, which is solved exactly.
#ifndef TERN_ELLIPSOID_ELLIPSOID_METRIC_HPP
#define TERN_ELLIPSOID_ELLIPSOID_METRIC_HPP

#include "base/linear.hpp"
#include "grid/local_boxes.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// An ellipsoid by its centre, orthonormal axes and semi-axes. Local frame, metres.
struct EllipsoidFrame {
  Vector center;
  Matrix direction;  ///< axes as columns
  Vector semi_axis;  ///< > 0
};

/// An ellipsoid { p : (p - c)' M (p - c) <= 1 }, in the form that distances need.
struct EllipsoidMetric {
  Vector center;
  Matrix matrix;  ///< M = E^-2
  Matrix shape;   ///< M^-1 = E^2
};

EllipsoidMetric metric_of(const EllipsoidFrame& frame) noexcept;

/// The point of the box that is nearest to `center` in the metric, as an offset from `center`. Zero if the box contains
/// `center`. The result is exact. The nearest point lies on a face that faces the centre. If the optimum on the plane
/// of that face is outside the face, the nearest point lies on an edge that faces this optimum, where clamping finds
/// it. At most three faces with two edges each are tried.
Vector nearest_offset(const EllipsoidMetric& metric, const Vector& center, const LocalBox& box) noexcept;

/// The contact of the growing ellipsoid with a box grown by the radius (the box with a ball at each of its points).
struct BoxContact {
  Vector point;   ///< relative to the ellipsoid's centre, on the grown box
  Vector normal;  ///< unit, away from the centre; zero if the box contains the centre
  double scale;   ///< scaled by this, the ellipsoid touches the plane with `normal` that cuts off the grown box
};

/// For radius 0 the contact is exact. For a radius > 0 the normal comes from a few fixed-point steps, so the plane may
/// lie slightly in front of the rounded edge of the grown box. The scale is that of the plane, so it never overstates
/// the room.
BoxContact contact_of(const EllipsoidMetric& metric, const LocalBox& box, double radius) noexcept;
/// Operations of contact_of(): three steps, each with up to three faces and six edges. A third of these, on average,
/// take a product with the matrix.
constexpr Operations kContactOperations = 3 * 3 * 8 * ops::kDot;

/// A lower bound of the scale at which the growing ellipsoid meets the box grown by the radius. It takes a fraction of
/// the price of contact_of: the ellipsoid meets the box beyond any plane that cuts the box off.
double least_scale(const EllipsoidMetric& metric, const LocalBox& box, double radius) noexcept;
/// Operations of least_scale(): the box's bounds, the nearest offset, and a product with the matrix.
constexpr Operations kScaleOperations = 8 * ops::kDot;

/// max of normal . p over the ellipsoid, relative to its centre.
double reach_along(const EllipsoidMetric& metric, const Vector& normal) noexcept;

}  // namespace tern

#endif
