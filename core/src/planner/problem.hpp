// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The request in the form that all stages and attempts read.
#ifndef TERN_PLANNER_PROBLEM_HPP
#define TERN_PLANNER_PROBLEM_HPP

#include <cstdint>

#include "base/bounds.hpp"
#include "base/work.hpp"
#include "prove/fences.hpp"
#include "tern/grid.hpp"
#include "tern/request.hpp"
#include "tern/status.hpp"
#include "tern/track.hpp"
#include "tern/trajectory.hpp"
#include "tern/vec3.hpp"
#include "tern/via.hpp"
#include "tracks/thing.hpp"
#include "world/world_memory.hpp"

namespace tern {

/// Pipeline::read() fills it in. After that, only the goal changes: with GoalMode::kNearest it becomes the reachable
/// point. The stages and attempts only read it.
struct Problem {
  const Grid* grid;          ///< the caller's
  GridVersion version;       ///< of that grid: it may not change
  const WorldMemory* world;  ///< the memory of the world: see world_of()
  const Via* vias;           ///< world frame
  std::int32_t via_count;
  const Track* tracks;
  std::int32_t track_count;
  std::int32_t thing_count;       ///< of `tracks`, with the keep-outs for a while behind the request's
  const ConvexSolid* solids;      ///< of these keep-outs
  const AskedWorld* asked_world;  ///< the fences, likewise; null: none
  bool has_windows;               ///< some of them are for a while
  MotionLimits limits;
  Request asked;       ///< the request; its pointers are not followed again
  Status goal_fault;   ///< kGoalFenced: only the reachable point is left to look for; else kOk
  bool given_at_rest;  ///< both ends were given at rest
  bool has_pace;       ///< Previous::plan passes the start, `pace_from` seconds after its beginning
  double pace_from;
  bool must_beat_pace;  ///< only a plan that is better than that is of use
};

/// What is wrong with a request.
struct RequestFault {
  Status status;
  Field field;
  std::int32_t fence = kNoFence;  ///< index in Request::fences
  std::int32_t via = kNoVia;      ///< index in Request::vias
  std::int32_t track = kNoTrack;  ///< index in Request::tracks
};

/// The ends that the search joins: the request's, or the places at which the plan stops first. The states are relative
/// to the requested start, which is, bit for bit, the origin of the plan's frame. The other positions are in the grid's
/// local frame, within its boundary.
struct Ends {
  State start;
  State goal;
  Vec3 start_in_grid;
  Vec3 goal_in_grid;
  Vec3 origin_in_grid;  ///< of the plan's frame
};

inline World world_of(const Problem& problem) noexcept {
  return world_of(*problem.world);
}

/// The world's voxels, which the stages search: the caller's grid, or a copy in which walls and solids are blocked.
inline const Grid& voxels_of(const Problem& problem) noexcept {
  return world_of(problem).voxels();
}

/// What a plan is led around, in a frame with this origin.
Things things_of(const Problem& problem, const Vec3& origin) noexcept;

/// The clock and the frame of a new plan. Its origin is the start, in world coordinates as they were given.
inline void begin_trajectory(const Problem& problem, Trajectory& trajectory) noexcept {
  trajectory.begin = problem.asked.begin;
  trajectory.origin = problem.asked.start.position;
}

/// The requested start (0) or goal (1), relative to the plan's origin.
State asked_end(const Problem& problem, int end) noexcept;

/// The request's ends.
void take_ends(const Problem& problem, Ends& ends) noexcept;

/// Reads the request's fences, for planning and for the check, and compares start, vias and goal with them. Answers kOk
/// or the first thing that is wrong. The field and the fence are also set for kOk with a goal that breaks a fence.
/// `spent` grows by the operations that it took.
RequestFault read_world(const Request& request, const Ends& ends, Problem& problem, WorldMemory& world,
                        AskedWorld& asked, Operations& spent) noexcept;

/// Both requested ends are at rest.
bool rests(const Problem& problem) noexcept;

/// The plan dwells at a via.
bool has_dwells(const Problem& problem) noexcept;

}  // namespace tern

#endif
