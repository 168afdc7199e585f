// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_TRAJECTORY_PIECE_HPP
#define TERN_TRAJECTORY_PIECE_HPP

#include "tern/vec3.hpp"
#include "times/chain.hpp"
#include "trajectory/programme.hpp"

namespace tern {

/// Brings the unknowns of the scaled Hessian to the size of metres; it does not change the minimum.
constexpr double kCostScale = 1e-5;
/// Number of derivatives of both ends together.
constexpr int kEnds = 2 * kJointOrder;

/// One segment in the form that the programme needs.
struct Piece {
  int index;
  double t;              ///< duration divided by the mean duration
  double cost;           ///< kCostScale / t^7
  bool free[2];          ///< whether its first and second end are unknown
  double factor[kEnds];  ///< normalised derivative = factor * unknown, of free ends only
  bool held;             ///< some derivatives of free ends are given
  bool given[kEnds];     ///< if `held`: which derivatives are given; the factors of these are 0
  Vec3 fixed[kEnds];     ///< normalised derivatives of fixed ends; if `held`, of free ends too, 0 if not given
};

/// The piece of the chain's segment `index`.
Piece piece_of(const Chain& chain, const ProgrammeScale& scale, int index) noexcept;

/// Index of the unknown, per axis, that stands for derivative e of a piece: 0 .. 3 at its first end, 4 .. 7 at its
/// second.
inline int unknown_of(const Piece& piece, int e) noexcept {
  return kJointOrder * (piece.index - 1) + e;
}

/// Derivative k that is given at the joint, in metres and seconds; the position is relative to the centre.
Vec3 given_value(const ViaJoint& via_joint, const Vec3& center, int k) noexcept;

}  // namespace tern

#endif
