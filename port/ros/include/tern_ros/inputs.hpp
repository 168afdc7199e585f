// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Messages as tern::onboard takes them. The message types are parameters, because those of ROS 1 and ROS 2 have the
// same fields in different namespaces. World frame: east, north, up, as ROS has it (REP 103), so nothing is turned.
#ifndef TERN_ROS_INPUTS_HPP
#define TERN_ROS_INPUTS_HPP

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "tern/tern.hpp"
#include "tern_onboard/pose.hpp"
#include "tern_onboard/sensors.hpp"
#include "tern_stacks/stacks.hpp"

namespace tern_ros {

/// Nanoseconds of a stamp: ROS 1 calls the part below a second nsec, ROS 2 nanosec.
template <typename Time>
auto stamp_of(const Time& time) -> decltype(time.nanosec, std::int64_t()) {
  return 1000000000 * static_cast<std::int64_t>(time.sec) + static_cast<std::int64_t>(time.nanosec);
}
template <typename Time>
auto stamp_of(const Time& time) -> decltype(time.nsec, std::int64_t()) {
  return 1000000000 * static_cast<std::int64_t>(time.sec) + static_cast<std::int64_t>(time.nsec);
}

template <typename Point>
tern::Vec3 vector_of(const Point& p) {
  return {p.x, p.y, p.z};
}

/// A geometry_msgs/Pose.
template <typename Pose>
tern::Pose pose_of(const Pose& pose) {
  const auto& q = pose.orientation;
  return {vector_of(pose.position), {q.w, q.x, q.y, q.z}};
}

/// A geometry_msgs/Transform: the pose of the child in the parent.
template <typename Transform>
tern::Pose pose_of_transform(const Transform& transform) {
  const auto& q = transform.rotation;
  return {vector_of(transform.translation), {q.w, q.x, q.y, q.z}};
}

/// The lens of a sensor_msgs/CameraInfo for a rectified image: it is in P, or in K if P is empty.
template <typename CameraInfo, typename Three, typename Four>
tern_onboard::Lens lens_from(const CameraInfo& info, const Three& k, const Four& p) {
  tern_onboard::Lens lens;
  lens.width = static_cast<std::int32_t>(info.width);
  lens.height = static_cast<std::int32_t>(info.height);
  const bool projected = p[0] > 0.0;
  lens.fx = projected ? p[0] : k[0];
  lens.fy = projected ? p[5] : k[4];
  lens.cx = projected ? p[2] : k[2];
  lens.cy = projected ? p[6] : k[5];
  return lens;
}
/// ROS 1 has capital letters, ROS 2 small ones.
template <typename CameraInfo>
auto lens_of(const CameraInfo& info) -> decltype(info.K, tern_onboard::Lens()) {
  return lens_from(info, info.K, info.P);
}
template <typename CameraInfo>
auto lens_of(const CameraInfo& info) -> decltype(info.k, tern_onboard::Lens()) {
  return lens_from(info, info.k, info.p);
}

/// A sensor_msgs/Image with depths, whose data must outlive the answer. False if it is neither 16UC1 nor 32FC1.
template <typename Image>
bool read_image(const Image& message, tern_onboard::DepthImage& image) {
  const bool metres = message.encoding == "32FC1";
  if (!metres && message.encoding != "16UC1" && message.encoding != "mono16") return false;
  image = {stamp_of(message.header.stamp),
           message.data.data(),
           message.data.size(),
           static_cast<std::int32_t>(message.width),
           static_cast<std::int32_t>(message.height),
           message.step,
           metres,
           message.is_bigendian != 0};
  return true;
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

/// A sensor_msgs/PointCloud2, whose data must outlive the answer. False if it has no x, y and z in single precision, or
/// is big-endian.
template <typename PointCloud2>
bool read_cloud(const PointCloud2& cloud, tern_onboard::PointScan& scan) {
  const int x = offset_of(cloud, "x"), y = offset_of(cloud, "y"), z = offset_of(cloud, "z");
  if (cloud.is_bigendian || x < 0 || y < 0 || z < 0) return false;
  scan = {stamp_of(cloud.header.stamp),
          cloud.data.data(),
          cloud.data.size(),
          cloud.width,
          cloud.height,
          cloud.row_step,
          cloud.point_step,
          static_cast<std::size_t>(x),
          static_cast<std::size_t>(y),
          static_cast<std::size_t>(z)};
  return true;
}

/// The points of a cloud in the frame that `cloud` has pose `pose` in; those that are not finite are left out. False
/// if it cannot be read, or its sizes do not agree.
template <typename PointCloud2>
bool read_points(const PointCloud2& cloud, const tern::Pose& pose, std::vector<tern::Vec3>& points) {
  tern_onboard::PointScan scan{};
  points.clear();
  if (!read_cloud(cloud, scan) || !tern_onboard::scan_is_whole(scan)) return false;
  const auto* bytes = static_cast<const std::uint8_t*>(scan.data);
  for (std::size_t row = 0; row < scan.height; ++row) {
    for (std::size_t k = 0; k < scan.width; ++k) {
      const std::uint8_t* at = bytes + row * scan.row_bytes + k * scan.point_bytes;
      float p[3];
      std::memcpy(&p[0], at + scan.x, sizeof(float));
      std::memcpy(&p[1], at + scan.y, sizeof(float));
      std::memcpy(&p[2], at + scan.z, sizeof(float));
      const tern::Vec3 point{static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
      if (tern_onboard::is_finite(point)) points.push_back(tern_onboard::compose(pose, {point, {1, 0, 0, 0}}).position);
    }
  }
  return true;
}

/// PX4's px4_msgs/VehicleOdometry: north-east-down and forward-right-down become east-north-up and forward-left-up. Its
/// time, microseconds, is that of the computer if the bridge to PX4 synchronises clocks, as it does by default. False
/// if its pose is not in the local frame.
template <typename VehicleOdometry>
bool read_px4_odometry(const VehicleOdometry& message, tern_onboard::StampedPose& pose, std::uint32_t& resets) {
  constexpr int kPoseFrameNed = 1;
  if (message.pose_frame != kPoseFrameNed) return false;
  const auto& p = message.position;
  const auto& q = message.q;
  pose.stamp =
      1000 * static_cast<std::int64_t>(message.timestamp_sample != 0 ? message.timestamp_sample : message.timestamp);
  pose.pose.position = {static_cast<double>(p[1]), static_cast<double>(p[0]), -static_cast<double>(p[2])};
  // The same turn leads there and back.
  const double ned[4] = {static_cast<double>(q[0]), static_cast<double>(q[1]), static_cast<double>(q[2]),
                         static_cast<double>(q[3])};
  tern::attitude_ned(ned, pose.pose.quaternion);
  resets = message.reset_counter;
  return true;
}

/// Whether a vehicle with this mavros_msgs/State follows setpoints: PX4 in offboard mode, ArduPilot in guided mode.
template <typename State>
bool follows_setpoints(const State& state) {
  return state.armed && (state.mode == "OFFBOARD" || state.mode == "GUIDED");
}

}  // namespace tern_ros

#endif
