// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Contract C4: every plan that leaves the planner as kOk was checked here, by code that shares nothing with the stages
// that made it. It reads the raw obstacle layer, the half-spaces and the control points, and believes no other claim.
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

/// What the request asked of the plan, as the caller gave it. World frame.
struct CheckQuery {
  State start;  ///< with the jerk that the plan was made to begin with
  State goal;
  Limits limits;
  const AskedFences* fences = nullptr;  ///< null: none
  const Via* vias = nullptr;
  const std::int32_t* joints = nullptr;  ///< for each via, the segment that begins where the plan passes it, or the
                                         ///< number of segments
  std::int32_t via_count = 0;
};

/// Memory for one keep-out at a time, relative to the centre of the box around the boundary.
struct FenceScratch {
  Solid<DoubleDouble> exact;
  Solid<double> quick;  ///< the same, rounded
};

/// One unit of work is one polyhedron or one segment. Plain data, no initialisation needed before check_begin. Its
/// CheckReport says why the stage failed.
struct CheckStage : CheckReport {
  Status status;        ///< kCheckFailed if the stage failed; else kOk
  std::int32_t next;    ///< units done: polyhedra first, then segments
  std::uint32_t units;  ///< units done, for the report
  FenceScratch scratch;
};

void check_begin(CheckStage& stage) noexcept;

/// kDone, or kFailed with the reason in `stage`. Reads its arguments only.
Progress check_advance(CheckStage& stage, const Grid& grid, const Corridor& corridor, const Trajectory& trajectory,
                       const CheckQuery& query, Work& work) noexcept;

// The tests of a unit. Each returns whether the plan passes; if it does not, `found` receives the reason.

/// True if each obstacle voxel, as a closed cube, is cut off by some half-space of the polyhedron with the grid's
/// radius to spare. The corridor stage promises this, and it suffices for a distance >= radius. `effort`, if not null,
/// grows by the test's instructions (see Work).
bool polyhedron_clear(const Grid& grid, const Polyhedron& polyhedron, CheckReport& found,
                      std::uint32_t* effort = nullptr) noexcept;

/// True if each keep-out is cut off by some half-space of the polyhedron (local frame) with the radius to spare, to
/// within the tolerance. Only the part of a keep-out within the radius of the boundary and of all keep-ins counts.
bool keep_outs_clear(const Grid& grid, const Polyhedron& polyhedron, const AskedFences& fences, FenceScratch& scratch,
                     CheckReport& found) noexcept;

/// True if all control points are in each keep-in, to within the tolerance. They are relative to `origin` in the world.
bool keep_ins_hold(const Segment& segment, const AskedFences& fences, const Vec3& origin, double tolerance,
                   CheckReport& found) noexcept;

/// True if velocity, acceleration and, if it is limited, jerk keep the limits at all times.
bool limits_hold(const Segment& segment, const Limits& limits, CheckReport& found) noexcept;

/// True if the segment's numbers are sane, it lies in its polyhedron and the boundary, it keeps the limits, and it
/// joins the segment before or the start state. The last segment must also meet the goal state.
bool segment_holds(const Grid& grid, const Corridor& corridor, const Trajectory& trajectory, int index,
                   const CheckQuery& query, CheckReport& found) noexcept;

/// True if the plan passes the vias at query.joints, in order, within each tolerance, and at rest or with the velocity
/// that the via asks for.
bool vias_met(const Grid& grid, const Trajectory& trajectory, const CheckQuery& query, CheckReport& found) noexcept;

/// Notes why a test failed. Always false.
inline bool refuse(Finding finding, CheckReport& found) noexcept {
  found.finding = finding;
  return false;
}

}  // namespace tern

#endif
