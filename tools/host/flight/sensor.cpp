// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/sensor.hpp"

#include <cmath>
#include <utility>

namespace tern_host {

std::size_t frame_bytes(const FlightSettings& settings) {
  if (settings.sensor == "lidar") return tern::scan_record_bytes(beam_count(settings));
  const float number = 0.0f;
  tern::DepthView view{};
  view.z32 = &number;
  view.width = view.stride = settings.width;
  view.height = settings.height;
  return tern::frame_record_bytes(view);
}

Sensor::Sensor(const FlightWorld& world, const FlightWorld& still_world, const tern::MapSpec& spec,
               tern::RollingMap& map, Noise& noise, FlightTape& tape)
    : world_(world), map_(map), noise_(noise), tape_(tape), watch_(still_world, spec, map) {}

void Sensor::take(std::int64_t t, const Vehicle& vehicle, double yaw, double pitch) {
  const FlightSettings& s = world_.settings;
  const double seconds = 1e-9 * static_cast<double>(t);
  if (seconds >= s.frames_until || static_cast<double>(taken_) > seconds * s.sensor_hz) return;
  ++taken_;
  if (!noise_.chance(s.dropout)) waiting_.push_back(frame(t, vehicle, yaw, pitch));
}

void Sensor::deliver(std::int64_t t) {
  const std::int64_t latency = std::llround(1e9 * world_.settings.sensor_latency);
  const auto arrived = [&](const Frame& taken) {
    return std::visit([](const auto& f) { return f.taken; }, taken) + latency <= t;
  };
  // Of those that have arrived, only the last one counts.
  while (waiting_.size() > 1 && arrived(waiting_[1])) waiting_.pop_front();
  if (map_.busy() || waiting_.empty() || !arrived(waiting_.front())) return;
  std::visit([this](const auto& frame) { watch_.after(frame); }, entered_);
  entered_ = std::move(waiting_.front());
  waiting_.pop_front();
  std::visit(
      [this](const auto& frame) {
        watch_.before(frame);
        enter(frame);
      },
      entered_);
}

/// The image is of what is, the pose what the vehicle believes.
Sensor::Frame Sensor::frame(std::int64_t t, const Vehicle& vehicle, double yaw, double pitch) {
  const FlightSettings& s = world_.settings;
  const std::array<double, 4> attitude = s.mount.kind == "body" ? vehicle.attitude() : level_attitude(yaw);
  if (s.sensor == "lidar" && s.beams > 0) {
    const tern::Vec3 believed = lidar_pose(s.mount, vehicle.estimate(), attitude).position;
    const auto first = static_cast<std::uint64_t>(taken_ - 1) * beam_count(s);
    return take_scattered_scan(world_, lidar_pose(s.mount, vehicle.position(), attitude), believed, t, first, noise_);
  }
  if (s.sensor == "lidar") return take_scan(world_, vehicle.position(), vehicle.estimate(), t, noise_);
  const bool is_plain = s.mount.is_plain() && s.pixel_part >= 1.0;
  DepthFrame image = is_plain
                         ? take_frame(world_, vehicle.position(), yaw, t, noise_)
                         : take_frame(world_, camera_pose(s.mount, vehicle.position(), attitude, pitch), t, noise_);
  image.pose.position = camera_pose(s.mount, vehicle.estimate(), attitude, pitch).position;
  return image;
}

void Sensor::enter(const DepthFrame& frame) {
  const tern::Status begun = map_.begin_frame(frame.view, frame.pose, frame.taken);
  tape_.recorder().frame(frame.view, frame.pose, frame.taken, begun);
}

void Sensor::enter(const LidarScan& scan) {
  const tern::Status begun = map_.begin_scan(scan.beams(), scan.origin, scan.taken);
  tape_.recorder().scan(scan.beams(), scan.origin, scan.taken, begun);
}

}  // namespace tern_host
