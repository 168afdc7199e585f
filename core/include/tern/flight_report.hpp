// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a flight says: what the vehicle is doing, why it rests or flies slower, what is in the way, and why a flight was
// refused.
#ifndef TERN_FLIGHT_REPORT_HPP
#define TERN_FLIGHT_REPORT_HPP

#include <stdint.h>

#include "tern/fence.hpp"
#include "tern/status.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// What keeps a flight from going on, or from beginning.
enum class BlockedBy : uint8_t {
  kNothing = 0,  ///< nothing that is known
  kUnseen,       ///< a voxel that no sensor has shown to be free yet: let one look there
  kObstacle,     ///< a voxel with something that was seen or marked
  kWindow,       ///< the face of the map's window, beyond which nothing is known
  kFence,        ///< a fence
  kTrack,        ///< something that moves: see Flight::update_track()
};

/// In English, for logs: "a voxel that was not seen free yet". Static strings; "unknown" for other numbers.
const char* blocked_by_text(BlockedBy by) noexcept;

/// Why Flight::start() refused, or what Flight::check_goal() found.
struct FlightRefusal {
  /// The field of FlightSpec, of the map or of the call. kNone if nothing was refused.
  Field field = Field::kNone;
  /// For kFences, and for a start that breaks a fence: the index in FlightSpec::fences; kNoFence if their pointer or
  /// count is wrong. Otherwise kNoFence.
  int32_t fence = kNoFence;
  /// For kStartOccupied: the nearest thing that is not known to be free, kUnseen, kObstacle or kWindow. For
  /// kGoalOccupied: kObstacle.
  BlockedBy blocked_by = BlockedBy::kNothing;
  /// Where, world frame, metres: the centre of that voxel, the nearest point of the window's face, or the stated
  /// ground.
  Vec3 blocked_at = {0.0, 0.0, 0.0};
  /// The start's or the goal's distance from that voxel's cube, that face or that ground, metres.
  double distance = 0.0;
  /// The least distance allowed, metres: the map's radius plus its tracking margin.
  double needed = 0.0;
};

/// What the vehicle is doing.
enum class FlightMode : uint8_t {
  kRest = 0,  ///< hovering
  kLook,      ///< hovering, and turning the sensor to where space is unknown
  kFly,       ///< on the way
  kStop,      ///< on the brake that ends the committed plan; a new plan may still take over
  kThreat,    ///< the committed plan is no longer proven on the map as it is now. At rest, this lasts for 0.3 s after
              ///< something came nearer than the radius, or nearer than before; then FlightReport::blocked_by tells
};

/// Why the vehicle rests, does not go on, or flies slower.
enum class FlightReason : uint8_t {
  kNone = 0,    ///< it flies as fast as it may, or is about to fly
  kNoGoal,      ///< there is no goal: none was set yet, or stop() took it away
  kArrived,     ///< it rests at the goal
  kNearest,     ///< the goal is occupied or cut off, and the vehicle rests as near to the goal as it can
  kNoProgress,  ///< after a look around there is still no way. set_goal() makes it try again
  kHemmedIn,    ///< after a look around there is still no way, and something is nearer to the vehicle than the radius
  kViaBlocked,  ///< the mission ended: its next point is in an obstacle or breaks a fence
  kViaUnreachable,  ///< the mission ended: after a look around there is still no way to its next point
  kMapStale,        ///< there is no way through known space, and no frames come. The flight goes on with the next frame
  kStrays,          ///< in flight: it flies slower, because it strays by more than 60 % of the tracking margin
  kMarginExceeded,  ///< in flight: likewise, and it strayed by more than the margin. Then no proof covers the vehicle
  kLanded,          ///< it stands where it was to land
  kGroundUnseen,    ///< it cannot land: the ground there, or what is above it, was not seen
  kGroundUneven,    ///< it cannot land: the ground there is not flat, or something is on it or above it
  kGoalUnseen,  ///< as kNoProgress: what the way to the goal needs was looked at in vain, or can be seen from nowhere
  kHeldUp,  ///< things that move have kept it from going on, or pushed it, for a minute. set_goal() makes it try again
};

/// The views of a voxel that are remembered: the last ones.
constexpr int32_t kRememberedViews = 4;
/// A voxel that the vehicle looked at in vain.
struct UnseenVoxel {
  Vec3 center;  ///< world frame
  /// How often it was looked at, and the last directions from which: unit vectors from the lookout to the voxel, of
  /// which min(views, kRememberedViews) are set, in no order.
  int32_t views;
  Vec3 directions[kRememberedViews];
};

/// What became of a point of a mission.
enum class PointState : uint8_t {
  kAhead = 0,
  kPassed,   ///< within its tolerance. The goal: the vehicle rests there
  kSkipped,  ///< it could not be reached
};

/// In English, for logs: "fly", and "there is no way that can be proven free". Static strings; "unknown" for other
/// numbers.
const char* flight_mode_name(FlightMode mode) noexcept;
const char* flight_reason_text(FlightReason reason) noexcept;

/// What one tick did.
struct FlightReport {
  FlightMode mode;
  FlightReason reason;
  /// Answer of the last plan. kOk, too, if none was better than what is left of the plan in flight.
  Status plan;
  /// Plans begun, committed, dropped because they were late, and failed. A plan fails if the planner finds none, or if
  /// nothing of it can be proven.
  uint32_t asked, committed, dropped, failed;
  /// Units that this tick spent.
  uint32_t work;
  /// For kThreat: the time until which the committed plan is proven, and the speed there, m/s. Otherwise 0.
  int64_t contact_time;
  double contact_speed;
  /// The mission's next point, and how many were passed and skipped. Flight::point_state() says which.
  int32_t leg, passed, skipped;
  /// True if the next thing to see is outside the sensor's field of view (FlightYaw::field_of_view): the limits on the
  /// yaw slow the flight.
  bool waits_for_nose;
  /// True if no frame was entered into the map for longer than FlightSpec::stale_after. The committed plan is as safe
  /// as ever, but ends where the known space ends.
  bool map_stale;
  /// Nanoseconds since a tick last found that a frame or scan was begun; since start(), if there was none.
  int64_t frame_age;
  /// What ended the proof of the last plan or, if no plan was found, what is in its way. kNothing at the goal, without
  /// a goal, and if the last plan was proven to its end. But while something is nearer to the resting vehicle than the
  /// radius, this is the nearest such thing. No decision depends on it.
  BlockedBy blocked_by;
  /// Where, world frame, metres: the centre of the voxel that is too near to the way; for kWindow, kFence and kTrack, a
  /// point of the way, or where it was to lead. Zero for kNothing.
  Vec3 blocked_at;
  /// For kFence: its index in FlightSpec::fences. Otherwise kNoFence.
  int32_t blocked_fence = kNoFence;
  /// Distance of the vehicle from its plan, metres, as it was last measured; 0 without Flight::note_position().
  double stray = 0.0;
  /// The part of the limits on speed that new plans keep: 1, or less while the vehicle strays.
  double speed_share = 1.0;
};

}  // namespace tern

#endif
