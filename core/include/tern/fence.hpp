// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_FENCE_HPP
#define TERN_FENCE_HPP

#include <stdint.h>

#include "tern/halfspace.hpp"
#include "tern/vec3.hpp"

namespace tern {

enum class FenceKind : uint8_t {
  kKeepIn = 0,   ///< the robot's centre stays inside, as it stays inside the boundary; the radius plays no part
  kKeepOut = 1,  ///< the robot's centre keeps the grid's radius from it, as from an obstacle
};

/// A geofence: the convex polyhedron that `count` half-spaces share. World frame, metres; normals of any length within
/// [kMinFenceNormal, kMaxFenceNormal]. It need not be bounded. With several fences all of them hold; a keep-out
/// without points keeps nothing out, a keep-in without points lets nothing in.
struct Fence {
  const Halfspace* planes;  ///< the caller's; read while a plan begins
  int32_t count;            ///< 1 or more
  FenceKind kind;
};
constexpr double kMinFenceNormal = 1e-6;
constexpr double kMaxFenceNormal = 1e6;

/// No fence, where one is named by its index in the request.
constexpr int32_t kNoFence = -1;

/// Half-spaces of a box.
constexpr int kBoxPlanes = 6;

/// The half-spaces of a box, for a fence that is one.
void box_planes(const Box& box, Halfspace (&out)[kBoxPlanes]) noexcept;

}  // namespace tern

#endif
