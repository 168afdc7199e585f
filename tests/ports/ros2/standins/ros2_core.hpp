// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A stand-in for rclcpp, rclcpp_lifecycle and tf2_ros, written from their documentation: one process, topics by name.
// spin() calls the test's world until it says that it is over. The clock stands still until the test advances it, and
// the test waits until the node's thread sleeps again.
#pragma once

#include <any>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "messages.hpp"

namespace rclcpp {

class Bus {
 public:
  using Deliver = std::function<void(const std::any&)>;

  std::map<std::string, std::vector<Deliver>> subscribers;
  std::map<std::string, bool> reliable;  // what each subscription asks for
  std::map<std::string, std::any> parameters;
  std::map<std::string, geometry_msgs::msg::Transform> transforms;  // by "parent child"
  std::vector<std::string> log;
  std::vector<std::function<void()>> timers;  // the test calls them
  std::function<bool()> world;                // one step; false when it is over

  void deliver(const std::string& topic, const std::any& message) {
    publish(topic, message);
    for (const Deliver& to : subscribers.at(topic)) to(message);
  }
  void publish(const std::string& topic, const std::any& message) {
    const std::lock_guard lock(mutex_);
    published_[topic] = message;
    ++counts_[topic];
  }
  /// The last message of a topic; empty if there was none.
  std::any last(const std::string& topic) {
    const std::lock_guard lock(mutex_);
    return published_[topic];
  }
  int count(const std::string& topic) {
    const std::lock_guard lock(mutex_);
    return counts_[topic];
  }
  std::int64_t now() {
    const std::lock_guard lock(mutex_);
    return now_;
  }
  /// Waits until the node's thread sleeps beyond the new time.
  void set_clock(std::int64_t now) {
    std::unique_lock lock(mutex_);
    now_ = now;
    changed_.notify_all();
    changed_.wait_for(lock, std::chrono::seconds(20), [this] { return sleeps_until_ > now_; });
  }
  void sleep_until(std::int64_t t) {
    std::unique_lock lock(mutex_);
    sleeps_until_ = t;
    changed_.notify_all();
    // The world has ended, or the node is being deactivated: nobody advances the clock.
    changed_.wait_for(lock, std::chrono::milliseconds(over_ ? 1 : 200), [this, t] { return now_ >= t || over_; });
    sleeps_until_ = 0;
  }
  bool ok() {
    const std::lock_guard lock(mutex_);
    return !over_;
  }
  void end() {
    const std::lock_guard lock(mutex_);
    over_ = true;
    changed_.notify_all();
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::map<std::string, std::any> published_;
  std::map<std::string, int> counts_;
  std::int64_t now_ = 42000000000, sleeps_until_ = 0;
  bool over_ = false;
};
inline std::unique_ptr<Bus>& the_bus() {
  static std::unique_ptr<Bus> bus = std::make_unique<Bus>();
  return bus;
}
inline Bus& bus() {
  return *the_bus();
}

struct Logger {};
template <typename... Args>
void log_line(const char* format, Args... args) {
  char line[1000];
  std::snprintf(line, sizeof line, format, args...);
  bus().log.emplace_back(line);
}
#define RCLCPP_INFO(logger, ...) (static_cast<void>(logger), rclcpp::log_line(__VA_ARGS__))
#define RCLCPP_WARN(logger, ...) RCLCPP_INFO(logger, __VA_ARGS__)
#define RCLCPP_FATAL(logger, ...) RCLCPP_INFO(logger, __VA_ARGS__)

class QoS {
 public:
  QoS(int) {}
  bool is_reliable() const { return reliable_; }

 protected:
  bool reliable_ = true;
};
class SensorDataQoS : public QoS {
 public:
  SensorDataQoS() : QoS(5) { reliable_ = false; }
};

class Time {
 public:
  explicit Time(std::int64_t ns, int = 1) : ns_(ns) {}
  std::int64_t nanoseconds() const { return ns_; }

 private:
  std::int64_t ns_;
};
class Clock {
 public:
  using SharedPtr = std::shared_ptr<Clock>;
  int get_clock_type() const { return 1; }
  bool sleep_until(const Time& t) {
    bus().sleep_until(t.nanoseconds());
    return true;
  }
};

class SubscriptionBase {
 public:
  using SharedPtr = std::shared_ptr<SubscriptionBase>;
};
class TimerBase {
 public:
  using SharedPtr = std::shared_ptr<TimerBase>;
};
class Parameter {
 public:
  explicit Parameter(std::any value) : value_(std::move(value)) {}
  template <typename T>
  T get_value() const {
    return std::any_cast<T>(value_);
  }

 private:
  std::any value_;
};

inline void init(int, char**) {}
inline void shutdown() {
  bus().end();
}
inline bool ok() {
  return bus().ok();
}
template <typename Base>
void spin(const Base&) {
  while (bus().world && bus().world()) {
  }
}

}  // namespace rclcpp

namespace lifecycle_msgs::msg {
struct State {
  static constexpr std::uint8_t PRIMARY_STATE_UNCONFIGURED = 1, PRIMARY_STATE_INACTIVE = 2, PRIMARY_STATE_ACTIVE = 3;
};
}  // namespace lifecycle_msgs::msg

namespace rclcpp_lifecycle {

class State {
 public:
  State(int id = 1) : id_(id) {}
  int id() const { return id_; }

 private:
  int id_;
};

namespace node_interfaces {
struct LifecycleNodeInterface {
  enum class CallbackReturn { SUCCESS, FAILURE, ERROR };
};
}  // namespace node_interfaces

/// Drops what is published while the node is not active.
template <typename Message>
class LifecyclePublisher {
 public:
  using SharedPtr = std::shared_ptr<LifecyclePublisher>;
  LifecyclePublisher(std::string topic, const bool& active) : topic_(std::move(topic)), active_(active) {}
  void publish(const Message& message) {
    if (active_) rclcpp::bus().publish(topic_, message);
  }
  std::size_t get_subscription_count() const { return 1; }

 private:
  std::string topic_;
  const bool& active_;
};

class LifecycleNode {
 public:
  using CallbackReturn = node_interfaces::LifecycleNodeInterface::CallbackReturn;

  explicit LifecycleNode(std::string name) : name_(std::move(name)) {}
  virtual ~LifecycleNode() = default;
  virtual CallbackReturn on_configure(const State&) { return CallbackReturn::SUCCESS; }
  virtual CallbackReturn on_activate(const State&) {
    active_ = true;
    return CallbackReturn::SUCCESS;
  }
  virtual CallbackReturn on_deactivate(const State&) {
    active_ = false;
    return CallbackReturn::SUCCESS;
  }
  virtual CallbackReturn on_cleanup(const State&) { return CallbackReturn::SUCCESS; }
  virtual CallbackReturn on_shutdown(const State&) { return CallbackReturn::SUCCESS; }
  const State& configure() { return go(1, 2, on_configure(state_)); }
  const State& activate() { return state_.id() == 2 ? go(2, 3, on_activate(state_)) : state_; }
  const State& deactivate() { return go(3, 2, on_deactivate(state_)); }
  const State& cleanup() { return go(2, 1, on_cleanup(state_)); }
  const State& get_current_state() const { return state_; }

  bool has_parameter(const std::string& name) const { return declared_.count(name) > 0; }
  template <typename T>
  T declare_parameter(const std::string& name, const T& otherwise) {
    const auto found = rclcpp::bus().parameters.find(name);
    declared_[name] = found == rclcpp::bus().parameters.end() ? std::any(otherwise) : found->second;
    return std::any_cast<T>(declared_[name]);
  }
  rclcpp::Parameter get_parameter(const std::string& name) const { return rclcpp::Parameter(declared_.at(name)); }

  template <typename Message>
  std::shared_ptr<LifecyclePublisher<Message>> create_publisher(const std::string& topic, const rclcpp::QoS&) {
    return std::make_shared<LifecyclePublisher<Message>>(topic, active_);
  }
  template <typename Message, typename Callback>
  rclcpp::SubscriptionBase::SharedPtr create_subscription(const std::string& topic, const rclcpp::QoS& qos,
                                                          Callback callback) {
    rclcpp::bus().reliable[topic] = qos.is_reliable();
    rclcpp::bus().subscribers[topic].push_back(
        [callback](const std::any& message) { callback(std::any_cast<const Message&>(message)); });
    return std::make_shared<rclcpp::SubscriptionBase>();
  }
  template <typename Duration, typename Callback>
  rclcpp::TimerBase::SharedPtr create_wall_timer(Duration, Callback callback) {
    rclcpp::bus().timers.emplace_back(callback);
    return std::make_shared<rclcpp::TimerBase>();
  }
  rclcpp::Logger get_logger() const { return {}; }
  rclcpp::Time now() const { return rclcpp::Time(rclcpp::bus().now()); }
  rclcpp::Clock::SharedPtr get_clock() const { return std::make_shared<rclcpp::Clock>(); }
  int get_node_base_interface() const { return 0; }

 private:
  const State& go(int from, int to, CallbackReturn answer) {
    state_ = State(answer == CallbackReturn::SUCCESS ? to : from);
    return state_;
  }

  std::string name_;
  std::map<std::string, std::any> declared_;
  State state_;
  bool active_ = false;
};

}  // namespace rclcpp_lifecycle

namespace tf2 {
class TransformException : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};
inline constexpr int TimePointZero = 0;
}  // namespace tf2

namespace tf2_ros {
class Buffer {
 public:
  explicit Buffer(const rclcpp::Clock::SharedPtr&) {}
  geometry_msgs::msg::TransformStamped lookupTransform(const std::string& parent, const std::string& child, int) const {
    const auto& known = rclcpp::bus().transforms;
    const auto found = known.find(parent + " " + child);
    if (found == known.end()) throw tf2::TransformException("\"" + child + "\" does not exist.");
    geometry_msgs::msg::TransformStamped transform;
    transform.transform = found->second;
    return transform;
  }
};
class TransformListener {
 public:
  explicit TransformListener(Buffer&) {}
};
}  // namespace tf2_ros
