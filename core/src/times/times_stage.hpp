// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The times stage: cuts the corridor into the segments of the trajectory and gives each its first duration (the paper's
// Section 3.3.2).
#ifndef TERN_TIMES_TIMES_STAGE_HPP
#define TERN_TIMES_TIMES_STAGE_HPP

#include "base/bounds.hpp"
#include "base/progress.hpp"
#include "base/work.hpp"
#include "tern/corridor.hpp"
#include "tern/request.hpp"
#include "times/chain.hpp"
#include "times/pace.hpp"

namespace tern {

/// The most segments that one polyhedron is split into.
constexpr int kMaxSplit = 5;

/// The most segments of one run of the stage.
constexpr std::uint32_t kTimesBound = static_cast<std::uint32_t>(kMaxSegments);

/// Same frame as the corridor.
struct TimesQuery {
  State start;
  State goal;
  MotionLimits limits;
  ViaJoints via_joints{};
  Pace pace{};  ///< of an earlier plan, which is at `start` at pace.from
};

/// Plain data; needs no initialisation before times_begin.
struct TimesStage {
  MotionLimits limits;
  bool after_stop[kMaxSegments];  ///< the polyhedron begins at a via at which the flight stops
  double slowing[kMaxSegments];   ///< part of the speed that is lost at the polyhedron's beginning
  double speed;                   ///< speed that the flight has room to reach, m/s
  std::int32_t timed;             ///< segments that have a duration: the work done
  Pace pace;
  PaceWalk walk;  ///< up to the end of the last segment that has a duration
  double along;   ///< metres of the way from its polyhedron's beginning to walk's end; 0 if the polyhedron ends there
  bool beside;    ///< the earlier plan passes near walk's end
  bool paced;     ///< at least one segment has its duration from the earlier plan
};

/// Cuts the corridor into a chain. One segment of degree 7 between given states has no freedom, and between two joints
/// it cannot hold a speed. So a polyhedron becomes several segments if it is a large part of the way, or if it is
/// around a moving start or goal. So does a polyhedron several times longer than the way to reach the limit speed and
/// stop again. A polyhedron becomes at most kMaxSplit segments, and fewer if kMaxSegments requires it. times_advance
/// gives the chain its durations. A segment gets its time in a trapezoidal profile (Section 3.3.2) along the whole way,
/// with some slack. The profile has cruising speed, and ramps at the ends and at vias that the flight slows down for.
void times_begin(TimesStage& stage, const Corridor& corridor, const TimesQuery& query, Chain& chain) noexcept;

/// If an earlier plan passes near both joints of a segment, the segment gets that plan's time between them, within
/// bounds (docs/times.md). A piece of work is one segment. kDone with all durations set; this stage cannot fail.
Progress times_advance(TimesStage& stage, const Corridor& corridor, Work& work, Chain& chain) noexcept;

}  // namespace tern

#endif
