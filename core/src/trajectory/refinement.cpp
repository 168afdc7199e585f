// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/refinement.hpp"

#include "base/math.hpp"
#include "curve/hermite.hpp"
#include "tern/request.hpp"

namespace tern {
namespace {

/// Stands for the cost of no plan: above every cost.
constexpr double kNoPlan = 1e300;
/// A step longer than this part of the radius counts as being as long as the radius.
constexpr double kAlmost = 0.99;
/// A stretch that should reach a given duration stays below it by this factor, so that rounding does not exceed it.
constexpr double kJustBelow = 1.0 - 1e-12;

int rung_of(double weight) {
  int rung = 0;
  for (int i = 0; i < kRungCount && weight >= kRungs[i]; ++i) rung = i + 1;
  return rung;
}

double weight_of(const Refinement& refinement, int rung) {
  if (rung > 0) return kRungs[rung - 1];
  double weight = smaller(refinement.weight, kDefaultTimeWeight);
  for (int i = rung; i < 0; ++i) weight *= 0.1;
  return weight;
}

/// How many rungs the ladder begins below rung 0 for this agility. Each has a tenth of the weight of the next.
int rungs_below(double agility) {
  int rungs = 0;
  for (double rest = agility; rungs < kRungsBelow && rest > kAgile; rest /= kAgilityPerRung) ++rungs;
  return rungs;
}

/// True on rungs that accept no plan that lasts longer than the best one.
bool bounded(const Refinement& refinement) {
  return refinement.first_rung < 0 || refinement.rung > 0;
}

void enter(Refinement& refinement, RefinementPhase phase) {
  refinement.phase = phase;
  refinement.round = 0;
  refinement.failures = 0;
  refinement.spent = 0;
  refinement.radius = 1.0;
}

/// Begins the descent on the next rung. It keeps the radius, because the limits that stopped long steps on one rung
/// stop them on the next one too. The radius of the first rung is not kept.
void enter_rung(Refinement& refinement) {
  const double carried = refinement.rung == refinement.first_rung ? 1.0 : larger(refinement.radius, kLeastRadius);
  ++refinement.rung;
  enter(refinement, RefinementPhase::kDescent);
  refinement.radius = carried;
}

double eighth_root(double x) {
  return square_root(square_root(square_root(x)));
}

/// Cost of the offer at its stretch: snap falls with the seventh power of the stretch.
double cost_of(const Offer& offer, double rate) {
  return offer.snap / seventh_power(offer.stretch) + rate * offer.stretch * offer.duration;
}

/// The stretch s of least cost, for which 7 snap s^-8 = rate duration.
double cheapest_stretch(const Offer& offer, double rate) {
  return eighth_root(7.0 * offer.snap / (rate * offer.duration));
}

/// e^x for a step of the search, to 1e-4.
double exponential(double x) {
  return (1.0 + x * (0.5 + x / 12.0)) / (1.0 - x * (0.5 - x / 12.0));
}

/// The natural logarithm, for the ratios of a step.
double logarithm(double x) {
  const double z = (x - 1.0) / (x + 1.0);
  const double square = z * z;
  return 2.0 * z * (1.0 + square * (1.0 / 3.0 + square * (1.0 / 5.0 + square / 7.0)));
}

/// The curvature before anything is learned: without limits, snap falls with the seventh power of a duration, and so
/// does its price.
void guess_curvature(Refinement& refinement, int count) {
  double diagonal[kMaxSegments];
  for (int i = 0; i < count; ++i) {
    const double least = kLeastPrice * refinement.rate * refinement.base[i];
    diagonal[i] = 7.0 * larger(refinement.prices[i], least);
  }
  curvature_begin(refinement.curvature, diagonal, count);
}

/// Keeps a better plan. Its prices fall with the seventh power of the stretch, as snap does. The search learns the
/// curvature from how the prices changed since the last plan.
void keep(Refinement& refinement, const Round& round, const Chain& chain) {
  const bool first = !(refinement.best.cost < kNoPlan);
  const bool is_far = refinement.forgets && round.offer.snap < kFallen * refinement.best.snap;
  const double stretch = round.offer.stretch;
  double step[kMaxSegments];
  double change[kMaxSegments];
  for (int i = 0; i < chain.count; ++i) {
    const double duration = stretch * chain.duration[i];
    const double price = round.prices[i] / seventh_power(stretch);
    step[i] = logarithm(duration / refinement.base[i]);
    change[i] = refinement.prices[i] - price;
    refinement.base[i] = duration;
    refinement.prices[i] = price;
  }
  refinement.best = round.offer;
  refinement.spent = 0;
  move_base(refinement.planes, step, chain.count);
  if (first || is_far) return guess_curvature(refinement, chain.count);
  curvature_learn(refinement.curvature, step, change, chain.count);
}

/// The length of the step relative to the longest steps allowed.
double excess(const Refinement& refinement, const double* step, int count) {
  double most = 0.0;
  for (int i = 0; i < count; ++i) {
    most = larger(most, larger(step[i] / refinement.longest_step, -step[i] / kShortestStep));
  }
  return most;
}

/// Takes Newton's step from the best plan, or as much of it as the radius allows. At the end of the whole step, each
/// segment's price would equal the cost of its time. Returns the gain that the whole step promises.
double retime(Refinement& refinement, Chain& chain) {
  double extra[kMaxSegments];
  double descent[kMaxSegments];
  double step[kMaxSegments];
  for (int i = 0; i < chain.count; ++i) {
    extra[i] = refinement.rate * refinement.base[i];
    descent[i] = refinement.prices[i] - extra[i];
  }
  newton_step(refinement.curvature, extra, descent, chain.count, step);
  const double snap = refinement.best.snap / seventh_power(refinement.best.stretch);
  if (refinement.planes.found > 0) bend_step(refinement.planes, refinement.curvature, snap, chain.count, step);
  const double beyond = excess(refinement, step, chain.count);
  const double scale = beyond > refinement.radius ? refinement.radius / beyond : 1.0;
  refinement.reach = scale * beyond;
  double promise = 0.0;
  for (int i = 0; i < chain.count; ++i) {
    promise += 0.5 * step[i] * descent[i];
    chain.duration[i] = larger(kMinDuration, exponential(scale * step[i]) * refinement.base[i]);
  }
  return promise;
}

/// Weighs the best plan at a higher rate. If plans may be stretched, shortens it as far as that makes it cheaper and
/// the limits allow.
void raise_rate(Refinement& refinement, const Chain& chain, double rate) {
  Offer& best = refinement.best;
  const double last = best.stretch;
  refinement.rate = rate;
  if (refinement.elastic) best.stretch = smaller(last, larger(best.least, cheapest_stretch(best, rate)));
  best.cost = cost_of(best, rate);
  const double factor = best.stretch / last;
  double step[kMaxSegments];
  for (int i = 0; i < chain.count; ++i) {
    refinement.base[i] = factor * refinement.base[i];
    refinement.prices[i] = refinement.prices[i] / seventh_power(factor);
    step[i] = logarithm(factor);
  }
  move_base(refinement.planes, step, chain.count);
  curvature_scale(refinement.curvature, 1.0 / seventh_power(factor), chain.count);
}

/// Goes on to the next rung. Above the last rung, only the stretch depends on the weight, which cannot make a plan
/// longer.
void next_rung(Refinement& refinement, Chain& chain) {
  if (refinement.rung == refinement.last_rung) {
    raise_rate(refinement, chain, refinement.unit * refinement.weight);
    return enter(refinement, RefinementPhase::kDone);
  }
  raise_rate(refinement, chain, refinement.unit * weight_of(refinement, refinement.rung + 1));
  enter_rung(refinement);
  retime(refinement, chain);
}

/// A round of the feasibility phase. fit_ends() may have shortened the chain's durations, so each round starts from the
/// last round's durations before they were shortened.
void lengthen(Refinement& refinement, const Round& round, Chain& chain) {
  if (round.better) {
    keep(refinement, round, chain);
    enter(refinement, RefinementPhase::kDescent);
    refinement.radius = refinement.first_radius;
    retime(refinement, chain);
    return;
  }
  if (refinement.round >= refinement.feasibility_rounds) return enter(refinement, RefinementPhase::kDone);
  for (int i = 0; i < chain.count; ++i) {
    refinement.base[i] = refinement.lengthening * refinement.base[i];
    chain.duration[i] = refinement.base[i];
  }
}

void add_plane(Refinement& refinement, const Round& round, const Chain& chain) {
  double step[kMaxSegments];
  for (int i = 0; i < chain.count; ++i) step[i] = logarithm(chain.duration[i] / refinement.base[i]);
  add_plane(refinement.planes, round.offer.snap, round.prices, step, chain.count);
}

/// Goes halfway back to the best plan, and takes no longer steps until one succeeds. If an abandoned programme tells
/// which durations are too short, takes a shorter step in another direction instead.
void retreat(Refinement& refinement, const Round& round, Chain& chain) {
  ++refinement.failures;
  if (round.bounded) add_plane(refinement, round, chain);
  if (refinement.failures > kRungFailures) return next_rung(refinement, chain);
  if (round.bounded) {
    refinement.radius = kBentPart * refinement.reach;
    retime(refinement, chain);
    return;
  }
  refinement.reach *= 0.5;
  refinement.radius = refinement.reach;
  for (int i = 0; i < chain.count; ++i) chain.duration[i] = square_root(chain.duration[i] * refinement.base[i]);
}

/// The gain that this many iterations should bring.
double worth(const Refinement& refinement, int iterations) {
  return larger(kLeastGain, kGainPerIteration * iterations) * refinement.best.cost;
}

/// Goes on from a better plan. Stays on the rung if the plan's gain was worth its iterations, and the next plan's gain
/// promises to be.
void advance(Refinement& refinement, const Round& round, Chain& chain) {
  const double enough = refinement.best.cost - worth(refinement, refinement.spent);
  keep(refinement, round, chain);
  if (refinement.reach > kAlmost * refinement.radius) refinement.radius = smaller(1.0, 2.0 * refinement.radius);
  if (refinement.round == kRungRounds || round.offer.cost > enough) return next_rung(refinement, chain);
  if (retime(refinement, chain) < worth(refinement, round.iterations)) next_rung(refinement, chain);
}

void descend(Refinement& refinement, const Round& round, Chain& chain) {
  refinement.spent += round.iterations;
  if (round.better) return advance(refinement, round, chain);
  if (refinement.round == kRungRounds) return next_rung(refinement, chain);
  retreat(refinement, round, chain);
}

}  // namespace

void refinement_begin(Refinement& refinement, const Chain& chain, const Question& question) noexcept {
  enter(refinement, RefinementPhase::kFeasibility);
  refinement.elastic = question.elastic;
  refinement.lengthening = question.lengthening;
  refinement.feasibility_rounds = question.feasibility_rounds;
  refinement.last_rung = rung_of(question.weight);
  refinement.first_rung = question.paced ? refinement.last_rung : -rungs_below(question.agility);
  refinement.rung = refinement.first_rung;
  refinement.unit = question.unit;
  refinement.weight = question.weight;
  refinement.rate = question.unit * weight_of(refinement, refinement.rung);
  refinement.best = Offer{0.0, kNoPlan, 1.0, 1.0, kNoPlan};
  refinement.planes.found = 0;
  refinement.forgets = question.forgets;
  refinement.longest_step = question.longest_step;
  refinement.first_radius = question.radius;
  for (int i = 0; i < chain.count; ++i) refinement.base[i] = chain.duration[i];
}

bool improves(const Refinement& refinement, Offer& offer) noexcept {
  const Offer& best = refinement.best;
  const double longest = bounded(refinement) ? best.stretch * best.duration : kNoPlan;
  offer.stretch = 1.0;
  if (refinement.elastic) {
    const double wish = cheapest_stretch(offer, refinement.rate);
    offer.stretch = larger(offer.least, smaller(wish, kJustBelow * longest / offer.duration));
  }
  offer.cost = cost_of(offer, refinement.rate);
  return offer.cost < best.cost && offer.stretch * offer.duration <= longest;
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
