// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Step (1) of the paper's Section 3.3.1: the ellipsoid around a segment. A sphere over the segment, its x axis fixed
// along it; the other two axes shrink until no obstacle is inside; then z alone stretches again as far as it may.
#ifndef TERN_CORRIDOR_ELLIPSOID_FIT_HPP
#define TERN_CORRIDOR_ELLIPSOID_FIT_HPP

#include <cstdint>

#include "corridor/ellipsoid_metric.hpp"
#include "corridor/local_boxes.hpp"
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

/// Fits the ellipsoid to the segment from `from` to `to` (local frame, metres). `cell` gives a point-like segment's
/// ball its size. `inside` is scratch for obstacles.count indices.
///
/// The paper shrinks for every obstacle inside. Here an obstacle may stay inside by kFitTolerance of the ellipsoid's
/// size, and no axis falls below kThinnest of the longest: the half-spaces are exact whatever the ellipsoid is, and a
/// segment that grazes an obstacle would otherwise get a needle whose half-spaces are all parallel to one plane.
EllipsoidFrame fit_ellipsoid(const Vec3& from, const Vec3& to, const Obstacles& obstacles, double cell,
                             std::int32_t* inside) noexcept;

}  // namespace tern

#endif
