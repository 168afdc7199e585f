// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_TRAJECTORY_CHAIN_HPP
#define TERN_TRAJECTORY_CHAIN_HPP

#include "curve/hermite.hpp"
#include "tern/config.hpp"
#include "tern/corridor.hpp"
#include "tern/request.hpp"
#include "tern/trajectory.hpp"

namespace tern {

/// The segments that a quadratic programme is about, each inside a polyhedron, with their durations. A polyhedron may
/// hold several segments in a row. Local frame.
struct Chain {
  int count;                      ///< 1 .. kMaxSegments
  int polyhedron[kMaxSegments];   ///< never decreasing
  double duration[kMaxSegments];  ///< seconds, >= kMinDuration
  double length[kMaxSegments];    ///< metres of the way that each is for
  JointState start;               ///< jerk zero
  JointState goal;
  Vec3 center;  ///< what the programme's positions are relative to
};

/// Segments that one polyhedron is split into at most: to gain speed, to keep it, to lose it.
constexpr int kMaxSplit = 3;

/// Cuts the corridor into a chain and gives every segment the time of a trapezoidal profile (Section 3.3.2) along the
/// whole way: cruising speed, with ramps at the ends that are at rest, and some slack. One segment of degree 7 between
/// given states has no freedom, and between two joints cannot hold a speed: a polyhedron longer than half of the way,
/// or than some times what it takes to reach the limit speed and stop again, becomes up to kMaxSplit segments, as far
/// as kMaxSegments allows. Where start or goal move, so do the polyhedra around them.
void make_chain(const Corridor& corridor, const State& start, const State& goal, const Limits& limits,
                Chain& chain) noexcept;

/// Shortens the first and the last segment until what follows from the boundary states alone (half of their control
/// points, and the hodographs' there) keeps the polyhedra and the limits; kMinDuration at least. No effect at rest.
void fit_ends(const Corridor& corridor, const Limits& limits, Chain& chain) noexcept;

/// The segments of a plan that keeps everything, from the chain's start to its goal, with their durations: a programme
/// over them has a solution. Segments from rest to rest become halves, which gives the programme freedom there, as far
/// as kMaxSegments allows. Start, goal and centre stay.
void follow(const Trajectory& plan, Chain& chain) noexcept;

/// Sum of the durations, in order, seconds.
double chain_duration(const Chain& chain) noexcept;

}  // namespace tern

#endif
