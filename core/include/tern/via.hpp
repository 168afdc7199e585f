// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Points that a plan passes on its way from start to goal.
#ifndef TERN_VIA_HPP
#define TERN_VIA_HPP

#include <stdint.h>

#include "tern/vec3.hpp"

namespace tern {

/// A point on the way of a plan. A plan passes all vias of its request in their order. World frame, SI units; all
/// numbers must be finite (kNonFiniteInput). The position must lie in the grid's boundary (kOutOfMap), keep the radius
/// from obstacles (kViaOccupied) and obey the fences (kViaFenced), whatever the tolerance.
struct Via {
  /// m, the robot's centre.
  Vec3 position{};
  /// m, >= 0: the plan comes at least this near. 0, and anything below kLeastTolerance: through the position itself.
  double tolerance = 0.0;
  /// True: the plan comes to rest there. Velocity, acceleration and jerk are zero for an instant, or for `dwell`.
  bool stop = false;
  /// True: the plan has exactly `velocity` there. Not together with `stop` (kInvalidArgument).
  bool has_velocity = false;
  /// m/s, within the limits (kViaExceedsLimits). Read only if has_velocity is true.
  Vec3 velocity{};
  /// s, 0 .. kMaxDwell: the plan rests there for so long. Above 0 only together with `stop` (kInvalidArgument).
  double dwell = 0.0;
};

/// A tolerance below this counts as 0, metres.
constexpr double kLeastTolerance = 1e-6;

/// The longest dwell, seconds.
constexpr double kMaxDwell = 3600.0;

/// Means "no via" in place of a via's index, as in Report::via.
constexpr int32_t kNoVia = -1;

}  // namespace tern

#endif
