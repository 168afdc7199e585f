// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A flight's state, in the first of the caller's words; the copy of the route grid follows it.
#ifndef TERN_FLIGHT_FLIGHT_STATE_HPP
#define TERN_FLIGHT_FLIGHT_STATE_HPP

#include <cstddef>
#include <cstdint>

#include "base/bounds.hpp"
#include "base/progress.hpp"
#include "base/work.hpp"
#include "curve/hermite.hpp"
#include "curve/stopping.hpp"
#include "flight/commitment.hpp"
#include "flight/flight_clock.hpp"
#include "flight/jobs.hpp"
#include "flight/nose.hpp"
#include "flight/route_copy.hpp"
#include "tern/flight.hpp"
#include "tern/proof.hpp"

namespace tern {

/// Cycles at rest without a commit after which the vehicle looks around, and directions of a full turn.
constexpr int kIdleCycles = 3;
constexpr int kDirections = 8;
/// After a look around, the vehicle looks at what ended the last proof for the time of this many directions: a noisy
/// sensor needs some frames.
constexpr int kStares = 5;
/// Voxels that an aim keeps from the window's faces, besides the radius. An aim must also be nearer to the goal by more
/// than this to count as nearer.
constexpr double kAimVoxels = 2.0;
/// kFruitless: new plans that may be committed without coming nearer to the goal and without learning kLearned words of
/// the map. kWandering: new plans that may be committed without coming nearer, whatever they learn.
constexpr int kFruitless = 150;
constexpr std::uint64_t kLearned = 64;
constexpr int kWandering = 1500;
/// Nanoseconds for which something that is too near to the resting vehicle, but comes no nearer, is reported as a
/// threat.
constexpr std::int64_t kTold = 300000000;
/// Metres: further than any window is wide.
constexpr double kAnywhere = 1e9;
/// Bits of FlightState::sought: all directions of a full turn, and straight away from what is to be seen.
constexpr std::uint32_t kAround = (1u << kDirections) - 1;
constexpr std::uint32_t kAway = 1u << kDirections;
/// Points of a way that are nearer to each other than this count as the same, metres.
constexpr double kSamePlace = 1e-6;

/// What keeps the flight from going on, and where, world frame.
struct Blockage {
  BlockedBy by;
  Vec3 at;
  std::int32_t fence;  ///< its index for kFence, otherwise kNoFence
};

constexpr Blockage kNoBlockage{BlockedBy::kNothing, kZero, kNoFence};

/// A place from where something may be seen.
struct Lookout {
  Vec3 place;              ///< world frame
  double drop;             ///< how far the line of sight drops or climbs across a voxel, in voxels
  std::int32_t direction;  ///< from what is to be seen to the place; negative: no lookout
  bool is_straight;        ///< the straight way there is known to be free
};

class FlightState {
 public:
  FlightSpec spec;
  MotionLimits limits;
  RollingMap map;
  Planner* planner;
  RouteCopy route;
  FlightClock clock;
  std::int64_t shown;      ///< what the clock showed at the last tick
  std::int64_t time;       ///< of the last tick, in nanoseconds since the start, as all times here
  std::int64_t gap;        ///< between the last two ticks
  std::uint32_t owed;      ///< instructions that are done but not paid for yet: a few pieces at most
  std::uint32_t deferred;  ///< instructions to pay for once no evasion is running
  Commitment now;          ///< the plan in flight
  Commitment next;         ///< the waiting plan: committed, but its takeover is still ahead
  bool has_next;

  // The mission. A goal alone is a mission of one point.
  Itinerary itinerary;
  bool has_goal;
  std::uint32_t goal_number;  ///< counts the missions
  bool parked;                ///< no more plans until the next goal
  bool stopping;              ///< a stop was asked for, and its brake is not made yet
  bool stops;                 ///< the current evasion serves a stop
  FlightReason reason;

  // The current job.
  Job job;
  std::int64_t takeover;  ///< when the job's result begins
  std::int64_t deadline;  ///< the last tick that may commit the result
  Proof proof;
  std::uint64_t proven_on;       ///< the safe grid's revision when `proof` began
  std::uint32_t planner_effort;  ///< how much of the pending plan's effort is paid for, as Planner counts it
  Commitment draft;              ///< the candidate for the next commit
  Trajectory plan;               ///< the planner's trajectory
  Stopping stop;                 ///< the brake that was tried last
  JointState start;              ///< the state at the takeover, world frame
  Via asked[kMaxVias];           ///< the points that the pending plan passes
  std::int32_t asked_point[kMaxVias];
  std::int32_t asked_count;
  std::int32_t target;         ///< the mission's point that the pending plan ends at, or leads to
  std::uint32_t planned_goal;  ///< number of the mission that the pending plan is for
  Vec3 goal;                   ///< where the target is, world frame
  Vec3 aim;
  bool aims_at_goal;  ///< the aim is the target
  bool moved_aim;     ///< the nearest free point to the aim replaced it
  bool beside_goal;   ///< the aim is the nearest free point to the target
  bool all_free;      ///< no unseen voxel is solid in the route copy
  bool to_reachable;  ///< no way led to the aim, and the reachable point nearest to it replaced it
  bool cut_off;       ///< no way leads to the target, and the vehicle rests as near to it as it can
  bool looks_out;     ///< the aim is a lookout, or on the way to one
  bool leaves;        ///< something is within the radius of where the vehicle rests
  bool keeps;         ///< the rest of the planner's plan in flight is free on the route copy
  bool extends;       ///< `draft` goes on along the planner's plan in flight
  double reached;     ///< until when `draft` is proven
  int branch;         ///< number of the candidate
  int straight;       ///< brakes straight ahead that were tried
  int along;          ///< brakes along the committed plan that were tried
  bool tries_branch;  ///< the candidate is being proven
  Evasion tried;      ///< the brake that is being judged
  Evasion best;       ///< the best brake of those that were judged
  BrakeProof proves;  ///< what `proof` shows of the brake that is being judged

  // The proof of the committed plan.
  Proof watch;
  bool watching;
  Watched watched_part;   ///< the part that is being proven
  bool has_added;         ///< the proof covers only what is near `added`
  Box added;              ///< around what became solid since the last proof
  bool watch_all;         ///< the next proof covers all of the plan, not only what is near `added`
  std::uint64_t watched;  ///< the safe grid's revision when the last proof began
  bool threat;
  bool alarmed;             ///< a threat was found in this tick
  std::int64_t alarm_time;  ///< of the last tick with `alarmed`
  double beside;            ///< at rest under a threat: how near the nearest thing was, metres
  bool evaded;              ///< an evasion of the threat was tried on this map
  int missed;               ///< evasions in a row that were too late; one that judged no brake counts twice
  Contact contact;          ///< of the threat, on the committed plan when it was found
  bool meets_before;        ///< the plan in flight is not proven up to the takeover of `next`
  Contact before;           ///< the contact there; any contact of `next` is later
  bool has_alarm;
  Alarm alarm;  ///< what became solid since the committed plan was proven
  bool known;   ///< the committed plan is clear of everything but the alarm

  Blockage block;  ///< what ended the last proof or plan to the goal

  Nose nose;

  std::uint64_t frames;     ///< RollingMap::frames() at the last tick
  std::int64_t frame_time;  ///< when that number last grew

  // At rest.
  int idle_cycles;
  int late;               ///< plans that were dropped, one after the other
  int fruitless;          ///< new plans since the vehicle was nearest to the goal, or learned something
  int wandering;          ///< new plans since the vehicle was nearest to the goal
  std::uint64_t learned;  ///< RollingMap::learned() when the vehicle last learned something
  double nearest;         ///< the vehicle's least distance to the next point, metres; negative: not known yet
  bool is_looking;
  std::int64_t look_since;
  Vec3 stuck_at;          ///< where the vehicle rested when it began to look for a way on
  bool turned;            ///< the vehicle looked around at `stuck_at`
  bool seeks;             ///< the next plan leads to a lookout
  int lookouts;           ///< lookouts flown to since the vehicle last came nearer to the goal
  std::uint32_t sought;   ///< directions in which a lookout was sought, as bits
  std::int32_t searched;  ///< places that the search for a lookout has looked at
  Lookout lookout;        ///< the best lookout so far
  Vec3 look_at;           ///< the place that the sensor should see for the next plan, world frame
  FlightReport report;

  // flight.cpp
  std::int64_t time_to_answer(std::int64_t t) const noexcept;
  void set_clock(std::int64_t t) noexcept;
  Sample sample_at(std::int64_t t) const noexcept;
  const Commitment& commitment_at(std::int64_t t) const noexcept;
  /// The committed plan that will be flown to its end: the waiting plan, if there is one.
  const Commitment& latest() const noexcept { return has_next ? next : now; }
  std::int64_t rest_begins() const noexcept;
  bool rests() const noexcept { return !has_next && time >= rest_begins(); }
  /// Something is nearer than the radius to where the vehicle rests.
  bool is_beside() const noexcept { return threat && rests(); }
  /// The vehicle hovers: the plan in flight is over, even if another one waits, or it is the hover that start() begins
  /// with.
  bool hovers() const noexcept { return time >= rest_begins() || !(duration(now.flown) > kMinDuration); }
  /// The vehicle rests at the takeover, if no other plan takes over before. Two ticks more or less do not matter.
  bool rests_at_takeover() const noexcept { return takeover + 2 * spec.tick >= rest_begins(); }
  void take_over() noexcept;
  FlightMode mode() const noexcept;
  bool reads_map() const noexcept;
  void note_frame() noexcept;
  bool is_stale() const noexcept { return spec.stale_after > 0 && time - frame_time > spec.stale_after; }
  void finish_report(std::uint32_t spent) noexcept;

  // charge.cpp: what a tick spends
  Work begin_work() noexcept;
  void owe(std::uint32_t effort, Work& work) noexcept;
  void defer_debt() noexcept;
  Progress step_proof(Proof& of, Work& work) noexcept;
  void charge_planner() noexcept;
  Status step_planner(Work& work) noexcept;
  void step_map(Work& work) noexcept;

  // aim.cpp: where to, and where to look.
  void choose_aim(const Vec3& from, double most) noexcept;
  void choose_way_out(const Vec3& from) noexcept;
  bool keeps_aim(const Vec3& from) const noexcept;
  void follow_window() noexcept;
  Vec3 looking_at(std::int64_t t) const noexcept;
  double seconds_per_direction() const noexcept;
  int sector_at(std::int64_t t) const noexcept;
  bool is_before_goal() const noexcept;
  void look_at_obstacle() noexcept;
  void note_idle() noexcept;
  void park(FlightReason why) noexcept;
  void note_progress() noexcept;
  bool is_nearest() noexcept;
  bool move_to_reachable(const Report& found) noexcept;
  bool reaches_goal() const noexcept;
  void note_rest() noexcept;

  // lookout.cpp: from where to see what blocks the way
  void forget_lookouts() noexcept;
  void note_place() noexcept;
  bool seek_lookout() noexcept;
  /// The lookout that is sought is straight away from what is to be seen.
  bool goes_away() const noexcept { return (sought & kAway) != 0; }
  void begin_lookout() noexcept;
  Progress run_lookout(Work& work) noexcept;
  void look_from(std::int32_t direction, int radii, int height) noexcept;
  void end_lookout() noexcept;
  void aim_at_lookout() noexcept;
  Vec3 place_away() noexcept;
  void note_lookout() noexcept;
  Vec3 place_to_see() const noexcept;

  // blocked.cpp: what the report says is in the way
  void note_unproven() noexcept;
  void note_no_plan(const Report& found) noexcept;
  double note_block_near(const Vec3& place, const Grid& grid) noexcept;
  void note_block_beyond(const Vec3& reachable) noexcept;
  Blockage block_at(const Voxel& voxel) const noexcept;

  // mission.cpp: the points on the way
  void begin_mission(const Via* points, std::int32_t count, ViaPolicy policy) noexcept;
  void try_anew() noexcept;
  bool ends_at_dwell() const noexcept;
  std::int32_t leg_at(std::int64_t t) const noexcept;
  void pass_points() noexcept;
  void pass_point() noexcept;
  void go_on_from(std::int32_t point) noexcept;
  bool in_window(const Vec3& place) const noexcept;
  void choose_points(const Vec3& from) noexcept;
  void ask_for(std::int32_t point) noexcept;
  void ask_for_first(std::int32_t points) noexcept;
  bool ask_for_less(const Report& found) noexcept;
  void end_at_point(std::int32_t number) noexcept;
  void keep_points() noexcept;
  bool still_fits() const noexcept;
  double way_length(const Vec3& from, const Vec3& to) const noexcept;
  Vec3 place_before_target(const Vec3& from) const noexcept;
  void shorten_way(const Path& way) noexcept;
  bool is_blocked(std::int32_t point) const noexcept;
  std::int32_t point_at_fault(const Report& found) const noexcept;
  bool note_fault(const Report& found) noexcept;
  bool leave_out(std::int32_t point, FlightReason why) noexcept;
  bool is_outdated() const noexcept;
  void list_passages(const Report& found) noexcept;
  bool passes_later() const noexcept;

  // nose.cpp: where the nose points
  Status check_yaw(const FlightYaw& yaw) const noexcept;
  void set_yaw(const FlightYaw& yaw) noexcept;
  void drop_late_yaw() noexcept;
  void turn_nose(Work& work) noexcept;
  NoseWish nose_wish(std::int64_t t) const noexcept;
  void begin_yaw(const NoseWish& wish) noexcept;
  void time_headings(YawRequest& request) noexcept;
  void advance_yaw(Work& work, std::uint32_t kept) noexcept;
  YawSample yaw_at(std::int64_t t) const noexcept;
  void note_view() noexcept;
  bool waits_for_view() const noexcept;

  // cycle.cpp: a plan
  bool is_hemmed_in() const noexcept;
  void begin_cycle() noexcept;
  void begin_copy() noexcept;
  void advance(Work& work) noexcept;
  Progress run_job(Work& work) noexcept;
  Progress run_copy(Work& work) noexcept;
  Progress run_keep(Work& work) noexcept;
  void begin_plan() noexcept;
  void ask_route() noexcept;
  Progress run_route(Work& work) noexcept;
  void ask_planner() noexcept;
  bool move_aim(const Report& found) noexcept;
  Progress run_plan(Work& work) noexcept;
  void end_plan(const Report& found) noexcept;
  void choose_draft(bool planned) noexcept;
  void compose() noexcept;
  Progress prove(Work& work) noexcept;

  // start.cpp
  Status prove_start(FlightRefusal& refusal) noexcept;
  void refuse_start(FlightRefusal& refusal) const noexcept;

  // prove_draft.cpp: how much of the draft may be committed
  ProofGrounds grounds_of(const Commitment& commitment) const noexcept;
  Status begin_proof(const Trajectory& trajectory, double from) noexcept;
  double start_of_proof() const noexcept;
  Progress run_wait() noexcept;
  Progress run_reach(Work& work) noexcept;
  double earliest_branch() const noexcept;
  bool leads_on() const noexcept;
  bool make_branch() noexcept;
  Progress next_branch(Work& work) noexcept;
  Progress run_branch(Work& work) noexcept;
  Progress run_confirm(Work& work) noexcept;
  bool changes_what_is_flown() const noexcept { return !extends || draft.branch > now.branch; }
  void note_changed_map() noexcept;
  bool joins_what_is_flown() noexcept;
  void enter_draft() noexcept;
  bool commit() noexcept;
  void fail() noexcept;
  void give_up() noexcept;

  // evade.cpp
  std::int64_t evade_ticks() const noexcept;
  void begin_evade() noexcept;
  bool make_evasion() noexcept;
  bool append_evasion(const Commitment& flown, double from) noexcept;
  bool begin_brake_proof(BrakeProof what) noexcept;
  bool go_on_proving(bool proven) noexcept;
  bool helps(const Evasion& brake) const noexcept;
  int number_of_next() noexcept;
  void try_brakes() noexcept;
  void next_evasion() noexcept;
  Progress run_evade(Work& work) noexcept;
  void end_evade() noexcept;
  void miss_evasion() noexcept;
  bool leaves_time_to_brake() const noexcept;

  // watch.cpp
  void begin_watch() noexcept;
  void watch_part(Watched which) noexcept;
  void end_part() noexcept;
  void note_beside() noexcept;
  bool is_news() noexcept;
  void note_threat() noexcept;
  Contact watched_contact() const noexcept;
  void note_added() noexcept;
  const Commitment& watched_commitment() const noexcept { return watched_part == Watched::kBefore ? now : latest(); }
  void run_watch(Work& work) noexcept;
};

/// One of the kDirections level unit vectors of a full turn.
Vec3 offset_of(int direction) noexcept;

/// What is wrong with a mission; kOk if nothing is.
Status check_mission(const Via* points, std::int32_t count, ViaPolicy policy) noexcept;

}  // namespace tern

#endif
