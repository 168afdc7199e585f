// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What follows a stage while a plan is led around a keep-out for a while, or a thing that stands, as if it always did.
// The flood in time looks at a coarse grid, and finds no narrow ways; the search does.
//
//   world (with that solid) -> search -> shortcut -> corridor -> times -> trajectory -> check -> the best plan so far
#include "base/math.hpp"
#include "planner/layout.hpp"
#include "planner/pipeline.hpp"
#include "world/closed.hpp"

namespace tern {

namespace {

/// True if a thing stands still, and its place is known as well at any time.
bool stands(const Track& thing) {
  const bool is_still = thing.piece_count == 0 && same(thing.velocity, kZero);
  return is_still && !(thing.error_speed > 0.0 || thing.error_growth > 0.0);
}

Box box_around(const Track& thing) {
  const bool is_box = thing.shape == TrackShape::kBox;
  const double up = thing.shape == TrackShape::kBall ? thing.radius : thing.half.z;
  const Vec3 half = is_box ? thing.half : Vec3{thing.radius, thing.radius, up};
  const Vec3 reach = half + Vec3{thing.error, thing.error, thing.error};
  return {thing.position - reach, thing.position + reach};
}

}  // namespace

bool Pipeline::close(std::int32_t fence, std::int32_t track) noexcept {
  if (fence != kNoFence) return close_fence(memory_->world, fence);
  if (track == kNoTrack || track >= problem_.track_count || !stands(problem_.tracks[track])) return false;
  return close_box(memory_->world, box_around(problem_.tracks[track]));
}

/// As many as fit.
void Pipeline::close_all() noexcept {
  close_all_fences(memory_->world);
  for (std::int32_t i = 0; i < problem_.track_count; ++i) close(kNoFence, i);
}

/// Closes what a plan met, a keep-out for a while or a thing that stands. False if it is neither, or no better plan is
/// needed.
bool Pipeline::begin_closed(std::int32_t fence, std::int32_t track) noexcept {
  Around& around = attempts_.around;
  const bool is_good = around.found > 0.0 && around.found <= kGoodEnough * around.alone;
  if (is_good || around.closed == kMostClosed || !close(fence, track)) return false;
  ++around.closed;
  around.is_closed = true;
  if (around.closed == kMostClosed) close_all();
  enter(Stage::kWorld);
  return true;
}

void Pipeline::go_on_closed(bool done) noexcept {
  Layout& memory = *memory_;
  if (!done) return end_closed();
  switch (stage_) {
    case Stage::kWorld:
      legs_begin(problem_, legs_, memory.path);
      return enter(Stage::kSearch);
    case Stage::kSearch:
      return enter(Stage::kShortcut);
    case Stage::kShortcut:
      if (is_last_leg(problem_, legs_)) return enter(Stage::kCorridor);
      ++legs_.leg;
      return enter(Stage::kSearch);
    case Stage::kCorridor:
      return enter(Stage::kTimes);
    case Stage::kTimes:
      return enter(Stage::kTrajectory);
    default:
      break;
  }
  if (!complete_trajectory(problem_, memory.stops, curves_, memory.vias, memory.trajectory)) return end_closed();
  quality_ = curves_.quality;
  optimiser_ = curves_.optimiser;
  enter(Stage::kCheck);
}

/// The check has proven the plan, or refused it: another keep-out may be in the way.
void Pipeline::judge_closed(bool is_clear) noexcept {
  const Around& around = attempts_.around;
  const bool is_better = around.found <= 0.0 || duration(memory_->trajectory) < around.found;
  if (is_clear && is_better) keep_found();
  const ProofReport& found = memory_->stage.check.found;
  const bool by_time = !is_clear && (found.finding == Finding::kFence || found.finding == Finding::kTrack);
  if (by_time && begin_closed(found.fence, found.track)) return;
  end_closed();
}

/// The floods are over: some were passed over if a way was found before.
void Pipeline::end_closed() noexcept {
  attempts_.around.is_closed = false;
  attempts_.around.seed = kTimedSeeds;
  next_seed();
}

}  // namespace tern
