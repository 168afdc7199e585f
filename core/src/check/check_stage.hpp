// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Contract C4: what leaves the planner as kOk was checked here, by code that shares nothing with the stages that made
// it. It reads the raw obstacle layer, the half-spaces and the control points, and believes no other claim.
#ifndef TERN_CHECK_CHECK_STAGE_HPP
#define TERN_CHECK_CHECK_STAGE_HPP

#include <cstdint>

#include "base/progress.hpp"
#include "base/work.hpp"
#include "check/asked_fences.hpp"
#include "check/solid.hpp"
#include "check/tolerance.hpp"
#include "tern/corridor.hpp"
#include "tern/grid.hpp"
#include "tern/report.hpp"
#include "tern/request.hpp"
#include "tern/status.hpp"
#include "tern/trajectory.hpp"
#include "tern/via.hpp"

namespace tern {

/// Units of one check: every polyhedron and every segment.
constexpr std::uint32_t kCheckBound = 2 * kMaxSegments;

/// What the plan was asked for, as it was asked. World frame.
struct CheckQuery {
  State start;  ///< with the jerk that the plan was made to begin with
  State goal;
  Limits limits;
  const AskedFences* fences = nullptr;  ///< null: none
  const Via* vias = nullptr;
  const std::int32_t* joints = nullptr;  ///< segment at whose beginning the plan passes each via, or their count
  std::int32_t via_count = 0;
};

/// One keep-out at a time, about the middle of what surrounds it.
struct FenceScratch {
  Solid<DoubleDouble> exact;
  Solid<double> quick;  ///< the same, rounded
};

/// One unit of work is one polyhedron or one segment. Plain data, no initialisation needed before check_begin.
/// As a CheckReport: what the stage failed for.
struct CheckStage : CheckReport {
  Status status;        ///< kCheckFailed where the stage failed; else kOk
  std::int32_t next;    ///< units done: polyhedra first, then segments
  std::uint32_t units;  ///< the same, for the report
  FenceScratch scratch;
};

void check_begin(CheckStage& stage) noexcept;

/// kDone, or kFailed with the reason in `stage`. Reads its arguments only.
Progress check_advance(CheckStage& stage, const Grid& grid, const Corridor& corridor, const Trajectory& trajectory,
                       const CheckQuery& query, Work& work) noexcept;

// What a unit tests. Each answers whether the plan holds, and where it does not, fills `found` with the reason.

/// True where every obstacle voxel, as a closed cube, is cut off from the polyhedron by one of its half-spaces with
/// the grid's radius to spare. Sufficient for a distance >= radius, and what the corridor stage promises.
/// `effort`, where it is not null, grows by what that took (see Work).
bool polyhedron_clear(const Grid& grid, const Polyhedron& polyhedron, CheckReport& found,
                      std::uint32_t* effort = nullptr) noexcept;

/// True where every keep-out is cut off from the polyhedron (local frame) by one of its half-spaces with the radius to
/// spare, but for kCheckDistance; as far as it comes within the radius of the boundary.
bool keep_outs_clear(const Grid& grid, const Polyhedron& polyhedron, const AskedFences& fences, FenceScratch& scratch,
                     CheckReport& found) noexcept;

/// True where all control points, which are relative to `origin` in the world, are in each keep-in, but for the
/// tolerance.
bool keep_ins_hold(const Segment& segment, const AskedFences& fences, const Vec3& origin, double tolerance,
                   CheckReport& found) noexcept;

/// The limits for all t, of velocity, acceleration and, where it is limited, jerk.
bool limits_hold(const Segment& segment, const Limits& limits, CheckReport& found) noexcept;

/// Malformed numbers, membership, those limits, and the joint to the segment before (or the start state).
bool segment_holds(const Grid& grid, const Corridor& corridor, const Trajectory& trajectory, int index,
                   const CheckQuery& query, CheckReport& found) noexcept;

/// True where the plan passes the vias at those joints, in order, as near as asked, and at rest or with the velocity
/// that was asked for.
bool vias_met(const Grid& grid, const Trajectory& trajectory, const CheckQuery& query, CheckReport& found) noexcept;

/// A test that failed.
inline bool refuse(Finding finding, CheckReport& found) noexcept {
  found.finding = finding;
  return false;
}

}  // namespace tern

#endif
