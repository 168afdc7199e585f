// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What follows a stage while a plan around things is made. First the plan as if nothing moved is the seed; if that
// gives no plan, or one that lasts much longer, ways from the flood in time are, one after the other. If the best of
// these plans takes longer than the one as if nothing moved, it is tried whether that one may wait instead.
//
//   tracks (when is the goal clear?) -> times -> trajectory -> check -> the best plan, or the next seed:
//   tracks (flood) -> corridor -> times -> ...
//   around keep-outs for a while, closed (closed_order.cpp)
//   the best plan -> tracks (wait) -> that plan, or check -> the one that waits
#include "base/math.hpp"
#include "planner/layout.hpp"
#include "planner/pipeline.hpp"

namespace tern {

/// The check has refused the plan in memory because of a track.
void Pipeline::begin_around() noexcept {
  Layout& memory = *memory_;
  Around& around = attempts_.around;
  around = Around{};
  around.is_active = true;
  around.quality = quality_;
  around.optimiser = optimiser_;
  around.alone = duration(memory.trajectory);
  keep(memory.path, memory.vias.marks, memory.corridor, memory.around.alone);
  const Trajectory& alone = memory.around.alone.trajectory;
  const int stops_and_dwells = memory.trajectory.count - alone.count;
  halve_segments(alone, kMaxSegments - stops_and_dwells, memory.around.seed);
  around.is_looking = true;
  enter(Stage::kTracks);
}

void Pipeline::go_on_around(bool done) noexcept {
  Layout& memory = *memory_;
  Around& around = attempts_.around;
  if (around.is_closed) return go_on_closed(done);
  if (around.is_looking) {
    around.is_looking = false;
    return around.soonest > kTooEarly * around.alone ? next_seed() : enter(Stage::kTimes);
  }
  if (around.is_waiting) return done ? enter(Stage::kCheck) : end_wait(false);
  around.is_flooding = false;
  if (stage_ == Stage::kTrajectory && curves_.status == Status::kSeparationsFull) around.lacking = curves_.status;
  if (stage_ == Stage::kTracks) {
    const TimedSeed& timed = memory.around.timed;
    raise(flood_words_, timed.words);
    if (around.lacking == Status::kOk) around.lacking = timed.lacking;
    const bool is_first = around.seed == 1 && around.found <= 0.0 && !around.looks_further;
    if (!done && is_first && timed.lacking == Status::kOk) {
      around.looks_further = true;
      around.seed = 0;
    }
  }
  if (!done) return next_seed();
  switch (stage_) {
    case Stage::kTracks:
      take_way(memory.around.timed, memory.path, memory.vias.marks);
      return enter(Stage::kCorridor);
    case Stage::kCorridor:
      if (!make_seed(memory.around.timed.way, memory.corridor, memory.ends, memory.around.seed)) return next_seed();
      return enter(Stage::kTimes);
    case Stage::kTimes:
      return enter(Stage::kTrajectory);
    default:
      break;
  }
  if (!complete_trajectory(problem_, memory.stops, curves_, memory.vias, memory.trajectory)) return next_seed();
  quality_ = curves_.quality;
  optimiser_ = curves_.optimiser;
  enter(Stage::kCheck);
}

/// The check has proven the plan around things, or refused it.
void Pipeline::judge_around(bool is_clear) noexcept {
  Layout& memory = *memory_;
  Around& around = attempts_.around;
  if (around.is_waiting) return end_wait(is_clear);
  if (around.is_closed) return judge_closed(is_clear);
  if (!is_clear) return next_seed();
  const double lasts = duration(memory.trajectory);
  const bool is_first = around.seed == 0 && !around.is_last;
  const double enough = larger(kGoodEnough * around.alone, kGoodArrival * larger(around.alone, around.soonest));
  if (is_first && lasts > enough) {
    keep_found();
    return next_seed();
  }
  if (!is_first && !around.is_last && around.found > 0.0 && lasts >= around.found) return next_seed();
  if (lasts <= kGoodEnough * around.alone) return take_plan();
  note_rest();
  keep_found();
  if (!around.is_last && begin_closed(conflict_.fence, conflict_.track)) return;
  begin_wait();
}

/// The trajectory in memory is the best so far.
void Pipeline::keep_found() noexcept {
  Layout& memory = *memory_;
  memory.around.found = memory.trajectory;
  memory.around.marks = memory.vias.marks;
  for (std::int32_t v = 0; v < problem_.via_count; ++v) memory.around.joint[v] = memory.vias.joint[v];
  attempts_.around.found_seed = seed_of(attempts_.around);
  attempts_.around.found = duration(memory.trajectory);
}

void Pipeline::take_found() noexcept {
  Layout& memory = *memory_;
  memory.trajectory = memory.around.found;
  memory.vias.marks = memory.around.marks;
  for (std::int32_t v = 0; v < problem_.via_count; ++v) memory.vias.joint[v] = memory.around.joint[v];
}

/// Puts the plan that was made as if nothing moved into memory, without its path and corridor.
void Pipeline::take_alone() noexcept {
  Layout& memory = *memory_;
  memory.vias.marks = memory.around.alone.marks;
  memory.trajectory = memory.around.alone.trajectory;
  complete_trajectory(problem_, memory.stops, curves_, memory.vias, memory.trajectory);
}

/// Tries whether the plan as if nothing moved may wait, and arrive about when the proven plan in memory does.
void Pipeline::begin_wait() noexcept {
  take_alone();
  enter(Stage::kTracks);
  attempts_.around.is_waiting = true;
}

/// The plan as if nothing moved is proven to be clear if it waits, or the proven plan that it would replace is the
/// answer.
void Pipeline::end_wait(bool may_wait) noexcept {
  Layout& memory = *memory_;
  attempts_.around.is_waiting = false;
  if (!may_wait) {
    take_found();
    return end_plan();
  }
  bring_back(memory.around.alone, memory.path, memory.vias.marks, memory.corridor);
  end_around();
  take_plan();
}

/// Goes on to the next flood. After the last one, the answer is the plan in the first corridor, if there is one; if
/// not, the one that was made as if nothing moved may wait.
void Pipeline::next_seed() noexcept {
  Layout& memory = *memory_;
  Around& around = attempts_.around;
  const int most = around.found > 0.0 ? kFastSeeds : kTimedSeeds;
  const double most_alone = around.looks_further ? kFurther * kLongestFlood : kLongestFlood;
  const double longest = around.found > 0.0 ? around.found : most_alone * around.alone;
  while (around.seed < most && !around.is_last) {
    const std::int32_t seed = around.seed++;
    TimedSeed& timed = memory.around.timed;
    const auto begins = [&](double most_seconds) {
      return timed_seed_begin(problem_, memory.ends, memory.stops[0], seed, most_seconds, memory.stage.flood, timed);
    };
    // Where the further look does not fit, the nearer one may.
    if (!begins(longest) && !(around.looks_further && begins(smaller(longest, kLongestFlood * around.alone)))) {
      if (around.lacking == Status::kOk) around.lacking = timed.lacking;
      continue;
    }
    around.is_flooding = true;
    return enter(Stage::kTracks);
  }
  if (!around.is_last && begin_closed(conflict_.fence, conflict_.track)) return;
  bring_back(memory.around.alone, memory.path, memory.vias.marks, memory.corridor);
  if (around.found <= 0.0 || around.is_last) {
    end_around();
    take_alone();
    return enter(Stage::kTracks);
  }
  take_found();
  quality_ = Quality::kOptimised;
  around.is_last = true;
  enter(Stage::kCheck);
}

/// No plan around things is the answer.
void Pipeline::end_around() noexcept {
  Around& around = attempts_.around;
  around.is_active = false;
  quality_ = around.quality;
  optimiser_ = around.optimiser;
}

/// Of the current stage's budget, what is for later seeds.
Operations Pipeline::kept_for_seeds() const noexcept {
  const std::uint32_t budget = problem_.asked.budget.trajectory;
  const Around& around = attempts_.around;
  const bool is_last = around.is_active && around.seed > 0;
  if (stage_ != Stage::kTrajectory || problem_.thing_count == 0 || budget == kNoBudget || is_last) return 0;
  return kUnit * budget * (around.is_active ? kKeptFirst : kKeptAlone) / 10;
}

}  // namespace tern
