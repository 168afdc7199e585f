// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The shapes of things that move, as the certifier reads them. A ball is a point here, and its radius part of the
// distance that a curve has to keep.
#ifndef TERN_PROVE_TRACK_SHAPE_HPP
#define TERN_PROVE_TRACK_SHAPE_HPP

#include "base/math.hpp"
#include "tern/track.hpp"

namespace tern {

/// The point of the shape that is nearest to `point`, both relative to the centre.
inline Vec3 nearest_of(const Track& track, const Vec3& point) {
  const Vec3& half = track.half;
  if (track.shape == TrackShape::kBall) return kZero;
  const double z = clamp(point.z, -half.z, half.z);
  if (track.shape == TrackShape::kBox) return {clamp(point.x, -half.x, half.x), clamp(point.y, -half.y, half.y), z};
  const double across = horizontal_length(point);
  const double share = across > track.radius ? track.radius / across : 1.0;
  return {share * point.x, share * point.y, z};
}

/// How far the shape reaches from its centre along a normal.
inline double reach_along(const Track& track, const Vec3& normal) {
  const Vec3& half = track.half;
  const double up = absolute(normal.z) * half.z;
  if (track.shape == TrackShape::kBall) return 0.0;
  if (track.shape == TrackShape::kBox) return (absolute(normal.x) * half.x + absolute(normal.y) * half.y) + up;
  return track.radius * horizontal_length(normal) + up;
}

/// What a distance from the shape has besides.
inline double ball_of(const Track& track) {
  return track.shape == TrackShape::kBall ? track.radius : 0.0;
}

/// No less than any coordinate of the shape: for rounding.
inline double shape_size(const Track& track) {
  if (track.shape == TrackShape::kBall) return track.radius;
  return track.radius + ((track.half.x + track.half.y) + track.half.z);
}

}  // namespace tern

#endif
