// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "plans/limit_rows.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "times/times_stage.hpp"

namespace tern_bench {
namespace {

using tern::Vec3;

constexpr int kSamples = 400;

double component(const Vec3& n, const Vec3& v) {
  return n.x * v.x + n.y * v.y + n.z * v.z;
}

/// The largest part of a derivative along n over the whole segment, by the evaluator, not by control points.
double peak(const tern::Trajectory& one, int order, const Vec3& n) {
  double result = 0.0;
  const double end = one.segments[0].duration;
  for (int k = 0; k <= kSamples; ++k) {
    const tern::Sample sample = tern::evaluate(one, k == kSamples ? std::nextafter(end, 0.0) : end * k / kSamples);
    result = std::max(result, component(n, order == 1 ? sample.velocity : sample.acceleration));
  }
  return result;
}

}  // namespace

std::vector<LimitRow> Prober::rows(const tern::Corridor& corridor, const tern::Limits& limits, double time_weight) {
  tern::TrajectoryQuery query{};
  query.start.position = corridor.polyhedra[0].from;
  query.goal.position = corridor.polyhedra[corridor.count - 1].to;
  query.limits = limits;
  query.time_weight = time_weight;
  tern::TimesStage times;
  tern::Chain chain;
  tern::Work all{0xFFFFFFFFu};
  tern::times_begin(times, corridor, {query.start, query.goal, limits}, chain);
  tern::times_advance(times, corridor, all, chain);
  tern::trajectory_begin(*stage_, corridor, query, chain);
  std::vector<LimitRow> rows;
  tern::Progress progress = tern::Progress::kMore;
  while (progress == tern::Progress::kMore) {
    const bool judges = stage_->phase == tern::TrajectoryPhase::kJudge;
    durations_.assign(stage_->chain.duration, stage_->chain.duration + stage_->chain.count);
    tern::Work unit{1};
    progress = tern::trajectory_advance(*stage_, corridor, unit, *plan_);
    if (judges && stage_->solve_status == tern::Status::kOk) collect(rows);
  }
  return rows;
}

LimitRow Prober::measure(const tern::QpConstraint& row) const {
  const tern::PointOrigin& origin = stage_->scale.origin[row.point];
  const tern::Halfspace& plane = stage_->problem.planes[row.plane];
  tern::Trajectory one{};
  one.count = 1;
  one.segments[0].duration = durations_[static_cast<std::size_t>(origin.segment)];
  std::copy_n(stage_->points[origin.segment], tern::kControlPoints, one.segments[0].points);
  const double limit = plane.offset * stage_->scale.unit[origin.order];
  LimitRow result{origin.order, 0, RowKind::kHorizontal, peak(one, origin.order, plane.normal) / limit};
  const double n[3] = {plane.normal.x, plane.normal.y, plane.normal.z};
  for (int a = 0; a < 3; ++a) {
    if (std::fabs(n[a]) < 1.0) continue;
    result.axis = a;
    result.kind = n[a] > 0.0 ? RowKind::kUp : RowKind::kDown;
  }
  return result;
}

void Prober::collect(std::vector<LimitRow>& rows) const {
  std::set<std::pair<int, int>> seen;  // segment and plane
  for (int r = 0; r < stage_->solution.active_count; ++r) {
    const tern::QpConstraint& row = stage_->solution.active[r];
    const tern::PointOrigin& origin = stage_->scale.origin[row.point];
    if (origin.order == 0 || !seen.insert({origin.segment, row.plane}).second) continue;
    rows.push_back(measure(row));
  }
}

}  // namespace tern_bench
