// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The planner's result and how to fly it: Bezier segments of degree 7 (the paper's Section 3.4.1).
#ifndef TERN_TRAJECTORY_HPP
#define TERN_TRAJECTORY_HPP

#include <stdint.h>

#include "tern/config.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// Degree of every segment (the paper's n), and its number of control points.
constexpr int kDegree = 7;
constexpr int kControlPoints = kDegree + 1;

/// Segment::polyhedron of a segment that is in no polyhedron.
constexpr int kNoPolyhedron = -1;

/// One Bezier segment, B_j of the paper's Section 3.4.1. At time t after its beginning the position relative to
/// Trajectory::origin is sum_i points[i] * C(7, i) u^i (1 - u)^(7 - i), with u = t / duration.
struct Segment {
  /// Seconds, > 0.
  double duration;
  /// Control points in flight order, metres, relative to Trajectory::origin, axes as in the world frame. The segment
  /// begins at the first one, ends at the last one, and lies in their convex hull.
  Vec3 points[kControlPoints];
  /// Index of the polyhedron of the corridor that holds all the control points; kNoPolyhedron for a stop, an arrival or
  /// a previous plan, which no corridor was made for.
  int polyhedron;
};

/// Position at one time with its first four derivatives. World frame.
struct Sample {
  Vec3 position;      ///< m
  Vec3 velocity;      ///< m/s
  Vec3 acceleration;  ///< m/s^2
  Vec3 jerk;          ///< m/s^3
  Vec3 snap;          ///< m/s^4
};

/// A plan: segments in flight order. Where two segments meet, position, velocity, acceleration and jerk agree; snap may
/// jump. Plain data without pointers: copy it, store it, send it. The caller owns it.
///
/// A time on a trajectory is in seconds since its beginning: 0 is where the first segment begins, duration() is where
/// the last one ends. `begin` says when that 0 is on a clock of yours. What is left of a trajectory at a later time is
/// the same trajectory and that time: evaluate(), clear_until(), Proof and Request::previous take both, so nothing is
/// cut, and nothing is rounded.
struct Trajectory {
  /// When the trajectory begins: nanoseconds of a clock of yours, which may show any number. A new plan has that of its
  /// request (Request::begin), 0 if you set none. A previous plan that is followed keeps its own.
  int64_t begin = 0;
  /// Segments in use, 1 .. kMaxSegments in a plan.
  int count;
  /// The point that the control points are relative to, world frame, metres. A plan's origin is the start position that
  /// it was made for, so the control points keep their precision far from the world's origin.
  Vec3 origin;
  Segment segments[kMaxSegments];
};

/// Duration of the whole trajectory in seconds: the segments' durations, added in order. 0 for an empty trajectory.
double duration(const Trajectory& trajectory) noexcept;

/// The time on the trajectory when the clock shows `now`: seconds since Trajectory::begin, negative before it. Every
/// pair of numbers has an answer. If they are at most 104 days apart, it is right to 3e-16 of itself.
double time_on(const Trajectory& trajectory, int64_t now) noexcept;

/// The state of the trajectory at `t` seconds after its beginning. Every input has an answer:
/// - `t` is NaN or negative: the state at the beginning.
/// - `t` is at the end or past it: the goal's position with all derivatives zero, even if the goal is in motion.
/// - `t` is where two segments meet: the later segment's state.
/// - an empty trajectory: zeros.
/// Takes time proportional to the number of segments. Safe to call from any thread.
Sample evaluate(const Trajectory& trajectory, double t) noexcept;

/// The integral of |snap|^2 over the whole trajectory, m^2/s^7: the objective of the paper's Section 3.4.3.
double snap_cost(const Trajectory& trajectory) noexcept;

}  // namespace tern

#endif
