// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A query to the planner. Everything is in the world frame and in SI units.
#ifndef TERN_REQUEST_HPP
#define TERN_REQUEST_HPP

#include <stdint.h>

#include "tern/fence.hpp"
#include "tern/track.hpp"
#include "tern/trajectory.hpp"
#include "tern/vec3.hpp"
#include "tern/via.hpp"

namespace tern {

/// The state at one end of a plan, world frame. All numbers must be finite (kNonFiniteInput). The position must lie in
/// the grid's boundary (kOutOfMap), velocity, acceleration and jerk within the limits (kStartExceedsLimits,
/// kGoalExceedsLimits). A plan has exactly this state at that end, with one exception: a plan that continues along
/// Request::previous begins with the jerk of that plan.
struct State {
  Vec3 position;      ///< m, the robot's centre
  Vec3 velocity;      ///< m/s
  Vec3 acceleration;  ///< m/s^2
  Vec3 jerk{};        ///< m/s^3. Pass the jerk that the vehicle flies with, and the new plan has no step in it.
};

/// Limits of velocity, acceleration and jerk. A plan keeps them for all t, to 3e-8 of each limit. They hold for each
/// axis of the world frame separately, in both directions, and for the horizontal norm if you set a limit for it. The
/// Euclidean norm of all three axes has no limit of its own. Every magnitude must lie within [kMinLimit, kMaxLimit],
/// those of jerk within [kMinLimit, kMaxJerk], else the answer is kLimitsInvalid with the field.
struct Limits {
  /// m/s, > 0: the largest velocity along each axis.
  Vec3 v_max;
  /// m/s^2, > 0: the largest acceleration along each axis.
  Vec3 a_max;
  /// m/s, < 0: the lowest velocity along each axis, for example to descend more slowly than climb. An axis of 0 means
  /// -v_max.
  Vec3 v_min{};
  /// m/s^2, < 0: the lowest acceleration along each axis. An axis of 0 means -a_max.
  Vec3 a_min{};
  /// m/s: limit of sqrt(vx^2 + vy^2), on top of the limits of x and y. 0 means none.
  double v_horizontal = 0.0;
  /// m/s^2: limit of sqrt(ax^2 + ay^2), on top of the limits of x and y. 0 means none.
  double a_horizontal = 0.0;
  /// m/s^3: the largest jerk along each axis, in both directions. An axis of 0 has no limit. Autopilots do not follow
  /// plans above their own limit (PX4's is 4 to 8, ArduPilot's 5 by default).
  Vec3 j_max{};
  /// m/s^3: limit of sqrt(jx^2 + jy^2). 0 means none.
  double j_horizontal = 0.0;

  // The vehicle's own limits. The thrust over mass is f = a + (0, 0, kGravity), as flat_state() gives it. With a limit
  // on thrust or tilt, it never points down.
  /// m/s^2, > kGravity: the largest thrust |f|. 0 means none.
  double thrust_max = 0.0;
  /// m/s^2, within [kMinLimit, kGravity - kMinLimit]: the least thrust. Plans keep its vertical part above it, which is
  /// stricter. 0 means none, and then plans may fall freely.
  double thrust_min = 0.0;
  /// Tangent of the largest angle between f and the vertical: 0.577 for 30 degrees, 1 for 45. Within [kMinLimit,
  /// kMaxLimit]. 0 means none.
  double tilt_tangent = 0.0;
  /// rad/s: the largest body rate across the thrust, roll and pitch together: |j x f| / |f|^2. Within [kMinLimit,
  /// kMaxLimit]. 0 means none. It needs a thrust_min, because without thrust there is no direction to turn.
  double rate_max = 0.0;
};
/// Smallest and largest magnitude of a limit.
constexpr double kMinLimit = 1e-3;
constexpr double kMaxLimit = 1e3;
/// Largest limit on jerk, and the largest jerk of a state along each axis, with or without a limit: m/s^3.
constexpr double kMaxJerk = 1e6;

/// How much a second of flight counts against smoothness. A plan minimises
///
///   (integral of squared snap) + time_weight * a^6 / v^4 * (duration),
///
/// where a is the acceleration limit along the path, and v the speed limit along it, or the speed that the path has
/// room to reach if that is less. The first term is the paper's (Section 3.4.3). The scale a^6 / v^4 makes one weight
/// mean one style of flight, for slow and for fast vehicles, short and long ways. A larger weight gives a faster plan:
/// 10 is gentle, 40 is the default, 200 is brisk, 1000 is nearly as fast as the limits allow. From the default up, a
/// larger weight never gives a slower plan of the same corridor, and takes more work. A request with a previous plan is
/// an exception: its search begins at the durations of that plan. docs/trajectory.md has measurements.
constexpr double kDefaultTimeWeight = 40.0;
constexpr double kMinTimeWeight = 1e-3;
constexpr double kMaxTimeWeight = 1e6;

/// How much work a plan may spend in each stage, in units: about a thousand instructions each (tern/work.hpp). Work is
/// counted, never timed (contract C7), so a budget gives the same plan on every machine. A piece of work may begin as
/// long as a budget is not spent, so a stage may take one piece more. Earlier plans on the same map change no amount of
/// work. By default, only the bounds of the stages apply (config.hpp). 0 is allowed.
struct Budget {
  /// The search, and finding Report::reachable. Beyond it: kBudgetSearch.
  uint32_t search = 0xFFFFFFFFu;
  /// The shortcut and the detour. Beyond it: kBudgetShortcut, or no detour.
  uint32_t shortcut = 0xFFFFFFFFu;
  /// The corridor, and the proofs that stops and the rest of a previous plan have room. Beyond it: kBudgetCorridor.
  uint32_t corridor = 0xFFFFFFFFu;
  /// The trajectory. Beyond it, the answer is the best plan so far, or stop-and-go if there is none yet;
  /// Report::optimiser is then kBudgetOptimise. 0 asks for stop-and-go.
  uint32_t trajectory = 0xFFFFFFFFu;
  /// Ways and times among things that move. Beyond it, no other one is tried: the answer is the best plan so far, or
  /// kBudgetTracks if there is none.
  uint32_t tracks = 0xFFFFFFFFu;
};

/// How the search finds a path over the grid. Any other number is refused (kInvalidArgument, field kSearch). In both
/// modes, kNoPath means that there is none.
enum class SearchMode : uint8_t {
  /// A path that costs a few per cent more than the cheapest, in a fraction of the time. Diagnostics::search_bound
  /// limits the excess. If that search is led astray, the optimal one answers.
  kFast = 0,
  /// A cheapest path.
  kOptimal = 1,
};

/// What to do if no plan can lead to the goal: it is occupied or fenced, or no chain of free voxels leads to it. Any
/// other number is refused (kInvalidArgument, field kGoalMode). A goal that a thing that moves or a fence for a while
/// covers is none of these: kGoalCovered in both modes.
enum class GoalMode : uint8_t {
  /// There is no plan: kGoalOccupied, kGoalFenced or kNoPath. Report::reachable says how near the robot could come.
  kExact = 0,
  /// As near as you can: the plan ends at rest at Report::reachable, and Report::goal_missed says why. A goal that can
  /// be planned to gets the same plan as with kExact.
  kNearest = 1,
};

/// One planning query. The caller owns it and everything that it points to. Planner::plan and Planner::begin read it
/// while they run and keep no pointer into it.
struct Request {
  State start{};
  State goal{};
  Limits limits{};
  Budget budget{};
  /// When the plan begins: nanoseconds of a clock of yours. A new plan carries it as Trajectory::begin. Nothing else
  /// depends on it but where the tracks are. Any number is accepted.
  int64_t begin = 0;
  SearchMode search = SearchMode::kFast;
  GoalMode goal_mode = GoalMode::kExact;
  /// Within [kMinTimeWeight, kMaxTimeWeight], else kLimitsInvalid.
  double time_weight = kDefaultTimeWeight;
  /// Geofences: an array of `fence_count`, or null with fence_count 0.
  const Fence* fences = nullptr;
  /// 0 .. kMaxFences. Beyond it: kFencesFull.
  int32_t fence_count = 0;
  /// Points to pass on the way to the goal, in order: an array of `via_count`, or null with via_count 0. Speed carries
  /// through a via that is not a stop. A request with vias takes GoalMode::kExact and no previous plan; the others are
  /// refused with kInvalidArgument and the field.
  const Via* vias = nullptr;
  /// 0 .. kMaxVias. Beyond it: kViasFull.
  int32_t via_count = 0;

  /// Things that move: an array of `track_count`, or null with track_count 0. The plan keeps the grid's radius from
  /// each of their tubes at all times. docs/tracks.md says what is promised and what is not.
  const Track* tracks = nullptr;
  /// 0 .. kMaxTracks. Beyond it: kTracksFull.
  int32_t track_count = 0;
  /// s, 0 .. kRestHorizon, else kInvalidArgument: for how long the plan's end must stay clear of the tracks.
  double rest_clear = 0.0;

  /// For replanning in flight: the plan that you are flying, or null. If the planner finds no plan, or none that
  /// arrives more than a microsecond earlier, it follows the rest of this one, provided that this is still free on the
  /// grid. The answer is then this plan itself, bit for bit, with Quality::kPrevious and previous_time as
  /// Report::entered; only its segments lose their polyhedra. So no new plan to the same goal arrives later than the
  /// rest. If the goal or its motion is a different one and there is no plan, it plans on to the goal from the end of
  /// the rest. Diagnostics::detours is 3 for both. The planner tries to stop first only if that fails, too.
  ///
  /// The previous plan also saves work: if a new plan leads nearly the same way, the optimiser begins at the durations
  /// of this one.
  ///
  /// `start` must be what evaluate(*previous, previous_time) returns, bit for bit. Otherwise the answer is
  /// kInvalidArgument, field kPrevious.
  ///
  /// On an unchanged map with the same limits and fences, a plan is always found under four conditions: `previous` was
  /// kOk; something is left of it; the goal is the same, or can be reached from the previous one; and budget and
  /// capacities suffice. To a different goal, at least a millisecond must be left, also of the current segment if
  /// `previous` leads more than a kilometre away.
  ///
  /// It may be the object that the new plan is written to: that object changes only when the new plan is kOk.
  const Trajectory* previous = nullptr;
  /// Time since the beginning of `previous` at which the new plan begins. Seconds, >= 0, finite. If both plans carry
  /// the times of one clock, it is time_on(*previous, begin).
  double previous_time = 0.0;
};

}  // namespace tern

#endif
