// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/refinement.hpp"

#include "base/math.hpp"
#include "curve/hermite.hpp"

namespace tern {
namespace {

void enter(Refinement& refinement, Course course) {
  refinement.course = course;
  refinement.round = 0;
  refinement.failures = 0;
}

void keep(Refinement& refinement, double cost, const Chain& chain) {
  refinement.cost = cost;
  for (int i = 0; i < chain.count; ++i) refinement.base[i] = chain.duration[i];
}

double eighth_root(double x) {
  return square_root(square_root(square_root(x)));
}

/// Snap alone falls with the seventh power of a duration, and so does its price: it is in balance at T' where
/// price (T / T')^7 = rate T'.
void retime(const Refinement& refinement, const Round& round, Chain& chain) {
  for (int i = 0; i < chain.count; ++i) {
    const double worth = larger(round.prices[i], 0.0) / (refinement.rate * chain.duration[i]);
    double factor = clamp(eighth_root(worth), kShortest, kLongest);
    for (int k = 0; k < refinement.failures; ++k) factor = square_root(factor);
    chain.duration[i] = larger(kMinDuration, factor * chain.duration[i]);
  }
}

void begin_trade(Refinement& refinement, const Round& round, Chain& chain) {
  keep(refinement, round.cost, chain);
  enter(refinement, Course::kTrade);
  retime(refinement, round, chain);
}

/// The ends' fitting may have shortened the chain's durations: each round starts from the last one's before that.
void climb(Refinement& refinement, const Round& round, Chain& chain) {
  if (round.accepted) return begin_trade(refinement, round, chain);
  if (refinement.round == kClimbRounds) return enter(refinement, Course::kDone);
  for (int i = 0; i < chain.count; ++i) {
    refinement.base[i] = kClimbStep * refinement.base[i];
    chain.duration[i] = refinement.base[i];
  }
}

/// Halfway back to the last gain.
void retreat(Refinement& refinement, Chain& chain) {
  ++refinement.failures;
  if (refinement.failures > kTradeFailures) return enter(refinement, Course::kDone);
  for (int i = 0; i < chain.count; ++i) chain.duration[i] = square_root(chain.duration[i] * refinement.base[i]);
}

void trade(Refinement& refinement, const Round& round, Chain& chain) {
  if (refinement.round == kTradeRounds) return enter(refinement, Course::kDone);
  if (!round.accepted || !(round.cost < refinement.cost)) return retreat(refinement, chain);
  if (round.cost > refinement.cost * (1.0 - kLeastGain)) return enter(refinement, Course::kDone);
  keep(refinement, round.cost, chain);
  retime(refinement, round, chain);
}

}  // namespace

void refinement_begin(Refinement& refinement, const Chain& chain, double rate) noexcept {
  enter(refinement, Course::kClimb);
  refinement.rate = rate;
  keep(refinement, 0.0, chain);
}

void refinement_next(Refinement& refinement, const Round& round, Chain& chain) noexcept {
  ++refinement.round;
  switch (refinement.course) {
    case Course::kClimb:
      return climb(refinement, round, chain);
    case Course::kTrade:
      return trade(refinement, round, chain);
    case Course::kDone:
      return;
  }
}

}  // namespace tern
