// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The messages of ROS 2 Jazzy that port/ros uses, with all their fields. definitions.mjs wrote this file, and a test
// compares the two.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

// clang-format off
namespace builtin_interfaces::msg {
struct Time {
  std::int32_t sec{};
  std::uint32_t nanosec{};
};
struct Duration {
  std::int32_t sec{};
  std::uint32_t nanosec{};
};
}  // namespace builtin_interfaces::msg

namespace std_msgs::msg {
struct Empty {
};

struct MultiArrayDimension {
  std::string label{};
  std::uint32_t size{};
  std::uint32_t stride{};
};

struct MultiArrayLayout {
  std::vector<std_msgs::msg::MultiArrayDimension> dim{};
  std::uint32_t data_offset{};
};

struct UInt8MultiArray {
  std_msgs::msg::MultiArrayLayout layout{};
  std::vector<std::uint8_t> data{};
};

struct Header {
  builtin_interfaces::msg::Time stamp{};
  std::string frame_id{};
};
}  // namespace std_msgs::msg

namespace geometry_msgs::msg {
struct Point {
  double x{};
  double y{};
  double z{};
};

struct Quaternion {
  double x{0};
  double y{0};
  double z{0};
  double w{1};
};

struct Pose {
  geometry_msgs::msg::Point position{};
  geometry_msgs::msg::Quaternion orientation{};
};

struct PoseStamped {
  std_msgs::msg::Header header{};
  geometry_msgs::msg::Pose pose{};
};

struct Vector3 {
  double x{};
  double y{};
  double z{};
};

struct Transform {
  geometry_msgs::msg::Vector3 translation{};
  geometry_msgs::msg::Quaternion rotation{};
};

struct TransformStamped {
  std_msgs::msg::Header header{};
  std::string child_frame_id{};
  geometry_msgs::msg::Transform transform{};
};

struct PoseWithCovariance {
  geometry_msgs::msg::Pose pose{};
  std::array<double, 36> covariance{};
};

struct Twist {
  geometry_msgs::msg::Vector3 linear{};
  geometry_msgs::msg::Vector3 angular{};
};

struct TwistWithCovariance {
  geometry_msgs::msg::Twist twist{};
  std::array<double, 36> covariance{};
};
}  // namespace geometry_msgs::msg

namespace nav_msgs::msg {
struct Odometry {
  std_msgs::msg::Header header{};
  std::string child_frame_id{};
  geometry_msgs::msg::PoseWithCovariance pose{};
  geometry_msgs::msg::TwistWithCovariance twist{};
};

struct Path {
  std_msgs::msg::Header header{};
  std::vector<geometry_msgs::msg::PoseStamped> poses{};
};
}  // namespace nav_msgs::msg

namespace sensor_msgs::msg {
struct RegionOfInterest {
  std::uint32_t x_offset{};
  std::uint32_t y_offset{};
  std::uint32_t height{};
  std::uint32_t width{};
  bool do_rectify{};
};

struct CameraInfo {
  std_msgs::msg::Header header{};
  std::uint32_t height{};
  std::uint32_t width{};
  std::string distortion_model{};
  std::vector<double> d{};
  std::array<double, 9> k{};
  std::array<double, 9> r{};
  std::array<double, 12> p{};
  std::uint32_t binning_x{};
  std::uint32_t binning_y{};
  sensor_msgs::msg::RegionOfInterest roi{};
};

struct Image {
  std_msgs::msg::Header header{};
  std::uint32_t height{};
  std::uint32_t width{};
  std::string encoding{};
  std::uint8_t is_bigendian{};
  std::uint32_t step{};
  std::vector<std::uint8_t> data{};
};

struct PointField {
  static constexpr std::uint8_t INT8 = 1;
  static constexpr std::uint8_t UINT8 = 2;
  static constexpr std::uint8_t INT16 = 3;
  static constexpr std::uint8_t UINT16 = 4;
  static constexpr std::uint8_t INT32 = 5;
  static constexpr std::uint8_t UINT32 = 6;
  static constexpr std::uint8_t FLOAT32 = 7;
  static constexpr std::uint8_t FLOAT64 = 8;
  std::string name{};
  std::uint32_t offset{};
  std::uint8_t datatype{};
  std::uint32_t count{};
};

struct PointCloud2 {
  std_msgs::msg::Header header{};
  std::uint32_t height{};
  std::uint32_t width{};
  std::vector<sensor_msgs::msg::PointField> fields{};
  bool is_bigendian{};
  std::uint32_t point_step{};
  std::uint32_t row_step{};
  std::vector<std::uint8_t> data{};
  bool is_dense{};
};
}  // namespace sensor_msgs::msg

namespace trajectory_msgs::msg {
struct MultiDOFJointTrajectoryPoint {
  std::vector<geometry_msgs::msg::Transform> transforms{};
  std::vector<geometry_msgs::msg::Twist> velocities{};
  std::vector<geometry_msgs::msg::Twist> accelerations{};
  builtin_interfaces::msg::Duration time_from_start{};
};

struct MultiDOFJointTrajectory {
  std_msgs::msg::Header header{};
  std::vector<std::string> joint_names{};
  std::vector<trajectory_msgs::msg::MultiDOFJointTrajectoryPoint> points{};
};
}  // namespace trajectory_msgs::msg

namespace std_msgs::msg {
struct ColorRGBA {
  float r{};
  float g{};
  float b{};
  float a{};
};
}  // namespace std_msgs::msg

namespace sensor_msgs::msg {
struct CompressedImage {
  std_msgs::msg::Header header{};
  std::string format{};
  std::vector<std::uint8_t> data{};
};
}  // namespace sensor_msgs::msg

namespace visualization_msgs::msg {
struct UVCoordinate {
  float u{};
  float v{};
};

struct MeshFile {
  std::string filename{};
  std::vector<std::uint8_t> data{};
};

struct Marker {
  static constexpr std::int32_t ARROW = 0;
  static constexpr std::int32_t CUBE = 1;
  static constexpr std::int32_t SPHERE = 2;
  static constexpr std::int32_t CYLINDER = 3;
  static constexpr std::int32_t LINE_STRIP = 4;
  static constexpr std::int32_t LINE_LIST = 5;
  static constexpr std::int32_t CUBE_LIST = 6;
  static constexpr std::int32_t SPHERE_LIST = 7;
  static constexpr std::int32_t POINTS = 8;
  static constexpr std::int32_t TEXT_VIEW_FACING = 9;
  static constexpr std::int32_t MESH_RESOURCE = 10;
  static constexpr std::int32_t TRIANGLE_LIST = 11;
  static constexpr std::int32_t ARROW_STRIP = 12;
  static constexpr std::int32_t ADD = 0;
  static constexpr std::int32_t MODIFY = 0;
  static constexpr std::int32_t DELETE = 2;
  static constexpr std::int32_t DELETEALL = 3;
  std_msgs::msg::Header header{};
  std::string ns{};
  std::int32_t id{};
  std::int32_t type{};
  std::int32_t action{};
  geometry_msgs::msg::Pose pose{};
  geometry_msgs::msg::Vector3 scale{};
  std_msgs::msg::ColorRGBA color{};
  builtin_interfaces::msg::Duration lifetime{};
  bool frame_locked{};
  std::vector<geometry_msgs::msg::Point> points{};
  std::vector<std_msgs::msg::ColorRGBA> colors{};
  std::string texture_resource{};
  sensor_msgs::msg::CompressedImage texture{};
  std::vector<visualization_msgs::msg::UVCoordinate> uv_coordinates{};
  std::string text{};
  std::string mesh_resource{};
  visualization_msgs::msg::MeshFile mesh_file{};
  bool mesh_use_embedded_materials{};
};

struct MarkerArray {
  std::vector<visualization_msgs::msg::Marker> markers{};
};
}  // namespace visualization_msgs::msg

namespace diagnostic_msgs::msg {
struct KeyValue {
  std::string key{};
  std::string value{};
};

struct DiagnosticStatus {
  static constexpr std::uint8_t OK = 0;
  static constexpr std::uint8_t WARN = 1;
  static constexpr std::uint8_t ERROR = 2;
  static constexpr std::uint8_t STALE = 3;
  std::uint8_t level{};
  std::string name{};
  std::string message{};
  std::string hardware_id{};
  std::vector<diagnostic_msgs::msg::KeyValue> values{};
};

struct DiagnosticArray {
  std_msgs::msg::Header header{};
  std::vector<diagnostic_msgs::msg::DiagnosticStatus> status{};
};
}  // namespace diagnostic_msgs::msg
