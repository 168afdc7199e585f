// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// From a solution of a programme back to the chain: the states at its joints, and the control points.
#include "base/math.hpp"
#include "curve/hermite.hpp"
#include "trajectory/piece.hpp"
#include "trajectory/programme.hpp"

namespace tern {
namespace {

/// The state of interior joint `joint` (0 .. count - 2) in the solution; local frame, metres and seconds.
JointState read_joint(const Chain& chain, const ProgrammeScale& scale, const QpSolution& solution, int joint) {
  JointState state;
  double power = 1.0;
  for (int k = 0; k < kJointOrder; ++k) {
    for (int a = 0; a < kQpAxes; ++a) {
      axis(state.d[k], a) = scale.joint[joint][k] * solution.x[a][kJointOrder * joint + k] / power;
    }
    power *= scale.tau;
  }
  state.d[0] = state.d[0] + chain.center;
  const ViaJoint* const via_joint = via_joint_at(chain, joint + 1);
  if (via_joint == nullptr) return state;
  for (int k = 0; k < kJointOrder; ++k) {
    if (gives(*via_joint, k)) state.d[k] = k == 0 ? via_joint->position : given_value(*via_joint, chain.center, k);
  }
  return state;
}

}  // namespace

void read_points(const Chain& chain, const ProgrammeScale& scale, const QpSolution& solution,
                 Vec3 (*points)[kControlPoints]) noexcept {
  JointState first = chain.start;
  for (int i = 0; i < chain.count; ++i) {
    const JointState second = i + 1 < chain.count ? read_joint(chain, scale, solution, i) : chain.goal;
    control_points(first, second, chain.duration[i], points[i]);
    first = second;
  }
}

}  // namespace tern
