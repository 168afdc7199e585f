// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The fields of messages.hpp, one after the other. definitions.mjs wrote this file, and a test compares the two.
#pragma once

#include "messages.hpp"

// clang-format off
namespace tern_test {
template <typename Visit>
void each_field(const builtin_interfaces::msg::Time& m, Visit& visit) {
  visit("sec", m.sec);
  visit("nanosec", m.nanosec);
}
template <typename Visit>
void each_field(const builtin_interfaces::msg::Duration& m, Visit& visit) {
  visit("sec", m.sec);
  visit("nanosec", m.nanosec);
}
template <typename Visit>
void each_field(const std_msgs::msg::MultiArrayDimension& m, Visit& visit) {
  visit("label", m.label);
  visit("size", m.size);
  visit("stride", m.stride);
}
template <typename Visit>
void each_field(const std_msgs::msg::MultiArrayLayout& m, Visit& visit) {
  visit("dim", m.dim);
  visit("data_offset", m.data_offset);
}
template <typename Visit>
void each_field(const std_msgs::msg::UInt8MultiArray& m, Visit& visit) {
  visit("layout", m.layout);
  visit("data", m.data);
}
template <typename Visit>
void each_field(const std_msgs::msg::Header& m, Visit& visit) {
  visit("stamp", m.stamp);
  visit("frame_id", m.frame_id);
}
template <typename Visit>
void each_field(const geometry_msgs::msg::Point& m, Visit& visit) {
  visit("x", m.x);
  visit("y", m.y);
  visit("z", m.z);
}
template <typename Visit>
void each_field(const geometry_msgs::msg::Quaternion& m, Visit& visit) {
  visit("x", m.x);
  visit("y", m.y);
  visit("z", m.z);
  visit("w", m.w);
}
template <typename Visit>
void each_field(const geometry_msgs::msg::Pose& m, Visit& visit) {
  visit("position", m.position);
  visit("orientation", m.orientation);
}
template <typename Visit>
void each_field(const geometry_msgs::msg::PoseStamped& m, Visit& visit) {
  visit("header", m.header);
  visit("pose", m.pose);
}
template <typename Visit>
void each_field(const geometry_msgs::msg::Vector3& m, Visit& visit) {
  visit("x", m.x);
  visit("y", m.y);
  visit("z", m.z);
}
template <typename Visit>
void each_field(const geometry_msgs::msg::Transform& m, Visit& visit) {
  visit("translation", m.translation);
  visit("rotation", m.rotation);
}
template <typename Visit>
void each_field(const geometry_msgs::msg::TransformStamped& m, Visit& visit) {
  visit("header", m.header);
  visit("child_frame_id", m.child_frame_id);
  visit("transform", m.transform);
}
template <typename Visit>
void each_field(const geometry_msgs::msg::PoseWithCovariance& m, Visit& visit) {
  visit("pose", m.pose);
  visit("covariance", m.covariance);
}
template <typename Visit>
void each_field(const geometry_msgs::msg::Twist& m, Visit& visit) {
  visit("linear", m.linear);
  visit("angular", m.angular);
}
template <typename Visit>
void each_field(const geometry_msgs::msg::TwistWithCovariance& m, Visit& visit) {
  visit("twist", m.twist);
  visit("covariance", m.covariance);
}
template <typename Visit>
void each_field(const nav_msgs::msg::Odometry& m, Visit& visit) {
  visit("header", m.header);
  visit("child_frame_id", m.child_frame_id);
  visit("pose", m.pose);
  visit("twist", m.twist);
}
template <typename Visit>
void each_field(const nav_msgs::msg::Path& m, Visit& visit) {
  visit("header", m.header);
  visit("poses", m.poses);
}
template <typename Visit>
void each_field(const sensor_msgs::msg::RegionOfInterest& m, Visit& visit) {
  visit("x_offset", m.x_offset);
  visit("y_offset", m.y_offset);
  visit("height", m.height);
  visit("width", m.width);
  visit("do_rectify", m.do_rectify);
}
template <typename Visit>
void each_field(const sensor_msgs::msg::CameraInfo& m, Visit& visit) {
  visit("header", m.header);
  visit("height", m.height);
  visit("width", m.width);
  visit("distortion_model", m.distortion_model);
  visit("d", m.d);
  visit("k", m.k);
  visit("r", m.r);
  visit("p", m.p);
  visit("binning_x", m.binning_x);
  visit("binning_y", m.binning_y);
  visit("roi", m.roi);
}
template <typename Visit>
void each_field(const sensor_msgs::msg::Image& m, Visit& visit) {
  visit("header", m.header);
  visit("height", m.height);
  visit("width", m.width);
  visit("encoding", m.encoding);
  visit("is_bigendian", m.is_bigendian);
  visit("step", m.step);
  visit("data", m.data);
}
template <typename Visit>
void each_field(const sensor_msgs::msg::PointField& m, Visit& visit) {
  visit("name", m.name);
  visit("offset", m.offset);
  visit("datatype", m.datatype);
  visit("count", m.count);
}
template <typename Visit>
void each_field(const sensor_msgs::msg::PointCloud2& m, Visit& visit) {
  visit("header", m.header);
  visit("height", m.height);
  visit("width", m.width);
  visit("fields", m.fields);
  visit("is_bigendian", m.is_bigendian);
  visit("point_step", m.point_step);
  visit("row_step", m.row_step);
  visit("data", m.data);
  visit("is_dense", m.is_dense);
}
template <typename Visit>
void each_field(const trajectory_msgs::msg::MultiDOFJointTrajectoryPoint& m, Visit& visit) {
  visit("transforms", m.transforms);
  visit("velocities", m.velocities);
  visit("accelerations", m.accelerations);
  visit("time_from_start", m.time_from_start);
}
template <typename Visit>
void each_field(const trajectory_msgs::msg::MultiDOFJointTrajectory& m, Visit& visit) {
  visit("header", m.header);
  visit("joint_names", m.joint_names);
  visit("points", m.points);
}
template <typename Visit>
void each_field(const std_msgs::msg::ColorRGBA& m, Visit& visit) {
  visit("r", m.r);
  visit("g", m.g);
  visit("b", m.b);
  visit("a", m.a);
}
template <typename Visit>
void each_field(const sensor_msgs::msg::CompressedImage& m, Visit& visit) {
  visit("header", m.header);
  visit("format", m.format);
  visit("data", m.data);
}
template <typename Visit>
void each_field(const visualization_msgs::msg::UVCoordinate& m, Visit& visit) {
  visit("u", m.u);
  visit("v", m.v);
}
template <typename Visit>
void each_field(const visualization_msgs::msg::MeshFile& m, Visit& visit) {
  visit("filename", m.filename);
  visit("data", m.data);
}
template <typename Visit>
void each_field(const visualization_msgs::msg::Marker& m, Visit& visit) {
  visit("header", m.header);
  visit("ns", m.ns);
  visit("id", m.id);
  visit("type", m.type);
  visit("action", m.action);
  visit("pose", m.pose);
  visit("scale", m.scale);
  visit("color", m.color);
  visit("lifetime", m.lifetime);
  visit("frame_locked", m.frame_locked);
  visit("points", m.points);
  visit("colors", m.colors);
  visit("texture_resource", m.texture_resource);
  visit("texture", m.texture);
  visit("uv_coordinates", m.uv_coordinates);
  visit("text", m.text);
  visit("mesh_resource", m.mesh_resource);
  visit("mesh_file", m.mesh_file);
  visit("mesh_use_embedded_materials", m.mesh_use_embedded_materials);
}
template <typename Visit>
void each_field(const visualization_msgs::msg::MarkerArray& m, Visit& visit) {
  visit("markers", m.markers);
}
template <typename Visit>
void each_field(const diagnostic_msgs::msg::KeyValue& m, Visit& visit) {
  visit("key", m.key);
  visit("value", m.value);
}
template <typename Visit>
void each_field(const diagnostic_msgs::msg::DiagnosticStatus& m, Visit& visit) {
  visit("level", m.level);
  visit("name", m.name);
  visit("message", m.message);
  visit("hardware_id", m.hardware_id);
  visit("values", m.values);
}
template <typename Visit>
void each_field(const diagnostic_msgs::msg::DiagnosticArray& m, Visit& visit) {
  visit("header", m.header);
  visit("status", m.status);
}
}  // namespace tern_test
