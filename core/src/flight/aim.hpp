// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where the pending plan leads, and which points of the mission it passes on the way.
#ifndef TERN_FLIGHT_AIM_HPP
#define TERN_FLIGHT_AIM_HPP

#include <cstdint>

#include "curve/hermite.hpp"
#include "flight/flight_facts.hpp"
#include "tern/path.hpp"
#include "tern/report.hpp"
#include "tern/via.hpp"

namespace tern {

struct Aim : Destination {
  JointState start;     ///< the state at the takeover, world frame
  Via asked[kMaxVias];  ///< the points that the plan passes
  std::int32_t asked_point[kMaxVias];
  std::int32_t asked_count;
  Vec3 target_place;  ///< world frame
  bool moved;         ///< the place was replaced by the nearest free point
  bool at_reachable;  ///< the place was replaced by the nearest reachable point, because no way led to it

  void begin(const JointState& from, std::uint32_t mission_number) noexcept;
  /// A new mission begins, with its first point here.
  void expect(const Vec3& first) noexcept { target_place = first; }
  /// Chooses the points to pass, and the target.
  void choose_points(const FlightFacts& flight, std::int64_t takeover) noexcept;
  /// Asks for the points that the plan in flight still passes, for a plan to the same place.
  void follow_points(const Commitment& in_flight, const Itinerary& itinerary, std::int64_t takeover) noexcept;
  /// Leads to the same place as the plan in flight.
  void follow_place(const Commitment& in_flight) noexcept;
  /// Leads to the target if that is at most `most` away and within the window. Otherwise leads along the straight line
  /// from the last point to pass, as far as both allow.
  void choose_place(const FlightFacts& flight, double most) noexcept;
  /// Leads one radius straight away from the obstacles within the radius of the start.
  void choose_way_out(const FlightFacts& flight) noexcept;
  void lead_to(const Vec3& elsewhere) noexcept;
  /// Passes only the first `number` of the points that are asked for; the one after them becomes the target. `cell`:
  /// edge of a voxel.
  void pass_first(std::int32_t number, const Itinerary& itinerary, double cell) noexcept;
  /// Ends at rest at point `number` of those that are asked for.
  void end_at_point(std::int32_t number, const Itinerary& itinerary) noexcept;
  /// A plan past all points that were asked for failed. Asks for one that ends at rest at the last point that may be
  /// reached.
  void ask_for_less(const Report& found, const Itinerary& itinerary) noexcept;
  /// The mission is over: no plan passes its points, or ends at its target.
  void forget_points() noexcept;
  /// If the way past the points is longer than a horizon, moves the place to the point one horizon along it.
  void shorten(const Path& way, const GridSpec& window, double horizon, const Itinerary& itinerary) noexcept;
  /// If the place is in an obstacle, moves it to the nearest free point, once. False if the place stays.
  bool move_to_free(const Report& found) noexcept;
  /// After move_to_free(): notes that the plan ends beside the target, if the place was the target. If the plan
  /// `followed` ends beside the same target, further from it by `slack` at most, the new plan ends there, too. Null:
  /// none is followed.
  void end_beside(const Commitment* followed, double slack) noexcept;
  /// If a thing that stands still, or whose curve ends, comes to rest too near to the place, moves the place back along
  /// the straight line from the last point to pass, as far as it must, or to that point: true if it did. `cell`: edge
  /// of a voxel.
  bool leave_room(const TrackTable& things, double clearance, double cell) noexcept;
  void move_to_reachable(const Vec3& reachable) noexcept;
  /// Leads to the point one horizon along the straight line, because there is no path.
  void return_to_line(const FlightFacts& flight) noexcept;

  /// Metres along straight lines past the points that are asked for, to `to`.
  double way_length(const Vec3& to) const noexcept;
  /// The last point that the plan passes, or its start.
  const Vec3& place_before_target() const noexcept {
    return asked_count > 0 ? asked[asked_count - 1].position : start.d[0];
  }
  /// True if a new mission began after the plan. The plan may be flown, but passes none of the new points. Its failure
  /// says nothing about them.
  bool is_outdated(const Itinerary& itinerary) const noexcept { return mission != itinerary.number; }
  /// The point at which a plan failed, if it may be left out; otherwise negative.
  std::int32_t point_at_fault(const Report& found, const Itinerary& itinerary) const noexcept;

 private:
  void ask_for(std::int32_t point, const Itinerary& itinerary) noexcept;
};

}  // namespace tern

#endif
