// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Finds the durations to try next, in a bounded search for the plan of least  snap + rate * duration.  Each round
// solves one programme.
//
//   feasibility   durations grow from round to round until the programme has a solution: the first feasible plan.
//   descent       a quasi-Newton method on the logarithms of the durations. The gradient comes with every solution
//                 (programme.hpp), the second derivatives are learned from its changes (curvature.hpp). If a step
//                 leaves no plan or a worse one, the search goes halfway back.
//
// A larger weight never gives a longer plan. For it, the search first finds the default weight's plan, and then goes up
// a ladder of weights. The search passes through the plan of every weight below, and from there takes only plans that
// cost less and last no longer. Since each of them also costs less at every larger weight, more budget never gives a
// more expensive plan.
//
// If the acceleration limit is far above the need of the way, the unit of the weight is so large that snap hardly
// counts. A search at the default weight then stops at the first limit. In this case the ladder begins at smaller
// weights.
//
// If the first durations come from an earlier plan (times/pace.hpp), they are already near the best ones for the
// weight. The ladder then has only its last rung, and a larger weight may give a longer plan.
#ifndef TERN_TRAJECTORY_REFINEMENT_HPP
#define TERN_TRAJECTORY_REFINEMENT_HPP

#include <cstdint>

#include "times/chain.hpp"
#include "trajectory/curvature.hpp"
#include "trajectory/cutting_planes.hpp"

namespace tern {

enum class RefinementPhase : std::uint8_t { kFeasibility, kDescent, kDone };

/// The figures of a plan that the search compares: those of a programme's solution, and its stretch in time.
struct Offer {
  double snap;      ///< m^2/s^7, before the stretch
  double duration;  ///< seconds, before the stretch
  double least;     ///< the least stretch: it meets the limits exactly
  double stretch;   ///< the chosen stretch, >= least; 1 if start or goal move
  double cost;      ///< snap + rate * duration of the stretched plan, m^2/s^7
};

/// Rounds of the feasibility phase that lengthen all durations, and by how much.
constexpr int kFeasibilityRounds = 6;
constexpr double kLengthening = 1.35;

/// The longest steps of one round, down and up, in the logarithm of a duration. It is costly to prove that a programme
/// with much too short durations is infeasible.
constexpr double kShortestStep = 0.12;
constexpr double kLongestStep = 0.47;

/// A plan that no longer squeezes past a thing may have a hundredth of the snap. From such a change, the search would
/// learn a curvature that lets the next step promise too little.
constexpr double kFallen = 0.3;

/// What the search is to find.
struct Question {
  double unit;     ///< m^2/s^8, > 0: what a second costs at weight 1
  double weight;   ///< > 0
  double agility;  ///< times/time_unit.hpp
  bool elastic;    ///< plans may be stretched: start and goal are at rest
  bool paced;      ///< the first durations are those of an earlier plan for that weight
  double lengthening = kLengthening;
  int feasibility_rounds = kFeasibilityRounds;
  double radius = 1.0;  ///< of the first step of the descent
  double longest_step = kLongestStep;
  bool forgets = false;  ///< the curvature, once snap falls below kFallen of what it was
};

struct Refinement {
  RefinementPhase phase;
  double longest_step;          ///< at radius 1, in the logarithm of a duration
  bool forgets;                 ///< as in Question
  double first_radius;          ///< of the descent
  double lengthening;           ///< of a round of the feasibility phase
  int feasibility_rounds;       ///< the most of that phase
  bool elastic;                 ///< plans may be stretched: from rest to rest
  int round;                    ///< rounds of this phase, or of this rung of the descent
  int failures;                 ///< steps of this rung that failed
  int spent;                    ///< iterations since the last better plan
  int first_rung;               ///< where the ladder begins: 0, less for agile flights, or last_rung for a paced flight
  int rung;                     ///< the current rung; rung 0 has the default weight, or the requested one if that is
                                ///< less
  int last_rung;                ///< the highest rung whose weight is not above the requested one
  double unit;                  ///< m^2/s^8: what a second costs at weight 1
  double weight;                ///< the requested weight
  double rate;                  ///< m^2/s^8: what a second costs on this rung
  double radius;                ///< the longest step allowed now, in parts of kShortestStep and kLongestStep; <= 1
  double reach;                 ///< length of the last step, in the parts of `radius`
  Offer best;                   ///< the best plan so far
  double base[kMaxSegments];    ///< durations of the best plan, stretched; in the feasibility phase, those tried last
  double prices[kMaxSegments];  ///< prices of each segment's time in the best plan, m^2/s^7
  Curvature curvature;          ///< of the best plan's snap
  CuttingPlanes planes;         ///< of abandoned programmes
};

/// The outcome of a round's programme.
struct Round {
  bool better;                  ///< it gave a plan that passes all tests and improves on the best one
  bool bounded;                 ///< it was abandoned, and its bound is known
  int iterations;               ///< of the programme
  Offer offer;                  ///< the plan; for a bound, only the snap is set
  double prices[kMaxSegments];  ///< prices of each segment's time in the plan or bound, before the stretch
};

/// The radius at the beginning of a rung is that at the end of the rung before, but at least this.
constexpr double kLeastRadius = 0.125;
/// In the first guess of the curvature, a price counts as at least this part of the cost of its time.
constexpr double kLeastPrice = 0.1;

/// The most rounds, and failures, of the descent on a rung.
constexpr int kRungRounds = 24;
constexpr int kRungFailures = 4;
/// A step that bends away from cutting planes is at most this part of the last step.
constexpr double kBentPart = 0.7;
/// The least gain of each iteration, and of each round, in parts of the cost.
constexpr double kGainPerIteration = 5e-5;
constexpr double kLeastGain = 1e-5;

/// If the agility is above kAgile, the ladder begins one rung further down, at a tenth of the weight. It begins one
/// more rung down for each further factor of kAgilityPerRung, at most kRungsBelow in all. That factor is the sixth root
/// of ten, since the unit grows with the sixth power of the acceleration.
constexpr double kAgile = 6.0;
constexpr double kAgilityPerRung = 1.468;
constexpr int kRungsBelow = 2;

/// Weights of the rungs above the first.
constexpr double kRungs[] = {100.0, 200.0, 500.0, 1e3, 1e4};
constexpr int kRungCount = sizeof(kRungs) / sizeof(kRungs[0]);

/// Durations of the first round are the chain's own.
void refinement_begin(Refinement& refinement, const Chain& chain, const Question& question) noexcept;

/// Chooses the offer's stretch and sets its cost. True if it improves on the best plan: it costs less and lasts no
/// longer. If the ladder begins at rung 0, the plan may last longer on that rung. With offer.least 0: true if any plan
/// of that snap or more could improve on the best plan.
bool improves(const Refinement& refinement, Offer& offer) noexcept;

/// Learns from a round and enters the next: fills the chain's durations, or sets the phase to kDone.
void refinement_next(Refinement& refinement, const Round& round, Chain& chain) noexcept;

}  // namespace tern

#endif
