// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which durations to try next: a bounded search for the plan of least  snap + rate * duration.  One solve a round.
//
//   climb   durations grow from round to round until the programme has a solution: the first feasible plan.
//   trade   every segment's duration moves to where the price of its time (time_prices.hpp) would equal the rate;
//           halfway back where that leaves no plan or a worse one, and shorter steps from there on.
#ifndef TERN_TRAJECTORY_REFINEMENT_HPP
#define TERN_TRAJECTORY_REFINEMENT_HPP

#include <cstdint>

#include "times/chain.hpp"

namespace tern {

enum class Course : std::uint8_t { kClimb, kTrade, kDone };

struct Refinement {
  Course course;
  int round;                  ///< of this course
  int failures;               ///< of the trade's steps, each of which halves the steps to come
  double rate;                ///< m^2/s^8: what a second costs
  double cost;                ///< that the trade has come to, m^2/s^7
  double base[kMaxSegments];  ///< durations that go with it; of the climb, the last ones tried
};

/// What became of the round's programme.
struct Round {
  bool accepted;                ///< a plan came of it that keeps everything
  double factor;                ///< by which that plan was stretched to meet the limits, between states at rest; else 1
  double cost;                  ///< that plan's snap + rate * duration, m^2/s^7
  double prices[kMaxSegments];  ///< of each segment's time, before the stretch; of a plan better than those before
};

constexpr int kClimbRounds = 6;
constexpr double kClimbStep = 1.35;
constexpr int kTradeRounds = 8;
constexpr int kTradeFailures = 3;
/// One round changes a duration by these factors at most: a programme that shrank too far is dear to prove infeasible.
constexpr double kShortest = 0.85;
constexpr double kLongest = 1.6;
/// The trade ends where a round gains less than this part of the cost.
constexpr double kLeastGain = 0.02;

/// Durations of the first round are the chain's own. `rate`: m^2/s^8, > 0.
void refinement_begin(Refinement& refinement, const Chain& chain, double rate) noexcept;

/// Learns from a round and enters the next: fills the chain's durations, or answers kDone.
void refinement_next(Refinement& refinement, const Round& round, Chain& chain) noexcept;

}  // namespace tern

#endif
