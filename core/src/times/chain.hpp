// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The segments that a trajectory will have, before anything but their durations is known.
#ifndef TERN_TIMES_CHAIN_HPP
#define TERN_TIMES_CHAIN_HPP

#include "curve/hermite.hpp"
#include "tern/config.hpp"

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

/// Appends `pieces` segments of `length` metres each, without durations, to the polyhedron.
inline void append_pieces(double length, int polyhedron, int pieces, Chain& chain) noexcept {
  for (int i = 0; i < pieces; ++i) {
    chain.polyhedron[chain.count] = polyhedron;
    chain.length[chain.count] = length;
    ++chain.count;
  }
}

/// Sum of the durations, in order, seconds.
inline double chain_duration(const Chain& chain) noexcept {
  double sum = 0.0;
  for (int i = 0; i < chain.count; ++i) sum += chain.duration[i];
  return sum;
}

}  // namespace tern

#endif
