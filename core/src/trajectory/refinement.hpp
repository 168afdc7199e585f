// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which durations to try next: a bounded search for a plan that is as fast as its limits allow. One solve a round.
//
//   shape     between states at rest: corridor rows only, always feasible. Stretching the whole plan by its exact peaks
//             makes it meet the limits without changing its path; every segment then gets the time that its own peaks
//             asked for, so that the next round is fast everywhere.
//   climb     from or to a moving state a stretch would change that state: limit rows, and durations that grow from
//             round to round until the programme has a solution.
//   descend   limit rows, and durations that shrink from the best plan's until the programme has none: speed then
//             stays at its limit for as long as it can.
#ifndef TERN_TRAJECTORY_REFINEMENT_HPP
#define TERN_TRAJECTORY_REFINEMENT_HPP

#include <cstdint>

#include "trajectory/chain.hpp"
#include "trajectory/programme.hpp"

namespace tern {

enum class Course : std::uint8_t { kShape, kClimb, kDescend, kDone };

struct Refinement {
  Course course;
  int round;                  ///< of this course
  int failures;               ///< of the descent
  double gap;                 ///< part of the duration that the descent tries to save
  double base[kMaxSegments];  ///< durations that the climb started from
};

/// What became of the round's programme.
struct Round {
  bool accepted;                 ///< a plan came of it that keeps everything
  double duration;               ///< that plan's, seconds
  double stretch[kMaxSegments];  ///< of each of its segments, to meet the limits exactly (shape only)
};

constexpr int kShapeRounds = 3;
constexpr int kClimbRounds = 12;
constexpr double kClimbStep = 1.35;
constexpr double kFirstGap = 0.15;
constexpr int kDescentFailures = 3;
/// The descent ends where a round saves less than this part.
constexpr double kLeastGain = 0.01;

static_assert(kMaxQpSolves > kShapeRounds, "the first solution and its refinement need a few solves");

/// Durations of the first round are the chain's own.
void refinement_begin(Refinement& refinement, const Chain& chain, bool at_rest) noexcept;

/// The rows of the round.
Rows refinement_rows(const Refinement& refinement) noexcept;

/// Learns from a round and enters the next: fills the chain's durations, or answers kDone. `best_duration`: seconds of
/// the best plan before this round, `best`: its segments' durations, which are read where there is one (or the round
/// was accepted).
void refinement_next(Refinement& refinement, const Round& round, double previous, const double* best,
                     Chain& chain) noexcept;

}  // namespace tern

#endif
