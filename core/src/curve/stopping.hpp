// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Manoeuvres that bring a moving state to rest, in closed form: straight ahead (brake.hpp), each axis on its own
// (axis_brake.hpp), after a turn, or with a swerve to a side. The caller has to check whether there is room.
#ifndef TERN_CURVE_STOPPING_HPP
#define TERN_CURVE_STOPPING_HPP

#include "base/bounds.hpp"
#include "base/work.hpp"
#include "curve/axis_brake.hpp"
#include "curve/brake.hpp"
#include "tern/request.hpp"
#include "tern/trajectory.hpp"

namespace tern {

/// Relative excess over a speed limit that a stop may have: a state at its limit cannot level off at once.
constexpr double kStopTolerance = 2e-8;

/// Levelling off an acceleration before the braking takes kMinDuration, halved at most this many times.
constexpr int kLevelHalvings = 12;

/// Turns before the braking. They differ in their side: eight around the velocity, and the one to which the state
/// already turns. They also differ in their sharpness, in the part of the limits that brakes at the same time, and in
/// their duration, relative to that of braking.
constexpr int kTurnSides = 9;
constexpr int kTurnStrengths = 3;
constexpr int kTurnBrakings = 3;
constexpr int kTurnHolds = 4;
constexpr int kTurns = kTurnSides * kTurnStrengths * kTurnBrakings * kTurnHolds;

/// Swerves while braking. They differ in their side, their size (each half the one before; the first takes all of the
/// limit on acceleration), the part of the limits that the braking takes, and its shape.
constexpr int kSwerveSides = 8;
constexpr int kSwerveSizes = 3;
constexpr int kSwerveStrengths = 2;
constexpr int kSwerveShapes = 2;
constexpr int kSwerves = kSwerveSides * kSwerveSizes * kSwerveStrengths * kSwerveShapes;

/// Brakings of each axis on its own: one with the shortest ramps, one with ramps four times as long.
constexpr int kAxisBrakes = 2;

/// The manoeuvres, in this order: braking straight ahead, the sharpest last; braking each axis on its own; turns, each
/// followed by either kind of braking; swerves. The choices are all manoeuvres with the usual ramps, then all again
/// with ramps that may be as short as kSharpRamp.
constexpr int kStoppingManoeuvres = kBrakeShapes + kAxisBrakes + 2 * kTurns + kSwerves;
constexpr int kStoppingChoices = 2 * kStoppingManoeuvres;
constexpr int kStoppingSegments = 2 + kAxisBrakeSegments;
constexpr double kSharpRamp = 0.01;  ///< seconds

/// Segments that lead from a state to rest, in the state's frame. They are continuous to jerk, which is that of the
/// state at the beginning and zero at the end.
struct Stopping {
  int count;
  Segment segments[kStoppingSegments];
};

/// Makes the stop of `choice`, 0 .. kStoppingChoices - 1. False if it breaks the limits by more than kStopTolerance.
bool make_stopping(const State& state, const MotionLimits& limits, int choice, Stopping& out) noexcept;
/// Operations of a stop: each segment with its three derivatives against the limits, in three ways to level off.
constexpr Operations kStopOperations = 3 * 4 * ops::kCurve * kStoppingSegments;

/// Turns the stop into the same motion flown backwards in time.
void reverse(Stopping& stopping) noexcept;

/// The position at which the stop ends.
inline const Vec3& rest_of(const Stopping& stopping) noexcept {
  return stopping.segments[stopping.count - 1].points[kDegree];
}

}  // namespace tern

#endif
