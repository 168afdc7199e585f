// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A vehicle with a camera in a world of the simulator, as ROS 1 topics: it publishes clock, camera, odometry and a
// goal, and flies the setpoints that come back.
#ifndef TERN_TESTS_PORTS_ROS1_FLOWN_WORLD_HPP
#define TERN_TESTS_PORTS_ROS1_FLOWN_WORLD_HPP

#include <diagnostic_msgs/DiagnosticArray.h>
#include <nav_msgs/Odometry.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <trajectory_msgs/MultiDOFJointTrajectory.h>

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <string>

#include "host/flight/depth_camera.hpp"
#include "host/flight/flight_world.hpp"
#include "host/vehicle/vehicle.hpp"

namespace tern_test {

/// What became of a flight.
struct Flown {
  std::string end = "timeout";  ///< reached, contact, stuck, timeout or silent
  double time = 0.0;            ///< seconds of the flight
  double clearance = 1e9;       ///< least, of the centre, m
  double off = 0.0;             ///< of the vehicle off the setpoints at most, m
  std::uint64_t late = 0;       ///< ticks for which no setpoint came within 0.2 s of true time
};

/// What the messages suffer from.
struct Spoilt {
  double share = 0.0;  ///< of frames and poses that are lost, repeated, of an earlier stamp or of another size
  double jump = 0.0;   ///< m: the estimate jumps by so much along y after 3 s
};

class FlightBag;

class FlownWorld {
 public:
  FlownWorld(const std::string& member, const Spoilt& spoilt);
  /// Sets the node's parameters on the master.
  void set_parameters() const;
  /// False if the node does not connect within 20 s.
  bool connect();
  Flown fly();
  /// What it publishes from now on is written to a bag.
  void record(const std::string& file);
  /// Publishes what a bag has instead. Flown::off is how far its vehicle is off the node's setpoints.
  Flown play(const std::string& file);
  /// The last message of the node's diagnostics.
  const std::string& told() const { return told_; }

 private:
  static constexpr std::int64_t kTick = 10000000;

  tern_host::Setpoint setpoint_at(double t) const;
  void step();
  template <typename Message>
  void publish(const ros::Publisher& publisher, const Message& message);
  void publish_clock();
  void publish_pose();
  void publish_frame();
  void publish_goal();
  void on_setpoint(const trajectory_msgs::MultiDOFJointTrajectory& message);
  bool wait_for_setpoint();
  void move();
  double yaw() const;
  double seconds() const { return 1e-9 * static_cast<double>(now_ - begin_); }
  std::string judge();

  tern_host::FlightWorld world_;
  Spoilt spoilt_;
  tern_host::Noise noise_;
  std::unique_ptr<tern_host::Vehicle> vehicle_;
  tern_host::Setpoint setpoint_{};
  double setpoint_time_ = 0.0;  // seconds of the flight
  std::int64_t setpoint_stamp_ = 0;
  std::int64_t begin_ = 10000000000, now_ = begin_;
  std::int64_t frames_ = 0;
  double rested_ = 0.0;
  tern::Vec3 jumped_{}, known_jump_{};  // of the estimate, and what of it the setpoints know
  Flown flown_;
  std::string told_;
  nav_msgs::Odometry earlier_;                 // the last one
  std::deque<sensor_msgs::Image> on_the_way_;  // images, until their latency is over
  std::shared_ptr<FlightBag> bag_;             // null: nothing is recorded
  ros::NodeHandle node_;
  ros::Publisher clock_, image_, lens_, odometry_, goal_, tf_;
  ros::Subscriber setpoints_, diagnostics_;
};

}  // namespace tern_test

#endif
