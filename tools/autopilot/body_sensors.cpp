// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "autopilot/body_sensors.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "depth_sender.h"
#include "host/flight/lidar.hpp"
#include "tern_onboard/pose.hpp"

namespace tern_autopilot {
namespace {

constexpr double kLidarHz = 10.0;
constexpr double kSide = 0.6;       // rad, to which cameras look that do not look ahead
constexpr float kBeyond = 1000.0f;  // m: a point where a beam meets nothing

}  // namespace

BodySensors::BodySensors(const tern_host::FlightWorld& world, const std::string& kinds, const std::string& socket,
                         std::int64_t began)
    : world_(world),
      lens_(tern_host::lens_of(world.settings)),
      began_(began),
      socket_(tern_depth_connect(socket.c_str())) {
  if (socket_ < 0) throw std::runtime_error("the companion's depth socket does not answer");
  if (kinds == "camera" || kinds == "both") add_camera(0.0);
  if (kinds == "cameras") {
    add_camera(kSide);
    add_camera(-kSide);
  }
  if (kinds == "lidar" || kinds == "both") add_lidar();
}

BodySensors::~BodySensors() {
  tern_depth_close(socket_);
}

/// `turned`: to the left, rad.
void BodySensors::add_camera(double turned) {
  tern_depth_header header =
      tern_depth_camera(TERN_DEPTH_METRES, static_cast<std::uint32_t>(lens_.width),
                        static_cast<std::uint32_t>(lens_.height), lens_.fx, lens_.fy, lens_.cx, lens_.cy);
  const tern::Pose turn{{0.0, 0.0, 0.0}, {std::cos(0.5 * turned), 0.0, 0.0, std::sin(0.5 * turned)}};
  const tern::Pose mounting = tern_onboard::compose(turn, {{0.0, 0.0, 0.0}, {0.5, -0.5, 0.5, -0.5}});
  std::copy(mounting.quaternion, mounting.quaternion + 4, header.attitude);
  header.sensor = static_cast<std::uint32_t>(units_.size());
  header.least = 0.1;
  header.most = 1000.0;
  units_.push_back({header, 1.0 / world_.settings.sensor_hz, 0.0});
}

/// Its axes are the body's.
void BodySensors::add_lidar() {
  tern_depth_header header = tern_depth_camera(TERN_DEPTH_POINTS, 1, 1, 1.0, 1.0, 0.0, 0.0);
  const double ahead[4] = {1.0, 0.0, 0.0, 0.0};
  std::copy(ahead, ahead + 4, header.attitude);
  header.sensor = static_cast<std::uint32_t>(units_.size());
  header.least = 0.1;
  units_.push_back({header, 1.0 / kLidarHz, 0.0});
}

void BodySensors::take(const tern::Pose& body, std::int64_t time, tern_host::Noise& noise) {
  const double seconds = 1e-9 * static_cast<double>(time);
  for (Unit& unit : units_) {
    if (seconds < unit.due) continue;
    unit.due = std::max(unit.due + unit.period, seconds);
    Frame frame{time, unit.header, {}};
    if (unit.header.format == TERN_DEPTH_POINTS) {
      frame.numbers = scan(body, time, noise);
      frame.header.width = static_cast<std::uint32_t>(frame.numbers.size() / 3);
      frame.header.payload_bytes = static_cast<std::uint32_t>(4 * frame.numbers.size());
    } else {
      const double* const q = unit.header.attitude;
      const tern::Pose eye = tern_onboard::compose(body, {{0.0, 0.0, 0.0}, {q[0], q[1], q[2], q[3]}});
      frame.numbers = take_frame(world_, eye, time, noise).depths;
    }
    frames_.push_back(std::move(frame));
  }
}

/// Points in the body's axes.
std::vector<float> BodySensors::scan(const tern::Pose& body, std::int64_t time, tern_host::Noise& noise) const {
  const tern_host::LidarScan scan = tern_host::take_scan(world_, body.position, body.position, time, noise);
  const double back[4] = {body.quaternion[0], -body.quaternion[1], -body.quaternion[2], -body.quaternion[3]};
  std::vector<float> points;
  for (std::size_t k = 0; k < scan.ranges.size(); ++k) {
    const double range = static_cast<double>(std::isinf(scan.ranges[k]) ? kBeyond : scan.ranges[k]);
    const tern::Vec3 point = tern_onboard::times(tern_onboard::turn(back, scan.directions[k]), range);
    for (const double x : {point.x, point.y, point.z}) points.push_back(static_cast<float>(x));
  }
  return points;
}

void BodySensors::deliver(std::int64_t time) {
  const auto latency = static_cast<std::int64_t>(1e9 * world_.settings.sensor_latency);
  while (!frames_.empty() && frames_.front().taken + latency <= time) {
    Frame& frame = frames_.front();
    frame.header.stamp_ns = frame.taken + began_;
    tern_depth_send(socket_, &frame.header, frame.numbers.data());
    frames_.pop_front();
  }
}

}  // namespace tern_autopilot
