// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros1/flown_sensors.hpp"

#include <sensor_msgs/CameraInfo.h>

#include <cmath>
#include <cstring>

#include "host/flight/depth_camera.hpp"
#include "host/flight/lidar.hpp"
#include "tern_ros/displays.hpp"

namespace tern_test {
namespace {

constexpr double kAhead = 0.1;  // m, of the cameras before the body's centre, as they look
constexpr double kAbove = 0.1;  // m, of the lidar
constexpr double kLidarHz = 10.0;
constexpr std::int64_t kEarlier = 200000000;  // ns, of stamps that go back

tern::Vec3 eye_of(const tern::Vec3& body, bool is_lidar, double looks) {
  if (is_lidar) return {body.x, body.y, body.z + kAbove};
  return {body.x + kAhead * std::cos(looks), body.y + kAhead * std::sin(looks), body.z};
}

}  // namespace

FlownSensors::FlownSensors(const tern_host::FlightWorld& world, const std::string& kinds, const Spoilt& spoilt,
                           tern_host::Noise& noise, Outlet& outlet, ros::NodeHandle& node)
    : world_(world), spoilt_(spoilt), noise_(noise), outlet_(outlet) {
  const double latency = world.settings.sensor_latency;
  if (kinds == "camera" || kinds == "both") add(node, "camera", 0.0, latency);
  if (kinds == "cameras") {
    add(node, "left", 0.6, latency);
    add(node, "right", -0.6, latency + 0.04);
  }
  if (kinds == "lidar" || kinds == "both") add_lidar(node, 1.5707963267948966);
}

void FlownSensors::add(ros::NodeHandle& node, const std::string& name, double turned, double latency) {
  units_.push_back({name,
                    false,
                    turned,
                    world_.settings.sensor_hz,
                    latency,
                    node.advertise<sensor_msgs::Image>(name + "/image", 10),
                    node.advertise<sensor_msgs::CameraInfo>(name + "/camera_info", 10),
                    0,
                    {},
                    {}});
}

void FlownSensors::add_lidar(ros::NodeHandle& node, double turned) {
  units_.push_back({"lidar",
                    true,
                    turned,
                    kLidarHz,
                    world_.settings.sensor_latency + 0.02,
                    node.advertise<sensor_msgs::PointCloud2>("lidar/points", 10),
                    ros::Publisher(),
                    0,
                    {},
                    {}});
}

void FlownSensors::set_parameters() const {
  std::string cameras, lidars;
  bool all_around = false;
  for (const Unit& unit : units_) {
    (unit.is_lidar ? lidars : cameras) += unit.name + " ";
    all_around = all_around || unit.is_lidar;
    ros::param::set("/tern/" + unit.name + "/least", 0.1);
    ros::param::set("/tern/" + unit.name + "/most", 1000.0);
  }
  ros::param::set("/tern/cameras", cameras);
  ros::param::set("/tern/lidars", lidars);
  ros::param::set("/tern/scan_pixel", world_.settings.scan_pixel);
  ros::param::set("/tern/field_of_view", all_around ? 0.0 : world_.settings.fov_horizontal);
}

tf2_msgs::TFMessage FlownSensors::mountings() const {
  tf2_msgs::TFMessage message;
  for (const Unit& unit : units_) {
    message.transforms.emplace_back();
    auto& t = message.transforms.back();
    t.header.frame_id = "base_link";
    t.child_frame_id = unit.name + "_frame";
    tern_ros::set_vector(t.transform.translation, eye_of({0.0, 0.0, 0.0}, unit.is_lidar, unit.turned));
    // About z; then, for cameras, from their own axes: x right, y down, z ahead.
    const double w = std::cos(0.5 * unit.turned), z = std::sin(0.5 * unit.turned);
    auto& q = t.transform.rotation;
    q.w = unit.is_lidar ? w : 0.5 * (w + z);
    q.x = unit.is_lidar ? 0.0 : -0.5 * (w + z);
    q.y = unit.is_lidar ? 0.0 : 0.5 * (w - z);
    q.z = unit.is_lidar ? z : 0.5 * (z - w);
  }
  return message;
}

bool FlownSensors::connected() const {
  for (const Unit& unit : units_) {
    if (unit.frames.getNumSubscribers() == 0) return false;
    if (!unit.is_lidar && unit.lens.getNumSubscribers() == 0) return false;
  }
  return true;
}

std::map<std::string, ros::Publisher> FlownSensors::publishers() const {
  std::map<std::string, ros::Publisher> all;
  for (const Unit& unit : units_) {
    all[unit.frames.getTopic()] = unit.frames;
    if (!unit.is_lidar) all[unit.lens.getTopic()] = unit.lens;
  }
  return all;
}

void FlownSensors::step(const tern::Vec3& body, double yaw, double seconds, std::int64_t now) {
  for (Unit& unit : units_) {
    deliver(unit, unit.images, now);
    deliver(unit, unit.clouds, now);
    if (static_cast<double>(unit.taken) > seconds * unit.hz) continue;
    ++unit.taken;
    if (unit.is_lidar) {
      spoil(unit.clouds, cloud(unit, body, yaw, now), now);
    } else {
      spoil(unit.images, image(unit, body, yaw, now), now);
    }
  }
}

template <typename Message>
void FlownSensors::deliver(Unit& unit, std::deque<Message>& on_the_way, std::int64_t now) {
  const std::int64_t latency = std::llround(1e9 * unit.latency);
  while (!on_the_way.empty() && static_cast<std::int64_t>(on_the_way.front().header.stamp.toNSec()) + latency <= now) {
    outlet_.publish(unit.frames, on_the_way.front(), now);
    on_the_way.pop_front();
  }
}

/// Frames are lost, stamped earlier, of another size, empty, or repeated.
template <typename Message>
void FlownSensors::spoil(std::deque<Message>& on_the_way, Message message, std::int64_t now) {
  if (noise_.chance(spoilt_.share)) return;
  if (noise_.chance(spoilt_.share)) message.header.stamp = time_of(now - kEarlier);
  if (noise_.chance(spoilt_.share)) message.height = message.height / 2 + 1;
  if (noise_.chance(spoilt_.share)) message.data.clear();
  on_the_way.push_back(message);
  if (noise_.chance(spoilt_.share)) on_the_way.push_back(message);
}

sensor_msgs::Image FlownSensors::image(Unit& unit, const tern::Vec3& body, double yaw, std::int64_t now) {
  const double looks = yaw + unit.turned;
  const tern_host::DepthFrame frame = tern_host::take_frame(world_, eye_of(body, false, looks), looks, now, noise_);
  sensor_msgs::CameraInfo info;
  info.header.stamp = time_of(now);
  info.header.frame_id = unit.name + "_frame";
  info.width = static_cast<std::uint32_t>(frame.view.width);
  info.height = static_cast<std::uint32_t>(frame.view.height);
  info.K = {frame.view.fx, 0.0, frame.view.cx, 0.0, frame.view.fy, frame.view.cy, 0.0, 0.0, 1.0};
  outlet_.publish(unit.lens, info, now);
  sensor_msgs::Image image;
  image.header = info.header;
  image.width = info.width;
  image.height = info.height;
  image.encoding = "32FC1";
  image.step = 4 * image.width;
  image.data.resize(4 * frame.depths.size());
  std::memcpy(image.data.data(), frame.depths.data(), image.data.size());
  return image;
}

/// Beams without a return end far beyond the map's range.
sensor_msgs::PointCloud2 FlownSensors::cloud(const Unit& unit, const tern::Vec3& body, double yaw, std::int64_t now) {
  const tern::Vec3 eye = eye_of(body, true, 0.0);
  const tern_host::LidarScan scan = tern_host::take_scan(world_, eye, eye, now, noise_);
  const double c = std::cos(yaw + unit.turned), s = std::sin(yaw + unit.turned);
  std::vector<tern::Vec3> points;
  for (std::size_t k = 0; k < scan.ranges.size(); ++k) {
    const double range = std::isinf(scan.ranges[k]) ? 1000.0 : static_cast<double>(scan.ranges[k]);
    const tern::Vec3& d = scan.directions[k];
    points.push_back({range * (c * d.x + s * d.y), range * (c * d.y - s * d.x), range * d.z});
  }
  sensor_msgs::PointCloud2 cloud;
  tern_ros::write_cloud(points, cloud);
  cloud.header.stamp = time_of(now);
  cloud.header.frame_id = unit.name + "_frame";
  return cloud;
}

}  // namespace tern_test
