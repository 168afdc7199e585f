// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/refinement.hpp"

#include "base/math.hpp"
#include "curve/hermite.hpp"
#include "tern/request.hpp"

namespace tern {
namespace {

/// Above any cost: that of no plan.
constexpr double kNoPlan = 1e300;
/// A stretch that is to reach a duration stays this much below it, lest rounding carry it beyond.
constexpr double kJustBelow = 1.0 - 1e-12;

int rung_of(double weight) {
  int rung = 0;
  for (int i = 0; i < kRungCount && weight >= kRungs[i]; ++i) rung = i + 1;
  return rung;
}

const Effort& effort(const Refinement& refinement) {
  return refinement.rung == 0 ? kFirstRung : kNextRungs;
}

void enter(Refinement& refinement, RefinementPhase phase) {
  refinement.phase = phase;
  refinement.round = 0;
  refinement.failures = 0;
}

double eighth_root(double x) {
  return square_root(square_root(square_root(x)));
}

/// Snap falls with the seventh power of the stretch.
double cost_of(const Offer& offer, double rate) {
  return offer.snap / seventh_power(offer.stretch) + rate * offer.stretch * offer.duration;
}

/// The stretch of least cost: where 7 snap s^-8 = rate duration.
double cheapest_stretch(const Offer& offer, double rate) {
  return eighth_root(7.0 * offer.snap / (rate * offer.duration));
}

/// Prices fall with the seventh power of the stretch, as snap does.
void keep(Refinement& refinement, const Round& round, const Chain& chain) {
  const double stretch = round.offer.stretch;
  refinement.best = round.offer;
  for (int i = 0; i < chain.count; ++i) {
    refinement.base[i] = stretch * chain.duration[i];
    refinement.prices[i] = round.prices[i] / seventh_power(stretch);
  }
}

/// Snap alone falls with the seventh power of a duration, and so does its price: it is in balance at T' where
/// price (T / T')^7 = rate T'.
void retime(const Refinement& refinement, Chain& chain) {
  for (int i = 0; i < chain.count; ++i) {
    const double base = refinement.base[i];
    const double worth = larger(refinement.prices[i], 0.0) / (refinement.rate * base);
    double factor = clamp(eighth_root(worth), kShortest, kLongest);
    for (int k = 0; k < refinement.failures; ++k) factor = square_root(factor);
    chain.duration[i] = larger(kMinDuration, factor * base);
  }
}

/// The best plan at a higher rate: as much shorter as that makes cheaper and the limits allow.
void raise_rate(Refinement& refinement, const Chain& chain, double rate) {
  Offer& best = refinement.best;
  const double last = best.stretch;
  refinement.rate = rate;
  if (refinement.elastic) best.stretch = smaller(last, larger(best.least, cheapest_stretch(best, rate)));
  best.cost = cost_of(best, rate);
  const double factor = best.stretch / last;
  for (int i = 0; i < chain.count; ++i) {
    refinement.base[i] = factor * refinement.base[i];
    refinement.prices[i] = refinement.prices[i] / seventh_power(factor);
  }
}

/// Above the last rung only the stretch answers to the weight, which no search can make longer.
void next_rung(Refinement& refinement, Chain& chain) {
  if (refinement.rung == refinement.last_rung) {
    raise_rate(refinement, chain, refinement.unit * refinement.weight);
    return enter(refinement, RefinementPhase::kDone);
  }
  raise_rate(refinement, chain, refinement.unit * kRungs[refinement.rung]);
  ++refinement.rung;
  enter(refinement, RefinementPhase::kDescent);
  retime(refinement, chain);
}

/// The ends' fitting may have shortened the chain's durations: each round starts from the last one's before that.
void lengthen(Refinement& refinement, const Round& round, Chain& chain) {
  if (round.better) {
    keep(refinement, round, chain);
    enter(refinement, RefinementPhase::kDescent);
    return retime(refinement, chain);
  }
  if (refinement.round == kFeasibilityRounds) return enter(refinement, RefinementPhase::kDone);
  for (int i = 0; i < chain.count; ++i) {
    refinement.base[i] = kLengthening * refinement.base[i];
    chain.duration[i] = refinement.base[i];
  }
}

/// Halfway back to the best plan.
void retreat(Refinement& refinement, Chain& chain) {
  ++refinement.failures;
  if (refinement.failures > effort(refinement).failures) return next_rung(refinement, chain);
  for (int i = 0; i < chain.count; ++i) chain.duration[i] = square_root(chain.duration[i] * refinement.base[i]);
}

void descend(Refinement& refinement, const Round& round, Chain& chain) {
  const double enough = refinement.best.cost * (1.0 - effort(refinement).least_gain);
  if (round.better) keep(refinement, round, chain);
  if (refinement.round == effort(refinement).rounds) return next_rung(refinement, chain);
  if (!round.better) return retreat(refinement, chain);
  if (round.offer.cost > enough) return next_rung(refinement, chain);
  retime(refinement, chain);
}

}  // namespace

void refinement_begin(Refinement& refinement, const Chain& chain, double unit, double weight, bool elastic) noexcept {
  enter(refinement, RefinementPhase::kFeasibility);
  refinement.elastic = elastic;
  refinement.rung = 0;
  refinement.last_rung = rung_of(weight);
  refinement.unit = unit;
  refinement.weight = weight;
  refinement.rate = unit * smaller(weight, kDefaultTimeWeight);
  refinement.best = Offer{0.0, 0.0, 1.0, 1.0, kNoPlan};
  for (int i = 0; i < chain.count; ++i) refinement.base[i] = chain.duration[i];
}

bool improves(const Refinement& refinement, Offer& offer) noexcept {
  const Offer& best = refinement.best;
  const double longest = best.stretch * best.duration;
  const bool bounded = refinement.rung > 0;
  offer.stretch = 1.0;
  if (refinement.elastic) {
    const double wish = cheapest_stretch(offer, refinement.rate);
    offer.stretch = larger(offer.least, bounded ? smaller(wish, kJustBelow * longest / offer.duration) : wish);
  }
  offer.cost = cost_of(offer, refinement.rate);
  if (bounded && offer.stretch * offer.duration > longest) return false;
  return offer.cost < best.cost;
}

void refinement_next(Refinement& refinement, const Round& round, Chain& chain) noexcept {
  ++refinement.round;
  switch (refinement.phase) {
    case RefinementPhase::kFeasibility:
      return lengthen(refinement, round, chain);
    case RefinementPhase::kDescent:
      return descend(refinement, round, chain);
    case RefinementPhase::kDone:
      return;
  }
}

}  // namespace tern
