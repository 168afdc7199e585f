// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/piece.hpp"

#include "base/math.hpp"

namespace tern {
namespace {

void fix_end(const JointState& state, const Vec3& center, double duration, Vec3* fixed) {
  fixed[0] = state.d[0] - center;
  double power = duration;
  for (int k = 1; k < kJointOrder; ++k) {
    fixed[k] = power * state.d[k];
    power *= duration;
  }
}

void free_end(const double* joint, double t, double* factor) {
  double power = 1.0;
  for (int k = 0; k < kJointOrder; ++k) {
    factor[k] = power * joint[k];
    power *= t;
  }
}

/// Fixes the derivatives that are given at an end, so that they are no longer unknowns.
void fix_end(const ViaJoint& via_joint, const Vec3& center, double duration, int at, Piece& piece) {
  double power = 1.0;
  for (int k = 0; k < kJointOrder; ++k) {
    if (gives(via_joint, k)) {
      piece.given[at + k] = true;
      piece.factor[at + k] = 0.0;
      piece.fixed[at + k] = power * given_value(via_joint, center, k);
    }
    power *= duration;
  }
}

void fix_ends(const Chain& chain, Piece& piece) {
  piece.held = false;
  if (chain.via_joint_count == 0) return;
  const ViaJoint* const via_joints[2] = {via_joint_at(chain, piece.index), via_joint_at(chain, piece.index + 1)};
  piece.held = via_joints[0] != nullptr || via_joints[1] != nullptr;
  if (!piece.held) return;
  for (int e = 0; e < kEnds; ++e) {
    piece.given[e] = false;
    if (piece.free[e / kJointOrder]) piece.fixed[e] = kZero;
  }
  for (int end = 0; end < 2; ++end) {
    if (via_joints[end] == nullptr) continue;
    fix_end(*via_joints[end], chain.center, chain.duration[piece.index], end * kJointOrder, piece);
  }
}

}  // namespace

Vec3 given_value(const ViaJoint& via_joint, const Vec3& center, int k) noexcept {
  if (k == 0) return via_joint.position - center;
  return k == 1 && via_joint.has_velocity ? via_joint.velocity : kZero;
}

Piece piece_of(const Chain& chain, const ProgrammeScale& scale, int index) noexcept {
  Piece piece;
  piece.index = index;
  piece.t = chain.duration[index] / scale.tau;
  piece.cost = kCostScale / seventh_power(piece.t);
  piece.free[0] = index > 0;
  piece.free[1] = index + 1 < chain.count;
  for (int end = 0; end < 2; ++end) {
    const int at = end * kJointOrder;
    if (piece.free[end]) {
      free_end(scale.joint[index - 1 + end], piece.t, piece.factor + at);
    } else {
      fix_end(end == 0 ? chain.start : chain.goal, chain.center, chain.duration[index], piece.fixed + at);
    }
  }
  fix_ends(chain, piece);
  return piece;
}

}  // namespace tern
