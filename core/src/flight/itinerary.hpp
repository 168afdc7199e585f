// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A mission: its points, how far it has come, and whether the flight should go on. A goal alone is a mission of one
// point.
#ifndef TERN_FLIGHT_ITINERARY_HPP
#define TERN_FLIGHT_ITINERARY_HPP

#include <cstdint>

#include "flight/committed_plans.hpp"
#include "tern/flight.hpp"
#include "tern/report.hpp"
#include "tern/via.hpp"

namespace tern {

struct FlightFacts;

/// How many plans must find a point blocked before it counts as unreachable. A wrong pixel does not block it for that
/// long.
constexpr int kBlockedPlans = 3;
/// kFruitless: new plans that may be committed without coming nearer to the next point and without learning kLearned
/// words of the map. kWandering: new plans that may be committed without coming nearer, whatever they learn.
constexpr int kFruitless = 150;
constexpr std::uint64_t kLearned = 64;
constexpr int kWandering = 1500;
/// For so long, things that move may keep the vehicle where it is, or push it, without it coming nearer to the next
/// point, nanoseconds.
constexpr std::int64_t kPatience = 60000000000;

/// What follows if a point cannot be reached.
enum class LeftOut : std::uint8_t {
  kNothing,  ///< the mission goes on as it is
  kSkipped,  ///< the mission goes on without the point
  kLeg,      ///< the mission goes on to another next point
  kEnded,    ///< the mission ended
};

struct Itinerary {
  Via points[kMaxMissionPoints];  ///< the last one is the goal
  PointState state[kMaxMissionPoints];
  std::int32_t count;
  std::int32_t leg;  ///< the next point
  ViaPolicy policy;
  bool has_goal;
  std::uint32_t number;  ///< counts the missions
  bool parked;           ///< no more plans until the next goal
  FlightReason reason;
  std::int32_t suspect;   ///< the point that was last found blocked
  int suspicions;         ///< how many plans found the suspect blocked
  double nearest;         ///< the vehicle's least distance to the next point, metres; negative: not known yet
  int fruitless;          ///< new plans since the vehicle was nearest to that point, or learned something
  int wandering;          ///< new plans since the vehicle was nearest to that point
  bool is_held_up;        ///< by things that move
  std::int64_t held_up;   ///< for so long since the vehicle was nearest to that point, nanoseconds
  std::uint64_t learned;  ///< RollingMap::learned() when the vehicle last learned something

  void begin(const Via* mission_points, std::int32_t point_count, ViaPolicy mission_policy) noexcept;
  /// Forgets all reasons to give up.
  void try_anew() noexcept;
  /// True: something that moves keeps the vehicle from going on, or pushed it away. False: a plan leads on.
  void note_held_up(bool by_thing) noexcept;
  /// Counts the time for which the vehicle is held up. True if that is too long.
  bool waits_too_long(std::int64_t gap) noexcept;
  void park(FlightReason why) noexcept;
  void forget_goal() noexcept;
  void pass(std::int32_t point) noexcept { state[point] = PointState::kPassed; }
  /// Notes the points that were passed until now. True if there are any.
  bool pass_points(const FlightFacts& flight) noexcept;
  void go_on_from(std::int32_t point) noexcept { leg = after(point); }
  /// The suspect may be clear on the map as it is now.
  void clear_suspicion(const FlightFacts& flight) noexcept;
  /// A plan found the point blocked. `lasts`: the cause cannot go away. True if the point now counts as unreachable.
  bool suspect_point(std::int32_t point, bool lasts) noexcept;
  /// Leaves out a point as the mission's policy says. The mission ends only if the point is the next one.
  LeftOut leave_out(std::int32_t point, FlightReason why) noexcept;
  /// Counts a new plan from this place that is about to be committed. True if it comes nearer to the next point.
  bool count_plan(const FlightFacts& flight, const Vec3& from) noexcept;

  /// There is a point to fly to, and the flight did not give up.
  bool goes_on() const noexcept { return has_goal && !parked; }
  std::int32_t last() const noexcept { return count - 1; }
  /// The first point after `point` that is not skipped. The goal is never skipped.
  std::int32_t after(std::int32_t point) const noexcept;
  /// The next point at time `t`, if nothing else is committed before. A point with a dwell is passed once the dwell is
  /// over.
  std::int32_t leg_at(const Commitment& in_flight, std::int64_t t) const noexcept;
  /// The plan ends at the goal.
  bool is_reached_by(const Commitment& plan) const noexcept;
  /// The plan ends at a point with a dwell, and the dwell is not over.
  bool dwells_after(const Commitment& plan) const noexcept;
  /// True if no point that the plan passes was skipped since, and its target is still ahead.
  bool still_fits(const Commitment& plan) const noexcept;
  /// Something that was seen is nearer to the point than the radius.
  bool is_blocked(const FlightFacts& flight, std::int32_t point) const noexcept;
  /// The next point is in an obstacle that was seen, and the vehicle is right before it.
  bool is_right_before(const FlightFacts& flight) const noexcept;
  /// New plans lead nowhere: the flight should give up.
  bool is_hopeless() const noexcept { return fruitless > kFruitless || wandering > kWandering; }
  std::int32_t count_points(PointState which) const noexcept;
};

/// kOk, or the fault of a mission.
Status check_mission(const Via* points, std::int32_t count, ViaPolicy policy) noexcept;

}  // namespace tern

#endif
