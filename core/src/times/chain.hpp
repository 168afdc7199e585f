// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The segments that a trajectory will have. So far, only their polyhedra and durations are known.
#ifndef TERN_TIMES_CHAIN_HPP
#define TERN_TIMES_CHAIN_HPP

#include "curve/hermite.hpp"
#include "tern/config.hpp"

namespace tern {

/// What is given at the joint at which a chain passes a via. Local frame.
struct Hold {
  int polyhedron;     ///< index of the polyhedron that begins there
  int segment;        ///< index of the chain's segment that begins there
  Vec3 position;      ///< position of the via
  double reach;       ///< half the edge of the cube around the via that the joint stays in, metres; 0: the joint is at
                      ///< the via
  bool stop;          ///< velocity, acceleration and jerk are zero
  bool has_velocity;  ///< the velocity is given
  Vec3 velocity;
};

/// The holds of a way, in its order, increasing in polyhedra. A view.
struct Holds {
  const Hold* list = nullptr;
  int count = 0;
};

/// The segments that a quadratic programme optimises, with their durations. Each lies inside a polyhedron, which may
/// contain several segments in a row. Local frame.
struct Chain {
  int count;                      ///< 1 .. kMaxSegments
  int polyhedron[kMaxSegments];   ///< never decreasing
  double duration[kMaxSegments];  ///< seconds, >= kMinDuration
  double length[kMaxSegments];    ///< metres of the way that each segment covers
  JointState start;               ///< jerk zero
  JointState goal;
  int hold_count;
  Hold holds[kMaxVias];
  Vec3 center;  ///< origin of the programme's positions
};

/// Appends `pieces` segments of `length` metres each, without durations, to the polyhedron.
inline void append_pieces(double length, int polyhedron, int pieces, Chain& chain) noexcept {
  for (int i = 0; i < pieces; ++i) {
    chain.polyhedron[chain.count] = polyhedron;
    chain.length[chain.count] = length;
    ++chain.count;
  }
}

/// True if derivative `k` (0: position) is given at the hold's joint.
inline bool gives(const Hold& hold, int k) noexcept {
  if (k == 0) return !(hold.reach > 0.0);
  return hold.stop || (k == 1 && hold.has_velocity);
}

/// The hold at the joint where the segment begins; null if there is none.
inline const Hold* hold_at(const Chain& chain, int segment) noexcept {
  for (int i = 0; i < chain.hold_count; ++i) {
    if (chain.holds[i].segment == segment) return &chain.holds[i];
  }
  return nullptr;
}

/// Finds the segment where each hold's polyhedron begins. False if one has no segment.
inline bool place_holds(Chain& chain) noexcept {
  int segment = 0;
  for (int i = 0; i < chain.hold_count; ++i) {
    Hold& hold = chain.holds[i];
    while (segment < chain.count && chain.polyhedron[segment] < hold.polyhedron) ++segment;
    if (segment == chain.count || chain.polyhedron[segment] != hold.polyhedron) return false;
    hold.segment = segment;
  }
  return true;
}

/// Sum of the durations, in order, seconds.
inline double chain_duration(const Chain& chain) noexcept {
  double sum = 0.0;
  for (int i = 0; i < chain.count; ++i) sum += chain.duration[i];
  return sum;
}

/// True if the chain passes a via with a given velocity. Such a chain has no stop-and-go, and cannot be stretched in
/// time.
inline bool hurries(const Chain& chain) noexcept {
  for (int i = 0; i < chain.hold_count; ++i) {
    if (chain.holds[i].has_velocity) return true;
  }
  return false;
}

}  // namespace tern

#endif
