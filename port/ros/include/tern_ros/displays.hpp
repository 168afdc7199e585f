// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What RViz and rqt show of a flight: markers, the map as a cloud, diagnostics.
#ifndef TERN_ROS_DISPLAYS_HPP
#define TERN_ROS_DISPLAYS_HPP

#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

#include "tern_onboard/onboard.hpp"
#include "tern_ros/edges.hpp"
#include "tern_ros/outputs.hpp"

namespace tern_ros {

struct Colour {
  float r, g, b, a;
};

/// An empty visualization_msgs/Marker of this kind and width in metres.
template <typename Marker>
Marker marker_of(const char* space, int type, double width, const Colour& colour) {
  Marker marker;
  marker.ns = space;
  marker.type = type;
  marker.action = Marker::ADD;
  marker.pose.orientation.w = 1.0;
  marker.scale.x = marker.scale.y = marker.scale.z = width;
  marker.color.r = colour.r;
  marker.color.g = colour.g;
  marker.color.b = colour.b;
  marker.color.a = colour.a;
  return marker;
}

/// Points of a display's line: RViz draws hundreds of them with ease.
constexpr std::size_t kMostPlanPoints = 400;

/// The committed plan, the corridor of the last new plan, what is in the way, and where the sensor should look, as
/// visualization_msgs/MarkerArray.
template <typename MarkerArray>
void write_markers(const tern_onboard::Onboard& onboard, std::int64_t now, MarkerArray& message) {
  using Marker = typename std::decay_t<decltype(message.markers)>::value_type;
  constexpr std::int64_t kStep = 50000000;  // ns
  const tern_onboard::Status status = onboard.status(now);
  const auto put = [](Marker& marker, const std::vector<tern::Vec3>& points) {
    marker.points.resize(points.size());
    for (std::size_t k = 0; k < points.size(); ++k) set_vector(marker.points[k], points[k]);
    if (points.empty()) marker.action = Marker::DELETE;
  };
  message.markers.clear();
  message.markers.push_back(marker_of<Marker>("plan", Marker::LINE_STRIP, 0.06, {0.1f, 0.4f, 0.9f, 1.0f}));
  std::vector<tern::Vec3> points = onboard.plan_points(now, kStep, kMostPlanPoints);
  if (points.size() == 1) points.push_back(points[0]);  // RViz complains about lines of one point
  put(message.markers.back(), points);

  message.markers.push_back(marker_of<Marker>("corridor", Marker::LINE_LIST, 0.02, {0.2f, 0.7f, 0.4f, 0.6f}));
  points.clear();
  for (const auto& polyhedron : onboard.corridor()) add_edges(polyhedron, points);
  put(message.markers.back(), points);

  message.markers.push_back(marker_of<Marker>("in_the_way", Marker::SPHERE_LIST, 0.3, {0.9f, 0.2f, 0.1f, 0.9f}));
  points.clear();
  if (status.state == tern_onboard::State::kFlying && status.report.blocked_by != tern::BlockedBy::kNothing) {
    points.push_back(tern_onboard::plus(status.report.blocked_at, status.offset));
  }
  put(message.markers.back(), points);

  message.markers.push_back(marker_of<Marker>("look_at", Marker::SPHERE_LIST, 0.2, {0.9f, 0.8f, 0.1f, 0.7f}));
  points.clear();
  const tern_onboard::Setpoint setpoint = onboard.setpoint(now);
  if (status.state == tern_onboard::State::kFlying) points.push_back(setpoint.look_at);
  put(message.markers.back(), points);
}

/// Points as sensor_msgs/PointCloud2.
template <typename PointCloud2>
void write_cloud(const std::vector<tern::Vec3>& points, PointCloud2& cloud) {
  constexpr std::uint8_t kFloat32 = 7;
  constexpr std::size_t kStep = 3 * sizeof(float);
  cloud.fields.resize(3);
  for (std::size_t k = 0; k < 3; ++k) {
    cloud.fields[k].name = std::string(1, "xyz"[k]);
    cloud.fields[k].offset = static_cast<std::uint32_t>(k * sizeof(float));
    cloud.fields[k].datatype = kFloat32;
    cloud.fields[k].count = 1;
  }
  cloud.height = 1;
  cloud.width = static_cast<std::uint32_t>(points.size());
  cloud.is_bigendian = false;
  cloud.is_dense = true;
  cloud.point_step = static_cast<std::uint32_t>(kStep);
  cloud.row_step = static_cast<std::uint32_t>(kStep * points.size());
  cloud.data.resize(cloud.row_step);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const float p[3] = {static_cast<float>(points[k].x), static_cast<float>(points[k].y),
                        static_cast<float>(points[k].z)};
    std::memcpy(&cloud.data[k * kStep], p, sizeof p);
  }
}

/// A flight's state as one diagnostic_msgs/DiagnosticStatus.
template <typename DiagnosticStatus>
void write_diagnostics(const tern_onboard::Onboard& onboard, std::int64_t now, DiagnosticStatus& message) {
  const tern_onboard::Status status = onboard.status(now);
  using tern_onboard::State;
  const bool threat = status.report.mode == tern::FlightMode::kThreat && status.state == State::kFlying;
  const bool bad = status.state == State::kLost || threat;
  const bool slow = status.state == State::kFlying && status.report.speed_share < 1.0;
  message.name = "tern: flight";
  message.hardware_id = "tern";
  const bool warns = status.state == State::kNoPose || status.report.map_stale || slow;
  message.level = bad ? DiagnosticStatus::ERROR : warns ? DiagnosticStatus::WARN : DiagnosticStatus::OK;
  message.message = tern_onboard::describe(status);
  message.values.clear();
  const auto put = [&message](const std::string& key, const std::string& value) {
    message.values.emplace_back();
    message.values.back().key = key;
    message.values.back().value = value;
  };
  const auto number = [](double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3f", value);
    return std::string(text);
  };
  put("state", tern_onboard::state_name(status.state));
  put("mode", tern::flight_mode_name(status.report.mode));
  put("reason", tern::flight_reason_text(status.report.reason));
  put("last plan", tern::status_name(status.report.plan));
  put("work of the last tick, units", std::to_string(status.report.work));
  put("plans committed", std::to_string(status.report.committed));
  put("plans dropped", std::to_string(status.report.dropped));
  put("plans failed", std::to_string(status.report.failed));
  put("ticks", std::to_string(status.ticks));
  put("ticks skipped", std::to_string(status.ticks_skipped));
  put("age of the pose, s", number(1e-9 * static_cast<double>(status.pose_age)));
  put("off the command, m", number(status.stray));
  put("off the command at most, m", number(status.stray_max));
  put("things that move", std::to_string(status.things));
  put("part of the speed that this leaves", number(status.report.speed_share));
  for (const tern_onboard::SensorState& sensor : status.sensors) {
    put(sensor.name + ": frames", std::to_string(sensor.taken));
    put(sensor.name + ": age of the last frame, s",
        sensor.taken == 0 ? "none" : number(1e-9 * static_cast<double>(now - sensor.last_stamp)));
  }
  const tern_onboard::FrameAges ages = onboard.frame_ages();
  put("frames' age on arrival, median / 99 % / most", ages.to_arrival);
  put("frames' age in the map", ages.to_map);
  put("frames' age at the first setpoint that rests on them", ages.to_setpoint);
  for (std::size_t k = 0; k < tern_onboard::kFaults; ++k) {
    if (status.faults[k] == 0) continue;
    put(tern_onboard::fault_name(static_cast<tern_onboard::Fault>(k)), std::to_string(status.faults[k]));
  }
}

}  // namespace tern_ros

#endif
