// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A stand-in for rclcpp, written from its documentation: one process, topics by name. What the test enters is delivered
// in spin(); a number on the topic `clock` sets the clock.
#pragma once

#include <any>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "common.hpp"

namespace rclcpp {

struct Bus {
  std::map<std::string, std::function<void(const std::any&)>> subscribers;
  std::vector<std::pair<std::string, std::any>> entered, published;
  std::map<std::string, std::any> parameters;
  std::map<std::string, bool> reliable;  // what each subscription asks for
  double seconds = 42.0;                 // the clock
};
inline Bus& bus() {
  static Bus the_bus;
  return the_bus;
}

struct Logger {};
#define RCLCPP_INFO(logger, ...) (static_cast<void>(logger), std::printf(__VA_ARGS__), std::printf("\n"))
#define RCLCPP_WARN(logger, ...) RCLCPP_INFO(logger, __VA_ARGS__)

class QoS {
 public:
  explicit QoS(int depth) : depth_(depth) {}
  QoS& transient_local() { return *this; }
  int depth() const { return depth_; }
  bool is_reliable() const { return reliable_; }

 protected:
  int depth_;
  bool reliable_ = true;
};
class SensorDataQoS : public QoS {
 public:
  SensorDataQoS() : QoS(5) { reliable_ = false; }
};

class Time {
 public:
  explicit Time(double seconds) : seconds_(seconds) {}
  double seconds() const { return seconds_; }
  operator builtin_interfaces::msg::Time() const {
    const double whole = std::floor(seconds_);
    return {static_cast<std::int32_t>(whole), static_cast<std::uint32_t>(1e9 * (seconds_ - whole))};
  }

 private:
  double seconds_;
};

template <typename Message>
class Publisher {
 public:
  using SharedPtr = std::shared_ptr<Publisher>;
  explicit Publisher(std::string topic) : topic_(std::move(topic)) {}
  void publish(const Message& message) { bus().published.emplace_back(topic_, message); }

 private:
  std::string topic_;
};

template <typename Message>
class Subscription {
 public:
  using SharedPtr = std::shared_ptr<Subscription>;
};

class Node {
 public:
  explicit Node(const std::string& name) : name_(name) {}
  virtual ~Node() = default;
  template <typename T>
  T declare_parameter(const std::string& name, const T& otherwise) {
    const auto found = bus().parameters.find(name);
    return found == bus().parameters.end() ? otherwise : std::any_cast<T>(found->second);
  }
  template <typename Message>
  typename Publisher<Message>::SharedPtr create_publisher(const std::string& topic, const QoS&) {
    return std::make_shared<Publisher<Message>>(topic);
  }
  template <typename Message, typename Callback>
  typename Subscription<Message>::SharedPtr create_subscription(const std::string& topic, const QoS& qos,
                                                                Callback callback) {
    bus().reliable[topic] = qos.is_reliable();
    bus().subscribers[topic] = [callback](const std::any& message) {
      callback(std::any_cast<const Message&>(message));
    };
    return std::make_shared<Subscription<Message>>();
  }
  Logger get_logger() const { return {}; }
  Time now() const { return Time(bus().seconds); }

 private:
  std::string name_;
};

inline void init(int, char**) {}
inline void shutdown() {}
template <typename SomeNode>
void spin(const std::shared_ptr<SomeNode>&) {
  for (const auto& [topic, message] : bus().entered) {
    if (topic == "clock") {
      bus().seconds = std::any_cast<double>(message);
    } else {
      bus().subscribers.at(topic)(message);
    }
  }
}

}  // namespace rclcpp
