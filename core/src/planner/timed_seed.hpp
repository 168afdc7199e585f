// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Seeds from the flood in time: a way among the things that move, with a time for each leg. Its corridor and its
// straight legs are what a plan around things begins from.
#ifndef TERN_PLANNER_TIMED_SEED_HPP
#define TERN_PLANNER_TIMED_SEED_HPP

#include "base/progress.hpp"
#include "base/work.hpp"
#include "corridor/corridor_stage.hpp"
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
constexpr int kTimedSeeds = 8;
/// If there is a plan already, only so many.
constexpr int kFastSeeds = 2;

/// A way through all vias: a flood for each leg, which begins when the one before has arrived and dwelt.
struct TimedSeed {
  TimedWay way;
  int number;          ///< of the try
  std::int32_t leg;    ///< leads to the via of this index, or to the goal
  bool is_led;         ///< the leg's flood has found its way
  std::int32_t first;  ///< the first of its legs in `way`
  double longest;      ///< s that all may take
  double begin;        ///< s of the things' clock: when the leg begins
  Status lacking;      ///< a capacity that did not suffice; else kOk
  std::int32_t words;  ///< of the largest flood
  std::int32_t waypoint[kMaxVias];
};

/// Begins flood number `number`, for ways of `longest` seconds at most. False if it lacks room.
bool timed_seed_begin(const Problem& problem, const Ends& ends, const EndStop& start_stop, int number, double longest,
                      TimedFlood& flood, TimedSeed& seed) noexcept;
/// Its pieces are those of the floods and of their ways. kFailed: there is none, or `lacking` says why.
Progress timed_seed_advance(const Problem& problem, const Ends& ends, TimedFlood& flood, TimedSeed& seed,
                            Work& work) noexcept;

/// Makes the way's legs the path's.
void take_way(const TimedSeed& seed, Path& path, ViaMarks& marks) noexcept;

/// The legs of the way as a trajectory through the corridor along it. False if it has too many segments.
bool make_seed(const TimedWay& way, const Corridor& corridor, const Ends& ends, Trajectory& seed) noexcept;

}  // namespace tern

#endif
