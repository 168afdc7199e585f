// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_TRAJECTORY_CHAIN_HPP
#define TERN_TRAJECTORY_CHAIN_HPP

#include "tern/config.hpp"
#include "tern/corridor.hpp"
#include "tern/request.hpp"
#include "trajectory/hermite.hpp"

namespace tern {

/// The segments that a quadratic programme is about, each inside a polyhedron, with their durations. A polyhedron may
/// hold several segments in a row. Local frame.
struct Chain {
  int count;                      ///< 1 .. kMaxSegments
  int polyhedron[kMaxSegments];   ///< never decreasing, by one at most
  double duration[kMaxSegments];  ///< seconds, >= kMinDuration
  JointState start;               ///< jerk zero
  JointState goal;
  Vec3 center;  ///< what the programme's positions are relative to
};

/// Segments that one polyhedron is split into at most: to gain speed, to keep it, to lose it.
constexpr int kMaxSplit = 3;

/// Cuts the corridor into a chain and gives every segment the paper's time (Section 3.3.2) for its part of the way.
/// One segment of degree 7 between given states has no freedom, and between two joints cannot hold a speed: a
/// polyhedron longer than it takes to reach the limit speed and stop again, or than a third of the way, becomes up to
/// kMaxSplit segments, as far as kMaxSegments allows. Where start or goal move, so do the polyhedra around them.
void make_chain(const Corridor& corridor, const State& start, const State& goal, const Limits& limits,
                Chain& chain) noexcept;

/// Shortens the first and the last segment until what follows from the boundary states alone (half of their control
/// points, and the hodographs' there) keeps the polyhedra and the limits; kMinDuration at least. No effect at rest.
void fit_ends(const Corridor& corridor, const Limits& limits, Chain& chain) noexcept;

/// Sum of the durations, in order, seconds.
double chain_duration(const Chain& chain) noexcept;

}  // namespace tern

#endif
