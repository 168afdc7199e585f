// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Geofences: convex regions that the robot must stay in or out of. They belong to one request and change nothing in the
// grid. docs/fences.md explains how plans respect them.
#ifndef TERN_FENCE_HPP
#define TERN_FENCE_HPP

#include <stdint.h>

#include "tern/halfspace.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// What a fence asks for. Any other number is refused.
enum class FenceKind : uint8_t {
  /// The robot's centre stays inside the fence. The radius plays no part, as with the grid's boundary.
  kKeepIn = 0,
  /// The robot's centre stays at least the grid's radius away from the fence, as from an obstacle.
  kKeepOut = 1,
};

/// A fence: the convex polyhedron in which all its half-spaces intersect. World frame, metres. It may be unbounded,
/// flat, or far from the map. If a request has several fences, all of them hold.
///
/// A keep-out without any point is refused with kFenceEmpty, and so are keep-ins without a point in common. The usual
/// cause is a reversed half-space, or a polygon whose corners go round the wrong way. Half-spaces that miss each other
/// by no more than 1e-13 of the map's diagonal count as flat, not as empty. If half-spaces meet only 100 000 times as
/// far away as their planes, they count as empty: they were meant to be parallel, and rounding turned them.
struct Fence {
  /// `count` half-spaces. The caller owns them. They are read only while a plan begins. Each normal has a length within
  /// [kMinFenceNormal, kMaxFenceNormal]; the offset is in the same scale. box_planes() writes those of a box.
  const Halfspace* planes;
  /// At least 1, and at most kMaxFencePlanes for all fences of a request together.
  int32_t count;
  FenceKind kind;
  /// Of a fence for a while: when it begins and ends, nanoseconds of the clock of Request::begin, or of Flight::tick().
  /// If both are equal, the fence always holds; `until` may not be before `from` (kInvalidArgument).
  int64_t from = 0;
  int64_t until = 0;
  /// s, >= 0 and finite: by how much the clock of the fence may differ from that of the plan, to both sides. A keep-out
  /// begins that much earlier and ends that much later, a keep-in begins later and ends earlier.
  double clock_error = 0.0;
};

/// True for a fence for a while. Plans are proven to respect it, and led around a keep-out in time. If a request has
/// keep-ins for a while, the centre is in one of those that hold, at all times.
constexpr bool is_timed(const Fence& fence) noexcept {
  return fence.from != fence.until;
}
/// Shortest and longest normal that a fence may have.
constexpr double kMinFenceNormal = 1e-6;
constexpr double kMaxFenceNormal = 1e6;

/// Means "no fence" in place of a fence's index, as in Report::fence.
constexpr int32_t kNoFence = -1;

}  // namespace tern

#endif
