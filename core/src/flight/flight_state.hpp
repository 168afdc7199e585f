// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A flight's state, in the first of the caller's words; the route's copy follows it.
#ifndef TERN_FLIGHT_FLIGHT_STATE_HPP
#define TERN_FLIGHT_FLIGHT_STATE_HPP

#include <cstddef>
#include <cstdint>

#include "base/bounds.hpp"
#include "base/progress.hpp"
#include "base/work.hpp"
#include "curve/hermite.hpp"
#include "curve/stopping.hpp"
#include "flight/branch.hpp"
#include "flight/route_copy.hpp"
#include "tern/flight.hpp"
#include "tern/proof.hpp"

namespace tern {

/// Instants of a plan from which a brake is tried, and brakes from each, sharp ones first: those need the least room,
/// and with limits on jerk the sharpest may be too sharp.
constexpr int kBranches = 16;
constexpr int kBranchShapes = kStops;
/// Ticks that getting out of the way may take before it begins.
constexpr int kEvadeTicks = 3;
/// Plans without a commit, at rest, after which the vehicle looks around; and directions of a full turn.
constexpr int kPatience = 3;
constexpr int kDirections = 8;
/// Voxels that an aim keeps from the window's faces, besides the radius; and by which one must be nearer to the goal to
/// count as nearer.
constexpr double kAimVoxels = 2.0;
/// New plans that may be committed without coming nearer to the goal than before.
constexpr int kFruitless = 300;

/// A committed plan, or one that may become it.
struct Course {
  Trajectory flown;    ///< ends at rest; proven
  Trajectory wished;   ///< the plan whose first part is flown
  double branch;       ///< seconds since the beginning up to which both are the same
  std::int64_t begin;  ///< nanoseconds
  Vec3 aim;            ///< where `wished` ends
  bool to_goal;        ///< the aim is the goal,
  bool beside_goal;    ///< or the nearest free point to it
  std::uint32_t goal;  ///< number of the goal that it was made for
};

/// What the flight works on. A cycle makes one plan; evading makes a brake.
enum class Job : std::uint8_t {
  kIdle,
  kCopy,     ///< the route grid
  kKeep,     ///< is the rest of the plan that is flown still free on the route?
  kPlan,     ///< the planner
  kWait,     ///< for the window to be done with its slide
  kReach,    ///< until when is the best plan proven?
  kBranch,   ///< a brake from there or before
  kConfirm,  ///< the whole of what would be flown
  kEvade,    ///< brakes from a few ticks ahead
};

class FlightState {
 public:
  FlightSpec spec;
  MotionLimits limits;
  RollingMap map;
  Planner* planner;
  RouteCopy route;
  std::int64_t time;  ///< of the last tick
  Course now;
  Course next;
  bool has_next;

  // The goal.
  Vec3 goal;
  bool has_goal;
  std::uint32_t goal_number;
  bool parked;  ///< no more plans until the next goal
  bool stopping;
  FlightReason reason;

  // The job at hand.
  Job job;
  std::int64_t takeover;  ///< when its result begins
  std::int64_t deadline;  ///< the last tick that may commit it
  Proof proof;
  Course draft;      ///< the plan at hand
  Trajectory plan;   ///< of the planner
  Stopping stop;     ///< the brake that was tried last
  JointState start;  ///< at the takeover, world frame
  Vec3 aim;
  bool aims_at_goal;
  bool moved_aim;     ///< the nearest free point took the aim's place,
  bool beside_goal;   ///< which was the goal
  bool keeps;         ///< the rest of the plan that is flown is free on the route
  bool extends;       ///< `draft` goes on along the plan that is flown
  double reached;     ///< until when `draft` is proven
  int branch;         ///< number of the candidate
  bool tries_branch;  ///< it is being proven
  double best_until;  ///< of the brakes tried
  int best_shape;

  // The proof of what is flown.
  Proof watch;
  bool watching;
  std::uint64_t watched;  ///< the map's revision; 0: none
  bool threat;
  bool alarmed;  ///< in this tick
  bool evaded;   ///< it was tried on this map
  std::int64_t contact;
  double contact_speed;  ///< m/s, along what was flown when the threat was found

  // At rest.
  int idle_cycles;
  int fruitless;   ///< new plans since the vehicle was nearest to the goal
  double nearest;  ///< metres to the goal; negative: not known yet
  bool is_looking;
  std::int64_t look_since;
  Vec3 look_at;
  FlightReport report;

  // flight.cpp
  Sample sample_at(std::int64_t t) const noexcept;
  const Course& course_at(std::int64_t t) const noexcept;
  std::int64_t rest_begins() const noexcept;
  bool rests() const noexcept { return !has_next && time >= rest_begins(); }
  /// Where nothing new takes over before; two ticks more or less do not matter.
  bool rests_at_takeover() const noexcept { return takeover + 2 * spec.tick >= rest_begins(); }
  void take_over() noexcept;
  FlightMode mode() const noexcept;
  bool reads_map() const noexcept;
  void step_map(Work& work) noexcept;
  void finish_report(std::uint32_t spent) noexcept;

  // aim.cpp: where to, and where to look.
  void choose_aim(const Vec3& from) noexcept;
  bool keeps_aim(const Vec3& from) const noexcept;
  void follow_window() noexcept;
  Vec3 looking_at(std::int64_t t) const noexcept;
  int sector_at(std::int64_t t) const noexcept;
  void note_idle() noexcept;
  void park(FlightReason why) noexcept;
  void note_progress() noexcept;
  bool is_nearest() noexcept;
  bool reaches_goal() const noexcept;
  void note_rest() noexcept;

  // cycle.cpp: a plan
  void begin_cycle() noexcept;
  void advance(Work& work) noexcept;
  Progress run_job(Work& work) noexcept;
  Progress run_copy(Work& work) noexcept;
  Progress run_keep(Work& work) noexcept;
  void begin_plan() noexcept;
  void ask_planner() noexcept;
  bool move_aim(const Report& found) noexcept;
  Progress run_plan(Work& work) noexcept;
  void choose_draft(bool planned) noexcept;
  void compose() noexcept;
  Progress prove(Work& work) noexcept;

  // prove_draft.cpp: what of it is flown
  double start_of_proof() const noexcept;
  Progress run_wait() noexcept;
  Progress run_reach(Work& work) noexcept;
  double earliest_branch() const noexcept;
  bool leads_on() const noexcept;
  bool make_branch() noexcept;
  Progress next_branch(Work& work) noexcept;
  Progress run_branch(Work& work) noexcept;
  Progress run_confirm(Work& work) noexcept;
  void commit() noexcept;
  void fail() noexcept;
  void give_up() noexcept;

  // evade.cpp
  void begin_evade() noexcept;
  bool make_evasion() noexcept;
  void next_evasion() noexcept;
  Progress run_evade(Work& work) noexcept;
  void end_evade() noexcept;

  // watch.cpp
  void begin_watch() noexcept;
  void run_watch(Work& work) noexcept;
};

/// Seconds from `begin` to `t`.
inline double seconds_between(std::int64_t begin, std::int64_t t) noexcept {
  return static_cast<double>(t - begin) * 1e-9;
}

/// Nanoseconds, rounded down.
inline std::int64_t nanoseconds(double seconds) noexcept {
  return static_cast<std::int64_t>(seconds * 1e9);
}

}  // namespace tern

#endif
