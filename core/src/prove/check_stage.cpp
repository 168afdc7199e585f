// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "prove/check_stage.hpp"

#include <new>

#include "base/math.hpp"
#include "prove/grants.hpp"
#include "prove/joints.hpp"
#include "prove/turning.hpp"

namespace tern {
namespace {

/// Half of what other curves are granted.
constexpr double kPlanTrackGrant = 0.5 * kTrackTolerance;
/// Operations at a joint: both curves and their derivatives at one end.
constexpr Operations kEndOperations = ops::kPiece + 2 * ops::kCurve;

bool refuse(Finding finding, std::int32_t segment, ProofReport& found) {
  found.finding = finding;
  found.segment = segment;
  return false;
}

/// True if the segment joins the one before, or the start if the plan enters there, and the goal if it is the last.
/// Nothing is asked of a segment that is over by then. The segment begins at found.until.
bool joint_holds(const Grid& grid, const Trajectory& trajectory, int index, const CheckQuery& query,
                 ProofReport& found) {
  const Segment& segment = trajectory.segments[index];
  const double distance = place_rounding(grid, trajectory);
  const bool is_last = index + 1 == trajectory.count;
  const double end = found.until + segment.duration;
  const bool is_over = !is_last && query.entered >= end;
  const bool follows = query.entered < found.until;
  if (follows && !segments_join(trajectory.segments[index - 1], segment, found)) {
    return refuse(Finding::kJoint, index, found);
  }
  if (!follows && !is_over) {
    const Jet start = jet_within(segment, smaller((query.entered - found.until) / segment.duration, 1.0));
    if (!state_met(start, segment, query.start, trajectory.origin, distance, found)) {
      return refuse(Finding::kBoundary, index, found);
    }
  }
  found.until = end;
  if (!is_last || state_met(jet_of(segment, true), segment, query.goal, trajectory.origin, distance, found)) {
    return true;
  }
  return refuse(Finding::kBoundary, index, found);
}

/// Begins the proof of the curve from `entered` on.
void begin_curve(CheckStage& stage, const Grid& grid, const Trajectory& trajectory, const Limits* limits,
                 double entered, const AskedWorld* world, double spare, const Corridor* corridor) {
  stage.hints.corridor = corridor;
  new (&stage.proof) Proof;
  stage.proof.begin_plan(grid, trajectory, entered, limits, world, spare, stage.hints);
  stage.phase = CheckPhase::kCurve;
}

/// What the plan must be clear of for so many seconds at its end.
TrackGrounds grounds_of(const Grid& grid, const CheckQuery& query, double rest) {
  TrackGrounds grounds{query.tracks, query.track_count, grid.spec().clearance(), rest, true};
  if (query.world == nullptr) return grounds;
  grounds.fences = query.world->fence;
  grounds.fence_count = query.world->count;
  return grounds;
}

/// Begins the proof of how long the plan may rest at its end.
void begin_rest(CheckStage& stage, const Grid& grid, const Trajectory& trajectory, const CheckQuery& query) {
  stage.phase = CheckPhase::kRest;
  stage.at_end.begin_accepted(trajectory, duration(trajectory), __builtin_inf(), kPlanTrackGrant,
                              grounds_of(grid, query, kRestHorizon));
}

Progress prove_rest(CheckStage& stage, Work& work) {
  return stage.at_end.step(work) == Status::kRunning ? Progress::kMore : Progress::kDone;
}

/// Goes on with the proof of the curve.
Progress prove_curve(CheckStage& stage, Work& work) {
  if (stage.proof.step(work) == Status::kRunning) return Progress::kMore;
  stage.phase = CheckPhase::kJoints;
  if (stage.proof.report().finding == Finding::kNone) return Progress::kDone;
  stage.found = stage.proof.report();
  return conclude(Status::kCheckFailed, stage.status);
}

}  // namespace

/// All rows of the grid may be near a piece, and every other voxel of a row may be an obstacle.
Operations check_piece_operations(const GridSpec& spec) noexcept {
  const Operations rows = Operations{spec.dims.y} * spec.dims.z;
  const Operations cuts = 4 * ops::kRow + 18 * ops::kMultiplyAdd * kMaxPlanes;
  const Operations boxes = 2 * ops::kRow + (spec.dims.x / 2 + 1) * (8 + 15 * kControlPoints) * ops::kDot;
  return kEndOperations + kTurningOperations + 12 * ops::kPiece + 6 * ops::kDot * kMaxPlanes + kAskedOperations +
         rows * (cuts + 2 * ops::kPiece + boxes);
}

void check_begin(CheckStage& stage) noexcept {
  stage.status = Status::kOk;
  stage.phase = CheckPhase::kBegin;
  stage.next = 0;
  new (&stage.at_end) TrackProof;
  stage.found = ProofReport{};
  stage.hints.hinted = stage.hints.solid = 0;
}

Progress room_advance(CheckStage& stage, const Grid& grid, const Trajectory& part, const AskedWorld* world,
                      double spare, Work& work) noexcept {
  if (stage.phase == CheckPhase::kBegin) begin_curve(stage, grid, part, nullptr, 0.0, world, spare, nullptr);
  return prove_curve(stage, work);
}

Progress check_advance(CheckStage& stage, const Grid& grid, const Corridor& corridor, const Trajectory& trajectory,
                       const CheckQuery& query, Work& work) noexcept {
  if (stage.phase == CheckPhase::kBegin) {
    begin_curve(stage, grid, trajectory, &query.limits, query.entered, query.world, 0.0, &corridor);
    stage.proof.watch(grounds_of(grid, query, query.rest), kPlanTrackGrant);
  }
  if (stage.phase == CheckPhase::kCurve) {
    const Progress proven = prove_curve(stage, work);
    if (proven != Progress::kDone) return proven;
  }
  if (stage.phase == CheckPhase::kRest) return prove_rest(stage, work);
  for (; stage.next < trajectory.count; ++stage.next) {
    if (!work.left()) return Progress::kMore;
    work.spend(kEndOperations);
    if (!joint_holds(grid, trajectory, stage.next, query, stage.found)) {
      return conclude(Status::kCheckFailed, stage.status);
    }
  }
  if (!vias_met(grid, trajectory, query, stage.found)) return conclude(Status::kCheckFailed, stage.status);
  if (!watches(grounds_of(grid, query, query.rest))) return Progress::kDone;
  begin_rest(stage, grid, trajectory, query);
  return prove_rest(stage, work);
}

double rest_clear_until(const CheckStage& stage) noexcept {
  const ProofReport& found = stage.at_end.report();
  return found.finding != Finding::kNone ? found.until : __builtin_inf();
}

}  // namespace tern
