// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// From the path to a trajectory: the corridor, first durations, then the optimiser, or stop-and-go if the optimiser's
// plan was refused.
#ifndef TERN_PLANNER_CURVES_HPP
#define TERN_PLANNER_CURVES_HPP

#include <cstdint>

#include "base/progress.hpp"
#include "base/work.hpp"
#include "corridor/corridor_stage.hpp"
#include "planner/end_stop.hpp"
#include "planner/problem.hpp"
#include "planner/vias.hpp"
#include "tern/corridor.hpp"
#include "tern/path.hpp"
#include "tern/report.hpp"
#include "tern/status.hpp"
#include "tern/trajectory.hpp"
#include "times/chain.hpp"
#include "times/pace.hpp"
#include "times/times_stage.hpp"
#include "trajectory/trajectory_stage.hpp"

namespace tern {

struct Rooms {
  Status status;     ///< why there is no corridor; else kOk
  std::int32_t via;  ///< the next via after the place where there was no room; kNoVia: the goal comes next
  // Figures for the report.
  std::int32_t planes_high;
  std::int32_t local_boxes_high;
};

/// Builds the corridor that corridor_begin() has begun.
Progress rooms_advance(const Problem& problem, const Path& path, CorridorStage& stage, Rooms& rooms, Corridor& corridor,
                       Work& work) noexcept;

/// The times stage and the trajectory stage, with their input.
struct CurveMemory {
  Corridor corridor;  ///< relative to the plan's origin
  TimesStage times;
  Chain chain;  ///< as the times stage made it
  Scene scene;  ///< of a plan around things
  TrajectoryStage stage;
};

struct Curves {
  bool stop_and_go;  ///< the optimiser's plan was refused
  Status refused;    ///< why it was refused
  Status status;     ///< why there is no trajectory; else kOk
  Quality quality;   ///< of the trajectory
  // Figures for the report.
  Status optimiser;
  std::int32_t active_high;
  std::int32_t iterations_high;
  std::int32_t solves_high;
  std::int32_t segments_high;
  std::int32_t separations_high;
};

/// Moves the corridor into the plan's frame and cuts it into a chain, for times_advance() to give it durations.
void chain_begin(const Problem& problem, const Ends& ends, const ViaJoints& via_joints, const Pace& pace,
                 const Corridor& corridor, CurveMemory& memory) noexcept;

/// Makes the trajectory of the chain; the origin is that of the plan's frame. Returns the operations that it took.
Operations curves_begin(const Problem& problem, const Ends& ends, const Curves& curves, CurveMemory& memory) noexcept;
Progress curves_advance(CurveMemory& memory, Curves& curves, Trajectory& trajectory, Work& work) noexcept;

/// Adds the stops at both ends and the dwells at the vias to the trajectory. False if there is no capacity for all
/// segments.
bool complete_trajectory(const Problem& problem, const EndStop* stops, Curves& curves, ViaMemory& vias,
                         Trajectory& trajectory) noexcept;

/// The next trajectory is stop-and-go along the same corridor. `why`: kCheckFailed, or kSegmentsFull if stops and
/// dwells leave too little room for the optimiser's segments.
void refuse_optimised(Status why, Curves& curves) noexcept;

}  // namespace tern

#endif
