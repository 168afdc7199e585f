// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What an Onboard takes of the world around the vehicle.
#include "tern_onboard/onboard.hpp"

namespace tern_onboard {

int Onboard::add_sensor(const SensorSpec& spec) {
  const std::lock_guard lock(mutex_);
  return sensors_.add(spec);
}

Answer Onboard::set_lens(int sensor, const Lens& lens) {
  const std::lock_guard lock(mutex_);
  const std::string fault = sensors_.set_lens(sensor, lens);
  return {fault.empty(), fault};
}

Answer Onboard::set_mounting(int sensor, const tern::Pose& in_body) {
  const std::lock_guard lock(mutex_);
  const std::string fault = sensors_.set_mounting(sensor, in_body);
  return {fault.empty(), fault};
}

void Onboard::add_frame(int sensor, const DepthImage& image, std::int64_t now) {
  const std::lock_guard lock(mutex_);
  if (sensors_.offer(sensor, image, now, notices_)) latency_.arrived(sensors_.newest(sensor), now);
}

void Onboard::add_frame(int sensor, const PointScan& scan, std::int64_t now) {
  const std::lock_guard lock(mutex_);
  if (sensors_.offer(sensor, scan, now, notices_)) latency_.arrived(sensors_.newest(sensor), now);
}

void Onboard::add_known_points(const std::vector<tern::Vec3>& points) {
  const std::lock_guard lock(mutex_);
  known_points_.insert(known_points_.end(), points.begin(), points.end());
}

void Onboard::add_sighting(const Sighting& sighting, std::int64_t now) {
  const std::lock_guard lock(mutex_);
  add_locked(sighting, now);
}

void Onboard::add_locked(const Sighting& sighting, std::int64_t now) {
  const StampedPose* newest = poses_.newest();
  const tern::Vec3 here = newest == nullptr ? tern::Vec3{} : plus(newest->pose.position, poses_.offset());
  things_.add(sighting, newest == nullptr ? nullptr : &here, now, notices_);
}

bool Onboard::body_at(std::int64_t stamp, tern::Pose& pose, double& late) const {
  const std::lock_guard lock(mutex_);
  late = 0.0;
  const PoseAt answer = poses_.at(stamp, pose);
  const StampedPose* newest = poses_.newest();
  if (answer == PoseAt::kNotYet && newest != nullptr) {
    pose = newest->pose;
    late = 1e-9 * static_cast<double>(stamp - newest->stamp);
  } else if (answer != PoseAt::kKnown) {
    return false;
  }
  pose.position = plus(pose.position, poses_.offset());
  return late <= settings_.watch.pose_gap;
}

}  // namespace tern_onboard
