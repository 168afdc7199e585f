// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The proofs, one function for each of the things that docs/verify.md lists. Each adds its claims.
#ifndef TERN_VERIFY_PROOFS_HPP
#define TERN_VERIFY_PROOFS_HPP

#include <string>
#include <vector>

#include "verify/claim.hpp"
#include "verify/plan.hpp"
#include "verify/solids.hpp"
#include "verify/tolerance.hpp"

namespace tern_verify {

/// A plan and what it is held against.
struct Subject {
  Subject(const Problem& problem, const Plan& plan);

  /// The segments' control points in the world frame.
  std::vector<Polygon<3>> curves() const;

  const Problem& problem;
  const Plan& plan;
  Lattice lattice;
  std::vector<Cells> solid;
  Tolerance tolerance;
};

/// "segment 3, t = 2.5 s": `u` in [0, 1] of a segment, and the plan's time there.
std::string place_of(const std::vector<Segment>& segments, std::size_t segment, const Rational& u);

/// Joints: position to jerk have no jump.
void prove_joints(const std::vector<Segment>& segments, Claims& claims);
/// The plan begins and ends in the states asked for. Where it may end elsewhere, it ends at rest where it says itself.
void prove_ends(const Subject& subject, Claims& claims);
/// It passes each via at a joint, in order.
void prove_vias(const Subject& subject, Claims& claims);
/// The curve, for all t, is inside the boundary.
void prove_boundary(const Subject& subject, Claims& claims);
/// The curve, for all t, is inside the keep-ins, and keeps the clearance from the keep-outs.
void prove_fences(const Subject& subject, Claims& claims);
/// The bounds hold for all t.
void prove_bounds(const std::vector<Segment>& segments, const std::vector<Bound>& bounds, Claims& claims);
/// Likewise those on the tilt and on its rate, which compare polynomials of control points.
void prove_turns(const std::vector<Segment>& segments, const std::vector<Bound>& bounds, Claims& claims);
/// The curve, for all t, keeps the clearance from each solid voxel.
void prove_clearance(const Subject& subject, Claims& claims);

/// Fences for a while, which a curve must respect at the times at which they hold.
struct FenceTimes {
  const std::vector<Fence>& fences;
  const Box& boundary;
  Rational zero;       ///< claims say times since this, s
  Rational tolerance;  ///< m
};

/// While a fence holds, the curve keeps out of it or in it. The way need not rest at its end.
void prove_windows(const TimedWay& way, const FenceTimes& demand, Claims& claims);

/// The plan in time.
TimedWay way_of(const Subject& subject);

/// The curve, for all t, keeps the clearance from the tubes of things that move.
void prove_tracks(const Subject& subject, Claims& claims);

/// What no proof of the plan covers and its reader must know, one text each: that it ends where it says itself.
std::vector<std::string> assumed_of(const Problem& problem, const Plan& plan);

/// All of them.
Claims prove(const Problem& problem, const Plan& plan);

}  // namespace tern_verify

#endif
