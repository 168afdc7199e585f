// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HALFSPACE_HPP
#define TERN_HALFSPACE_HPP

#include "tern/vec3.hpp"

namespace tern {

/// The half-space of all points p with normal . p <= offset (the H_j of the paper's Section 3.3.1). The normal points
/// out of it. Frame: the one of the structure that holds it.
struct Halfspace {
  /// Half-spaces that Tern returns have a normal of length 1. A function that takes half-spaces says which lengths it
  /// accepts.
  Vec3 normal;
  /// With a normal of length 1: the distance of the plane from the origin along the normal, metres.
  double offset;
};

/// Half-spaces of a box.
constexpr int kBoxPlanes = 6;

/// Writes the six half-spaces of `box` to `out`, in the frame of `box`: upper and lower face of x, then of y, then of
/// z. The normals have length 1.
void box_planes(const Box& box, Halfspace (&out)[kBoxPlanes]) noexcept;

}  // namespace tern

#endif
