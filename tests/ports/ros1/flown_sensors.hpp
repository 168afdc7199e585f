// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The sensors of a vehicle in a world of the simulator, as ROS 1 topics.
#ifndef TERN_TESTS_PORTS_ROS1_FLOWN_SENSORS_HPP
#define TERN_TESTS_PORTS_ROS1_FLOWN_SENSORS_HPP

#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>
#include <tf2_msgs/TFMessage.h>

#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <vector>

#include "host/flight/flight_world.hpp"
#include "host/flight/noise.hpp"
#include "ros1/outlet.hpp"

namespace tern_test {

/// What the messages suffer from.
struct Spoilt {
  double share = 0.0;  ///< of frames and poses that are lost, repeated, of an earlier stamp or of another size
  double jump = 0.0;   ///< m: the estimate jumps by so much along y after 3 s
};

class FlownSensors {
 public:
  /// `kinds`: "camera", "cameras" (one to the left and one to the right), "lidar", or "both".
  FlownSensors(const tern_host::FlightWorld& world, const std::string& kinds, const Spoilt& spoilt,
               tern_host::Noise& noise, Outlet& outlet, ros::NodeHandle& node);
  /// The node's parameters that depend on them.
  void set_parameters() const;
  /// Where they sit on the body.
  tf2_msgs::TFMessage mountings() const;
  bool connected() const;
  /// By topic.
  std::map<std::string, ros::Publisher> publishers() const;
  /// Takes the frames that are due, and publishes those that have arrived. `seconds`: of the flight.
  void step(const tern::Vec3& body, double yaw, double seconds, std::int64_t now);

 private:
  struct Unit {
    std::string name;
    bool is_lidar;
    double turned;  // to the left, rad
    double hz, latency;
    ros::Publisher frames, lens;
    std::int64_t taken = 0;
    std::deque<sensor_msgs::Image> images;  // until their latency is over
    std::deque<sensor_msgs::PointCloud2> clouds;
  };

  void add(ros::NodeHandle& node, const std::string& name, double turned, double latency);
  void add_lidar(ros::NodeHandle& node, double turned);
  template <typename Message>
  void deliver(Unit& unit, std::deque<Message>& on_the_way, std::int64_t now);
  template <typename Message>
  void spoil(std::deque<Message>& on_the_way, Message message, std::int64_t now);
  sensor_msgs::Image image(Unit& unit, const tern::Vec3& body, double yaw, std::int64_t now);
  sensor_msgs::PointCloud2 cloud(const Unit& unit, const tern::Vec3& body, double yaw, std::int64_t now);

  const tern_host::FlightWorld& world_;
  Spoilt spoilt_;
  tern_host::Noise& noise_;
  Outlet& outlet_;
  std::vector<Unit> units_;
};

}  // namespace tern_test

#endif
