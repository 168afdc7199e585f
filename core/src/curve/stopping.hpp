// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Manoeuvres that bring a moving state to rest, in closed form: straight ahead (brake.hpp), each axis on its own
// (axis_brake.hpp), after a turn, or with a swerve to a side. Whether there is room for one is the caller's question.
#ifndef TERN_CURVE_STOPPING_HPP
#define TERN_CURVE_STOPPING_HPP

#include "base/bounds.hpp"
#include "curve/axis_brake.hpp"
#include "curve/brake.hpp"
#include "tern/request.hpp"
#include "tern/trajectory.hpp"

namespace tern {

/// Relative excess over a speed limit that a stop may have: a state at its limit cannot level off at once.
constexpr double kStopTolerance = 2e-8;

/// Shortest time in which an acceleration levels off before the brakes, seconds: 0.05 s halved this many times.
constexpr int kLevelHalvings = 12;

/// Turns before the brakes: towards a side (eight around the velocity, or where the state turns already), how sharply,
/// how much of the limits goes into braking at the same time, and for how long, in parts of what braking takes.
constexpr int kTurnSides = 9;
constexpr int kTurnStrengths = 3;
constexpr int kTurnBrakings = 3;
constexpr int kTurnHolds = 4;
constexpr int kTurns = kTurnSides * kTurnStrengths * kTurnBrakings * kTurnHolds;

/// Swerves while braking: sides, sizes (each half the one before; the first takes all of the limit on acceleration),
/// and parts of the limits that the braking takes.
constexpr int kSwerveSides = 8;
constexpr int kSwerveSizes = 3;
constexpr int kSwerveStrengths = 2;
constexpr int kSwerveShapes = 2;
constexpr int kSwerves = kSwerveSides * kSwerveSizes * kSwerveStrengths * kSwerveShapes;

/// Axes on their own: with ramps as short as may be, and four times that.
constexpr int kAxisBrakes = 2;

/// In this order: braking straight ahead, the sharpest last; braking each axis on its own; turns, each followed by
/// either kind of braking; swerves. First all of them with the usual ramps, then all again with ramps that may be as
/// short as kSharpRamp.
constexpr int kStoppingManoeuvres = kBrakeShapes + kAxisBrakes + 2 * kTurns + kSwerves;
constexpr int kStoppingChoices = 2 * kStoppingManoeuvres;
constexpr int kStoppingSegments = 2 + kAxisBrakeSegments;
constexpr double kSharpRamp = 0.01;  ///< seconds

/// Segments that lead from the state to rest, continuous to jerk, which is zero at either end. Same frame as the state.
struct Stopping {
  int count;
  Segment segments[kStoppingSegments];
};

/// The stop of that choice, 0 .. kStoppingChoices - 1. False where it breaks the limits by more than kStopTolerance.
bool make_stopping(const State& state, const MotionLimits& limits, int choice, Stopping& out) noexcept;

/// The same flown backwards in time.
void reverse(Stopping& stopping) noexcept;

/// Where it ends.
inline const Vec3& rest_of(const Stopping& stopping) noexcept {
  return stopping.segments[stopping.count - 1].points[kDegree];
}

}  // namespace tern

#endif
