// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The pace of an earlier plan. If the plan leads nearly the same way as a chain, its times at the chain's joints give
// good first durations. The optimiser then starts close to its solution (docs/times.md).
#ifndef TERN_TIMES_PACE_HPP
#define TERN_TIMES_PACE_HPP

#include "tern/trajectory.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// The rest of a plan, from some instant on. The plan must outlive it.
struct Pace {
  const Trajectory* plan = nullptr;  ///< null: no pace; else a plan of at least one segment
  double from = 0.0;                 ///< seconds since the plan's beginning, >= 0
  Vec3 offset{0.0, 0.0, 0.0};        ///< from the plan's frame to the chain's, metres
  bool is_rival = false;             ///< it is flown on unless a new plan is better
};

/// What is left of a plan that a new one has to beat.
struct Rival {
  double duration = 0.0;  ///< s; 0: there is none
  double snap = 0.0;      ///< the integral of its squared snap, m^2/s^7
};

/// Each segment of the plan counts as this many straight pieces, each flown at constant speed.
constexpr int kPacePieces = 8;
/// The search for the nearest piece ends after this many pieces in a row that come no nearer.
constexpr int kPaceLookahead = 24;

/// The progress of the search along the plan.
struct PaceWalk {
  int piece;          ///< index of the piece, of all pieces of the plan
  Vec3 begin;         ///< beginning of the piece, in the chain's frame
  double begin_time;  ///< when the piece begins, seconds since the plan's beginning
  double time;        ///< when the plan passes the last place that was looked for, seconds since its beginning; never
                      ///< decreases
};

/// Begins at pace.from. The pace must have a plan.
void pace_begin(const Pace& pace, PaceWalk& walk) noexcept;

/// Advances to the point at which the plan passes nearest to a place (chain's frame), within kPaceLookahead. Returns
/// their distance in metres, or 1e300 if the plan is over. walk.time becomes the plan's time at that point. `pieces`
/// grows by the number of pieces examined.
double pace_to(const Pace& pace, const Vec3& place, PaceWalk& walk, int& pieces) noexcept;

/// What is left of the plan from pace.from on. The pace must have a plan.
Rival rest_of(const Pace& pace) noexcept;

}  // namespace tern

#endif
