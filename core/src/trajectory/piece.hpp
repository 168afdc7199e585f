// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_TRAJECTORY_PIECE_HPP
#define TERN_TRAJECTORY_PIECE_HPP

#include "tern/vec3.hpp"
#include "times/chain.hpp"
#include "trajectory/programme.hpp"

namespace tern {

/// Brings the scaled Hessian's unknowns to metres or so; of no influence on the minimum.
constexpr double kCostScale = 1e-5;
/// Derivatives of both ends.
constexpr int kEnds = 2 * kJointOrder;

/// One segment as the programme sees it.
struct Piece {
  int index;
  double t;              ///< duration over the mean
  double cost;           ///< kCostScale / t^7
  bool free[2];          ///< whether its first and second end are unknown
  double factor[kEnds];  ///< normalised derivative = factor * unknown, of free ends only
  bool held;             ///< some derivatives of free ends are given
  bool given[kEnds];     ///< which, where some are; their factors are 0
  Vec3 fixed[kEnds];     ///< normalised derivative where it is given; of free ends only where some are, else 0
};

/// The chain's segment `index`.
Piece piece_of(const Chain& chain, const ProgrammeScale& scale, int index) noexcept;

/// The unknown that derivative e (of both ends, 0 .. 7) of a piece is, per axis.
inline int unknown_of(const Piece& piece, int e) noexcept {
  return kJointOrder * (piece.index - 1) + e;
}

/// Derivative k that a hold gives, in metres and seconds; the position is relative to the centre.
Vec3 held_value(const Hold& hold, const Vec3& center, int k) noexcept;

}  // namespace tern

#endif
