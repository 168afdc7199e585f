// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A vehicle with sensors in a world of the simulator, as ROS 1 topics: it publishes clock, sensors, odometry and a
// goal, and flies the setpoints that come back.
#ifndef TERN_TESTS_PORTS_ROS1_FLOWN_WORLD_HPP
#define TERN_TESTS_PORTS_ROS1_FLOWN_WORLD_HPP

#include <mavros_msgs/PositionTarget.h>
#include <nav_msgs/Odometry.h>
#include <ros/ros.h>
#include <trajectory_msgs/MultiDOFJointTrajectory.h>

#include <cstdint>
#include <memory>
#include <string>

#include "host/flight/flight_world.hpp"
#include "host/vehicle/vehicle.hpp"
#include "ros1/flown_displays.hpp"
#include "ros1/flown_sensors.hpp"
#include "ros1/outlet.hpp"

namespace tern_test {

/// What became of a flight.
struct Flown {
  std::string end = "timeout";  ///< reached, contact, stuck, timeout or silent
  double time = 0.0;            ///< seconds of the flight
  double clearance = 1e9;       ///< least, of the centre, m
  double off = 0.0;             ///< of the vehicle off the setpoints at most, m
  double agreed = 0.0;          ///< of a bag that is played: seconds until a setpoint is 0.1 m off the one in the bag
  std::uint64_t late = 0;       ///< ticks for which no setpoint came within 0.2 s of true time
};

/// How a world is flown.
struct FlownSettings {
  Spoilt spoilt;
  std::string sensors = "camera";  ///< as FlownSensors has it
  bool mavros = false;     ///< setpoints as MAVROS takes them, in offboard mode; otherwise MultiDOFJointTrajectory
  bool real_time = false;  ///< by the computer's clock; otherwise the clock waits for the node's setpoints
};

class FlownWorld {
 public:
  FlownWorld(const std::string& member, const FlownSettings& settings);
  /// Sets the node's parameters on the master.
  void set_parameters() const;
  /// False if the node does not connect within 20 s.
  bool connect();
  Flown fly();
  /// What it publishes from now on, and the node's setpoints, are written to a bag.
  void record(const std::string& file) { outlet_.record(file); }
  /// Publishes what a bag has instead. Flown::off is how far the node's setpoints are off those in the bag.
  Flown play(const std::string& file);
  const FlownDisplays& displays() const { return displays_; }

 private:
  static constexpr std::int64_t kTick = 10000000;

  tern_host::Setpoint setpoint_at(double t) const;
  void step();
  void publish_clock();
  void publish_pose();
  void publish_goal();
  void publish_mode();
  void on_setpoint(const trajectory_msgs::MultiDOFJointTrajectory& message);
  void on_target(const mavros_msgs::PositionTarget& message);
  void take_setpoint(const tern_host::Setpoint& setpoint, const ros::Time& stamp);
  bool wait_for_setpoint();
  bool wait_for_clock();
  void move();
  double yaw() const;
  double seconds() const { return 1e-9 * static_cast<double>(now_ - begin_); }
  std::string judge();

  tern_host::FlightWorld world_;
  FlownSettings settings_;
  tern_host::Noise noise_;
  std::unique_ptr<tern_host::Vehicle> vehicle_;
  tern_host::Setpoint setpoint_{};
  double setpoint_time_ = 0.0;  // seconds of the flight
  std::int64_t setpoint_stamp_ = 0;
  std::int64_t begin_ = 10000000000, now_ = begin_;
  double rested_ = 0.0;
  tern::Vec3 jumped_{}, known_jump_{};  // of the estimate, and what of it the setpoints know
  Flown flown_;
  nav_msgs::Odometry earlier_;  // the last one
  ros::NodeHandle node_;
  Outlet outlet_;
  FlownSensors sensors_;
  FlownDisplays displays_;
  ros::Publisher clock_, odometry_, goal_, tf_, mode_;
  ros::Subscriber setpoints_;
};

}  // namespace tern_test

#endif
