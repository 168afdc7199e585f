// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cinttypes>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "host/flight/commits_json.hpp"
#include "host/flight/simulated_flight.hpp"
#include "host/flight/straight_way.hpp"
#include "host/flight/things_json.hpp"
#include "host/number.hpp"

namespace tern_host {
namespace {

using Json = nlohmann::ordered_json;

/// The speed, and the angle where one is given.
Json wind_json(const Air& air) {
  return air.has_angle ? Json{air.wind, air.angle} : Json(air.wind);
}

Json cameras_json(const FlightSettings& s) {
  Json all = Json::array();
  for (const FurtherCamera& camera : s.cameras) all.push_back({camera.turn, camera.pitch});
  return all;
}

/// The source, and for clusters the number of the class that they are taken for.
Json source_json(const FlightSettings& s) {
  if (s.detection_source == "truth") return s.detection_source;
  return {s.detection_source, static_cast<int>(s.cluster_class)};
}

Json settings_json(const FlightSettings& s) {
  return {{"body_radius", s.body_radius},
          {"tracking_margin", s.tracking_margin},
          {"pose_margin", s.pose_margin},
          {"depth_margin", s.depth_margin},
          {"cell", s.cell},
          {"window", {s.window.x, s.window.y, s.window.z}},
          {"sensor", s.sensor},
          {"scan_pixel", s.scan_pixel},
          {"beams", s.beams},
          {"sensor_range", s.sensor_range},
          {"sensor_min", s.sensor_min},
          {"sensor_far", s.sensor_far},
          {"sensor_fov", {s.fov_horizontal, s.fov_vertical}},
          {"sensor_size", {s.width, s.height}},
          {"sensor_hz", s.sensor_hz},
          {"sensor_latency", s.sensor_latency},
          {"pixel_part", s.pixel_part},
          {"mount", s.mount.kind},
          {"mount_offset", {s.mount.offset.x, s.mount.offset.y, s.mount.offset.z}},
          {"mount_pitch", s.mount.pitch},
          {"further_camera", cameras_json(s)},
          {"gimbal_pitch", {s.mount.gimbal_low, s.mount.gimbal_high}},
          {"no_return", s.no_return},
          {"depth_noise", s.depth_noise},
          {"depth_error", {s.depth_error.base, s.depth_error.square}},
          {"holes", s.holes},
          {"dropout", s.dropout},
          {"outliers", s.outliers},
          {"speckle_filter", s.speckle_filter},
          {"hits", s.hits},
          {"support", s.support},
          {"v_max", s.v_max},
          {"a_max", s.a_max},
          {"j_max", s.j_max},
          {"thrust_max", s.thrust_max},
          {"thrust_min", s.thrust_min},
          {"tilt_tangent", s.tilt_tangent},
          {"rate_max", s.rate_max},
          {"yaw_rate", s.yaw_rate},
          {"yaw_acceleration", s.yaw_acceleration},
          {"yaw", s.yaw},
          {"tick_hz", s.tick_hz},
          {"work_per_tick", s.work_per_tick},
          {"far_cell", s.far_cell},
          {"time_limit", s.time_limit},
          {"goal_tolerance", s.goal_tolerance},
          {"tracking", s.tracking},
          {"monitor", s.monitor},
          {"wind", wind_json(s.air)},
          {"gusts", s.air.deviation()},
          {"drag", s.air.drag},
          {"stack_speed", s.stack_speed},
          {"seed", s.seed},
          {"things", s.things},
          {"things_seen", s.things_seen},
          {"detection_source", source_json(s)},
          {"thing_memory", s.thing_memory},
          {"detection_hz", s.detection_hz},
          {"detection_latency", s.detection_latency},
          {"detection_error", {s.detection_error, s.detection_speed_error}},
          {"detection_range", s.detection_range},
          {"detection_misses", s.detection_misses},
          {"detection_swaps", s.detection_swaps},
          {"detection_occlusion", s.detection_occlusion},
          {"from_beyond", {s.beyond_speed, s.beyond_size}},
          {"thing_bounds", s.thing_bounds},
          {"frames_until", s.frames_until},
          {"pose_jump", {s.pose_jump.size, s.pose_jump.every}},
          {"pose_drift", s.pose_drift},
          {"pose_lag", s.pose_lag},
          {"tick_skip", {s.tick_skip.share, s.tick_skip.longest}},
          {"goal_jitter", {s.goal_jitter.size, s.goal_jitter.until}},
          {"appear_ahead", {s.appear_ahead.time, s.appear_ahead.distance}},
          {"goal_place", s.goal_place}};
}

Json states_json(const FlightResult& result) {
  const auto& s = result.seconds_in;
  return {{"rest", s[0]}, {"look", s[1]}, {"fly", s[2]}, {"stop", s[3]}, {"threat", s[4]}};
}

Json watched_json(const WatchTotals& w) {
  return {{"ticks", w.ticks}, {"commits", w.commits}, {"points", w.points},  {"voxels", w.voxels},
          {"hits", w.hits},   {"snap", w.snap},       {"slivers", w.slivers}};
}

Json appeared_json(const std::vector<Appearance>& appeared) {
  Json all = Json::array();
  for (const Appearance& a : appeared) {
    const tern::Box& b = a.block;
    const Cylinder& c = a.cylinder;
    Json one = {{"time_s", a.time}};
    if (a.is_block) one["block"] = {b.lower.x, b.lower.y, b.lower.z, b.upper.x, b.upper.y, b.upper.z};
    if (!a.is_block) one["cylinder"] = {c.x, c.y, c.bottom, c.top, c.radius};
    all.push_back(one);
  }
  return all;
}

Json contact_json(const FlightContact& c) {
  Json json = {{"time_s", c.time}, {"speed", c.speed}, {"broken_assumption", c.broken_assumption}};
  if (c.with_appeared) {
    json["shown"] = c.threat.shown;
    json["commanded_speed"] = c.threat.speed;
    json["announced_speed"] = c.threat.announced_speed;
    json["brake_speed"] = c.threat.brake_speed;
  }
  return json;
}

Json narrow_json(const NarrowPlace& narrow) {
  Json json = {{"at", {narrow.at.x, narrow.at.y, narrow.at.z}}, {"gap", narrow.gap}, {"width_needed", narrow.width}};
  if (narrow.axis != 0) {
    json["along"] = std::string(1, narrow.axis);
    json["free"] = narrow.free;
  }
  return json;
}

Json blocked_json(const FlightResult& result) {
  const tern::Vec3& at = result.blocked_at;
  Json blocked = {{"by", tern::blocked_by_text(result.blocked_by)}, {"at", {at.x, at.y, at.z}}};
  if (result.blocked_fence != tern::kNoFence) blocked["fence"] = result.blocked_fence;
  return blocked;
}

Json in_vain_json(const std::vector<tern::UnseenVoxel>& voxels) {
  Json all = Json::array();
  for (const tern::UnseenVoxel& v : voxels) {
    Json directions = Json::array();
    for (std::int32_t k = 0; k < std::min(v.views, tern::kRememberedViews); ++k) {
      directions.push_back({v.directions[k].x, v.directions[k].y, v.directions[k].z});
    }
    all.push_back({{"at", {v.center.x, v.center.y, v.center.z}}, {"views", v.views}, {"directions", directions}});
  }
  return all;
}

Json mission_json(const std::vector<MissionPoint>& points) {
  Json all = Json::array();
  for (const MissionPoint& p : points) {
    Json point = {{"position", {p.position.x, p.position.y, p.position.z}}, {"state", p.state}};
    if (p.state == "passed") point.update({{"time_s", p.time}, {"distance", p.distance}, {"speed", p.speed}});
    all.push_back(point);
  }
  return all;
}

}  // namespace

std::string FlightResult::blocked() const {
  if (blocked_by == tern::BlockedBy::kNothing) return "";
  const std::string number =
      blocked_fence == tern::kNoFence ? "" : ", number " + std::to_string(blocked_fence + 1) + ",";
  return tern::blocked_by_text(blocked_by) + number + " at " + fixed(blocked_at.x, 2) + " " + fixed(blocked_at.y, 2) +
         " " + fixed(blocked_at.z, 2);
}

std::string flight_json(const FlightWorld& world, const FlightResult& result, bool with_commits) {
  char hash[17];
  std::snprintf(hash, sizeof hash, "%016" PRIx64, result.commands_hash);
  Json json = {{"format", "tern-flight/1"},
               {"status", result.status},
               {"reason", result.reason},
               {"world", world.name},
               {"start", {world.start.x, world.start.y, world.start.z}},
               {"goal", {world.goal.x, world.goal.y, world.goal.z}},
               {"mission", mission_json(result.mission)},
               {"settings", settings_json(world.settings)},
               {"time_s", result.time},
               {"length_m", result.length},
               {"mean_speed", result.time > 0.0 ? result.length / result.time : 0.0},
               {"min_clearance", result.min_clearance},
               {"tracking_error", {{"max", result.tracking_max}, {"rms", result.tracking_rms}}},
               {"pose_error", result.pose_max},
               {"plans",
                {{"asked", result.asked},
                 {"committed", result.committed},
                 {"dropped", result.dropped},
                 {"failed", result.failed}}},
               {"states", states_json(result)},
               {"view_wait_s", result.view_wait},
               {"standing_s", result.standing},
               {"straight_s", straight_time(world)},
               {"work", {{"max", result.work_max}, {"p99", result.work_p99}, {"total", result.work_total}}},
               {"watched", watched_json(result.watched)},
               {"commands_hash", hash}};
  const tern::Cylinder& column = world.column;
  if (column.radius > 0.0) json["column"] = {column.base.z, column.radius, column.height};
  if (world.landing.speed > 0.0) json["land"] = {world.landing.ground, world.landing.speed};
  if (result.blocked_by != tern::BlockedBy::kNothing) json["blocked"] = blocked_json(result);
  if (result.narrow.found) json["narrow"] = narrow_json(result.narrow);
  if (!result.reached() && !result.looked_in_vain.empty()) json["looked_in_vain"] = in_vain_json(result.looked_in_vain);
  if (result.skipped > 0) json["skipped_ticks"] = result.skipped;
  if (!result.appeared.empty()) json["appeared"] = appeared_json(result.appeared);
  if (result.contact.happened) json["contact"] = contact_json(result.contact);
  if (!world.things.empty()) json["things"] = things_json(world, result);
  if (result.far.searches > 0) json["far"] = {{"searches", result.far.searches}, {"marked", result.far.marked}};
  if (result.full_knowledge > 0.0) json["full_knowledge_s"] = result.full_knowledge;
  if (with_commits) {
    json["true_world"] = true_world_json(world);
    json["commits"] = commits_json(result);
    json["track"] = track_json(world, result);
  }
  return json.dump(with_commits ? 1 : 2) + "\n";
}

}  // namespace tern_host
