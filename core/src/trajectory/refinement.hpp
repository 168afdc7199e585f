// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which durations to try next: a bounded search for the plan of least  snap + rate * duration.  One solve a round.
//
//   feasibility   durations grow from round to round until the programme has a solution: the first feasible plan.
//   descent       every segment's duration moves to where the price of its time (time_prices.hpp) would equal the rate;
//                 halfway back where that leaves no plan or a worse one, and shorter steps from there on.
//
// A larger weight never gives a longer plan. The search for it first finds the default weight's plan, and then goes up
// a ladder of weights. It passes through the plan of every weight below, and from there takes only plans that cost less
// and last no longer. Since each of them also costs less at every larger weight, more budget never gives a more
// expensive plan.
#ifndef TERN_TRAJECTORY_REFINEMENT_HPP
#define TERN_TRAJECTORY_REFINEMENT_HPP

#include <cstdint>

#include "times/chain.hpp"

namespace tern {

enum class RefinementPhase : std::uint8_t { kFeasibility, kDescent, kDone };

/// A plan as the search weighs it: the figures of a programme's solution, and by how much it is stretched in time.
struct Offer {
  double snap;      ///< m^2/s^7, before the stretch
  double duration;  ///< seconds, before the stretch
  double least;     ///< the stretch with which the limits are met exactly
  double stretch;   ///< the one chosen, >= least; 1 where start or goal move
  double cost;      ///< snap + rate * duration with it, m^2/s^7
};

struct Refinement {
  RefinementPhase phase;
  bool elastic;                 ///< plans may be stretched: from rest to rest
  int round;                    ///< of this phase, or of this rung of the descent
  int failures;                 ///< of the rung's steps, each of which halves the steps to come
  int rung;                     ///< of the ladder of weights; 0 is the default weight, or the one asked for if less
  int last_rung;                ///< the highest one not above the weight asked for
  double unit;                  ///< m^2/s^8: what a second costs at weight 1
  double weight;                ///< that was asked for
  double rate;                  ///< m^2/s^8: what a second costs on this rung
  Offer best;                   ///< the best plan so far
  double base[kMaxSegments];    ///< durations of that plan, stretched; of the feasibility phase, the last ones tried
  double prices[kMaxSegments];  ///< of each segment's time in that plan, m^2/s^7
};

/// What became of the round's programme.
struct Round {
  bool better;                  ///< a plan came of it that keeps everything and improves on the best one
  Offer offer;                  ///< that plan
  double prices[kMaxSegments];  ///< of each segment's time, before the stretch
};

constexpr int kFeasibilityRounds = 6;
constexpr double kLengthening = 1.35;
/// One round changes a duration by these factors at most: a programme that shrank too far is costly to prove
/// infeasible.
constexpr double kShortest = 0.85;
constexpr double kLongest = 1.6;

/// How long the descent stays on a rung.
struct Effort {
  int rounds;
  int failures;
  double least_gain;  ///< it leaves after a round that gains less than this part of the cost
};
constexpr Effort kFirstRung{12, 4, 0.01};
constexpr Effort kNextRungs{10, 3, 0.003};

/// Weights of the rungs above the first.
constexpr double kRungs[] = {100.0, 200.0, 500.0, 1e3, 1e4};
constexpr int kRungCount = sizeof(kRungs) / sizeof(kRungs[0]);

/// Durations of the first round are the chain's own. `unit`: m^2/s^8, > 0. `elastic`: start and goal are at rest.
void refinement_begin(Refinement& refinement, const Chain& chain, double unit, double weight, bool elastic) noexcept;

/// Chooses the offer's stretch and sets its cost. True where it improves on the best plan: costs less and, on a rung
/// above the first, lasts no longer. With least 0: whether any plan of that snap or more could.
bool improves(const Refinement& refinement, Offer& offer) noexcept;

/// Learns from a round and enters the next: fills the chain's durations, or answers kDone.
void refinement_next(Refinement& refinement, const Round& round, Chain& chain) noexcept;

}  // namespace tern

#endif
