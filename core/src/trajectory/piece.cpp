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

/// Fixes the derivatives that a hold gives at an end, so that they are no longer unknowns.
void hold_end(const Hold& hold, const Vec3& center, double duration, int at, Piece& piece) {
  double power = 1.0;
  for (int k = 0; k < kJointOrder; ++k) {
    if (gives(hold, k)) {
      piece.given[at + k] = true;
      piece.factor[at + k] = 0.0;
      piece.fixed[at + k] = power * held_value(hold, center, k);
    }
    power *= duration;
  }
}

void hold_ends(const Chain& chain, Piece& piece) {
  piece.held = false;
  if (chain.hold_count == 0) return;
  const Hold* const holds[2] = {hold_at(chain, piece.index), hold_at(chain, piece.index + 1)};
  piece.held = holds[0] != nullptr || holds[1] != nullptr;
  if (!piece.held) return;
  for (int e = 0; e < kEnds; ++e) {
    piece.given[e] = false;
    if (piece.free[e / kJointOrder]) piece.fixed[e] = kZero;
  }
  for (int end = 0; end < 2; ++end) {
    if (holds[end] == nullptr) continue;
    hold_end(*holds[end], chain.center, chain.duration[piece.index], end * kJointOrder, piece);
  }
}

}  // namespace

Vec3 held_value(const Hold& hold, const Vec3& center, int k) noexcept {
  if (k == 0) return hold.position - center;
  return k == 1 && hold.has_velocity ? hold.velocity : kZero;
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
  hold_ends(chain, piece);
  return piece;
}

}  // namespace tern
