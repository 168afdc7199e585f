// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a status and a report may say.
#include <cinttypes>
#include <cstdio>
#include <cstring>

#include "attack/attack_case.hpp"
#include "attack/emptiness.hpp"
#include "attack/solid.hpp"

namespace tern_attack {

using tern::Status;

bool is_capacity(Status status) {
  const int value = static_cast<int>(status);
  return value >= 50 && value < 70;
}

namespace {

bool is_occupied(Status status) {
  return status == Status::kStartOccupied || status == Status::kGoalOccupied || status == Status::kViaOccupied;
}

bool is_narrow(Status status) {
  return status == Status::kStartTooNarrow || status == Status::kGoalTooNarrow || status == Status::kViaTooNarrow;
}

bool is_budget(Status status) {
  return static_cast<int>(status) >= 90;
}

/// No answer to any valid request: the plan failed inside, or the request was called wrong.
bool never(Status status) {
  switch (status) {
    case Status::kCheckFailed:
    case Status::kNumerical:
    case Status::kInfeasible:
    case Status::kSelfTestFailed:
    case Status::kRunning:
    case Status::kNonFiniteInput:
    case Status::kInvalidArgument:
    case Status::kLimitsInvalid:
    case Status::kOutOfMap:
    case Status::kStartExceedsLimits:
    case Status::kGoalExceedsLimits:
    case Status::kViaExceedsLimits:
    case Status::kViasFull:
    case Status::kMapChanged:
    case Status::kWorkingSetFull:
    case Status::kIterationLimit:
      return true;
    default:
      return std::strcmp(tern::status_name(status), "unknown") == 0;
  }
}

bool fits_budget(const Ask& ask, Status status) {
  const tern::Budget& b = ask.request.budget;
  constexpr std::uint32_t kNone = 0xFFFFFFFFu;
  switch (status) {
    case Status::kBudgetSearch:
      return b.search != kNone;
    case Status::kBudgetShortcut:
      return b.shortcut != kNone;
    case Status::kBudgetCorridor:
      return b.corridor != kNone;
    case Status::kBudgetOptimise:
      return b.trajectory != kNone && (!ask.rest_to_rest() || ask.hurries());
    case Status::kBudgetTracks:
      return b.tracks != kNone;
    default:
      return true;
  }
}

/// True where a fence is said to be broken that some half-space proves to be kept.
bool fence_claim_is_wrong(const World& world, const Ask& ask, const tern::Report& report, Status status) {
  if (report.fence < 0 || report.fence >= ask.request.fence_count) return true;
  const tern::Fence& fence = ask.request.fences[report.fence];
  const bool at_via = status == Status::kViaFenced;
  if (at_via && (report.via < 0 || report.via >= ask.request.via_count)) return true;
  const tern::State& state = status == Status::kStartFenced ? ask.request.start : ask.request.goal;
  const Point p = world.local(at_via ? ask.vias[static_cast<std::size_t>(report.via)].position : state.position);
  Real outmost = -1e30L;
  for (const Plane& plane : planes_of(world, fence)) outmost = std::max(outmost, dot(plane.normal, p) - plane.offset);
  constexpr Real kDoubt = 1e-8L;
  return fence.kind == tern::FenceKind::kKeepIn ? outmost <= -kDoubt : outmost >= world.radius() + kDoubt;
}

void check_report(Context& context, const World& world, const Ask& ask, const tern::Report& r, Status status,
                  const char* what) {
  Findings& f = context.findings;
  if (r.status != status) report(f, "report", "%s: its status is %s", what, tern::status_name(r.status));
  const bool ok = status == Status::kOk;
  if (ok != (r.quality != tern::Quality::kNone))
    report(f, "report", "%s: quality %d", what, static_cast<int>(r.quality));
  for (int k = 0; k < tern::kStageCount; ++k) {
    if (r.diagnostics.stages[k].work <= r.diagnostics.stages[k].bound) continue;
    report(f, "report", "%s: %s spent %" PRIu64 " of %" PRIu64, what, tern::stage_name(static_cast<tern::Stage>(k)),
           r.diagnostics.stages[k].work, r.diagnostics.stages[k].bound);
  }
  if (r.entered != (r.quality == tern::Quality::kPrevious ? ask.request.previous_time : 0.0)) {
    report(f, "report", "%s: entered at %.17g", what, r.entered);
  }
  const bool occupied = is_occupied(status) || is_narrow(status);
  if (r.has_nearest_free && !occupied)
    report(f, "report", "%s: a nearest free voxel for %s", what, tern::status_name(status));
  if (r.has_nearest_free && free_voxel_at(world, r.nearest_free).x < 0) {
    report(f, "report", "%s: the nearest free voxel is not free", what);
  }
  if (r.finer_cell > 0.0 && (!is_narrow(status) || r.finer_cell > 0.5 * world.spec.cell)) {
    report(f, "report", "%s: a finer cell of %g for %s", what, r.finer_cell, tern::status_name(status));
  }
  const bool fenced = status == Status::kStartFenced || status == Status::kGoalFenced || status == Status::kViaFenced;
  if (r.via != tern::kNoVia && (ok || r.via < 0 || r.via >= ask.request.via_count)) {
    report(f, "report", "%s: via %d for %s", what, r.via, tern::status_name(status));
  }
  if (fenced && fence_claim_is_wrong(world, ask, r, status)) {
    report(f, "fenced", "%s: %s by fence %d, which is kept", what, tern::status_name(status), r.fence);
  }
}

bool is_map_answer(Status status) {
  return is_occupied(status) || is_narrow(status) || status == Status::kNoPath || status == Status::kViaFenced ||
         status == Status::kCorridorBlocked || status == Status::kStartFenced || status == Status::kGoalFenced;
}

}  // namespace

void judge(Context& context, const World& world, const Map& map, const Ask& ask, const tern::Report& r, Status status,
           const char* what) {
  ++context.tally.plans;
  ++context.tally.status[static_cast<int>(status)];
  for (const tern::StageReport& stage : r.diagnostics.stages) context.tally.work += stage.work;
  check_report(context, world, ask, r, status, what);
  judge_fences(world, ask.request.fences, ask.request.fence_count, status, r.fence, what, context.findings);
  if (status == Status::kOk) {
    context.tally.hover += r.quality == tern::Quality::kHover;
    context.tally.stop_and_go += r.quality == tern::Quality::kStopAndGo;
    context.tally.optimised += r.quality == tern::Quality::kOptimised;
    context.tally.followed += r.quality == tern::Quality::kPrevious;
    return;
  }
  Findings& f = context.findings;
  const char* name = tern::status_name(status);
  const std::string kind = std::string("status_") + name;
  if (never(status) || !fits_budget(ask, status)) return report(f, kind.c_str(), "%s: never an answer", what);
  if (is_capacity(status) || is_budget(status) || status == Status::kFenceEmpty) return;
  const bool rest = ask.rest_to_rest() && !ask.hurries();
  if (rest && (status == Status::kCorridorBlocked || status == Status::kNoTrajectory)) {
    return report(f, kind.c_str(), "%s: from rest to rest", what);
  }
  if ((rest || is_map_answer(status)) && ask.unlimited_search() && must_connect(world, map, ask)) {
    const std::string c6 = std::string(ask.fences.empty() ? "c6_" : "c6_fences_") + name;
    return report(f, c6.c_str(), "%s: the grid connects start and goal", what);
  }
  if (status == Status::kNoTrajectory && has_room_to_stop(world, ask)) {
    report(f, "no_room", "%s: there is room to stop straight ahead", what);
  }
}

}  // namespace tern_attack
