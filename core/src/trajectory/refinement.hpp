// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which durations to try next: a bounded search for the plan of least  snap + rate * duration.  One solve a round.
//
//   feasibility   durations grow from round to round until the programme has a solution: the first feasible plan.
//   descent       a quasi-Newton method on the logarithms of the durations. The gradient comes with every solution
//                 (time_prices.hpp), the second derivatives are learned from its changes (curvature.hpp). Halfway back
//                 where a step leaves no plan or a worse one.
//
// A larger weight never gives a longer plan. The search for it first finds the default weight's plan, and then goes up
// a ladder of weights. It passes through the plan of every weight below, and from there takes only plans that cost less
// and last no longer. Since each of them also costs less at every larger weight, more budget never gives a more
// expensive plan.
//
// Where the acceleration limit is far above what the way asks for, the unit of the weight is so large that snap hardly
// counts, and a search at the default weight stops at the first wall. There the ladder begins further down.
//
// Where the first durations come from an earlier plan (times/pace.hpp), they are near the best ones for the weight
// already. There the ladder has only its last rung, and a larger weight may give a longer plan.
#ifndef TERN_TRAJECTORY_REFINEMENT_HPP
#define TERN_TRAJECTORY_REFINEMENT_HPP

#include <cstdint>

#include "times/chain.hpp"
#include "trajectory/curvature.hpp"
#include "trajectory/cutting_planes.hpp"

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

/// What is searched for.
struct Question {
  double unit;     ///< m^2/s^8, > 0: what a second costs at weight 1
  double weight;   ///< > 0
  double agility;  ///< times/time_unit.hpp
  bool elastic;    ///< plans may be stretched: start and goal are at rest
  bool paced;      ///< the first durations are those of an earlier plan for that weight
};

struct Refinement {
  RefinementPhase phase;
  bool elastic;                 ///< plans may be stretched: from rest to rest
  int round;                    ///< of this phase, or of this rung of the descent
  int failures;                 ///< of the rung's steps
  int spent;                    ///< iterations since the last better plan
  int first_rung;               ///< of the ladder of weights: 0, less where it begins further down, or the last one
  int rung;                     ///< 0 is the default weight, or the one asked for if less
  int last_rung;                ///< the highest one not above the weight asked for
  double unit;                  ///< m^2/s^8: what a second costs at weight 1
  double weight;                ///< that was asked for
  double rate;                  ///< m^2/s^8: what a second costs on this rung
  double radius;                ///< of a step, as a part of the longest ones; <= 1
  double reach;                 ///< of the last step, the same
  Offer best;                   ///< the best plan so far
  double base[kMaxSegments];    ///< durations of that plan, stretched; of the feasibility phase, the last ones tried
  double prices[kMaxSegments];  ///< of each segment's time in that plan, m^2/s^7
  Curvature curvature;          ///< of its snap
  CuttingPlanes planes;         ///< of programmes that were abandoned
};

/// What became of the round's programme.
struct Round {
  bool better;                  ///< a plan came of it that keeps everything and improves on the best one
  bool bounded;                 ///< or it was abandoned, and its bound is known
  int iterations;               ///< that it took
  Offer offer;                  ///< that plan; of a bound, the snap alone
  double prices[kMaxSegments];  ///< of each segment's time in that plan or bound, before the stretch
};

constexpr int kFeasibilityRounds = 6;
constexpr double kLengthening = 1.35;
/// Longest steps of one round, in the logarithm of a duration. A programme that shrank too far is costly to prove
/// infeasible.
constexpr double kShortestStep = 0.12;
constexpr double kLongestStep = 0.47;
/// Steps of a next rung may begin as short as those of the last rung ended, but not shorter than this part of the
/// longest.
constexpr double kLeastRadius = 0.125;
/// A price counts as this part of the cost of its time, at least, where nothing else is known of the curvature.
constexpr double kLeastPrice = 0.1;

/// How long the descent stays on a rung.
constexpr int kRungRounds = 24;
constexpr int kRungFailures = 4;
/// A step that bends away from cutting planes is this part of the last one, at most.
constexpr double kBentPart = 0.7;
/// Parts of the cost: what each iteration should gain, and what each round should.
constexpr double kGainPerIteration = 5e-5;
constexpr double kLeastGain = 1e-5;

/// The ladder begins a rung further down, at a tenth of the weight, where the agility is above kAgile, and one more for
/// each further factor: the sixth root of ten, since the unit grows with the sixth power of the acceleration.
constexpr double kAgile = 6.0;
constexpr double kAgilityPerRung = 1.468;
constexpr int kRungsBelow = 2;

/// Weights of the rungs above the first.
constexpr double kRungs[] = {100.0, 200.0, 500.0, 1e3, 1e4};
constexpr int kRungCount = sizeof(kRungs) / sizeof(kRungs[0]);

/// Durations of the first round are the chain's own.
void refinement_begin(Refinement& refinement, const Chain& chain, const Question& question) noexcept;

/// Chooses the offer's stretch and sets its cost. True where it improves on the best plan: costs less and lasts no
/// longer. On rung 0, where the ladder begins there, it may last longer. With least 0: whether any plan of that snap or
/// more could.
bool improves(const Refinement& refinement, Offer& offer) noexcept;

/// Learns from a round and enters the next: fills the chain's durations, or answers kDone.
void refinement_next(Refinement& refinement, const Round& round, Chain& chain) noexcept;

}  // namespace tern

#endif
