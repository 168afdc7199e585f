// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Clouds, plans and pictures as ROS messages. The message types are parameters, because those of ROS 1 and ROS 2 have
// the same fields in different namespaces. World frame: east, north, up, as ROS has it (REP 103), so nothing is turned.
#ifndef TERN_ROS_MESSAGES_HPP
#define TERN_ROS_MESSAGES_HPP

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>

#include "tern/tern.hpp"

namespace tern_ros {

/// A time since the beginning: ROS 1 calls the part below a second nsec, ROS 2 nanosec.
template <typename Duration, typename = void>
struct Nanoseconds {
  static void set(Duration& duration, std::uint32_t value) { duration.nanosec = value; }
};
template <typename Duration>
struct Nanoseconds<Duration, std::void_t<decltype(Duration::nsec)>> {
  static void set(Duration& duration, std::uint32_t value) {
    duration.nsec = static_cast<decltype(Duration::nsec)>(value);
  }
};

template <typename Duration>
void set_duration(Duration& duration, double seconds) {
  const auto nanoseconds = static_cast<std::int64_t>(std::llround(seconds * 1e9));
  duration.sec = static_cast<decltype(Duration::sec)>(nanoseconds / 1000000000);
  Nanoseconds<Duration>::set(duration, static_cast<std::uint32_t>(nanoseconds % 1000000000));
}

template <typename Vector>
void set_vector(Vector& out, const tern::Vec3& v) {
  out.x = v.x;
  out.y = v.y;
  out.z = v.z;
}

/// The offset of a field of single precision, or -1.
template <typename PointCloud2>
int offset_of(const PointCloud2& cloud, const char* name) {
  constexpr std::uint8_t kFloat32 = 7;
  for (const auto& field : cloud.fields) {
    if (field.name == name && field.datatype == kFloat32) return static_cast<int>(field.offset);
  }
  return -1;
}

/// The points of a sensor_msgs/PointCloud2, in the cloud's frame; those that are not finite are left out. False for a
/// cloud without x, y and z in single precision, or whose sizes do not agree.
template <typename PointCloud2>
bool read_points(const PointCloud2& cloud, std::vector<tern::Vec3>& points) {
  const int at[3] = {offset_of(cloud, "x"), offset_of(cloud, "y"), offset_of(cloud, "z")};
  points.clear();
  if (cloud.is_bigendian || at[0] < 0 || at[1] < 0 || at[2] < 0) return false;
  for (const int offset : at) {
    if (static_cast<std::size_t>(offset) + sizeof(float) > cloud.point_step) return false;
  }
  const std::size_t row = cloud.row_step, step = cloud.point_step;
  if (step * cloud.width > row || row * cloud.height > cloud.data.size()) return false;
  for (std::size_t v = 0; v < cloud.height; ++v) {
    for (std::size_t u = 0; u < cloud.width; ++u) {
      float p[3];
      for (int k = 0; k < 3; ++k)
        std::memcpy(&p[k], &cloud.data[v * row + u * step + static_cast<std::size_t>(at[k])], 4);
      if (std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2])) points.push_back({p[0], p[1], p[2]});
    }
  }
  return true;
}

/// A plan as trajectory_msgs/MultiDOFJointTrajectory: a point every 1/rate seconds and one at rest at the end, with
/// pose, velocities and accelerations. The attitude is the heading alone; controllers find the tilt from the
/// acceleration.
template <typename MultiDofTrajectory>
void write_trajectory(const tern::Trajectory& plan, const tern::YawPlan& yaw, double rate,
                      MultiDofTrajectory& message) {
  const int count = static_cast<int>(std::ceil(tern::duration(plan) * rate)) + 1;
  message.joint_names.assign(1, "base_link");
  message.points.clear();
  for (int i = 0; i < count; ++i) {
    const double t = i / rate;
    const tern::Sample sample = tern::evaluate(plan, t);
    const tern::YawSample heading = tern::evaluate(yaw, t);
    message.points.emplace_back();
    auto& point = message.points.back();
    point.transforms.resize(1);
    point.velocities.resize(1);
    point.accelerations.resize(1);
    set_vector(point.transforms[0].translation, sample.position);
    point.transforms[0].rotation.w = std::cos(0.5 * heading.angle);
    point.transforms[0].rotation.z = std::sin(0.5 * heading.angle);
    set_vector(point.velocities[0].linear, sample.velocity);
    point.velocities[0].angular.z = heading.yaw.rate;
    set_vector(point.accelerations[0].linear, sample.acceleration);
    point.accelerations[0].angular.z = heading.acceleration;
    set_duration(point.time_from_start, t);
  }
}

/// A plan as visualization_msgs/Marker: a line of 200 pieces.
template <typename Marker>
void write_marker(const tern::Trajectory& plan, Marker& marker) {
  constexpr int kPieces = 200;
  marker.ns = "plan";
  marker.id = 0;
  marker.type = Marker::LINE_STRIP;
  marker.action = Marker::ADD;
  marker.pose.orientation.w = 1.0;
  marker.scale.x = 0.05;
  marker.color.r = 0.1f;
  marker.color.g = 0.4f;
  marker.color.b = 0.8f;
  marker.color.a = 1.0f;
  marker.points.resize(kPieces + 1);
  for (int i = 0; i <= kPieces; ++i) {
    const tern::Sample sample = tern::evaluate(plan, tern::duration(plan) * i / kPieces);
    set_vector(marker.points[static_cast<std::size_t>(i)], sample.position);
  }
}

}  // namespace tern_ros

#endif
