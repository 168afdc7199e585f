// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Poses and how they are put together.
#ifndef TERN_ONBOARD_POSE_HPP
#define TERN_ONBOARD_POSE_HPP

#include <cstdint>

#include "tern/map.hpp"
#include "tern/vec3.hpp"

namespace tern_onboard {

/// Where the body is: position in the world, m, and the unit quaternion (w, x, y, z) that turns body axes (x ahead, y
/// left, z up) into the world's (east, north, up, or any frame with z up). `stamp`: nanoseconds, when it was true, on
/// the clock of Onboard::tick().
struct StampedPose {
  std::int64_t stamp;
  tern::Pose pose;
};

/// a - b, a + b, and a times k.
tern::Vec3 minus(const tern::Vec3& a, const tern::Vec3& b);
tern::Vec3 plus(const tern::Vec3& a, const tern::Vec3& b);
tern::Vec3 times(const tern::Vec3& a, double k);
double length(const tern::Vec3& a);
bool is_finite(const tern::Vec3& a);

/// The vector turned by a unit quaternion (w, x, y, z).
tern::Vec3 turn(const double (&q)[4], const tern::Vec3& v);
/// The pose in the outer frame of what has pose `inner` in the frame that has pose `outer`.
tern::Pose compose(const tern::Pose& outer, const tern::Pose& inner);
/// Between two poses, at a share of 0 .. 1: the position on the straight line, the attitude on the shortest turn.
tern::Pose between(const tern::Pose& a, const tern::Pose& b, double share);
/// The angle between two attitudes, rad.
double angle_between(const double (&a)[4], const double (&b)[4]);
/// The angle of the body's x from the world's x, seen from above, rad.
double heading_of(const double (&q)[4]);
/// Scales the quaternion to norm 1. False, and it stays, if it is not finite or its norm is off by more than 0.01.
bool make_unit(double (&q)[4]);

}  // namespace tern_onboard

#endif
