// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Flying through a world that is discovered: a RollingMap is filled by the vehicle's sensors, a Planner makes plans on
// it, and a Flight decides which plans the vehicle follows. A committed plan ends at rest, and was proven clear of all
// space that is not known to be free. docs/flight.md has the rules and what they promise.
#ifndef TERN_FLIGHT_HPP
#define TERN_FLIGHT_HPP

#include <stddef.h>
#include <stdint.h>

#include "tern/fence.hpp"
#include "tern/flight_report.hpp"
#include "tern/flight_sensor.hpp"
#include "tern/map.hpp"
#include "tern/planner.hpp"
#include "tern/request.hpp"
#include "tern/status.hpp"
#include "tern/track.hpp"
#include "tern/trajectory.hpp"
#include "tern/vec3.hpp"
#include "tern/via.hpp"
#include "tern/yaw.hpp"

namespace tern {

/// How to fly. The distance kept from obstacles is the map's radius plus its tracking margin; the radius must cover the
/// body and the error of its pose.
struct FlightSpec {
  /// Limits of every plan and every brake, as Request::limits.
  Limits limits;
  /// As Request::time_weight.
  double time_weight;
  /// Nanoseconds from one tick to the next, > 0, at most 10 s.
  int64_t tick;
  /// Units of work that a tick may spend, 256 at least. A unit takes about a thousand instructions.
  uint32_t work_per_tick;
  /// Units after which a plan is dropped, > 0. plan_work and work_per_tick give the number of ticks by which a plan
  /// begins before its takeover.
  uint32_t plan_work;
  /// How far ahead plans lead, metres, > 0 and less than half the window's length along x. Choose a little less than
  /// the map's range.
  double horizon;
  /// Up to this distance from the vehicle along each axis, plans take unseen voxels for solid. Metres, >= 0.
  double near;
  /// How fast the vehicle turns its sensor, rad/s, >= 0.001. A look around gives each direction the time of that turn.
  double yaw_rate;
  /// Geofences, `fence_count` of them, valid as for a Request, or null. All committed plans respect them; fences for a
  /// while, up to where the plan rests. They and their half-spaces are yours and must outlive the flight, unchanged.
  const Fence* fences = nullptr;
  int32_t fence_count = 0;
  /// Nanoseconds without a new frame after which FlightReport::map_stale is true, >= 0; 0: never, for flights over a
  /// map that nobody fills.
  int64_t stale_after = 1000000000;
  /// The sensor, as the flight takes it into account when it chooses from where to look.
  FlightSensor sensor = kLevelCamera;
  /// Nanoseconds that are left to others to answer whether a plan may be flown, >= 0, at most 10 s; 0: plans need no
  /// clearance. Else each plan waits for Flight::answer() before it is committed, and begins so much later.
  int64_t clearance = 0;
};

/// A spec with common values: time weight 1000, 100 ticks a second, 4000 units a tick and 16000 a plan, horizon 8 m,
/// near half of what the vehicle flies in a second and 2.5 m at most, yaw rate 2.5 rad/s, a map that is stale after a
/// second without frames, and a level camera.
FlightSpec flight_spec(const Limits& limits) noexcept;

/// Words of 64 bits that a flight needs for a map of these dimensions; 0 if they are out of range.
size_t flight_words(const Voxel& dims) noexcept;

/// Points of a mission, at most: the vias and the goal.
constexpr int32_t kMaxMissionPoints = kMaxVias + 1;

/// Things that move that a flight knows at once, at most. Each committed plan keeps a copy of them.
constexpr int32_t kMaxFlightTracks = kMaxTracks < 64 ? kMaxTracks : 64;

/// Pieces of their curves that a flight keeps, at most: those of the latest curves, kMaxTrackPieces at most, and those
/// that committed plans were proven with.
constexpr int32_t kMaxFlightPieces = 2 * kMaxTrackPieces;

/// What happens if a point of a mission, other than the goal, cannot be reached.
enum class ViaPolicy : uint8_t {
  kEnd = 0,  ///< the mission ends: the vehicle comes to rest and says why
  kSkip,     ///< the vehicle goes on to the next point
};

/// Where the nose points in flight. In every mode, a vehicle that rests and looks for its way turns to the space that
/// the next plan needs to see.
enum class FlightYawMode : uint8_t {
  kTowardsUnseen = 0,  ///< to the first point of the way that is not proven yet
  kAlongMotion,        ///< along the horizontal velocity
  kTowardsPoint,       ///< to FlightYaw::point, seen from above
  kFixed,              ///< to FlightYaw::heading
  kAtPoints,           ///< passes each point of the mission with its heading of FlightYaw::headings
};

/// How to turn the nose, and a sensor that is fixed to it. The limit on the rate is FlightSpec::yaw_rate, which must
/// then be within 0.01 .. 100.
struct FlightYaw {
  FlightYawMode mode;
  /// Limit on the angular acceleration, rad/s^2, 0.01 .. 1000.
  double acceleration_max;
  /// The sensor's horizontal field of view, rad, 0 .. 2 pi; 0 if FlightReport::waits_for_nose does not matter.
  double field_of_view;
  /// The heading at rest; only the first set_yaw() after start() reads it.
  Heading start;
  Heading heading;  ///< for kFixed
  Vec3 point;       ///< for kTowardsPoint: world frame, m
  /// For kAtPoints: one heading for each point of the mission, copied; points beyond the last one have its heading.
  const Heading* headings;
  int32_t heading_count;  ///< 1 .. kMaxMissionPoints
};

/// The command for one time.
struct Command {
  /// Position to snap, world frame.
  Sample sample;
  /// Where to point the sensor, world frame, metres.
  Vec3 look_at;
};

class FlightState;

/// A flight over a map and a planner, in words of yours. All three must outlive it, and nobody else may step or slide
/// the map, or plan with the planner, while it is in use. Enter frames with RollingMap::begin_frame() whenever the map
/// is not busy; tick() does the rest. Copies share the flight. It is not thread-safe.
///
/// Times are nanoseconds of a clock of yours, which may show any number. Choose one that nobody sets: a clock that
/// leaps ahead takes the command along. No decision depends on any other clock, so a recorded flight replays to the
/// same bits.
class Flight {
 public:
  /// Begins at rest at `position`, world frame, at time `t`, hovering or on the ground (RollingMap::assume_column):
  /// then the flight climbs straight up before it goes anywhere. `words`: flight_words() of them with any content. kOk;
  /// kNonFiniteInput; kInvalidArgument (spec out of range, map not bound, busy or with radius 0, a window too short for
  /// the horizon, too few words, a malformed fence); kLimitsInvalid; kFencesFull, kFencePlanesFull or kFenceEmpty;
  /// kStartOccupied if not all within the radius was seen free (see RollingMap::assume_free); kStartFenced if the
  /// position breaks a fence that holds at `t`. A refused call leaves the flight without a binding. `refusal` receives
  /// what is wrong; it may be null.
  Status start(const FlightSpec& spec, const RollingMap& map, Planner& planner, uint64_t* words, size_t word_count,
               const Vec3& position, int64_t t, FlightRefusal* refusal = nullptr) noexcept;
  /// Sets the goal, world frame. It may be anywhere, also beyond the window or in an obstacle. kNonFiniteInput leaves
  /// the goal as it was; kInvalidArgument before start().
  Status set_goal(const Vec3& goal) noexcept;
  /// Says what is known of a goal at once, before or after it is set, and changes nothing: kOk, if nothing that was
  /// seen, marked or stated (RollingMap::assume_column) is nearer to it than the radius, but what was not seen may be;
  /// kGoalOccupied, if something is, and a flight would end beside it; kGoalFenced, by a fence that always
  /// holds; kNonFiniteInput; kInvalidArgument before start(). `why` receives what is in the way; it may be null. For a
  /// goal at the ground, fly to a point that is FlightRefusal::needed above it, or call land(). Reads the voxels within
  /// the radius of the goal.
  Status check_goal(const Vec3& goal, FlightRefusal* why = nullptr) const noexcept;
  /// Sets a mission in place of the goal: the vehicle passes points[0] to points[count - 2] in order, with speed, and
  /// ends at the last one, the goal. Each point is passed within its tolerance, but for 1e-9 m. If its `stop` is true,
  /// the vehicle comes to rest there, and stays for its `dwell`. The goal's tolerance, stop and dwell mean nothing,
  /// whatever they are. The points are copied. `policy` says what happens if a point is in an obstacle, breaks a fence
  /// or cannot be reached. The goal is treated as set_goal() does. kOk; or a refusal, which leaves the goal as it was:
  /// kNonFiniteInput; kViasFull (more than kMaxMissionPoints); kInvalidArgument (no points, a negative tolerance, a
  /// velocity, no such policy, or before start()).
  Status set_mission(const Via* points, int32_t count, ViaPolicy policy) noexcept;
  /// Lands: flies to the point above `place` that keeps the radius and a voxel from the voxels of ground, then descends
  /// straight to it, at most at `speed`, m/s, and rests there. `place`: where the vehicle's centre is once it stands,
  /// world frame. `ground`: a height that the ground around it does not exceed, errors of the sensor included. Within
  /// the radius and one and a half voxels of `place`, seen from above, voxels that reach below `ground` count as
  /// ground, and the vehicle may come as near to them as it stands. From all others it keeps the radius. The ground
  /// must have been seen there, within two voxels below `ground`, or have been stated (RollingMap::assume_column).
  /// FlightReport::reason becomes kLanded, kGroundUnseen or kGroundUneven. Any other goal takes off again. kOk;
  /// kNonFiniteInput; kInvalidArgument (before start(), no speed > 0, or `place` no lower than that point).
  Status land(const Vec3& place, double ground, double speed) noexcept;
  /// What became of a point of the mission. kAhead for a number that is no point.
  PointState point_state(int32_t point) const noexcept;
  /// The voxels that the vehicle looked at in vain on its way to the next point, from lookouts: for
  /// FlightReason::kGoalUnseen, why it gave up, and the views that it tried. Writes the first `capacity` of them to
  /// `voxels`, which may be null if that is 0. Returns how many there are, 64 at most; 0 before start(). They are
  /// forgotten with a new goal, once a point is passed, and before the last search of a flight that gives up.
  int32_t looked_in_vain(UnseenVoxel* voxels, int32_t capacity) const noexcept;
  /// From now on, plans yaws beside the committed plans. Without this call, yaw() is 0. May be called again at any
  /// time: the nose goes on from where it is, though an acceleration beyond a new, lower limit steps down to it. kOk;
  /// or a refusal, which changes nothing: kNonFiniteInput; kLimitsInvalid; kInvalidArgument (before start(), a mode
  /// that is none, a heading without direction, too many headings or none, a field of view out of range). Fields that
  /// the mode does not read may hold anything.
  Status set_yaw(const FlightYaw& yaw) noexcept;
  /// Where the nose points at time `t`, with rate and acceleration: all three are continuous, however ticks come. The
  /// angle begins within half a turn of 0 and counts whole turns from there. Every time has an answer, as for
  /// command().
  YawSample yaw(int64_t t) const noexcept;
  /// Comes to rest soon and forgets the goal. With FlightSpec::clearance, the vehicle follows the committed plan to its
  /// end, since a brake would be another plan. kInvalidArgument before start().
  Status stop() noexcept;
  /// Does one tick's work: continues the map's job, proves the committed plan anew where the map changed, and continues
  /// the pending plan. Call it every FlightSpec::tick; if ticks are skipped, plans come late and are dropped. kOk;
  /// kClockBehind if `t` is before the last tick's, and nothing was done; kInvalidArgument before start(). `report` is
  /// always filled: if nothing was done, with the last report.
  Status tick(int64_t t, FlightReport& report) noexcept;
  /// Does one tick's work without a report.
  Status tick(int64_t t) noexcept;
  /// The command for time `t`. Every time has an answer. A time before the last tick gets the answer for the last tick,
  /// so that nothing is flown twice. After the end, the answer is rest. Before start(), it is zeros.
  Command command(int64_t t) const noexcept;
  /// Says where the vehicle was measured to be at time `t`, world frame. Call it with every pose. A pose from more than
  /// 0.1 s before the plan in flight began is ignored. The flight compares the distance from the plan with the map's
  /// tracking margin. Beyond 60 % of it, the vehicle brakes along its path and flies on at half the speed; beyond 80 %,
  /// at a quarter. After 3 s within half of the distance at which a step began, it flies faster again by one step.
  /// FlightReport::reason says so in flight. kOk; kNonFiniteInput; kInvalidArgument before start(). A flight without
  /// this call takes the vehicle to be where the plan is.
  Status note_position(const Vec3& position, int64_t t) noexcept;
  /// A thing that moves was measured, or is expected: `track` says where and when, how wrong that may be, and what the
  /// thing may do; its `id` says who it is. It takes the place of the last measurement with this id. Call it with every
  /// measurement. From then on, plans keep clear of what the thing is expected to do, and every plan that is committed
  /// is proven clear of all that it may do. A measurement that shows a thing outside the tube that the committed plan
  /// was proven with is handled like a new obstacle: the plan is proven anew, and if that fails, the vehicle brakes. A
  /// thing that is measured no more is not forgotten: its tube grows on. See docs/flight.md for what is promised.
  ///
  /// A track with pieces, as track_of() makes it of another vehicle's plan, is taken at its word: plans and proofs keep
  /// clear of the curve and its error. The pieces are copied. It may begin later than now. Each new curve of a thing is
  /// a measurement outside its tube, unless plans need a clearance: who gives that keeps curves clear of them.
  ///
  /// kOk; or a refusal, which leaves the thing as it was: kNonFiniteInput; kTracksFull (kMaxFlightTracks are known);
  /// kTrackPiecesFull (more than kMaxTrackPieces with those of all other things, or no kMaxFlightPieces are left while
  /// committed plans hold older ones: then it may be taken a second later); kClockBehind (older than the last
  /// measurement of this thing); kInvalidArgument (a track that a Request may not have, one without pieces that was
  /// measured more than a tick after the last tick, or before start()).
  Status update_track(const Track& track) noexcept;
  /// The thing with this id is gone for certain, or was taken for something else: new plans and proofs leave it out.
  /// kOk; kInvalidArgument if there is none, or before start().
  Status forget_track(uint32_t id) noexcept;
  /// The plan that waits for its clearance, and the number of that question; 0 if none waits. `plan` is what the
  /// vehicle would follow from `takeover` on, up to rest; its beginning, and `takeover`, are on the clock of tick(),
  /// and up to then it is the committed plan. Ask after each tick. The plan is withdrawn without an answer if it is
  /// late, a threat calls for a brake or there is another goal: then the number is another one or 0. For flights with
  /// FlightSpec::clearance.
  uint32_t proposal(Trajectory& plan, int64_t& takeover) const noexcept;
  /// Answers that question. A plan that may be flown is proven once more, on the map as it is, then committed:
  /// proposal() is 0 from now on, and FlightReport::committed rises or, if that fails, FlightReport::failed or dropped.
  /// Any other plan is dropped, the committed one stays, and the next one is asked for. The answer may be changed to
  /// false before the tick at which the plan takes over: then it is not flown, and FlightReport::dropped rises. Not so
  /// for a plan that goes on along the committed one, which counts as flown from its commit on. kOk; kInvalidArgument
  /// if no plan with this number waits.
  Status answer(uint32_t number, bool may_fly) noexcept;
  /// Gives answers another time than FlightSpec::clearance did, from the next plan on. kOk; kInvalidArgument for a time
  /// that is not above 0 and at most 10 s, for a flight whose plans need no clearance, or before start().
  Status set_clearance(int64_t clearance) noexcept;
  /// Until when the place where the committed plan ends stays clear of the tubes of all things that move, and of fences
  /// for a while, on the clock of tick(): a vehicle that rests there may be run into later. The answer is that of the
  /// last tick, and may lie in the past. INT64_MAX if nothing comes within kRestHorizon, or before start(). A proof
  /// that takes more than a quarter of a tick's work goes on in the next ticks; until it ends, the answer is the time
  /// from which on it proves.
  int64_t rest_clear_until() const noexcept;
  /// The clock was set, back or ahead, and shows `t` now: one FlightSpec::tick after the last tick. From there the
  /// flight goes on. The map takes frames of the new time; those of the old time are too late. kInvalidArgument before
  /// start().
  Status set_clock(int64_t t) noexcept;
  /// The latest committed plan, for a follower that does not ask for every command, for example another board.
  /// Trajectory::begin is when it takes over, on the clock of tick(): once the clock shows that, command() at time t is
  /// the state at time_on(plan, t), bit for bit. Take it after each tick that raises FlightReport::committed, and after
  /// set_clock(), which moves its beginning. If the plan begins later than now, go on with the one before until then,
  /// but take it again after each tick: a threat may withdraw it. kInvalidArgument before start().
  Status committed_plan(Trajectory& plan) const noexcept;
  /// The committed plan's end: where the vehicle comes to rest if nothing else happens. World frame.
  Vec3 rest_position() const noexcept;

 private:
  FlightState* state_ = nullptr;
};

}  // namespace tern

#endif
