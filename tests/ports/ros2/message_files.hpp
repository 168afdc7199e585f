// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Writes messages to files as ROS 2 sends them (CDR, little-endian), each beside a list of its fields. messages.mjs
// reads the one with a decoder of others, and compares it with the other.
#ifndef TERN_TESTS_PORTS_ROS2_MESSAGE_FILES_HPP
#define TERN_TESTS_PORTS_ROS2_MESSAGE_FILES_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <string>
#include <type_traits>
#include <vector>

#include "autopilots.hpp"
#include "fields.hpp"

namespace tern_test {

// What port/ros sends to PX4. npm has no definitions of px4_msgs; messages.mjs has these as text.
template <typename Visit>
void each_field(const px4_msgs::msg::OffboardControlMode& m, Visit& visit) {
  visit("timestamp", m.timestamp);
  visit("position", m.position);
  visit("velocity", m.velocity);
  visit("acceleration", m.acceleration);
  visit("attitude", m.attitude);
  visit("body_rate", m.body_rate);
  visit("thrust_and_torque", m.thrust_and_torque);
  visit("direct_actuator", m.direct_actuator);
}
template <typename Visit>
void each_field(const px4_msgs::msg::TrajectorySetpoint& m, Visit& visit) {
  visit("timestamp", m.timestamp);
  visit("position", m.position);
  visit("velocity", m.velocity);
  visit("acceleration", m.acceleration);
  visit("jerk", m.jerk);
  visit("yaw", m.yaw);
  visit("yawspeed", m.yawspeed);
}

/// A message as bytes and as lines "path value". A fraction's value is the bits of a double; a sequence has a line with
/// its length before its elements.
class WrittenMessage {
 public:
  /// A field, for each_field().
  template <typename Value>
  void operator()(const char* name, const Value& value) {
    within((path_.empty() ? "" : ".") + std::string(name), value);
  }
  void save(const std::string& path) const {
    std::ofstream(path + ".cdr", std::ios::binary).write(bytes_.data(), static_cast<std::streamsize>(bytes_.size()));
    std::ofstream(path + ".txt") << lines_;
  }

 private:
  template <typename Value>
  void within(const std::string& step, const Value& value) {
    const std::size_t before = path_.size();
    path_ += step;
    put(value);
    path_.resize(before);
  }
  template <typename Value>
  void put(const Value& value) {
    if constexpr (std::is_arithmetic_v<Value>) {
      number(value);
      line(text(value));
    } else {
      each_field(value, *this);
    }
  }
  void put(const std::string& value) {
    number(static_cast<std::uint32_t>(value.size() + 1));
    bytes_.append(value.c_str(), value.size() + 1);
    line(value);
  }
  template <typename Value, std::size_t kCount>
  void put(const std::array<Value, kCount>& values) {
    elements(values);
  }
  template <typename Value>
  void put(const std::vector<Value>& values) {
    number(static_cast<std::uint32_t>(values.size()));
    line(std::to_string(values.size()));
    elements(values);
  }
  template <typename Values>
  void elements(const Values& values) {
    for (std::size_t k = 0; k < values.size(); ++k) within("[" + std::to_string(k) + "]", values[k]);
  }
  /// At a multiple of its size, from the end of the head on.
  template <typename Number>
  void number(Number value) {
    while ((bytes_.size() - kHead) % sizeof value != 0) bytes_ += '\0';
    char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    bytes_.append(bytes, sizeof value);
  }
  template <typename Number>
  static std::string text(Number value) {
    if constexpr (!std::is_floating_point_v<Number>) return std::to_string(value);
    const auto wide = static_cast<double>(value);
    std::uint64_t bits = 0;
    std::memcpy(&bits, &wide, sizeof bits);
    char hex[20];
    std::snprintf(hex, sizeof hex, "%016llx", static_cast<unsigned long long>(bits));
    return hex;
  }
  void line(const std::string& value) { lines_ += path_ + " " + value + "\n"; }

  static constexpr std::size_t kHead = 4;
  std::string bytes_ = std::string("\0\1\0\0", kHead);
  std::string lines_, path_;
};

/// Writes a message of the type "package/Name".
template <typename Message>
void write_message(const std::string& type, const Message& message) {
  WrittenMessage written;
  each_field(message, written);
  written.save(std::string(TERN_TEST_MESSAGES "/") + type.substr(0, type.find('/')) + "." +
               type.substr(type.find('/') + 1));
}

}  // namespace tern_test

#endif
