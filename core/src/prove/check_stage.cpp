// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "prove/check_stage.hpp"

#include <new>

#include "prove/grants.hpp"
#include "prove/joints.hpp"

namespace tern {
namespace {

/// Instructions of a joint with the test of an end.
constexpr std::uint32_t kEndEffort = 1500;

bool refuse(Finding finding, std::int32_t segment, ProofReport& found) {
  found.finding = finding;
  found.segment = segment;
  return false;
}

/// True if the segment joins the one before or the start, and the goal if it is the last.
bool joint_holds(const Grid& grid, const Trajectory& trajectory, int index, const CheckQuery& query,
                 ProofReport& found) {
  const Segment& segment = trajectory.segments[index];
  const double distance = place_rounding(grid, trajectory);
  if (index == 0 && !state_met(segment, false, query.start, trajectory.origin, distance, found)) {
    return refuse(Finding::kBoundary, index, found);
  }
  if (index > 0 && !segments_join(trajectory.segments[index - 1], segment, found)) {
    return refuse(Finding::kJoint, index, found);
  }
  found.until += segment.duration;
  if (index + 1 < trajectory.count || state_met(segment, true, query.goal, trajectory.origin, distance, found)) {
    return true;
  }
  return refuse(Finding::kBoundary, index, found);
}

}  // namespace

/// The check's way into a proof.
struct PlanProof {
  static void begin(CheckStage& stage, const Grid& grid, const Corridor& corridor, const Trajectory& trajectory,
                    const CheckQuery& query) {
    const bool fenced = query.fences != nullptr;
    Proof* const proof = new (&stage.proof) Proof;
    proof->begin_plan(grid, trajectory, query.limits, fenced ? query.fences->fence : nullptr,
                      fenced ? query.fences->count : 0, corridor, stage.scratch);
    stage.phase = CheckPhase::kCurve;
  }

  /// Looks at a piece. False if the proof is over.
  static bool advance(CheckStage& stage, Work& work) {
    const std::uint32_t before = stage.proof.effort_;
    const Status status = stage.proof.step(1);
    work.effort += stage.proof.effort_ - before;
    return status == Status::kRunning;
  }
};

void check_begin(CheckStage& stage) noexcept {
  stage.status = Status::kOk;
  stage.phase = CheckPhase::kBegin;
  stage.next = 0;
  stage.units = 0;
  stage.found = ProofReport{};
}

Progress check_advance(CheckStage& stage, const Grid& grid, const Corridor& corridor, const Trajectory& trajectory,
                       const CheckQuery& query, Work& work) noexcept {
  if (stage.phase == CheckPhase::kBegin) PlanProof::begin(stage, grid, corridor, trajectory, query);
  while (stage.phase == CheckPhase::kCurve) {
    if (!work.take()) return Progress::kMore;
    ++stage.units;
    if (PlanProof::advance(stage, work)) continue;
    stage.phase = CheckPhase::kJoints;
    if (stage.proof.report().finding != Finding::kNone) {
      stage.found = stage.proof.report();
      return conclude(Status::kCheckFailed, stage.status);
    }
  }
  for (; stage.next < trajectory.count; ++stage.next) {
    if (!work.take()) return Progress::kMore;
    ++stage.units;
    work.effort += kEndEffort;
    if (!joint_holds(grid, trajectory, stage.next, query, stage.found)) {
      return conclude(Status::kCheckFailed, stage.status);
    }
  }
  return conclude(vias_met(grid, trajectory, query, stage.found) ? Status::kOk : Status::kCheckFailed, stage.status);
}

}  // namespace tern
