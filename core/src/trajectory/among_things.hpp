// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the trajectory stage does besides if there are things that move: it holds each plan that improves against all of
// them, adds planes for what the plan meets, and turns the planes to each better plan.
#ifndef TERN_TRAJECTORY_AMONG_THINGS_HPP
#define TERN_TRAJECTORY_AMONG_THINGS_HPP

#include "base/work.hpp"
#include "trajectory/refinement.hpp"
#include "trajectory/trajectory_stage.hpp"

namespace tern {

/// How often the same durations are tried again with more planes, before there is a plan.
constexpr int kMostRepeats = 8;
/// A plan is not made much longer for want of a solution: that moves it in time, and meets other things.
constexpr double kLengtheningAmongThings = 1.08;
constexpr int kRoundsAmongThings = 2;
/// The first durations are near the best ones, or lead past a thing, which a longest step would meet.
constexpr double kRadiusAmongThings = 0.33;
/// To let a thing pass, all segments before it are prolonged at once: each of them by less.
constexpr double kLongestStepAmongThings = kShortestStep;

/// A plan that lasts longer than the reference by more than this factor follows a thing instead of passing it.
constexpr double kLongestAmongThings = 1.6;

/// A programme among things that takes more iterations has no solution, nearly always.
constexpr int kIterationsAmongThings = 200;

/// True if the programme is among things, and has taken that many.
bool takes_too_long(const TrajectoryStage& stage) noexcept;

/// False for a plan among things that lasts too long.
bool is_short_enough(const TrajectoryStage& stage) noexcept;

void ask_among_things(Question& question) noexcept;

/// Appends the planes' rows to the programme. If there is no room, the stage ends: false.
bool part_from_things(TrajectoryStage& stage, Work& work) noexcept;

/// Begins to look at the scene's reference, before the first programme.
void look_at_reference(TrajectoryStage& stage) noexcept;
/// Begins to look at the plan of the last solution.
void look_at_things(TrajectoryStage& stage) noexcept;
/// Looks. True at the end.
bool meet(TrajectoryStage& stage, Work& work) noexcept;
/// False if the same durations are to be tried again with the planes that were added. Else round.better says whether
/// the plan is clear.
bool meets_nothing_new(TrajectoryStage& stage, Work& work) noexcept;

}  // namespace tern

#endif
