// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The facts that every part of a flight reads: how to fly, the map, the time, the committed plans and the mission. Only
// the functions that join the parts write it.
#ifndef TERN_FLIGHT_FLIGHT_FACTS_HPP
#define TERN_FLIGHT_FLIGHT_FACTS_HPP

#include <cstdint>

#include "base/bounds.hpp"
#include "curve/hermite.hpp"
#include "flight/committed_plans.hpp"
#include "flight/flight_clock.hpp"
#include "flight/itinerary.hpp"
#include "flight/lift.hpp"
#include "flight/stray.hpp"
#include "tern/flight.hpp"
#include "tern/map.hpp"

namespace tern {

/// Of a tick, and of the time for an answer, ns.
constexpr std::int64_t kLongestTick = std::int64_t{10} * 1000000000;

/// Voxels that an aim keeps from the window's faces, besides the radius. An aim must also be nearer to the goal by more
/// than this to count as nearer.
constexpr double kAimVoxels = 2.0;
/// Stands for no limit on a distance, metres.
constexpr double kAnywhere = 1e9;
/// Points of a way that are nearer to each other than this count as the same, metres.
constexpr double kSamePlace = 1e-6;

struct FlightFacts {
  FlightSpec spec;                    ///< its fences are those below
  const Fence* asked_fences;          ///< the caller's
  Fence fences[kMaxFences];           ///< the same, with the flight's times
  bool has_windows;                   ///< some of them are for a while
  bool has_chain;                     ///< some of those are keep-ins
  bool meet[kMaxFences][kMaxFences];  ///< two keep-ins for a while have a place in common
  MotionLimits limits;                ///< those of the spec
  RollingMap map;
  FlightClock clock;
  std::int64_t shown;  ///< what the clock showed at the last tick
  std::int64_t time;   ///< of the last tick, in nanoseconds since the start, as all times of a flight
  std::int64_t gap;    ///< between the last two ticks
  CommittedPlans plans;
  Itinerary itinerary;
  Landing landing;  ///< what follows at the goal, if it is asked for
  Stray stray;
  TrackTable tracks;        ///< the last measurement of each thing that moves
  std::uint64_t frames;     ///< RollingMap::frames() at the last tick
  std::int64_t frame_time;  ///< of the tick at which `frames` last grew

  /// The vehicle hovers at `position`, and the clock shows `t`.
  void begin(const FlightSpec& how, const RollingMap& over, const Vec3& position, std::int64_t t) noexcept;
  /// The clock shows `t` at this tick.
  void begin_tick(std::int64_t t) noexcept;
  /// The clock was set and shows `t` one tick after the last one.
  void set_clock(std::int64_t t) noexcept;
  /// True if there are new frames.
  bool note_frame() noexcept;
  /// The vehicle was measured at `position` when the clock showed `t`. True if less speed is left than before.
  bool note_position(const Vec3& position, std::int64_t t) noexcept;
  /// Reads a measurement of a thing that moves, at a time of the clock: see Flight::update_track(). `taken` receives it
  /// with the flight's times.
  Status read_track(const Track& measured, Track& taken) const noexcept;
  /// Moves the map's window after the vehicle, as far as it must.
  void follow_vehicle() noexcept;

  /// The flight's time to answer for: never before the last tick, because the past is never commanded again.
  std::int64_t time_to_answer(std::int64_t t) const noexcept;
  /// Where the vehicle is at this tick, world frame.
  Vec3 position() const noexcept;
  bool rests() const noexcept { return !plans.has_waiting && time >= plans.rest_begins(); }
  /// The vehicle hovers: the plan in flight is over, even if another one waits, or it is the hover that start() begins
  /// with.
  bool hovers() const noexcept {
    return time >= plans.rest_begins() || !(duration(plans.in_flight.trajectory) > kMinDuration);
  }
  /// The plan in flight leads down to where the vehicle is to land.
  bool lands() const noexcept {
    return landing.is_asked && plans.in_flight.lands && plans.in_flight.mission == itinerary.number;
  }
  /// The vehicle rests at this takeover, or within two ticks of it, if no other plan takes over before.
  bool rests_at(std::int64_t takeover) const noexcept { return takeover + 2 * spec.tick >= plans.rest_begins(); }
  /// A plan may begin at any time: the vehicle hovers, and nothing that it keeps clear of changes with time.
  bool takes_plans_at_any_time() const noexcept {
    return hovers() && !plans.has_waiting && tracks.count == 0 && !has_windows && spec.clearance == 0;
  }
  /// At this takeover, the vehicle is faster than a plan may be that begins there.
  bool is_too_fast_at(std::int64_t takeover) const noexcept;
  /// Ticks that are left to others to answer whether a plan may be flown.
  std::int64_t clearance_ticks() const noexcept { return (spec.clearance + spec.tick - 1) / spec.tick; }
  bool is_stale() const noexcept { return spec.stale_after > 0 && time - frame_time > spec.stale_after; }
  /// A plan may end at this place: it keeps the radius and kAimVoxels from the window's faces.
  bool in_window(const Vec3& place) const noexcept;

 private:
  /// Takes the caller's fences, by what the clock shows.
  void read_fences() noexcept;
};

}  // namespace tern

#endif
