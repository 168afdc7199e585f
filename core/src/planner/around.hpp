// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Plans around things that move. The plan that was made as if nothing moved is the seed: its corridor, its durations,
// and its curve, which says on which side to pass. The trajectory stage then makes a plan with planes between it and
// the things.
#ifndef TERN_PLANNER_AROUND_HPP
#define TERN_PLANNER_AROUND_HPP

#include "base/progress.hpp"
#include "base/work.hpp"
#include "planner/curves.hpp"
#include "planner/end_stop.hpp"
#include "planner/problem.hpp"
#include "planner/timed_seed.hpp"
#include "tern/corridor.hpp"
#include "tern/path.hpp"
#include "tern/report.hpp"
#include "tern/status.hpp"
#include "tern/trajectory.hpp"

namespace tern {

/// What of a plan may come back.
struct Kept {
  Trajectory trajectory;  ///< without stops and dwells
  Corridor corridor;
  std::int32_t points;  ///< of its path
  Vec3 path[kMaxWaypoints];
  double length;
  ViaMarks marks;
};

/// The plans that the search for one around things begins from, and falls back to.
struct AroundMemory {
  Kept alone;        ///< the plan as if nothing moved
  Trajectory found;  ///< the best one around things so far, with stops and dwells,
  ViaMarks marks;    ///< and its marks and joints as in ViaMemory
  std::int32_t joint[kMaxVias];
  Trajectory seed;  ///< of the current way
  TimedSeed timed;
};

struct Around {
  bool is_active = false;            ///< the trajectory in memory, or the one that is being made, leads around things
  Quality quality = Quality::kNone;  ///< of the plan that was made as if nothing moved
  Status optimiser = Status::kOk;
  Status lacking = Status::kOk;  ///< a capacity that did not suffice
  bool is_looking = false;       ///< the stage `tracks` looks when the goal is clear
  bool is_flooding = false;      ///< the stage `tracks` looks for a way
  bool looks_further = false;    ///< because the first flood found none
  bool is_last = false;          ///< what is checked now is the answer, if it is clear
  std::int32_t seed = 0;         ///< floods that were begun
  double alone = 0.0;            ///< s that the plan as if nothing moved takes
  std::int32_t instant = 0;      ///< of that look, the next one
  double soonest = 0.0;          ///< s: the first arrival after which the goal stays clear, about
  double latest = 0.0;           ///< s: and the last one, if that is not after the first plan's seed arrives
  double found = 0.0;            ///< s that the best plan so far takes; 0: there is none
  std::int32_t found_seed = 0;   ///< what it began from, as Diagnostics::seed
  bool is_closed = false;        ///< a plan around what was closed is being made
  std::int32_t closed = 0;       ///< keep-outs for a while and things that were closed
  bool is_waiting = false;       ///< the stages `tracks` and `check` look whether the plan as if nothing moved may wait
};

/// As Diagnostics::seed, for the plan in memory.
constexpr std::int32_t seed_of(const Around& around) noexcept {
  if (!around.is_active) return 0;
  if (around.is_last) return around.found_seed;
  return around.is_closed ? 2 + kTimedSeeds : 1 + around.seed;
}

/// True if there is a corridor and a plan of this quality to begin from.
constexpr bool may_lead_around(Quality quality, bool has_corridor) noexcept {
  return has_corridor && (quality == Quality::kOptimised || quality == Quality::kStopAndGo);
}

/// Tenths of Budget::trajectory that are kept while the plan as if nothing moved is made, and while the first one
/// around things is. Without them, a plan that takes long to improve would leave nothing to lead one around a thing.
constexpr int kKeptAlone = 6;
constexpr int kKeptFirst = 3;

/// The durations of the plan as if nothing moved are lengthened by this factor: the way around is longer.
constexpr double kAroundSlack = 1.04;
/// s. Its segments that last longer become two each: five on an empty way are too few to pass a thing in the least
/// time.
constexpr double kLongestWhole = 1.8;
/// A plan that lasts longer than that one by no more than this factor is good enough.
constexpr double kGoodEnough = 1.02;
/// So is one that arrives later than the goal is clear by no more than this factor: a thing that leaves it is still in
/// the way of the approach.
constexpr double kGoodArrival = 1.045;
/// If the goal is clear later than that plan arrives by more than this factor, no plan in its corridor and near its
/// durations helps.
constexpr double kTooEarly = 1.06;
/// A plan may arrive sooner than that one by this factor, before something comes to the goal.
constexpr double kSoonestArrival = 0.97;
/// A flood at full speed looks for no ways that take longer by more than this factor; slower ones look further.
constexpr double kLongestFlood = 1.6;
/// If the first flood finds no way, it and all others look further by this factor: it takes long until there is one,
/// and a flood at full speed finds the shortest wait.
constexpr double kFurther = 2.0;

/// How often what a plan met, a keep-out for a while or a thing that stands, is closed at all times to lead a plan
/// around it. The last time, all others are closed as well.
constexpr std::int32_t kMostClosed = 4;

/// A plan that waits may arrive later than one that flies about instead by this part of how much longer than the one as
/// if nothing moved that takes: a run-up to a closed passage gains little.
constexpr double kWorthWaiting = 0.03;

/// Keeps what the search for other ways overwrites, and brings it back.
void keep(const Path& path, const ViaMarks& marks, const Corridor& corridor, Kept& kept) noexcept;
void bring_back(const Kept& kept, Path& path, ViaMarks& marks, Corridor& corridor) noexcept;

/// Makes the first seed of the plan as if nothing moved: the same curve in `most` segments at most, or as many as it
/// has.
void halve_segments(const Trajectory& alone, int most, Trajectory& seed) noexcept;

/// Instants at which the goal is looked at.
constexpr std::int32_t kGoalInstants = 96;

/// Looks when the plan may arrive so that the goal is clear for as long as it is to rest there: from Around::soonest
/// until Around::latest. A piece of work is an instant. kMore or kDone.
Progress look_at_goal(const Problem& problem, const Ends& ends, Around& around, Work& work) noexcept;

/// By how much the durations of the first seed are lengthened, so that it arrives while the goal is clear.
double first_slack(const Around& around) noexcept;

/// Makes the chain and the scene of the seed, and begins its trajectory. The times stage has run: the memory has the
/// corridor and the chain's ends and vias. The durations are `slack` times those of the seed, which must stay until the
/// trajectory is done.
void around_begin(const Problem& problem, const Ends& ends, const EndStop& start_stop, const Trajectory& seed,
                  double slack, CurveMemory& memory) noexcept;

}  // namespace tern

#endif
