// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/swarm/swarm_sensor.hpp"

#include <algorithm>
#include <cmath>

#include "host/flight/assumed_ball.hpp"
#include "host/flight/flight_specs.hpp"

namespace tern_host {
namespace {

constexpr std::int64_t kPeriod = 100000000;  ///< ns from one scan to the next
constexpr double kScanPixel = 0.06;          ///< rad

}  // namespace

SwarmSensor::SwarmSensor(const SwarmWorld& world, const SwarmTask& task, double range, double margin) {
  truth_.name = world.name;
  truth_.blocks = world.blocks;
  truth_.boundary = world.boundary;
  truth_.start = task.start;
  truth_.goal = task.mission.back().position;
  FlightSettings& s = truth_.settings;
  s.body_radius = world.body_radius;
  s.tracking_margin = margin;
  s.cell = world.cell;
  s.sensor = "lidar";
  s.sensor_range = range;
  s.scan_pixel = kScanPixel;
  s.fov_vertical = std::acos(0.0);
  s.speckle_filter = 0;
  s.hits = 1;
  s.support = 0;
  s.v_max = world.limits.v_max.x;
  s.a_max = world.limits.a_max.x;
  s.j_max = world.limits.j_max.x;
}

void SwarmSensor::describe(tern::MapSpec& spec) const {
  const tern::MapSpec own = map_spec_of(truth_);
  spec.range = own.range;
  spec.depth_margin = own.depth_margin;
  spec.depth_margin_square = own.depth_margin_square;
  spec.pose_margin = own.pose_margin;
  spec.scan_pixel = own.scan_pixel;
  spec.hits = own.hits;
  spec.support = own.support;
  spec.pixels = own.pixels;
}

void SwarmSensor::describe(tern::FlightSpec& spec) const {
  const tern::FlightSpec own = flight_spec_of(truth_.settings);
  spec.horizon = std::min(spec.horizon, own.horizon);
  spec.sensor = own.sensor;
}

void SwarmSensor::assume_start(tern::RollingMap& map) const {
  for (const AssumedBall& ball : assumed_balls(truth_, map.safe().spec())) map.assume_free(ball.center, ball.radius);
}

void SwarmSensor::look(const tern::Vec3& place, std::int64_t time, tern::RollingMap& map) {
  if (time < next_ || map.busy()) return;
  next_ = time + kPeriod;
  scan_ = take_scan(truth_, place, place, time, noise_);
  map.begin_scan(scan_.beams(), scan_.origin, scan_.taken);
}

}  // namespace tern_host
