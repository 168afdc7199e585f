// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Publishes, and writes what was published to a bag.
#ifndef TERN_TESTS_PORTS_ROS1_OUTLET_HPP
#define TERN_TESTS_PORTS_ROS1_OUTLET_HPP

#include <ros/ros.h>

#include <cstdint>
#include <memory>
#include <string>

namespace tern_test {

class FlightBag;

inline ros::Time time_of(std::int64_t ns) {
  ros::Time time;
  time.fromNSec(static_cast<std::uint64_t>(ns));
  return time;
}

/// Flies a node's record again. Prints, as JSON, how many ticks it has, how many of them have a setpoint in the bag, in
/// how many the command has other bits than that, and what differs from the record. Answers the exit status.
int replay(const std::string& record, const std::string& bag);

class Outlet {
 public:
  /// From now on, messages are written to this bag, too.
  void record(const std::string& file);
  bool records() const { return bag_ != nullptr; }
  template <typename Message>
  void publish(const ros::Publisher& publisher, const Message& message, std::int64_t now) {
    publisher.publish(message);
    note(publisher.getTopic(), message, now);
  }
  /// Writes a message that somebody else published. bag.cpp has the types.
  template <typename Message>
  void note(const std::string& topic, const Message& message, std::int64_t now);

 private:
  std::shared_ptr<FlightBag> bag_;  // null: nothing is recorded
};

}  // namespace tern_test

#endif
