// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_TRAJECTORY_HPP
#define TERN_TRAJECTORY_HPP

#include "tern/config.hpp"
#include "tern/vec3.hpp"

namespace tern {

constexpr int kDegree = 7;
constexpr int kControlPoints = kDegree + 1;

/// One Bezier segment of degree 7 (the paper's Section 3.4.1).
struct Segment {
  double duration;              ///< seconds, > 0
  Vec3 points[kControlPoints];  ///< Bernstein coefficients over u = t / duration, relative to Trajectory::origin
  int polyhedron;               ///< index of the corridor polyhedron that holds all of them
};

/// A point of a trajectory with its derivatives, world frame.
struct Sample {
  Vec3 position;
  Vec3 velocity;
  Vec3 acceleration;
  Vec3 jerk;
  Vec3 snap;
};

/// A plan: segments joined with equal position, velocity, acceleration and jerk (C3).
struct Trajectory {
  int count;    ///< segments, 1 at least in a plan
  Vec3 origin;  ///< what the control points are relative to, world frame: a planner's plan begins here
  Segment segments[kMaxSegments];
};

/// The sum of the segments' durations, seconds, added in order.
double duration(const Trajectory& trajectory) noexcept;

/// State at time t (seconds from the start). Total in all inputs: NaN and times before 0 give the start; past the end
/// the goal's position is held with zero derivatives; at a joint the later segment speaks. An empty trajectory gives
/// zeros.
Sample evaluate(const Trajectory& trajectory, double t) noexcept;

/// The integral over time of |snap|^2, summed over segments (the paper's Section 3.4.3), m^2/s^7.
double snap_cost(const Trajectory& trajectory) noexcept;

}  // namespace tern

#endif
