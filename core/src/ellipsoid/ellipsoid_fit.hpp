// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Step (1) of the paper's Section 3.3.1: the ellipsoid around a segment. A sphere over the segment, its x axis fixed
// along it; the other two axes shrink until no obstacle is inside; then z alone stretches again as far as it may.
#ifndef TERN_ELLIPSOID_ELLIPSOID_FIT_HPP
#define TERN_ELLIPSOID_ELLIPSOID_FIT_HPP

#include <cstdint>

#include "ellipsoid/ellipsoid_metric.hpp"
#include "grid/local_boxes.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// Boxes grown by a radius: what the ellipsoid must not meet.
struct Obstacles {
  const LocalBox* boxes;
  int count;
  double radius;
};

/// Segments shorter than this, in metres, are points: their ellipsoid is a ball.
constexpr double kPointLike = 1e-6;

/// The sphere over a segment that is no point (kPointLike), x along it.
EllipsoidFrame sphere_over(const Vec3& from, const Vec3& to) noexcept;

/// Fits the ellipsoid to the segment from `from` to `to` (local frame, metres). `cell` gives a point-like segment's
/// ball its size. `inside` is scratch for obstacles.count indices.
///
/// The paper shrinks until no obstacle is inside. Here one may stay inside by a thousandth of the ellipsoid's size, and
/// no axis falls below a hundredth of the longest: what is stored with a polyhedron is inscribed in it afterwards.
EllipsoidFrame fit_ellipsoid(const Vec3& from, const Vec3& to, const Obstacles& obstacles, double cell,
                             std::int32_t* inside) noexcept;

/// The ellipsoid with no semi-axis below `share` of the first. A segment that grazes an obstacle has a needle for an
/// ellipsoid; the tangents of a needle are all nearly parallel, and cut away space that no obstacle takes.
EllipsoidFrame at_least_as_thick(const EllipsoidFrame& frame, double share) noexcept;

}  // namespace tern

#endif
