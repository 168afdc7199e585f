// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/flight_specs.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "host/flight/clear_ends.hpp"
#include "host/flight/full_knowledge.hpp"
#include "host/flight/lidar.hpp"
#include "host/number.hpp"
#include "tern/from_beyond.hpp"

namespace tern_host {
namespace {

constexpr double kHorizon = 0.8;                       ///< of plans, in sensor ranges
constexpr double kScanPixels = 6.0 * 2.5 * 2.5 + 0.1;  ///< of a map with a scan_pixel of 1 rad

int voxels(double metres, double cell) {
  return std::min(tern::kMaxDimension, static_cast<int>(std::ceil(metres / cell)));
}

/// Flies no faster than lets the vehicle stop for what comes from beyond the detector's range.
void slow_for_beyond(const FlightSettings& s, tern::FlightSpec& spec) {
  if (!(s.beyond_speed > 0.0)) return;
  const double delay = 1.0 / s.detection_hz + s.detection_latency;
  const double error = s.detection_error + s.pose_margin;
  const double clearance = s.body_radius + s.pose_margin + s.tracking_margin;
  tern::Trajectory room;
  const tern::Status status = tern::limit_speed({s.detection_range, delay, s.beyond_speed, s.beyond_size + error}, spec,
                                                clearance, spec.limits, room);
  if (status == tern::Status::kOk) return;
  throw std::runtime_error("from_beyond " + brief(s.beyond_speed) + " " + brief(s.beyond_size) +
                           (status == tern::Status::kLimitsInvalid
                                ? ": a detection_range of " + brief(s.detection_range) + " m is too short to stop in"
                                : ": the vehicle's limits have a rate_max, for which nothing is known"));
}

}  // namespace

tern::MapSpec map_spec_of(const FlightWorld& world) {
  const FlightSettings& s = world.settings;
  const tern::Box& b = world.boundary;
  const double height = std::min(s.window.z, b.upper.z - b.lower.z + 4.0 * s.cell);
  const tern::Voxel dims{voxels(s.window.x, s.cell), voxels(s.window.y, s.cell), voxels(height, s.cell)};
  const double bottom = height < s.window.z ? b.lower.z - 2.0 * s.cell : world.start.z - 0.5 * height;
  const tern::Vec3 origin{world.start.x - 0.5 * s.window.x, world.start.y - 0.5 * s.window.y, bottom};
  tern::MapSpec spec = tern::map_spec(origin, s.cell, dims, s.body_radius + s.pose_margin);
  spec.tracking_margin = s.tracking_margin;
  spec.range = s.sensor_range;
  spec.depth_margin = s.depth_margin + s.depth_noise * s.sensor_range + s.depth_error.base;
  spec.depth_margin_square = s.depth_error.square;
  spec.pose_margin = s.pose_margin;
  spec.hits = s.hits;
  spec.support = s.support;
  spec.slack = 8;
  spec.pixels = s.width * s.height;
  if (s.sensor == "lidar") {
    spec.scan_pixel = s.scan_pixel;
    spec.pixels = static_cast<int>(std::ceil(kScanPixels / (s.scan_pixel * s.scan_pixel)));
  }
  return spec;
}

tern::FlightSensor flight_sensor_of(const FlightSettings& s) {
  const bool is_lidar = s.sensor == "lidar";
  tern::FlightSensor sensor = tern::kLevelCamera;
  sensor.horizontal = is_lidar ? 2.0 * std::acos(-1.0) : std::min(s.fov_horizontal, 3.0);
  sensor.vertical = std::min(s.fov_vertical, 3.0);
  sensor.pitch_min = std::clamp(s.mount.pitch + s.mount.gimbal_low, -1.5, 1.5);
  sensor.pitch_max = std::clamp(s.mount.pitch + s.mount.gimbal_high, sensor.pitch_min, 1.5);
  sensor.nearest = s.sensor_min;
  sensor.offset = s.mount.offset;
  if (is_lidar && s.beams > 0) sensor.raised = kScatteredRaised;
  return sensor;
}

tern::FlightSpec flight_spec_of(const FlightSettings& s) {
  tern::FlightSpec spec = tern::flight_spec(limits_of(s));
  spec.tick = std::llround(1e9 / s.tick_hz);
  spec.work_per_tick = static_cast<std::uint32_t>(s.work_per_tick);
  spec.plan_work = 4 * spec.work_per_tick;
  spec.horizon = kHorizon * s.sensor_range;
  spec.yaw_rate = s.yaw_rate;
  spec.sensor = flight_sensor_of(s);
  slow_for_beyond(s, spec);
  return spec;
}

void check_world(const FlightWorld& world, const tern::FlightSpec& spec, const tern::MapSpec& map) {
  const double length = map.cell * map.dims.x;
  if (spec.horizon < 0.5 * length) return refuse_occupied_ends(world, map.origin);
  throw std::runtime_error(world.name + ": plans lead " + brief(spec.horizon) + " m ahead, " + brief(kHorizon) +
                           " of sensor_range, and the window is only " + brief(length) +
                           " m long. Set window to more than " + brief(2.0 * spec.horizon) +
                           " m along x, or sensor_range to less than " + brief(0.5 * length / kHorizon) + " m");
}

std::string describe_refusal(const tern::FlightRefusal& refusal) {
  if (refusal.blocked_by == tern::BlockedBy::kNothing) return "";
  const tern::Vec3& at = refusal.blocked_at;
  return ": all within " + fixed(refusal.needed, 2) + " m of the start must be known to be free, and " +
         tern::blocked_by_text(refusal.blocked_by) + " is " + fixed(refusal.distance, 2) + " m away, at " +
         fixed(at.x, 2) + " " + fixed(at.y, 2) + " " + fixed(at.z, 2);
}

tern::FlightYaw flight_yaw_of(const FlightSettings& s, double start) {
  tern::FlightYaw yaw{};
  yaw.mode = tern::FlightYawMode::kTowardsUnseen;
  if (s.yaw == "motion") yaw.mode = tern::FlightYawMode::kAlongMotion;
  if (s.yaw == "point") yaw.mode = tern::FlightYawMode::kTowardsPoint;
  if (s.yaw == "heading") yaw.mode = tern::FlightYawMode::kFixed;
  yaw.acceleration_max = s.yaw_acceleration;
  yaw.field_of_view = s.fov_horizontal;
  yaw.start = {std::cos(start), std::sin(start)};
  yaw.heading = {std::cos(s.yaw_heading), std::sin(s.yaw_heading)};
  yaw.point = s.yaw_point;
  return yaw;
}

}  // namespace tern_host
