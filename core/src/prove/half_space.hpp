// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A half-space as the certifier reads it: exactly, however far from the world's origin.
#ifndef TERN_PROVE_HALF_SPACE_HPP
#define TERN_PROVE_HALF_SPACE_HPP

#include "base/double_double.hpp"
#include "base/math.hpp"
#include "prove/solid.hpp"
#include "tern/halfspace.hpp"

namespace tern {

/// An offset of this size holds every map or none.
constexpr double kBeyondAnyMap = 1e100;

/// Normalises a half-space that is not beyond any map. `frame`: the origin of local coordinates, in the world.
/// `center`: the origin of the result, in local coordinates. The length of the normal alone is rounded.
inline Plane<DoubleDouble> plane_about(const Halfspace& world, const Vec3& frame, const Vec3& center) {
  const double scale = 1.0 / length(world.normal);
  const DoubleDouble offset = depth_of(depth_of(DoubleDouble(world.offset), world.normal, frame), world.normal, center);
  return {{exact_product(scale, world.normal.x), exact_product(scale, world.normal.y),
           exact_product(scale, world.normal.z)},
          DoubleDouble(scale) * offset};
}

/// The same in doubles: a half-space beyond any map has an infinite offset.
inline Halfspace local_plane(const Halfspace& world, const Vec3& frame) {
  const double scale = 1.0 / length(world.normal);
  if (absolute(world.offset) > kBeyondAnyMap) {
    return {scale * world.normal, world.offset > 0.0 ? __builtin_inf() : -__builtin_inf()};
  }
  const DoubleDouble offset = depth_of(DoubleDouble(world.offset), world.normal, frame);
  return {scale * world.normal, scale * offset.high};
}

}  // namespace tern

#endif
