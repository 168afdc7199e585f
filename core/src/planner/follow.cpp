// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planner/follow.hpp"

#include "base/too_narrow.hpp"
#include "curve/rest.hpp"
#include "prove/grants.hpp"

namespace tern {
namespace {

/// The part of check_distance by which hulls of the remainder may come closer to obstacles than touching allows. A
/// checked plan may violate a half-space by the check's tolerance, and the half-space itself may be too near to an
/// obstacle. So the plan's hulls may be too near by both. A factor below 1 leaves room for rounding.
constexpr double kPreviousSlack = 0.9;
/// A new plan replaces the remainder if it arrives earlier by more than this, seconds.
constexpr double kEarlierBy = 1e-6;

/// Appends the remainder's segments to the tube, one by one.
Progress enclose_remainder(const Problem& problem, const Vec3& origin, Previous& previous, GrowScratch& scratch,
                           Tube& tube, Work& work) {
  for (; previous.next < previous.count; ++previous.next) {
    if (!previous.is_enclosing) append_begin(previous.enclosure, previous.segments[previous.next]);
    const Progress progress = append_advance(previous.enclosure, world_of(problem), origin, scratch, tube, work);
    previous.is_enclosing = progress == Progress::kMore;
    previous.enclosed = tube.count;
    if (progress != Progress::kDone) return progress;
  }
  return Progress::kDone;
}

}  // namespace

bool follow_trial_is_due(const Previous& previous) noexcept {
  return previous.count > 0 && previous.meets_goal;
}

bool follow_may_help(const Problem& problem, const Previous& previous, Status failure) noexcept {
  if (previous.tried || previous.count == 0) return false;
  return previous.meets_goal || (!lacks_goal_voxel(failure) && !at_rest(problem.asked.start));
}

void follow_begin(Follow& follow, Previous& previous) noexcept {
  previous.tried = true;
  previous.is_enclosing = false;
  follow.leads_plan = false;
}

Progress follow_advance(const Problem& problem, const Ends& ends, Follow& follow, Previous& previous,
                        GrowScratch& scratch, EndStop& lead, Corridor& corridor, Trajectory& trajectory,
                        Work& work) noexcept {
  const double slack = kPreviousSlack * check_distance(*problem.grid);
  Tube tube{lead.segments, lead.polyhedra, kMaxSegments, previous.enclosed, slack};
  if (previous.meets_goal) {
    tube.segments = trajectory.segments;
    tube.polyhedra = corridor.polyhedra;
  }
  const Progress progress = enclose_remainder(problem, ends.origin_in_grid, previous, scratch, tube, work);
  if (progress != Progress::kDone) return progress;
  follow.leads_plan = true;
  if (previous.meets_goal) {
    corridor.count = trajectory.count = previous.enclosed;
    trajectory.origin = problem.asked.start.position;
  } else {
    lead.count = previous.enclosed;
    lead.place = end_of(previous);
  }
  return progress;
}

void follow_note_trial(bool holds, const Trajectory& trajectory, Operations spent, Follow& follow) noexcept {
  follow.held = holds;
  follow.held_duration = duration(trajectory);
  follow.held_operations = spent;
}

bool prefers_remainder(const Follow& follow, const Previous& previous, const Trajectory& trajectory,
                       Operations left) noexcept {
  const bool is_flown = follow.leads_plan && previous.meets_goal;
  if (!follow.held || is_flown || left < follow.held_operations) return false;
  return !(duration(trajectory) < follow.held_duration - kEarlierBy);
}

}  // namespace tern
