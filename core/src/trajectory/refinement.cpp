// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/refinement.hpp"

#include "base/math.hpp"
#include "times/times.hpp"

namespace tern {
namespace {

void enter(Refinement& refinement, Course course) {
  refinement.course = course;
  refinement.round = 0;
}

void scale_durations(const double* from, double factor, Chain& chain) {
  for (int i = 0; i < chain.count; ++i) chain.duration[i] = larger(kMinDuration, factor * from[i]);
}

/// Every segment gets the time that its own peaks ask for.
void shape_again(const Round& round, Chain& chain) {
  for (int i = 0; i < chain.count; ++i) {
    chain.duration[i] = larger(kMinDuration, chain.duration[i] * round.stretch[i]);
  }
}

void descend(Refinement& refinement, const double* best, Chain& chain) {
  enter(refinement, Course::kDescend);
  scale_durations(best, 1.0 - refinement.gap, chain);
}

void climb(Refinement& refinement, Chain& chain) {
  if (refinement.round == kClimbRounds) return enter(refinement, Course::kDone);
  scale_durations(refinement.base, kClimbStep, chain);
  for (int i = 0; i < chain.count; ++i) refinement.base[i] = chain.duration[i];
}

void descend_again(Refinement& refinement, const Round& round, double previous, const double* best, Chain& chain) {
  if (round.accepted && round.duration > previous * (1.0 - kLeastGain)) return enter(refinement, Course::kDone);
  if (!round.accepted) {
    ++refinement.failures;
    refinement.gap *= 0.5;
  }
  if (refinement.failures == kDescentFailures) return enter(refinement, Course::kDone);
  descend(refinement, best, chain);
}

}  // namespace

void refinement_begin(Refinement& refinement, const Chain& chain, bool at_rest) noexcept {
  enter(refinement, at_rest ? Course::kShape : Course::kClimb);
  refinement.failures = 0;
  refinement.gap = kFirstGap;
  for (int i = 0; i < chain.count; ++i) refinement.base[i] = chain.duration[i];
}

Rows refinement_rows(const Refinement& refinement) noexcept {
  return refinement.course == Course::kShape ? Rows::kCorridor : Rows::kCorridorAndLimits;
}

void refinement_next(Refinement& refinement, const Round& round, double previous, const double* best,
                     Chain& chain) noexcept {
  ++refinement.round;
  switch (refinement.course) {
    case Course::kShape:
      // Corridor rows alone have a solution; where the solver finds none it will find none with more rows.
      if (!round.accepted) return enter(refinement, Course::kDone);
      return refinement.round < kShapeRounds ? shape_again(round, chain) : descend(refinement, best, chain);
    case Course::kClimb:
      return round.accepted ? descend(refinement, best, chain) : climb(refinement, chain);
    case Course::kDescend:
      return descend_again(refinement, round, previous, best, chain);
    case Course::kDone:
      return;
  }
}

}  // namespace tern
