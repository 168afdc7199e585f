// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_STATUS_HPP
#define TERN_STATUS_HPP

#include <stdint.h>

namespace tern {

/// What became of a call. Grouped by whose fault it is; the values are part of the ABI.
/// Whatever is neither kOk nor kRunning leaves the caller's output untouched.
enum class Status : uint8_t {
  kOk = 0,
  kRunning = 1,  ///< a sliced plan has work left: call step() again

  // The caller's: the request is wrong. Report::field says which field.
  kNonFiniteInput = 10,      ///< NaN or infinity in a field
  kInvalidArgument = 11,     ///< null, zero, beyond a capacity, or a call out of order
  kLimitsInvalid = 12,       ///< a limit that is zero, negative, denormal or absurdly large, or a time weight that is
  kOutOfMap = 13,            ///< start or goal outside the closed boundary
  kStartExceedsLimits = 14,  ///< start velocity or acceleration above its limit
  kGoalExceedsLimits = 15,   ///< goal velocity or acceleration above its limit

  // The world's: the request is right, the map has no answer.
  kStartOccupied = 30,    ///< closer than the radius to an obstacle; Report::nearest_free has a way out
  kGoalOccupied = 31,     ///< likewise for the goal
  kNoPath = 32,           ///< the free voxels do not connect start and goal
  kMapChanged = 33,       ///< the grid's revision changed between the slices of one plan
  kCorridorBlocked = 34,  ///< an obstacle touches the segment that a polyhedron was asked for
  kNoTrajectory = 35,     ///< from a moving start or to a moving goal, nothing within the limits was found

  kStartFenced = 36,  ///< start outside a keep-in, or nearer than the radius to a keep-out
  kGoalFenced = 37,   ///< likewise for the goal

  // The configuration's: a capacity ran out. Each names the constant of config.hpp to raise.
  kNodesFull = 50,        ///< TERN_MAX_NODES
  kOpenFull = 51,         ///< TERN_MAX_OPEN
  kJumpPointsFull = 52,   ///< TERN_MAX_JUMP_POINTS
  kSegmentsFull = 53,     ///< TERN_MAX_SEGMENTS
  kPlanesFull = 54,       ///< TERN_MAX_PLANES
  kObstaclesFull = 55,    ///< TERN_MAX_LOCAL_BOXES
  kWorkingSetFull = 56,   ///< TERN_MAX_ACTIVE (reported of the optimiser; the plan falls back)
  kIterationLimit = 57,   ///< TERN_MAX_QP_ITERATIONS (reported of the optimiser; the plan falls back)
  kFencesFull = 58,       ///< TERN_MAX_FENCES
  kFencePlanesFull = 59,  ///< TERN_MAX_FENCE_PLANES
  kFenceLayerFull = 60,   ///< TERN_MAX_FENCE_WORDS

  // Numerics: the solver's answer, or the machine, did not hold up.
  kInfeasible = 70,      ///< the constraints contradict each other; proven by multipliers
  kNumerical = 71,       ///< no accurate solution: a residual stayed above its tolerance
  kCheckFailed = 72,     ///< the independent check refused the plan; please report it
  kSelfTestFailed = 73,  ///< the machine or build does not compute as the contracts need

  // The budget's: the caller's allowance of work ran out in that stage.
  kBudgetSearch = 90,
  kBudgetShortcut = 91,
  kBudgetCorridor = 92,
  kBudgetOptimise = 93,  ///< reported of the optimiser; the plan falls back to stop-and-go where it can
};

/// The stages of a plan, in the order that data flows through them.
enum class Stage : uint8_t {
  kRequest = 0,  ///< validation of the request, before any stage
  kSearch,       ///< jump point search
  kShortcut,     ///< shortest chain of visible waypoints
  kCorridor,     ///< a polyhedron a segment
  kTimes,        ///< trapezoidal time allocation
  kTrajectory,   ///< minimum snap by quadratic programmes
  kCheck,        ///< the independent check
};
constexpr int kStageCount = 7;

/// The field of a request or grid that a status speaks of.
enum class Field : uint8_t {
  kNone = 0,
  kStartPosition,
  kStartVelocity,
  kStartAcceleration,
  kGoalPosition,
  kGoalVelocity,
  kGoalAcceleration,
  kVMax,
  kAMax,
  kOrigin,
  kCell,
  kDimensions,
  kBoundary,
  kRadius,
  kStorage,
  kWorkspace,
  kCallOrder,
  kBox,
  kVMin,
  kAMin,
  kVHorizontal,
  kAHorizontal,
  kTimeWeight,
  kFences,
  kShortcut,
  kPrevious,
  kNotInflated,    ///< the grid was marked, cleared or bound since its last inflate()
  kConfiguration,  ///< the caller's headers and the library were compiled with different capacities
};

/// The status' name as plan files carry it, e.g. "no_path"; "unknown" for a value that is none.
const char* status_name(Status status) noexcept;
/// One sentence: what it means and what to do.
const char* status_meaning(Status status) noexcept;
/// The stage's name, e.g. "search".
const char* stage_name(Stage stage) noexcept;
/// The field's name, e.g. "start velocity".
const char* field_name(Field field) noexcept;

}  // namespace tern

#endif
