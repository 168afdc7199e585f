// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The report: the only place that writes it, from what the parts noted.
#include "base/too_narrow.hpp"
#include "planner/layout.hpp"
#include "planner/pipeline.hpp"

namespace tern {
namespace {

std::int32_t most(std::int32_t a, std::int32_t b) {
  return a < b ? b : a;
}

bool is_occupied(Status status) {
  return status == Status::kStartOccupied || status == Status::kGoalOccupied || status == Status::kViaOccupied;
}

void write_failure(const Failure& failure, Status status, Report& report) {
  const bool narrow = is_too_narrow(status);
  report.via = failure.via;
  if (!narrow && !is_occupied(status)) return;
  report.raw_occupied = failure.end.raw_occupied;
  report.has_nearest_free = failure.end.has_nearest_free;
  report.nearest_free = failure.end.nearest_free;
  if (!narrow) return;
  report.finer_cell = failure.end.finer_cell;
  report.fence = failure.end.solid;
}

HighWater high_water(const Legs& legs, const Rooms& rooms, const Curves& curves, bool segments_full,
                     std::int32_t flood_words) {
  const std::int32_t segments = segments_full ? kMaxSegments : most(legs.segments_high, curves.segments_high);
  return {legs.nodes_high,
          legs.open_high,
          legs.jump_points_high,
          segments,
          rooms.planes_high,
          rooms.local_boxes_high,
          curves.active_high,
          curves.iterations_high,
          curves.solves_high,
          curves.separations_high,
          flood_words};
}

}  // namespace

void Pipeline::write(Report& report) const noexcept {
  report = Report{};
  const bool planned = status_ == Status::kOk && wanted_ == Asked::kPlan;
  report.status = status_;
  report.stage = ended_in_;
  report.field = fault_.field;
  report.fence = fault_.fence;
  report.track = fault_.track;
  if (status_ != Status::kOk) write_failure(failure_, status_, report);
  if (planned) report.quality = quality_;
  if (planned) report.entered = entered();
  if (planned) report.track = left_;
  if (planned) report.rest_clear_until = rest_until_;
  if (planned && !attempts_.around.is_active) report.waits = attempts_.waiting.waits;
  const bool is_by_track = status_ == conflict_.status || status_ == Status::kBudgetTracks;
  if (status_ != Status::kOk && is_by_track) {
    report.track = conflict_.track;
    report.fence = conflict_.fence;
    report.conflict = conflict_.until;
    if (status_ == Status::kGoalCovered) report.goal_free = goal_free_.free;
  }
  if (planned) write_passages(problem_, memory_->vias, memory_->trajectory, report.vias);
  report.optimiser = optimiser_;
  if (status_ == Status::kCheckFailed || optimiser_ == Status::kCheckFailed) report.check = refused_;
  report.has_reachable = attempts_.nearest.has_point;
  report.reachable = attempts_.nearest.point;
  report.goal_missed = attempts_.nearest.goal_missed;
  Diagnostics& diagnostics = report.diagnostics;
  diagnostics.detours = detours_of(attempts_.current);
  diagnostics.seed = planned ? seed_of(attempts_.around) : 0;
  diagnostics.search_bound = legs_.search_bound;
  diagnostics.search_used = legs_.search_used;
  diagnostics.high_water = high_water(legs_, rooms_, curves_, segments_full_, flood_words_);
  ledger_.write(diagnostics);
}

}  // namespace tern
