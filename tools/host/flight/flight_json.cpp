// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cinttypes>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "host/flight/simulated_flight.hpp"

namespace tern_host {
namespace {

using Json = nlohmann::ordered_json;

Json settings_json(const FlightSettings& s) {
  return {{"body_radius", s.body_radius},
          {"tracking_margin", s.tracking_margin},
          {"pose_margin", s.pose_margin},
          {"depth_margin", s.depth_margin},
          {"cell", s.cell},
          {"window", {s.window.x, s.window.y, s.window.z}},
          {"sensor_range", s.sensor_range},
          {"sensor_fov", {s.fov_horizontal, s.fov_vertical}},
          {"sensor_size", {s.width, s.height}},
          {"sensor_hz", s.sensor_hz},
          {"sensor_latency", s.sensor_latency},
          {"depth_noise", s.depth_noise},
          {"dropout", s.dropout},
          {"outliers", s.outliers},
          {"hits", s.hits},
          {"v_max", s.v_max},
          {"a_max", s.a_max},
          {"j_max", s.j_max},
          {"yaw_rate", s.yaw_rate},
          {"tick_hz", s.tick_hz},
          {"work_per_tick", s.work_per_tick},
          {"time_limit", s.time_limit},
          {"goal_tolerance", s.goal_tolerance},
          {"tracking", s.tracking},
          {"seed", s.seed}};
}

Json states_json(const FlightResult& result) {
  const auto& s = result.seconds_in;
  return {{"rest", s[0]}, {"look", s[1]}, {"fly", s[2]}, {"stop", s[3]}, {"threat", s[4]}};
}

}  // namespace

std::string flight_json(const FlightWorld& world, const FlightResult& result) {
  char hash[17];
  std::snprintf(hash, sizeof hash, "%016" PRIx64, result.commands_hash);
  const Json json = {{"format", "tern-flight/1"},
                     {"status", result.status},
                     {"world", world.name},
                     {"goal", {world.goal.x, world.goal.y, world.goal.z}},
                     {"settings", settings_json(world.settings)},
                     {"time_s", result.time},
                     {"length_m", result.length},
                     {"mean_speed", result.time > 0.0 ? result.length / result.time : 0.0},
                     {"min_clearance", result.min_clearance},
                     {"plans",
                      {{"asked", result.asked},
                       {"committed", result.committed},
                       {"dropped", result.dropped},
                       {"failed", result.failed}}},
                     {"states", states_json(result)},
                     {"work", {{"max", result.work_max}, {"p99", result.work_p99}}},
                     {"commands_hash", hash}};
  return json.dump(2) + "\n";
}

}  // namespace tern_host
