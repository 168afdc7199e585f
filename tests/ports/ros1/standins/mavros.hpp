// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Stand-ins for the messages of MAVROS, which is not in Debian. Their fields are MAVROS's, in their order: the sums are
// those of its own definitions.
#pragma once

#include <geometry_msgs/Point.h>
#include <geometry_msgs/Vector3.h>
#include <std_msgs/Header.h>

#include <boost/shared_ptr.hpp>
#include <cstdint>
#include <string>

#include "standin.hpp"

namespace mavros_msgs {
struct State {
  using ConstPtr = boost::shared_ptr<const State>;
  static constexpr const char* kType = "mavros_msgs/State";
  static constexpr const char* kSum = "65cd0a9fff993b062b91e354554ec7e9";
  std_msgs::Header header;
  std::uint8_t connected = 0, armed = 0, guided = 0, manual_input = 0;
  std::string mode;
  std::uint8_t system_status = 0;
  template <typename Stream, typename Self>
  static void all(Stream& s, Self& m) {
    s.next(m.header), s.next(m.connected), s.next(m.armed), s.next(m.guided), s.next(m.manual_input);
    s.next(m.mode), s.next(m.system_status);
  }
};
struct PositionTarget {
  using ConstPtr = boost::shared_ptr<const PositionTarget>;
  static constexpr const char* kType = "mavros_msgs/PositionTarget";
  static constexpr const char* kSum = "dedb0081aaf8cb20209737746bb49117";
  enum : std::uint8_t { FRAME_LOCAL_NED = 1 };
  std_msgs::Header header;
  std::uint8_t coordinate_frame = 0;
  std::uint16_t type_mask = 0;
  geometry_msgs::Point position;
  geometry_msgs::Vector3 velocity, acceleration_or_force;
  float yaw = 0, yaw_rate = 0;
  template <typename Stream, typename Self>
  static void all(Stream& s, Self& m) {
    s.next(m.header), s.next(m.coordinate_frame), s.next(m.type_mask), s.next(m.position), s.next(m.velocity);
    s.next(m.acceleration_or_force), s.next(m.yaw), s.next(m.yaw_rate);
  }
};
}  // namespace mavros_msgs

TERN_ROS1_STANDIN(mavros_msgs::State)
TERN_ROS1_STANDIN(mavros_msgs::PositionTarget)
