// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tern_onboard/map_spec.hpp"

#include <algorithm>
#include <cmath>

#include "tern/from_beyond.hpp"
#include "tern_onboard/notices.hpp"
#include "tern_onboard/pose.hpp"

namespace tern_onboard {
namespace {

constexpr double kAllAround = 6.2831853071795862;  // 2 pi

std::int32_t voxels(double metres, double cell) {
  return static_cast<std::int32_t>(std::ceil(metres / cell - 1e-9));
}

}  // namespace

tern::MapSpec map_spec_of(const MapSettings& s) {
  const tern::Voxel dims{voxels(s.window.x, s.cell), voxels(s.window.y, s.cell), voxels(s.window.z, s.cell)};
  tern::MapSpec spec = tern::map_spec({}, s.cell, dims, s.radius);
  spec.tracking_margin = s.tracking_margin;
  spec.range = s.range;
  spec.depth_margin = s.depth_margin;
  spec.depth_margin_square = s.depth_margin_square;
  spec.pose_margin = s.pose_margin;
  spec.angle_margin = s.angle_margin;
  spec.scan_pixel = s.scan_pixel;
  spec.hits = static_cast<std::int32_t>(s.hits);
  spec.misses = static_cast<std::int32_t>(s.misses);
  spec.support = static_cast<std::int32_t>(s.support);
  spec.age = std::llround(1e9 * s.age);
  spec.slack = 8;
  // Room for an image, and for the six faces of a scan (MapSpec::pixels).
  const double faces = std::ceil(6.0 * (2.5 / s.scan_pixel) * (2.5 / s.scan_pixel) + 0.1);
  spec.pixels = static_cast<std::int32_t>(std::max(s.image_pixels, std::min(faces, 1e9)));
  return spec;
}

tern::FlightSpec flight_spec_of(const Settings& settings) {
  const FlySettings& s = settings.fly;
  tern::Limits limits{{s.speed, s.speed, s.climb}, {s.acceleration, s.acceleration, s.acceleration_z}};
  limits.v_min = {0.0, 0.0, -s.sink};
  limits.v_horizontal = s.speed;
  limits.a_horizontal = s.acceleration;
  limits.j_max = {s.jerk, s.jerk, s.jerk};
  tern::FlightSpec spec = tern::flight_spec(limits);
  spec.time_weight = s.time_weight;
  spec.tick = std::llround(1e9 / s.tick_rate);
  spec.work_per_tick = static_cast<std::uint32_t>(s.work_per_tick);
  spec.plan_work = static_cast<std::uint32_t>(s.plan_work);
  spec.horizon = s.horizon;
  spec.yaw_rate = s.yaw_rate;
  spec.stale_after = std::llround(1e9 * settings.watch.stale_after);
  spec.sensor.horizontal = s.field_of_view > 0.0 ? s.field_of_view : kAllAround;
  spec.sensor.vertical = s.view_height;
  spec.sensor.pitch_min = spec.sensor.pitch_max = s.view_pitch;
  spec.sensor.raised = s.view_raised;
  return spec;
}

tern::Status slow_for_beyond(const Settings& settings, tern::FlightSpec& spec) {
  const ThingSettings& s = settings.things;
  if (!(s.beyond_speed > 0.0)) return tern::Status::kOk;
  const double clearance = settings.map.radius + settings.map.tracking_margin;
  tern::Trajectory room;
  return tern::limit_speed({s.detector_range, s.detector_delay, s.beyond_speed, s.beyond_size}, spec, clearance,
                           spec.limits, room);
}

std::int32_t height_planes(const Settings& settings, tern::Halfspace (&planes)[2]) {
  const double keeps = settings.map.radius + settings.map.tracking_margin;
  std::int32_t count = 0;
  if (settings.fly.ground > kNoGround) planes[count++] = {{0.0, 0.0, -1.0}, -(settings.fly.ground + keeps)};
  if (settings.fly.ceiling < kNoCeiling) planes[count++] = {{0.0, 0.0, 1.0}, settings.fly.ceiling};
  return count;
}

std::string mission_fault(const std::vector<tern::Via>& points, const Settings& settings) {
  if (points.empty()) return "it has no points";
  if (points.size() > static_cast<std::size_t>(tern::kMaxMissionPoints)) {
    return "it has " + std::to_string(points.size()) + " points, and at most " +
           std::to_string(tern::kMaxMissionPoints) + " are allowed";
  }
  const double lowest = settings.fly.ground + settings.map.radius + settings.map.tracking_margin;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const std::string which = points.size() == 1 ? "the goal" : "point " + std::to_string(k + 1);
    const tern::Vec3& p = points[k].position;
    if (!is_finite(p)) return which + " is not finite";
    if (!(points[k].tolerance >= 0.0)) return which + " has a negative tolerance";
    if (settings.fly.ground > kNoGround && p.z < lowest) {
      return which + " is at a height of " + metres(p.z) + ", and the body stays above the ground from " +
             metres(lowest) + " on. Set its height";
    }
    if (settings.fly.ceiling < kNoCeiling && p.z > settings.fly.ceiling) {
      return which + " is at a height of " + metres(p.z) + ", and ceiling is " + metres(settings.fly.ceiling);
    }
  }
  return {};
}

}  // namespace tern_onboard
