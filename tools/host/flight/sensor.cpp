// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/sensor.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "host/nanoseconds.hpp"

namespace tern_host {

std::size_t frame_bytes(const FlightSettings& settings) {
  const std::size_t scan = settings.sensor == "lidar" ? tern::scan_record_bytes(beam_count(settings)) : 0;
  const float number = 0.0f;
  tern::DepthView view{};
  view.z32 = &number;
  view.width = view.stride = settings.width;
  view.height = settings.height;
  return std::max(scan, tern::frame_record_bytes(view));
}

Sensor::Sensor(const FlightWorld& world, const FlightWorld& still_world, const tern::MapSpec& spec,
               tern::RollingMap& map, Noise& noise, FlightTape& tape, Explains explains)
    : world_(world),
      map_(map),
      noise_(noise),
      tape_(tape),
      watch_(still_world, spec, map, std::move(explains)),
      waiting_(1 + world.settings.cameras.size()) {}

const Sensor::Frame* Sensor::take(std::int64_t t, const Vehicle& vehicle, double yaw, double pitch) {
  const FlightSettings& s = world_.settings;
  const double seconds = seconds_of(t);
  if (seconds >= s.frames_until || static_cast<double>(taken_) > seconds * s.sensor_hz) return nullptr;
  ++taken_;
  const bool is_lost = noise_.chance(s.dropout);
  if (!is_lost) waiting_[0].push_back(frame(t, vehicle, yaw, pitch));
  for (std::size_t k = 0; k < s.cameras.size(); ++k) {
    SensorMount mount = s.mount;
    mount.turn += s.cameras[k].turn;
    mount.pitch += s.cameras[k].pitch;
    if (!noise_.chance(s.dropout)) waiting_[k + 1].push_back(image(t, vehicle, mount, yaw, 0.0));
  }
  return is_lost ? nullptr : &waiting_[0].back();
}

/// The queue whose turn it is, if a frame of it has arrived. Of those that have, only the last one counts.
std::deque<Sensor::Frame>* Sensor::next(std::int64_t t) {
  const std::int64_t latency = nanoseconds(world_.settings.sensor_latency);
  const auto arrived = [&](const Frame& taken) {
    return std::visit([](const auto& f) { return f.taken; }, taken) + latency <= t;
  };
  for (std::size_t k = 0; k < waiting_.size(); ++k) {
    turn_ = (turn_ + 1) % waiting_.size();
    std::deque<Frame>& queue = waiting_[turn_];
    while (queue.size() > 1 && arrived(queue[1])) queue.pop_front();
    if (!queue.empty() && arrived(queue.front())) return &queue;
  }
  return nullptr;
}

void Sensor::deliver(std::int64_t t) {
  std::deque<Frame>* const queue = map_.busy() ? nullptr : next(t);
  if (queue == nullptr) return;
  std::visit([this](const auto& frame) { watch_.after(frame); }, entered_);
  entered_ = std::move(queue->front());
  queue->pop_front();
  std::visit(
      [this](const auto& frame) {
        watch_.before(frame);
        enter(frame);
      },
      entered_);
}

Sensor::Frame Sensor::frame(std::int64_t t, const Vehicle& vehicle, double yaw, double pitch) {
  const FlightSettings& s = world_.settings;
  if (s.sensor != "lidar") return image(t, vehicle, s.mount, yaw, pitch);
  if (s.beams == 0) return take_scan(world_, vehicle.position(), vehicle.estimate(), t, noise_);
  const std::array<double, 4> attitude = s.mount.kind == "body" ? vehicle.attitude() : level_attitude(yaw);
  const tern::Vec3 believed = lidar_pose(s.mount, vehicle.estimate(), attitude).position;
  const auto first = static_cast<std::uint64_t>(taken_ - 1) * beam_count(s);
  return take_scattered_scan(world_, lidar_pose(s.mount, vehicle.position(), attitude), believed, t, first, noise_);
}

/// The image is of what is, the pose what the vehicle believes.
Sensor::Frame Sensor::image(std::int64_t t, const Vehicle& vehicle, const SensorMount& mount, double yaw,
                            double pitch) {
  const std::array<double, 4> attitude = mount.kind == "body" ? vehicle.attitude() : level_attitude(yaw);
  const bool is_plain = mount.is_plain() && world_.settings.pixel_part >= 1.0;
  DepthFrame image = is_plain ? take_frame(world_, vehicle.position(), yaw, t, noise_)
                              : take_frame(world_, camera_pose(mount, vehicle.position(), attitude, pitch), t, noise_);
  image.pose.position = camera_pose(mount, vehicle.estimate(), attitude, pitch).position;
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
