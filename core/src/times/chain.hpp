// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The segments that a trajectory will have. So far, only their polyhedra and durations are known.
#ifndef TERN_TIMES_CHAIN_HPP
#define TERN_TIMES_CHAIN_HPP

#include "curve/hermite.hpp"
#include "tern/config.hpp"

namespace tern {

/// The joint at which a chain passes a via, and the values given there. Local frame.
struct ViaJoint {
  int polyhedron;     ///< index of the polyhedron that begins there
  int segment;        ///< index of the chain's segment that begins there
  Vec3 position;      ///< position of the via
  double reach;       ///< half the edge of the cube around the via that the joint stays in, metres; 0: the joint is at
                      ///< the via
  bool stop;          ///< velocity, acceleration and jerk are zero
  bool has_velocity;  ///< the velocity is given
  Vec3 velocity;
};

/// The via joints of a way in flight order. The list must outlive this object.
struct ViaJoints {
  const ViaJoint* list = nullptr;
  int count = 0;
};

/// The segments that a quadratic programme optimises, with their durations. Each lies inside a polyhedron, which may
/// contain several segments in a row. Local frame.
struct Chain {
  int count;                      ///< 1 .. kMaxSegments
  int polyhedron[kMaxSegments];   ///< never decreasing
  double duration[kMaxSegments];  ///< seconds, >= kMinDuration
  double length[kMaxSegments];    ///< metres of the way that each segment covers
  JointState start;
  JointState goal;
  int via_joint_count;
  ViaJoint via_joints[kMaxVias];
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

/// True if derivative `k` (0: position) is given at the joint.
inline bool gives(const ViaJoint& via_joint, int k) noexcept {
  if (k == 0) return !(via_joint.reach > 0.0);
  return via_joint.stop || (k == 1 && via_joint.has_velocity);
}

/// The via joint at the beginning of the segment; null if there is none.
inline const ViaJoint* via_joint_at(const Chain& chain, int segment) noexcept {
  for (int i = 0; i < chain.via_joint_count; ++i) {
    if (chain.via_joints[i].segment == segment) return &chain.via_joints[i];
  }
  return nullptr;
}

/// Finds the first segment of each via joint's polyhedron. False if a polyhedron has no segment.
inline bool place_via_joints(Chain& chain) noexcept {
  int segment = 0;
  for (int i = 0; i < chain.via_joint_count; ++i) {
    ViaJoint& via_joint = chain.via_joints[i];
    while (segment < chain.count && chain.polyhedron[segment] < via_joint.polyhedron) ++segment;
    if (segment == chain.count || chain.polyhedron[segment] != via_joint.polyhedron) return false;
    via_joint.segment = segment;
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
  for (int i = 0; i < chain.via_joint_count; ++i) {
    if (chain.via_joints[i].has_velocity) return true;
  }
  return false;
}

}  // namespace tern

#endif
