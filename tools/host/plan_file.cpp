// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/plan_file.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "host/closed_start.hpp"
#include "host/finding_text.hpp"
#include "host/met_text.hpp"
#include "host/number.hpp"
#include "host/occupied_text.hpp"

namespace tern_host {
namespace {

using Json = nlohmann::ordered_json;
using tern::Vec3;

Vec3 to_world(const Vec3& local, const Vec3& origin) {
  return {local.x + origin.x, local.y + origin.y, local.z + origin.z};
}

Json json(const Vec3& v) {
  return {v.x, v.y, v.z};
}

Json json(const tern::State& state) {
  return {{"position", json(state.position)},
          {"velocity", json(state.velocity)},
          {"acceleration", json(state.acceleration)},
          {"jerk", json(state.jerk)}};
}

Json limits_json(const tern::Limits& limits) {
  const LimitRange velocity = velocity_range(limits);
  const LimitRange acceleration = acceleration_range(limits);
  Json result = {{"v_max", json(velocity.upper)},
                 {"a_max", json(acceleration.upper)},
                 {"v_min", json(velocity.lower)},
                 {"a_min", json(acceleration.lower)}};
  if (velocity.horizontal > 0.0) result["v_horizontal"] = velocity.horizontal;
  if (acceleration.horizontal > 0.0) result["a_horizontal"] = acceleration.horizontal;
  const Vec3& jerk = limits.j_max;
  if (jerk.x > 0.0 || jerk.y > 0.0 || jerk.z > 0.0) result["j_max"] = json(jerk);
  if (limits.j_horizontal > 0.0) result["j_horizontal"] = limits.j_horizontal;
  if (limits.thrust_max > 0.0) result["thrust_max"] = limits.thrust_max;
  if (limits.thrust_min > 0.0) result["thrust_min"] = limits.thrust_min;
  if (limits.tilt_tangent > 0.0) result["tilt_tangent"] = limits.tilt_tangent;
  if (limits.rate_max > 0.0) result["rate_max"] = limits.rate_max;
  return result;
}

Json points_json(const Vec3* local, int count, const Vec3& origin) {
  Json points = Json::array();
  for (int i = 0; i < count; ++i) points.push_back(json(to_world(local[i], origin)));
  return points;
}

Json search_json(const PlanResult& result) {
  const tern::Path& path = *result.path;
  const Vec3& origin = result.grid.origin;
  return {{"jps_path", points_json(path.raw, path.raw_count, origin)},
          {"jps_length", path.raw_length},
          {"work", result.report.diagnostics.stages[static_cast<int>(tern::Stage::kSearch)].work},
          {"path", points_json(path.points, path.count, origin)},
          {"length", path.length}};
}

// a . (world - origin) <= b is a . world <= b + a . origin.
Json halfspace_json(const tern::Halfspace& plane, const Vec3& origin) {
  const Vec3& n = plane.normal;
  return {n.x, n.y, n.z, plane.offset + (n.x * origin.x + n.y * origin.y + n.z * origin.z)};
}

Json polyhedron_json(const tern::Polyhedron& polyhedron, const Vec3& origin) {
  Json planes = Json::array();
  for (int i = 0; i < polyhedron.count; ++i) planes.push_back(halfspace_json(polyhedron.planes[i], origin));
  return {{"halfspaces", planes}};
}

Json corridor_json(const tern::Corridor& corridor, const Vec3& origin) {
  Json polyhedra = Json::array();
  for (int i = 0; i < corridor.count; ++i) polyhedra.push_back(polyhedron_json(corridor.polyhedra[i], origin));
  return polyhedra;
}

Json segments_json(const tern::Trajectory& trajectory) {
  Json segments = Json::array();
  for (int i = 0; i < trajectory.count; ++i) {
    const tern::Segment& segment = trajectory.segments[i];
    segments.push_back({{"polyhedron", segment.polyhedron},
                        {"duration", segment.duration},
                        {"control_points", points_json(segment.points, tern::kControlPoints, trajectory.origin)},
                        {"relative_points", points_json(segment.points, tern::kControlPoints, {0.0, 0.0, 0.0})}});
  }
  return segments;
}

/// What was asked for at each via, and how the plan passes it, where there is one.
Json vias_json(const PlanResult& result) {
  Json vias = Json::array();
  for (std::size_t v = 0; v < result.scenario.vias.size(); ++v) {
    const tern::Via& via = result.scenario.vias[v];
    Json entry = {{"position", json(via.position)}, {"tolerance", via.tolerance}, {"stop", via.stop}};
    if (via.dwell > 0.0) entry["dwell"] = via.dwell;
    if (via.has_velocity) entry["velocity"] = json(via.velocity);
    if (result.ok()) {
      entry["time"] = result.report.vias[v].time;
      entry["distance"] = result.report.vias[v].distance;
    }
    vias.push_back(entry);
  }
  return vias;
}

Json timing_json(const Timing& timing) {
  return {{"inflate", timing.inflate},
          {"search", timing.of(tern::Stage::kSearch)},
          {"shortcut", timing.of(tern::Stage::kShortcut)},
          {"corridor", timing.of(tern::Stage::kCorridor)},
          {"time_allocation", timing.of(tern::Stage::kTimes)},
          {"optimization", timing.of(tern::Stage::kTrajectory)},
          {"check", timing.of(tern::Stage::kCheck)},
          {"world", timing.of(tern::Stage::kWorld)},
          {"detour", timing.of(tern::Stage::kDetour)},
          {"previous", timing.of(tern::Stage::kPrevious)},
          {"stop_first", timing.of(tern::Stage::kStopFirst)},
          {"reach", timing.of(tern::Stage::kReach)},
          {"tracks", timing.of(tern::Stage::kTracks)},
          {"total", timing.total()}};
}

Json yaw_json(const YawWish& wish, const tern::YawPlan& plan) {
  return {{"mode", yaw_mode_word(wish.mode)},
          {"rate_max", wish.rate_max},
          {"acceleration_max", wish.acceleration_max},
          {"start", {{"angle", wish.start}, {"rate", wish.start_rate}, {"acceleration", wish.start_acceleration}}},
          {"lead", {{"duration", plan.lead}, {"polynomial", plan.polynomial}}},
          {"step", plan.step},
          {"points", std::vector<double>(plan.points, plan.points + plan.count + 3)}};
}

std::string point_text(const Vec3& v) {
  return "(" + brief(v.x) + ", " + brief(v.y) + ", " + brief(v.z) + ")";
}

/// A number that is not -1 only where it has a value.
Json index_json(int index) {
  return index < 0 ? Json(nullptr) : Json(index);
}

Json check_json(const tern::ProofReport& check) {
  const tern::Voxel& voxel = check.voxel;
  return {{"finding", tern::finding_name(check.finding)},
          {"segment", index_json(check.segment)},
          {"time", check.until},
          {"fence", index_json(check.fence)},
          {"track", index_json(check.track)},
          {"via", index_json(check.via)},
          {"voxel", voxel.x < 0 ? Json(nullptr) : Json({voxel.x, voxel.y, voxel.z})},
          {"derivative", index_json(check.derivative)},
          {"axis", index_json(check.axis)},
          {"excess", check.excess}};
}

/// What the plan does about things that move.
void add_tracks(const PlanResult& result, Json& plan) {
  const Scenario& scenario = result.scenario;
  if (!scenario.depends_on_time()) return;
  const tern::Report& report = result.report;
  if (result.ok()) {
    const double until = report.rest_clear_until;
    plan["rest_clear_until"] = std::isfinite(until) ? Json(scenario.start_time + until) : Json(nullptr);
    plan["waits"] = report.waits;
    if (report.track >= 0) plan["leaves"] = result.track_name();
  }
  if (is_met(result)) {
    Json& conflict = plan["first_conflict"];
    if (report.track >= 0) conflict["track"] = result.track_name();
    if (report.track < 0) conflict["fence"] = report.fence;
    if (report.track < 0 && !zone_text(scenario.fences, report.fence).empty()) {
      conflict["zone"] = scenario.fences[static_cast<std::size_t>(report.fence)].zone;
    }
    conflict["time"] = scenario.start_time + report.conflict;
    if (report.status == tern::Status::kGoalCovered) {
      conflict["goal_free"] =
          std::isfinite(report.goal_free) ? Json(scenario.start_time + report.goal_free) : Json(nullptr);
    }
  }
}

std::string finding_text(const PlanResult& result) {
  const tern::ProofReport& check = result.report.check;
  if (check.finding == tern::Finding::kNone) return "";
  return "; the check found: " + describe_finding(check, result.scenario.fences, result.scenario.tracks);
}

std::string fence_text(const PlanResult& result) {
  const std::int32_t fence = result.report.fence;
  return "; fence: number " + std::to_string(fence + 1) + " of the request" + zone_text(result.scenario.fences, fence);
}

std::string describe_failure(const PlanResult& result) {
  const tern::Report& report = result.report;
  std::string text = std::string(tern::status_meaning(report.status)) + "; stage: " + tern::stage_name(report.stage);
  if (report.field != tern::Field::kNone) text += std::string("; field: ") + tern::field_name(report.field);
  if (report.via != tern::kNoVia) text += "; via: number " + std::to_string(report.via + 1) + " of the request";
  if (report.fence != tern::kNoFence) text += fence_text(result);
  text += describe_met(result) + describe_closed_start(result) + describe_occupied(result) + result.closed_way;
  if (report.has_reachable) text += "; a path comes as near as " + point_text(report.reachable);
  if (report.has_nearest_free) text += "; the nearest free voxel is at " + point_text(report.nearest_free);
  return text + finding_text(result);
}

}  // namespace

std::string describe_status(const PlanResult& result) {
  const tern::Report& report = result.report;
  if (report.status != tern::Status::kOk) return describe_failure(result);
  if (report.goal_missed != tern::Status::kOk) {
    return std::string("not at the goal but at ") + point_text(report.reachable) +
           ", as near as a path comes: " + tern::status_meaning(report.goal_missed) + result.closed_way;
  }
  const std::string reason = std::string(tern::status_name(report.optimiser)) + ", " +
                             tern::status_meaning(report.optimiser) + finding_text(result);
  const bool optimised = report.optimiser == tern::Status::kOk;
  if (report.quality == tern::Quality::kStopAndGo) {
    return optimised ? "one curve straight into the goal's motion, which is not optimised"
                     : "from stop to stop, because the optimiser ended with " + reason;
  }
  return optimised ? "" : "the optimiser ended with " + reason;
}

std::string plan_json(const PlanResult& result) {
  const Scenario& scenario = result.scenario;
  Json plan = {{"format", "tern-plan/1"},
               {"status", tern::status_name(result.report.status)},
               {"detail", describe_status(result)},
               {"scenario", scenario.name},
               {"resolution", scenario.resolution},
               {"robot_radius", scenario.radius},
               {"tracking_margin", scenario.tracking_margin},
               {"limits", limits_json(scenario.limits)},
               {"time_weight", scenario.time_weight},
               {"start_state", json(scenario.start)},
               {"goal_state", json(scenario.goal)}};
  const tern::Report& report = result.report;
  if (scenario.earth.is_known()) plan["frame"] = earth_json(scenario.earth);
  plan["start_time"] = scenario.start_time;
  add_tracks(result, plan);
  if (scenario.rest_clear > 0.0) plan["rest_clear"] = scenario.rest_clear;
  if (!scenario.vias.empty()) plan["vias"] = vias_json(result);
  if (report.finer_cell > 0.0) plan["finer_resolution"] = report.finer_cell;
  if (report.has_reachable) plan["reachable"] = json(report.reachable);
  if (report.goal_missed != tern::Status::kOk) plan["goal_missed"] = tern::status_name(report.goal_missed);
  if (result.path != nullptr) plan["search"] = search_json(result);
  if (result.corridor != nullptr) plan["corridor"] = corridor_json(*result.corridor, result.grid.origin);
  if (result.ok()) {
    plan["origin"] = json(result.trajectory.origin);
    plan["segments"] = segments_json(result.trajectory);
    plan["cost"] = {{"snap", tern::snap_cost(result.trajectory)}};
    plan["qp"] = {{"work", result.report.diagnostics.stages[static_cast<int>(tern::Stage::kTrajectory)].work}};
    if (result.yaw != nullptr) plan["yaw"] = yaw_json(scenario.yaw, *result.yaw);
  }
  if (result.report.check.finding != tern::Finding::kNone) plan["check"] = check_json(result.report.check);
  plan["timing_us"] = timing_json(result.timing);
  return plan.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace tern_host
