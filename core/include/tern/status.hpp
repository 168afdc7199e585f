// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The answers to a call, and the words for them. docs/faults.md lists which input gets which answer.
#ifndef TERN_STATUS_HPP
#define TERN_STATUS_HPP

#include <stdint.h>

namespace tern {

/// The answer to a call, grouped by who can do something about it. The numbers are part of the ABI. Unless the answer
/// is kOk or kRunning, the call leaves the caller's output as it was.
enum class Status : uint8_t {
  /// Success. From plan() and finish(): the trajectory is a plan that passed the check.
  kOk = 0,
  /// A plan in slices has work left. Call step() again.
  kRunning = 1,

  // 10 .. 29: the request or the call is wrong. Correct it. Report::field names the field.

  /// A number is NaN or infinite.
  kNonFiniteInput = 10,
  /// An argument is null, zero, out of range, beyond a capacity or excluded by another one, or a call came out of
  /// order.
  kInvalidArgument = 11,
  /// A limit or the time weight is outside its range (tern/request.hpp), or a lower limit is positive.
  kLimitsInvalid = 12,
  /// Start or goal lies outside the grid's boundary. The boundary itself counts as inside. From mark_voxel and
  /// clear_voxel: the voxel lies outside the grid.
  kOutOfMap = 13,
  /// The start's velocity or acceleration exceeds a limit by more than 4e-8 of it. Clamp the state, or raise the
  /// limit for this request.
  kStartExceedsLimits = 14,
  /// The goal's velocity or acceleration exceeds a limit by more than 4e-8 of it.
  kGoalExceedsLimits = 15,

  /// A via's velocity exceeds a limit by more than 4e-8 of it. Report::via says which via.
  kViaExceedsLimits = 16,

  /// A keep-out is empty, or the keep-ins have no point in common: a half-space is reversed, or the order of a polygon
  /// is. Report::fence says which fence; of the keep-ins, the first one that leaves no point.
  kFenceEmpty = 17,

  /// Only from a RollingMap: the pose's quaternion is not a unit quaternion.
  kPoseInvalid = 18,
  /// Only from a RollingMap: a depth image has no size, or intrinsics that no camera has (tern/map.hpp).
  kCameraInvalid = 19,

  /// Only for records (tern/record.hpp): the bytes are no record, not all of it, or altered.
  kRecordDamaged = 20,
  /// Only for records: another version of the format wrote it.
  kRecordVersion = 21,
  /// Only from Flight::tick() and a RollingMap: the time is before the last one (a frame's: by over kMaxFrameDelay), so
  /// the clock was set back. Nothing was done. Go on once it has caught up, or call Flight::set_clock().
  kClockBehind = 22,

  // 30 .. 49: the request is right, but the world has no answer to it. Choose another start, goal, radius or
  // resolution, or wait.

  /// The start is closer to an obstacle than the radius.
  /// Report::raw_occupied says whether it is inside an obstacle, Report::nearest_free has the nearest free voxel.
  kStartOccupied = 30,
  /// The goal is closer to an obstacle than the radius. Report::raw_occupied and Report::nearest_free are as for the
  /// start.
  kGoalOccupied = 31,
  /// At this resolution and radius, no chain of free voxels connects start and goal. With vias, Report::via says which
  /// of them cannot be reached from the one before.
  kNoPath = 32,
  /// The grid changed between two slices of a plan. Begin the plan again.
  kMapChanged = 33,
  /// An obstacle or a fence is closer than the radius to a line that the corridor must hold. A finer grid may help.
  kCorridorBlocked = 34,
  /// Only for a start or goal in motion, or a via with a velocity: no trajectory within the limits leaves or meets that
  /// motion here. Keep flying the plan that you have (Request::previous), slow down earlier, or ask for a goal at rest.
  kNoTrajectory = 35,
  /// The start lies outside a keep-in fence, or closer than the radius to a keep-out fence. Report::fence says which.
  kStartFenced = 36,
  /// The goal lies outside a keep-in fence, or closer than the radius to a keep-out fence. Report::fence says which.
  kGoalFenced = 37,

  /// A via is closer to an obstacle than the radius. Report::via says which. Report::raw_occupied and
  /// Report::nearest_free are as for the start.
  kViaOccupied = 38,
  /// A via lies outside a keep-in fence, or closer than the radius to a keep-out fence. Report::via and Report::fence
  /// say which.
  kViaFenced = 39,

  /// The start keeps the radius and the fences, but no straight line leads from it to a free voxel near it: the free
  /// space there is narrower than a voxel. Report::finer_cell says which resolution would do, Report::fence which fence
  /// makes it so narrow.
  kStartTooNarrow = 40,
  /// The goal keeps the radius and the fences, but the free space there is narrower than a voxel, as for
  /// kStartTooNarrow.
  kGoalTooNarrow = 41,
  /// A via keeps the radius and the fences, but the free space there is narrower than a voxel, as for kStartTooNarrow.
  /// Report::via says which.
  kViaTooNarrow = 42,

  /// The start is nearer to a moving thing than it should be, and no plan leads away. Report::track says which.
  kStartInContact = 43,
  /// The goal is not clear of a moving thing when the plan arrives, or for Request::rest_clear seconds from then on.
  /// Waiting did not help. Report::track says which, Report::conflict when.
  kGoalCovered = 44,
  /// There is a way, but no plan along it that is clear of all moving things was found. Report::track and
  /// Report::conflict say what the first plan meets, and when. Keep the plan that you have, or choose another goal.
  /// Unless that thing stays there for good, you may also wait and ask again.
  kNoClearTime = 45,

  // 50 .. 69: a capacity ran out. Raise the constant of config.hpp that is named here, or give the planner less to do:
  // a coarser grid, or a goal that is nearer.

  kNodesFull = 50,       ///< TERN_MAX_NODES: the search generated more jump points, or took 27 pieces of work for each
  kOpenFull = 51,        ///< TERN_MAX_OPEN: the search's open list is full
  kJumpPointsFull = 52,  ///< TERN_MAX_JUMP_POINTS: the jump-point path has more points
  kSegmentsFull = 53,    ///< TERN_MAX_SEGMENTS: the path needs more segments
  kPlanesFull = 54,      ///< TERN_MAX_PLANES: a polyhedron needs more half-spaces
  kObstaclesFull = 55,   ///< TERN_MAX_LOCAL_BOXES: there are too many obstacles around a segment
  /// TERN_MAX_ACTIVE: too many constraints are active at once. Only as Report::optimiser; the plan falls back to
  /// stop-and-go.
  kWorkingSetFull = 56,
  /// TERN_MAX_QP_ITERATIONS: a quadratic programme needs more iterations. Only as Report::optimiser; the plan falls
  /// back to stop-and-go.
  kIterationLimit = 57,
  kFencesFull = 58,       ///< TERN_MAX_FENCES: the request has more fences
  kFencePlanesFull = 59,  ///< TERN_MAX_FENCE_PLANES: the fences have more half-spaces or corners
  kWorldFull = 60,  ///< TERN_MAX_WORLD_WORDS: the grid is too large to be planned on with fences, or with kNearest

  kViasFull = 61,  ///< TERN_MAX_VIAS: the request has more vias

  /// MapSpec::pixels, or TERN_MAX_PIXELS: the image is larger. Only from a RollingMap.
  kPixelsFull = 63,
  kPriorFull = 64,   ///< TERN_MAX_PRIOR_BOXES: the map's prior has more boxes, or more cylinders
  kRecordFull = 65,  ///< The room for a record does not suffice. plan_record_bytes() says how much always does.

  kTracksFull = 66,       ///< TERN_MAX_TRACKS: the request has more tracks
  kTrackPiecesFull = 67,  ///< TERN_MAX_TRACK_PIECES: the tracks have more pieces

  /// TERN_MAX_SEPARATIONS: too many segments come near things that move, and waiting does not help.
  kSeparationsFull = 68,
  /// TERN_MAX_FLOOD_WORDS: the way is too long, and the grid too large, to look for a way around things that move, and
  /// waiting does not help.
  kFloodFull = 69,

  kNeighboursFull = 62,  ///< TERN_MAX_NEIGHBOURS: the fleet has more other members

  // 70 .. 89: the solver or the machine did not hold up.

  /// The constraints contradict each other, and the solver has a proof. Only as Report::optimiser; the plan falls back
  /// to stop-and-go.
  kInfeasible = 70,
  /// No solution was accurate enough. Only as Report::optimiser; the plan falls back to stop-and-go.
  kNumerical = 71,
  /// The final check refused the plan and every fallback. This is a defect of Tern: please report it.
  kCheckFailed = 72,
  /// Only from self_test(): this machine or build does not compute as Tern needs. Do not fly with it. The faults that
  /// self_test() gives out name the cause.
  kSelfTestFailed = 73,

  // 90 .. 99: the request's budget ran out. Allow more, or go on with what you have.

  kBudgetSearch = 90,    ///< Budget::search
  kBudgetShortcut = 91,  ///< Budget::shortcut
  kBudgetCorridor = 92,  ///< Budget::corridor
  /// Budget::trajectory. Only as Report::optimiser: the plan is the best so far, or stop-and-go.
  kBudgetOptimise = 93,
  kBudgetTracks = 94,  ///< Budget::tracks: there may be a way or a time that is clear of the things that move
};

/// The stages of a plan. The first seven make a plan, in this order. The others are for requests with fences, and for
/// attempts after a failure. The numbers are part of the ABI.
enum class Stage : uint8_t {
  kRequest = 0,  ///< validation of the request, before any other stage
  kSearch,       ///< guided search, or jump point search (the paper's Section 3.2.1)
  kShortcut,     ///< shortening the path (Section 3.2.3)
  kCorridor,     ///< polyhedra along the path (Section 3.3.1)
  kTimes,        ///< first durations by trapezoidal profiles (Section 3.3.2)
  kTrajectory,   ///< minimum snap by quadratic programmes (Section 3.4)
  kCheck,        ///< the independent check of the finished plan (contract C4)
  kWorld,        ///< blocking voxels for the request's fences, in a copy of the grid's blocked layer
  kDetour,       ///< leading the path along the motion of its ends, if a moving end has no room
  kPrevious,     ///< proving the rest of Request::previous anew, if nothing new was found
  kStopFirst,    ///< finding ways to come to rest first, if a moving end has no other way
  kReach,        ///< finding the point nearest to the goal that a path leads to, if none leads to the goal
  kTracks,       ///< finding a way in time among the tracks, or a time at which the plan is clear of them all
};
constexpr int kStageCount = 13;

/// Reasons for which a proof ends, and for which a plan is refused. The numbers are part of the ABI; docs/proof.md has
/// the rules and tolerances.
enum class Finding : uint8_t {
  kNone = 0,      ///< nothing: all is proven
  kMalformed,     ///< counts, durations or coordinates that are no trajectory
  kObstacle,      ///< closer than the radius to an obstacle voxel, or too nearly so to tell
  kOutside,       ///< beyond the boundary, or too near to it with Beyond::kSolid
  kVelocity,      ///< some v(t) is beyond a limit
  kAcceleration,  ///< some a(t) is beyond a limit
  kJoint,         ///< position jumps at a joint; of a plan, also velocity, acceleration or jerk
  kFence,         ///< outside a keep-in, or closer than the radius to a keep-out, or too nearly so to tell
  kBoundary,      ///< the start's or the goal's state is not met; plans only
  kJerk,          ///< some jerk(t) is beyond a limit
  kVia,           ///< a via is missed, out of order, or not passed as it was asked for; plans only
  kPieces,        ///< a segment needs more pieces than kProofPieces
  kBodyRate,      ///< some body rate is beyond its limit
  kTrack,         ///< closer than the radius to a tube of a thing that moves, or too nearly so to tell
};

/// The field of a request, a grid, a flight or a call that a status is about. The numbers are part of the ABI; 17 and
/// 24 are not used.
enum class Field : uint8_t {
  kNone = 0,           ///< no single field
  kStartPosition,      ///< Request::start.position
  kStartVelocity,      ///< Request::start.velocity
  kStartAcceleration,  ///< Request::start.acceleration
  kGoalPosition,       ///< Request::goal.position
  kGoalVelocity,       ///< Request::goal.velocity
  kGoalAcceleration,   ///< Request::goal.acceleration
  kVMax,               ///< Limits::v_max
  kAMax,               ///< Limits::a_max
  kOrigin,             ///< GridSpec::origin: not finite, or too far away for cells of this size
  kCell,               ///< GridSpec::cell
  kDimensions,         ///< GridSpec::dims
  kBoundary,           ///< GridSpec::boundary: not finite, lower > upper, or not inside the grid
  kRadius,             ///< GridSpec::radius, or its sum with tracking_margin
  kStorage,            ///< the grid's words: null or too few; or the grid is not bound to any
  kWorkspace,          ///< the planner's memory: null, or less than kWorkspaceBytes
  kCallOrder,          ///< finish() before begin(), or before step() was done
  kVMin = 18,          ///< Limits::v_min
  kAMin,               ///< Limits::a_min
  kVHorizontal,        ///< Limits::v_horizontal
  kAHorizontal,        ///< Limits::a_horizontal
  kTimeWeight,         ///< Request::time_weight
  kFences,             ///< Request::fences or fence_count, or a fence in it
  kPrevious = 25,      ///< Request::previous or previous_time: no trajectory, or it does not give `start` at that time
  kNotInflated,        ///< the grid was bound, marked or cleared since its last inflate()
  kConfiguration,      ///< the caller's headers and the library were compiled with different capacities
  kSearch,             ///< Request::search
  kRange,              ///< MapSpec::range
  kMargins,            ///< a margin of MapSpec
  kScanPixel,          ///< MapSpec::scan_pixel
  kEvidence,           ///< MapSpec::hits, misses or support
  kAge,                ///< MapSpec::age
  kSlack,              ///< MapSpec::slack
  kPixels,             ///< MapSpec::pixels: below 1, too many, or too few for scans
  kPrior,              ///< MapSpec::prior: too many, null, or an invalid box or cylinder
  kStartJerk,          ///< Request::start.jerk
  kGoalJerk,           ///< Request::goal.jerk
  kJMax,               ///< Limits::j_max
  kJHorizontal,        ///< Limits::j_horizontal
  kGoalMode,           ///< Request::goal_mode
  kVias,               ///< Request::vias or via_count, or a via in it
  kTrackingMargin,     ///< GridSpec::tracking_margin
  kMap,                ///< the RollingMap: not bound, or busy with a job
  kTick,               ///< FlightSpec::tick
  kWork,               ///< FlightSpec::work_per_tick or plan_work
  kHorizon,            ///< FlightSpec::horizon: not above 0, or half the map's window along x or more
  kNear,               ///< FlightSpec::near
  kYawRate,            ///< FlightSpec::yaw_rate
  kStaleAfter,         ///< FlightSpec::stale_after
  kThrustMax,          ///< Limits::thrust_max
  kThrustMin,          ///< Limits::thrust_min; with a rate_max, it must be given
  kTiltTangent,        ///< Limits::tilt_tangent
  kRateMax,            ///< Limits::rate_max
  kTracks,             ///< Request::tracks or track_count, or a track in it
  kRestClear,          ///< Request::rest_clear
  kSensor,             ///< FlightSpec::sensor
  kClearance,          ///< FlightSpec::clearance
};

/// The status' name as plan files carry it, for example "no_path". "unknown" for a number that is no status. This and
/// the next four return constant strings that are never null and need not be freed.
const char* status_name(Status status) noexcept;
/// What the status means and, in many cases, what to do, as one line of English.
const char* status_meaning(Status status) noexcept;
/// The stage's name, for example "search". "unknown" for a number that is no stage.
const char* stage_name(Stage stage) noexcept;
/// The field's name, for example "start velocity". "unknown" for a number that is no field.
const char* field_name(Field field) noexcept;
/// The finding's name, for example "obstacle". "unknown" for a number that is no finding.
const char* finding_name(Finding finding) noexcept;

}  // namespace tern

#endif
