// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Seeds from the flood in time: a way among the things that move, with a time for each leg. Its corridor and its
// straight legs are what a plan around things begins from.
#ifndef TERN_PLANNER_TIMED_SEED_HPP
#define TERN_PLANNER_TIMED_SEED_HPP

#include "base/progress.hpp"
#include "base/work.hpp"
#include "flood/timed_flood.hpp"
#include "flood/timed_way.hpp"
#include "planner/end_stop.hpp"
#include "planner/problem.hpp"
#include "tern/corridor.hpp"
#include "tern/path.hpp"
#include "tern/status.hpp"
#include "tern/trajectory.hpp"

namespace tern {

/// Floods that are tried: slower ones, and ones that keep off things by less or by more.
constexpr int kTimedSeeds = 7;
/// If there is a plan already, only so many.
constexpr int kFastSeeds = 3;

/// True if the flood can lead this plan: it knows no vias.
bool may_flood(const Problem& problem) noexcept;

/// Begins flood number `seed`, for ways of `longest` seconds at most. kRunning or kFloodFull.
Status timed_seed_begin(const Problem& problem, const Ends& ends, const EndStop& start_stop, int seed, double longest,
                        TimedFlood& flood, TimedWay& way) noexcept;
/// Its pieces are those of the flood and of its way. kFailed: there is none.
Progress timed_seed_advance(const Problem& problem, const Ends& ends, TimedFlood& flood, TimedWay& way,
                            Work& work) noexcept;

/// Makes the way's legs the path's.
void take_way(const TimedWay& way, Path& path) noexcept;

/// The legs of the way as a trajectory through the corridor along it. False if it has too many segments.
bool make_seed(const TimedWay& way, const Corridor& corridor, const Ends& ends, Trajectory& seed) noexcept;

}  // namespace tern

#endif
