// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planner/curves.hpp"

#include "tern/via.hpp"
#include "trajectory/relative_corridor.hpp"

namespace tern {

Progress rooms_advance(const Problem& problem, const Path& path, CorridorStage& stage, Rooms& rooms, Corridor& corridor,
                       Work& work) noexcept {
  const Progress progress = corridor_advance(stage, world_of(problem), path, work, corridor);
  raise(rooms.planes_high, stage.planes_high);
  raise(rooms.local_boxes_high, stage.boxes_high);
  if (progress == Progress::kMore) return progress;
  rooms.status = stage.status;
  rooms.via = stage.passed < problem.via_count ? stage.passed : kNoVia;
  return progress;
}

void chain_begin(const Problem& problem, const Ends& ends, const ViaJoints& via_joints, const Pace& pace,
                 const Corridor& corridor, CurveMemory& memory) noexcept {
  relative_corridor(corridor, ends.origin_in_grid, ends.start.position, ends.goal.position, via_joints,
                    memory.corridor);
  times_begin(memory.times, memory.corridor, {ends.start, ends.goal, problem.limits, via_joints, pace}, memory.chain);
}

Operations curves_begin(const Problem& problem, const Ends& ends, const Curves& curves, CurveMemory& memory) noexcept {
  const TimesStage& times = memory.times;
  TrajectoryQuery query{ends.start,         ends.goal,  problem.limits, problem.asked.time_weight,
                        curves.stop_and_go, times.paced};
  const bool has_rival = times.paced && times.pace.is_rival;
  if (has_rival) query.rival = rest_of(times.pace);
  trajectory_begin(memory.stage, memory.corridor, query, memory.chain);
  return has_rival ? 2 * ops::kCurve * times.pace.plan->count : 0;
}

Progress curves_advance(CurveMemory& memory, Curves& curves, Trajectory& trajectory, Work& work) noexcept {
  const TrajectoryStage& stage = memory.stage;
  const Progress progress = trajectory_advance(memory.stage, memory.corridor, work, trajectory);
  raise(curves.active_high, stage.active_high);
  raise(curves.iterations_high, stage.longest_solve);
  raise(curves.solves_high, stage.solves);
  if (progress == Progress::kMore) return progress;
  if (stage.query.scene != nullptr) raise(curves.separations_high, stage.separations.count);
  curves.status = stage.status;
  curves.quality = stage.quality;
  curves.optimiser = curves.stop_and_go ? curves.refused : stage.optimiser;
  return progress;
}

bool complete_trajectory(const Problem& problem, const EndStop* stops, Curves& curves, ViaMemory& vias,
                         Trajectory& trajectory) noexcept {
  if (!add_stops(stops[0], stops[1], trajectory)) return false;
  if (!add_dwells(problem, vias, trajectory)) return false;
  raise(curves.segments_high, trajectory.count);
  return true;
}

void refuse_optimised(Status why, Curves& curves) noexcept {
  curves.stop_and_go = true;
  curves.refused = why;
}

}  // namespace tern
