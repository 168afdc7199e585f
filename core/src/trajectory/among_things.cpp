// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/among_things.hpp"

#include "base/capacity.hpp"
#include "base/math.hpp"

namespace tern {
namespace {

/// Turns the planes to where the best plan has most room, so that it keeps the new ones, too: these were chosen for a
/// plan that failed.
void turn_to_best(TrajectoryStage& stage, Work& work) {
  double tried[kMaxSegments];
  for (int i = 0; i < stage.chain.count; ++i) {
    tried[i] = stage.chain.duration[i];
    stage.chain.duration[i] = stage.best.duration[i];
  }
  turn_planes(stage.chain, *stage.query.scene, stage.best.points, stage.separations, work);
  for (int i = 0; i < stage.chain.count; ++i) stage.chain.duration[i] = tried[i];
}

}  // namespace

void ask_among_things(Question& question) noexcept {
  question.paced = true;
  question.lengthening = kLengtheningAmongThings;
  question.feasibility_rounds = kRoundsAmongThings;
  question.radius = kRadiusAmongThings;
  question.longest_step = kLongestStepAmongThings;
  question.forgets = true;
}

bool takes_too_long(const TrajectoryStage& stage) noexcept {
  return stage.query.scene != nullptr && stage.solver.iterations >= kIterationsAmongThings;
}

bool is_short_enough(const TrajectoryStage& stage) noexcept {
  if (stage.query.scene == nullptr) return true;
  const Trajectory& reference = *stage.query.scene->reference;
  double most = 0.0;
  for (int i = 0; i < reference.count; ++i) most += kLongestAmongThings * reference.segments[i].duration;
  return chain_duration(stage.chain) <= most;
}

bool part_from_things(TrajectoryStage& stage, Work& work) noexcept {
  if (stage.query.scene == nullptr) return true;
  Separations& separations = stage.separations;
  stage.phase = TrajectoryPhase::kFinish;
  return !separations.is_full &&
         add_separations(stage.chain, *stage.query.scene, separations, stage.scale, stage.problem, work);
}

void look_at_reference(TrajectoryStage& stage) noexcept {
  const Scene& scene = *stage.query.scene;
  separations_begin(scene, stage.chain.start.d[0], stage.separations);
  for (int i = 0; i < stage.chain.count; ++i) {
    for (int k = 0; k < kControlPoints; ++k) stage.points[i][k] = scene.reference->segments[i].points[k];
  }
  meet_begin(true, stage.separations);
  stage.phase = TrajectoryPhase::kMeet;
}

void look_at_things(TrajectoryStage& stage) noexcept {
  meet_begin(false, stage.separations);
  stage.phase = TrajectoryPhase::kMeet;
}

bool meet(TrajectoryStage& stage, Work& work) noexcept {
  return meet_advance(stage.chain, *stage.query.scene, stage.points, stage.separations, work);
}

bool meets_nothing_new(TrajectoryStage& stage, Work& work) noexcept {
  const Separations& separations = stage.separations;
  if (separations.by_reference) return false;
  const bool is_first = stage.refinement.phase == RefinementPhase::kFeasibility;
  const bool is_lost = separations.is_full || separations.is_stuck;
  if (separations.added == 0 && !is_lost) return true;
  stage.round.better = false;
  if (!is_first && separations.added > 0) turn_to_best(stage, work);
  if (is_lost || !is_first || stage.repeats == kMostRepeats) return true;
  ++stage.repeats;
  return false;
}

}  // namespace tern
