// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "host/figures.hpp"
#include "host/nearest_thing.hpp"
#include "host/number.hpp"
#include "host/page/page.hpp"
#include "host/page/run_json.hpp"
#include "host/plan_file.hpp"
#include "host/track_sample.hpp"

namespace tern_host {
namespace {

using tern::Vec3;

constexpr double kStep = 0.02;       ///< seconds between rows, at most
constexpr double kMaxRows = 6000.0;  ///< of a long plan
constexpr double kNoseRate = 2.0;    ///< rad/s, of a vehicle whose plan says nothing about its nose
constexpr double kNoseAcceleration = 4.0;
constexpr double kMotion = 0.3;  ///< m/s from which a motion has a direction

/// Where the plan leads first, seen from above.
tern::Heading first_heading(const tern::Trajectory& plan) {
  const double end = tern::duration(plan);
  for (int i = 0; i < 200; ++i) {
    const Vec3 v = tern::evaluate(plan, end * i / 200.0).velocity;
    if (std::hypot(v.x, v.y) > kMotion) return {v.x, v.y};
  }
  return {1.0, 0.0};
}

/// The plan's own yaw, or the nose along the motion.
tern::YawPlan nose_of(const PlanResult& result) {
  if (result.yaw != nullptr) return *result.yaw;
  tern::YawPlan plan{};
  tern::YawPlanner planner;
  planner.plan(result.trajectory, tern::yaw_request(first_heading(result.trajectory), kNoseRate, kNoseAcceleration),
               plan);
  return plan;
}

RunJson motion_json(const PlanResult& result) {
  const double end = tern::duration(result.trajectory);
  const double rows = std::clamp(std::ceil(end / kStep), 1.0, kMaxRows);
  const tern::YawPlan nose = nose_of(result);
  MotionColumns columns;
  for (double i = 0.0; i <= rows; i += 1.0) {
    const double t = end * i / rows;
    const tern::Sample sample = tern::evaluate(result.trajectory, t);
    const tern::FlatState flat = tern::flat_state(sample, tern::evaluate(nose, t).yaw);
    const double(&q)[4] = flat.quaternion;
    columns.add(sample, {q[0], q[1], q[2], q[3]}, distance_to_blocks(sample.position, result.scenario));
  }
  return columns.json(end / rows);
}

RunJson boxes_json(const Scenario& scenario, bool keepout) {
  RunJson list = RunJson::array();
  for (const Block& block : scenario.blocks) {
    if (block.keepout != keepout) continue;
    append_point(list, block.box.lower);
    append_point(list, block.box.upper);
  }
  return list;
}

RunJson points_json(const Vec3* points, int count, const Vec3& origin) {
  RunJson list = RunJson::array();
  for (int i = 0; i < count; ++i) {
    append_point(list, {points[i].x + origin.x, points[i].y + origin.y, points[i].z + origin.z});
  }
  return list;
}

/// One number for the three axes and both ways where they have the same limit; otherwise null.
RunJson common_limit(const LimitRange& limit) {
  const double most = limit.upper.x;
  for (const double number : {limit.upper.y, limit.upper.z, -limit.lower.x, -limit.lower.y, -limit.lower.z}) {
    if (number != most) return nullptr;
  }
  return rounded(most);
}

RunJson stages_json(const PlanResult& result) {
  RunJson stages = RunJson::array();
  for (int i = 0; i < tern::kStageCount; ++i) {
    if (result.report.diagnostics.stages[i].work == 0) continue;
    stages.push_back({{"name", tern::stage_name(static_cast<tern::Stage>(i))},
                      {"work", result.report.diagnostics.stages[i].work},
                      {"us", rounded(result.timing.stages[i], 0)}});
  }
  return stages;
}

constexpr double kThingStep = 0.1;    ///< seconds between rows of a thing, at least
constexpr double kThingRows = 600.0;  ///< of a thing, at most
constexpr double kAlone = 10.0;       ///< seconds that things are shown for without a plan

/// A shape, and rows of place and error; null while it is not there.
RunJson things_json(const PlanResult& result) {
  const double end = result.ok() ? tern::duration(result.trajectory) : kAlone;
  const double step = std::max(kThingStep, end / kThingRows);
  RunJson list = RunJson::array();
  const std::vector<tern::Track> tracks = tracks_of(result.scenario.tracks);
  for (std::size_t k = 0; k < tracks.size(); ++k) {
    RunJson rows = RunJson::array();
    for (double i = 0.0; i <= std::ceil(end / step); i += 1.0) {
      const TrackSample sample = sample_of(tracks[k], result.scenario.start_time + i * step);
      RunJson row = RunJson::array();
      append_point(row, sample.place);
      row.push_back(rounded(sample.error));
      rows.push_back(sample.is_there ? row : RunJson(nullptr));
    }
    const TrackRecord& record = result.scenario.tracks[k];
    list.push_back(
        thing_json({record.id, record.is_fence, tracks[k].shape, tracks[k].radius, tracks[k].half, step, rows}));
  }
  return list;
}

/// When each fence for a while holds, s since the plan's beginning; null for one that always does.
RunJson windows_json(const Scenario& scenario) {
  RunJson list = RunJson::array();
  for (const FenceRecord& record : scenario.fences) {
    const FenceSpan span = span_of(record.fence);
    const RunJson times{rounded(span.from - scenario.start_time), rounded(span.until - scenario.start_time)};
    list.push_back(tern::is_timed(record.fence) ? times : RunJson(nullptr));
  }
  return list;
}

/// Labels and texts, in the order in which they are shown.
RunJson facts_json(const PlanResult& result) {
  RunJson facts = RunJson::array();
  const auto add = [&](const char* label, const std::string& text) { facts.push_back({label, text}); };
  add("status", tern::status_name(result.report.status));
  const std::string detail = describe_status(result);
  if (!detail.empty()) add("why", detail);
  add("radius", fixed(result.scenario.radius, 2) + " m");
  add("computed in", fixed(1e-3 * result.timing.total(), 2) + " ms");
  if (result.ok() && result.report.waits > 0.0) add("waits", fixed(result.report.waits, 2) + " s for what moves");
  if (!result.ok()) return facts;
  const Figures figures = measure(result.trajectory, result.scenario);
  add("duration", fixed(figures.duration, 2) + " s");
  add("length", fixed(figures.length, 2) + " m");
  std::string clear = std::isfinite(figures.clearance) ? fixed(figures.clearance, 3) + " m from blocks" : "";
  const std::string moving = nearest_thing_text(nearest_thing(result.trajectory, result.scenario), result.scenario);
  if (!clear.empty() && !moving.empty()) clear += "; ";
  if (!(clear + moving).empty()) add("least clearance", clear + moving);
  add("highest speed", fixed(figures.speed, 2) + " m/s");
  add("limits used",
      fixed(100.0 * figures.v_use, 0) + " % of velocity, " + fixed(100.0 * figures.a_use, 0) + " % of acceleration");
  add("segments", std::to_string(result.trajectory.count));
  return facts;
}

}  // namespace

std::string plan_run(const PlanResult& result) {
  const Scenario& scenario = result.scenario;
  RunJson run = {{"kind", "plan"},
                 {"name", scenario.name.substr(scenario.name.find_last_of('/') + 1)},
                 {"facts", facts_json(result)},
                 {"boundary", rounded(scenario.boundary)},
                 {"radius", scenario.radius},
                 {"boxes", boxes_json(scenario, false)},
                 {"keepout", boxes_json(scenario, true)},
                 {"cylinders", RunJson::array()},
                 {"fences", fences_json(scenario.fences)},
                 {"windows", windows_json(scenario)},
                 {"things", things_json(result)},
                 {"start", rounded(scenario.start.position)},
                 {"goal", rounded(scenario.goal.position)},
                 {"vias", vias_json(scenario.vias)},
                 {"limits",
                  {{"v", common_limit(velocity_range(scenario.limits))},
                   {"a", common_limit(acceleration_range(scenario.limits))},
                   {"j", common_limit(jerk_range(scenario.limits))}}},
                 {"stages", stages_json(result)}};
  const Vec3& origin = result.grid.origin;
  if (result.path != nullptr) {
    run["path"] = {{"search", points_json(result.path->raw, result.path->raw_count, origin)},
                   {"short", points_json(result.path->points, result.path->count, origin)}};
  }
  if (result.corridor != nullptr) run["corridor"] = corridor_json(*result.corridor, origin);
  if (result.ok()) run["motion"] = motion_json(result);
  return run.dump(-1, ' ', false, RunJson::error_handler_t::replace);
}

}  // namespace tern_host
