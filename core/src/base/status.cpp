// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tern/status.hpp"

namespace tern {

// One line a status: a table.
// clang-format off
// NOLINTNEXTLINE(readability-function-size): one line each
const char* status_name(Status status) noexcept {
  switch (status) {
    case Status::kOk: return "ok";
    case Status::kRunning: return "running";
    case Status::kNonFiniteInput: return "non_finite_input";
    case Status::kInvalidArgument: return "invalid_argument";
    case Status::kLimitsInvalid: return "limits_invalid";
    case Status::kOutOfMap: return "out_of_map";
    case Status::kStartExceedsLimits: return "start_exceeds_limits";
    case Status::kGoalExceedsLimits: return "goal_exceeds_limits";
    case Status::kViaExceedsLimits: return "via_exceeds_limits";
    case Status::kFenceEmpty: return "fence_empty";
    case Status::kPoseInvalid: return "pose_invalid";
    case Status::kCameraInvalid: return "camera_invalid";
    case Status::kRecordDamaged: return "record_damaged";
    case Status::kRecordVersion: return "record_version";
    case Status::kClockBehind: return "clock_behind";
    case Status::kStartOccupied: return "start_occupied";
    case Status::kGoalOccupied: return "goal_occupied";
    case Status::kNoPath: return "no_path";
    case Status::kMapChanged: return "map_changed";
    case Status::kCorridorBlocked: return "corridor_blocked";
    case Status::kNoTrajectory: return "no_trajectory";
    case Status::kStartFenced: return "start_fenced";
    case Status::kGoalFenced: return "goal_fenced";
    case Status::kViaOccupied: return "via_occupied";
    case Status::kStartTooNarrow: return "start_too_narrow";
    case Status::kGoalTooNarrow: return "goal_too_narrow";
    case Status::kViaTooNarrow: return "via_too_narrow";
    case Status::kStartInContact: return "start_in_contact";
    case Status::kGoalCovered: return "goal_covered";
    case Status::kNoClearTime: return "no_clear_time";
    case Status::kViaFenced: return "via_fenced";
    case Status::kNodesFull: return "nodes_full";
    case Status::kOpenFull: return "open_full";
    case Status::kJumpPointsFull: return "jump_points_full";
    case Status::kSegmentsFull: return "segments_full";
    case Status::kPlanesFull: return "planes_full";
    case Status::kObstaclesFull: return "obstacles_full";
    case Status::kFencesFull: return "fences_full";
    case Status::kFencePlanesFull: return "fence_planes_full";
    case Status::kWorldFull: return "world_full";
    case Status::kViasFull: return "vias_full";
    case Status::kPixelsFull: return "pixels_full";
    case Status::kPriorFull: return "prior_full";
    case Status::kRecordFull: return "record_full";
    case Status::kTracksFull: return "tracks_full";
    case Status::kTrackPiecesFull: return "track_pieces_full";
    case Status::kNeighboursFull: return "neighbours_full";
    case Status::kSeparationsFull: return "separations_full";
    case Status::kFloodFull: return "flood_full";
    case Status::kWorkingSetFull: return "working_set_full";
    case Status::kIterationLimit: return "iteration_limit";
    case Status::kInfeasible: return "infeasible";
    case Status::kNumerical: return "numerical";
    case Status::kCheckFailed: return "check_failed";
    case Status::kSelfTestFailed: return "self_test_failed";
    case Status::kBudgetSearch: return "budget_search";
    case Status::kBudgetShortcut: return "budget_shortcut";
    case Status::kBudgetCorridor: return "budget_corridor";
    case Status::kBudgetOptimise: return "budget_optimise";
    case Status::kBudgetTracks: return "budget_tracks";
  }
  return "unknown";
}

// NOLINTNEXTLINE(readability-function-size): one line each
const char* status_meaning(Status status) noexcept {
  switch (status) {
    case Status::kOk: return "a checked plan";
    case Status::kRunning: return "the plan has work left: call step() again";
    case Status::kNonFiniteInput: return "a field is NaN or infinite";
    case Status::kInvalidArgument: return "an argument is null, zero, too large or excluded by another one, or a call came out of order";
    case Status::kLimitsInvalid: return "a limit has the wrong sign or a size outside 0.001 to 1000 (jerk: to 1e6), or the time weight is outside 0.001 to 1e6";
    case Status::kOutOfMap: return "start, goal or a via lies outside the boundary";
    case Status::kStartExceedsLimits: return "the start's velocity or acceleration is above its limit";
    case Status::kGoalExceedsLimits: return "the goal's velocity or acceleration is above its limit";
    case Status::kViaExceedsLimits: return "a via's velocity is above its limit";
    case Status::kFenceEmpty: return "a geofence's half-spaces have no point in common: is one of them, or the order of the polygon, reversed?";
    case Status::kPoseInvalid: return "the pose's quaternion is not a unit quaternion";
    case Status::kCameraInvalid: return "the image has no size, or its intrinsics are those of no camera";
    case Status::kRecordDamaged: return "the bytes are no record, not all of it, or altered";
    case Status::kRecordVersion: return "another version of the format wrote the record";
    case Status::kClockBehind: return "the time is before the last one: wait until the clock has caught up, or say with set_clock() that it was set";
    case Status::kStartOccupied: return "the start is closer to an obstacle than the radius";
    case Status::kGoalOccupied: return "the goal is closer to an obstacle than the radius";
    case Status::kNoPath: return "free space at this resolution and radius does not connect start and goal";
    case Status::kMapChanged: return "the map changed while the plan was being made: begin again";
    case Status::kCorridorBlocked: return "an obstacle touches a segment of the path";
    case Status::kNoTrajectory: return "no trajectory within the limits leaves or reaches the moving boundary state, or has the velocity that a via asks for";
    case Status::kStartTooNarrow: return "the free space around the start is narrower than a voxel";
    case Status::kGoalTooNarrow: return "the free space around the goal is narrower than a voxel";
    case Status::kStartInContact: return "the start is too near to a moving thing, and no plan leads away from it";
    case Status::kGoalCovered: return "the goal is not clear of moving things and fences for a while when the plan arrives, or soon after";
    case Status::kNoClearTime: return "no plan was found that is clear of all moving things and fences for a while";
    case Status::kViaTooNarrow: return "the free space around a via is narrower than a voxel";
    case Status::kViaOccupied: return "a via is closer to an obstacle than the radius";
    case Status::kViaFenced: return "a via is outside a keep-in, or nearer than the radius to a keep-out";
    case Status::kNodesFull: return "the search needs more nodes: raise TERN_MAX_NODES or coarsen the grid";
    case Status::kOpenFull: return "the open list is full: raise TERN_MAX_OPEN or coarsen the grid";
    case Status::kJumpPointsFull: return "the jump-point path turns too often: raise TERN_MAX_JUMP_POINTS";
    case Status::kSegmentsFull: return "the path needs more segments: raise TERN_MAX_SEGMENTS";
    case Status::kPlanesFull: return "a polyhedron needs more half-spaces: raise TERN_MAX_PLANES";
    case Status::kStartFenced: return "the start is outside a keep-in, or nearer than the radius to a keep-out";
    case Status::kGoalFenced: return "the goal is outside a keep-in, or nearer than the radius to a keep-out";
    case Status::kFencesFull: return "too many geofences: raise TERN_MAX_FENCES";
    case Status::kFencePlanesFull: return "too many half-spaces in geofences: raise TERN_MAX_FENCE_PLANES";
    case Status::kWorldFull: return "the grid is too large for geofences, or for a goal as near as possible: raise TERN_MAX_WORLD_WORDS";
    case Status::kViasFull: return "too many vias: raise TERN_MAX_VIAS";
    case Status::kPixelsFull: return "too many pixels for the map: raise MapSpec::pixels or TERN_MAX_PIXELS";
    case Status::kPriorFull: return "too many boxes known beforehand: raise TERN_MAX_PRIOR_BOXES";
    case Status::kTracksFull: return "too many tracks: raise TERN_MAX_TRACKS";
    case Status::kNeighboursFull: return "too many other members of a fleet: raise TERN_MAX_NEIGHBOURS";
    case Status::kTrackPiecesFull: return "too many pieces of tracks: raise TERN_MAX_TRACK_PIECES";
    case Status::kSeparationsFull: return "too many segments near things that move: raise TERN_MAX_SEPARATIONS";
    case Status::kFloodFull: return "too large a grid or too long a way for the flood in time: raise TERN_MAX_FLOOD_WORDS";
    case Status::kRecordFull: return "the room for the record does not suffice";
    case Status::kObstaclesFull: return "too many obstacles around a segment: raise TERN_MAX_LOCAL_BOXES";
    case Status::kWorkingSetFull: return "too many constraints active at once: raise TERN_MAX_ACTIVE";
    case Status::kIterationLimit: return "the quadratic programme ran out of iterations: raise TERN_MAX_QP_ITERATIONS";
    case Status::kInfeasible: return "the constraints contradict each other";
    case Status::kNumerical: return "no solution of the accuracy that the contracts need";
    case Status::kCheckFailed: return "the independent check refused the plan: a defect, please report it";
    case Status::kSelfTestFailed: return "this machine or build does not compute as Tern needs: see docs/determinism.md";
    case Status::kBudgetSearch: return "the budget of the search ran out";
    case Status::kBudgetShortcut: return "the budget of the shortcut ran out";
    case Status::kBudgetCorridor: return "the budget of the corridor ran out";
    case Status::kBudgetOptimise: return "the budget of the trajectory ran out";
    case Status::kBudgetTracks: return "the budget of ways among things that move ran out";
  }
  return "not a status of this version";
}

const char* stage_name(Stage stage) noexcept {
  switch (stage) {
    case Stage::kRequest: return "request";
    case Stage::kSearch: return "search";
    case Stage::kShortcut: return "shortcut";
    case Stage::kCorridor: return "corridor";
    case Stage::kTimes: return "times";
    case Stage::kTrajectory: return "trajectory";
    case Stage::kCheck: return "check";
    case Stage::kWorld: return "world";
    case Stage::kDetour: return "detour";
    case Stage::kPrevious: return "previous";
    case Stage::kStopFirst: return "stop_first";
    case Stage::kReach: return "reach";
    case Stage::kTracks: return "tracks";
  }
  return "unknown";
}

const char* finding_name(Finding finding) noexcept {
  switch (finding) {
    case Finding::kNone: return "none";
    case Finding::kMalformed: return "malformed";
    case Finding::kObstacle: return "obstacle";
    case Finding::kOutside: return "outside";
    case Finding::kVelocity: return "velocity";
    case Finding::kAcceleration: return "acceleration";
    case Finding::kJerk: return "jerk";
    case Finding::kJoint: return "joint";
    case Finding::kFence: return "fence";
    case Finding::kVia: return "via";
    case Finding::kBoundary: return "boundary state";
    case Finding::kPieces: return "pieces";
    case Finding::kBodyRate: return "body rate";
    case Finding::kTrack: return "track";
  }
  return "unknown";
}

// NOLINTNEXTLINE(readability-function-size): one line each
const char* field_name(Field field) noexcept {
  switch (field) {
    case Field::kNone: return "none";
    case Field::kStartPosition: return "start position";
    case Field::kStartVelocity: return "start velocity";
    case Field::kStartAcceleration: return "start acceleration";
    case Field::kGoalPosition: return "goal position";
    case Field::kGoalVelocity: return "goal velocity";
    case Field::kGoalAcceleration: return "goal acceleration";
    case Field::kVMax: return "v_max";
    case Field::kAMax: return "a_max";
    case Field::kOrigin: return "grid origin";
    case Field::kCell: return "cell size";
    case Field::kDimensions: return "grid dimensions";
    case Field::kBoundary: return "boundary";
    case Field::kRadius: return "radius";
    case Field::kStorage: return "grid storage";
    case Field::kWorkspace: return "workspace";
    case Field::kCallOrder: return "call order";
    case Field::kVMin: return "v_min";
    case Field::kAMin: return "a_min";
    case Field::kStartJerk: return "start jerk";
    case Field::kGoalJerk: return "goal jerk";
    case Field::kJMax: return "j_max";
    case Field::kJHorizontal: return "j_horizontal";
    case Field::kThrustMax: return "thrust_max";
    case Field::kThrustMin: return "thrust_min";
    case Field::kTiltTangent: return "tilt_tangent";
    case Field::kRateMax: return "rate_max";
    case Field::kTracks: return "tracks";
    case Field::kRestClear: return "rest_clear";
    case Field::kVHorizontal: return "v_horizontal";
    case Field::kAHorizontal: return "a_horizontal";
    case Field::kTimeWeight: return "time_weight";
    case Field::kFences: return "fences";
    case Field::kSearch: return "search";
    case Field::kPrevious: return "previous plan";
    case Field::kNotInflated: return "grid not inflated";
    case Field::kConfiguration: return "configuration";
    case Field::kRange: return "range";
    case Field::kMargins: return "margins";
    case Field::kScanPixel: return "scan pixel";
    case Field::kEvidence: return "hits and misses";
    case Field::kAge: return "age";
    case Field::kSlack: return "slack";
    case Field::kPixels: return "pixels";
    case Field::kPrior: return "prior";
    case Field::kGoalMode: return "goal mode";
    case Field::kVias: return "vias";
    case Field::kTrackingMargin: return "tracking margin";
    case Field::kMap: return "map";
    case Field::kTick: return "tick";
    case Field::kWork: return "work per tick or plan";
    case Field::kHorizon: return "horizon";
    case Field::kNear: return "near";
    case Field::kYawRate: return "yaw rate";
    case Field::kStaleAfter: return "stale_after";
    case Field::kSensor: return "sensor";
    case Field::kClearance: return "clearance";
  }
  return "unknown";
}
// clang-format on

}  // namespace tern
