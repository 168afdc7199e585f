// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The pace of an earlier plan. If it leads nearly the same way as a chain, the times at which it passes the chain's
// joints are good first durations: the optimiser then starts close to its solution (docs/times.md).
#ifndef TERN_TIMES_PACE_HPP
#define TERN_TIMES_PACE_HPP

#include "tern/trajectory.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// What is left of a plan from some instant on. A view: the plan must outlive it.
struct Pace {
  const Trajectory* plan = nullptr;  ///< null: none; else at least one segment
  double from = 0.0;                 ///< seconds since the plan's beginning, >= 0
  Vec3 offset{0.0, 0.0, 0.0};        ///< from the plan's frame to the chain's, metres
};

/// Each segment of the plan counts as this many straight pieces, each flown at constant speed.
constexpr int kPacePieces = 8;
/// The search for the nearest piece ends when this many in a row came no nearer.
constexpr int kPaceLookahead = 24;

/// How far along the plan the search has come.
struct PaceWalk {
  int piece;          ///< of the whole plan
  Vec3 begin;         ///< where that piece begins, chain's frame
  double begin_time;  ///< when it begins, seconds since the plan's beginning
  double time;        ///< when the plan passes the place that was looked for last, likewise; never decreases
};

/// Begins at pace.from. The pace must have a plan.
void pace_begin(const Pace& pace, PaceWalk& walk) noexcept;

/// Advances to where the plan passes nearest to a place (chain's frame), as far as the lookahead sees. Answers that
/// distance in metres, or 1e300 if the plan is over; walk.time is when. `pieces` grows by the number of pieces seen.
double pace_to(const Pace& pace, const Vec3& place, PaceWalk& walk, int& pieces) noexcept;

}  // namespace tern

#endif
