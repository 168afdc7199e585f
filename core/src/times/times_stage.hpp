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

namespace tern {

/// Segments that one polyhedron is split into at most: to gain speed, to keep it, to lose it.
constexpr int kMaxSplit = 3;

/// Units of one run: a segment each.
constexpr std::uint32_t kTimesBound = static_cast<std::uint32_t>(kMaxSegments);

/// Same frame as the corridor.
struct TimesQuery {
  State start;
  State goal;
  MotionLimits limits;
};

/// Plain data; needs no initialisation before times_begin.
struct TimesStage {
  MotionLimits limits;
  double speed;        ///< m/s that the flight has room to reach
  std::int32_t timed;  ///< segments that have a duration: the work done
};

/// Cuts the corridor into a chain, which times_advance gives its durations: each segment the time of a trapezoidal
/// profile (Section 3.3.2) along the whole way: cruising speed, with ramps at the ends that are at rest, and some
/// slack. One segment of degree 7 between given states has no freedom, and between two joints cannot hold a speed: a
/// polyhedron longer than half of the way, or than some times what it takes to reach the limit speed and stop again,
/// becomes up to kMaxSplit segments, as far as kMaxSegments allows. Where start or goal move, so do the polyhedra
/// around them.
void times_begin(TimesStage& stage, const Corridor& corridor, const TimesQuery& query, Chain& chain) noexcept;

/// One unit is one segment. kDone with all durations set; this stage cannot fail.
Progress times_advance(TimesStage& stage, const Corridor& corridor, Work& work, Chain& chain) noexcept;

}  // namespace tern

#endif
