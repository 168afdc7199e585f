// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The flight node for ROS 2, a lifecycle node: poses, frames of sensors, goals and missions in, setpoints, markers, the
// map and diagnostics out. Configuring reads the parameters, activating begins to tick and to send setpoints.
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include <chrono>
#include <cstdlib>
#include <diagnostic_msgs/msg/diagnostic_array.hpp>
#include <functional>
#include <geometry_msgs/msg/pose_stamped.hpp>
#include <lifecycle_msgs/msg/state.hpp>
#include <memory>
#include <nav_msgs/msg/odometry.hpp>
#include <nav_msgs/msg/path.hpp>
#include <rclcpp/rclcpp.hpp>
#include <rclcpp_lifecycle/lifecycle_node.hpp>
#include <sensor_msgs/msg/camera_info.hpp>
#include <sensor_msgs/msg/image.hpp>
#include <sensor_msgs/msg/point_cloud2.hpp>
#include <std_msgs/msg/empty.hpp>
#include <stdexcept>
#include <string>
#include <visualization_msgs/msg/marker_array.hpp>

#include "detections.hpp"
#include "senders.hpp"
#include "tern_ros/displays.hpp"
#include "tern_ros/flight_topics.hpp"
#include "tern_ros/parameters.hpp"
#include "tern_ros/tick_loop.hpp"
#include "tern_ros/tracking.hpp"

namespace {

using rclcpp_lifecycle::LifecycleNode;
using CallbackReturn = rclcpp_lifecycle::node_interfaces::LifecycleNodeInterface::CallbackReturn;
using tern_onboard::Setpoint;

class Node : public LifecycleNode {
 public:
  Node() : LifecycleNode("tern") {}
  ~Node() override { loop_.reset(); }

  CallbackReturn on_configure(const rclcpp_lifecycle::State&) override {
    try {
      set_up();
    } catch (const std::exception& fault) {  // also rclcpp's, of a parameter with another type
      RCLCPP_FATAL(get_logger(), "%s", fault.what());
      return CallbackReturn::FAILURE;
    }
    return CallbackReturn::SUCCESS;
  }
  CallbackReturn on_activate(const rclcpp_lifecycle::State& state) override {
    LifecycleNode::on_activate(state);
    loop_ = std::make_unique<tern_ros::TickLoop>(
        *onboard_, options_.setpoint_rate,
        tern_ros::Loop{
            [this] { return now_ns(); },
            [this](std::int64_t t) { get_clock()->sleep_until(rclcpp::Time(t, get_clock()->get_clock_type())); },
            [] { return rclcpp::ok(); }, [this](std::int64_t now, const Setpoint& setpoint) { send_(now, setpoint); }});
    return CallbackReturn::SUCCESS;
  }
  CallbackReturn on_deactivate(const rclcpp_lifecycle::State& state) override {
    loop_.reset();
    LifecycleNode::on_deactivate(state);
    return CallbackReturn::SUCCESS;
  }
  CallbackReturn on_cleanup(const rclcpp_lifecycle::State&) override {
    forget();
    return CallbackReturn::SUCCESS;
  }
  CallbackReturn on_shutdown(const rclcpp_lifecycle::State&) override {
    forget();
    return CallbackReturn::SUCCESS;
  }

  /// A parameter, which is declared when it is first asked for.
  template <typename Value>
  Value parameter(const std::string& name, const Value& otherwise) {
    if (!has_parameter(name)) declare_parameter(name, otherwise);
    return get_parameter(name).get_value<Value>();
  }

 private:
  std::int64_t now_ns() { return now().nanoseconds(); }

  void forget() {
    loop_.reset();
    displays_.reset();
    subscriptions_.clear();
    send_ = {};
    topics_.reset();
    listener_.reset();
    buffer_.reset();
    onboard_.reset();
  }

  auto parameters() {
    return [this](const std::string& name, const auto& otherwise) { return parameter(name, otherwise); };
  }

  void set_up() {
    forget();
    options_ = tern_ros::read_options(parameters());
    const tern_onboard::Settings settings = tern_ros::read_settings(parameters());
    onboard_ = std::make_unique<tern_onboard::Onboard>(settings, tern_ros::detector_of(settings, options_));
    buffer_ = std::make_unique<tf2_ros::Buffer>(get_clock());
    listener_ = std::make_unique<tf2_ros::TransformListener>(*buffer_);
    topics_ = std::make_unique<tern_ros::FlightTopics>(
        *onboard_, options_, [this](auto&&... args) { return find(args...); },
        [this](bool bad, const std::string& text) {
          if (bad) {
            RCLCPP_WARN(get_logger(), "%s", text.c_str());
          } else {
            RCLCPP_INFO(get_logger(), "%s", text.c_str());
          }
        });
    listen_to_sensors();
    listen();
    advertise();
  }

  bool find(const std::string& parent, const std::string& child, tern::Pose& pose, std::string& why) const {
    try {
      pose = tern_ros::pose_of_transform(buffer_->lookupTransform(parent, child, tf2::TimePointZero).transform);
      return true;
    } catch (const tf2::TransformException& exception) {
      why = exception.what();
      return false;
    }
  }

  template <typename Message, typename Handle>
  void on(const std::string& topic, const rclcpp::QoS& qos, Handle handle) {
    subscriptions_.push_back(create_subscription<Message>(topic, qos, [handle](const Message& m) { handle(m); }));
  }

  void listen_to_sensors() {
    int sensor = 0;
    const rclcpp::SensorDataQoS data;
    for (const std::string& name : tern_ros::words_of(options_.cameras)) {
      topics_->add_sensor(name, tern_onboard::SensorKind::kDepth,
                          tern_ros::read_sensor_settings(name + ".", parameters()));
      on<sensor_msgs::msg::CameraInfo>(name + "/camera_info", data,
                                       [this, sensor](const auto& m) { topics_->on_lens(sensor, m); });
      on<sensor_msgs::msg::Image>(name + "/image", data,
                                  [this, sensor](const auto& m) { topics_->on_image(sensor, m, now_ns()); });
      ++sensor;
    }
    for (const std::string& name : tern_ros::words_of(options_.lidars)) {
      topics_->add_sensor(name, tern_onboard::SensorKind::kPoints,
                          tern_ros::read_sensor_settings(name + ".", parameters()));
      on<sensor_msgs::msg::PointCloud2>(name + "/points", data,
                                        [this, sensor](const auto& m) { topics_->on_scan(sensor, m, now_ns()); });
      ++sensor;
    }
  }

  /// Estimators and MAVROS publish poses as sensor data, best effort: a reliable subscription would not be connected.
  void listen() {
    const rclcpp::SensorDataQoS data;
    const rclcpp::QoS reliable(4);
    on<nav_msgs::msg::Odometry>("odometry", data, [this](const auto& m) { topics_->on_odometry(m, now_ns()); });
    on<geometry_msgs::msg::PoseStamped>("pose", data, [this](const auto& m) { topics_->on_pose(m, now_ns()); });
    on<sensor_msgs::msg::PointCloud2>("known", reliable, [this](const auto& m) { topics_->on_known(m); });
    on<geometry_msgs::msg::PoseStamped>("goal", reliable, [this](const auto& m) { topics_->on_goal(m, now_ns()); });
    on<nav_msgs::msg::Path>("mission", reliable, [this](const auto& m) { topics_->on_mission(m, now_ns()); });
    on<std_msgs::msg::Empty>("stop", reliable, [this](const auto&) { topics_->on_stop(); });
    tern_ros::use_tracker(*topics_, options_);
    tern_ros::listen_to_detections({*this, *onboard_, *topics_, options_, subscriptions_}, [this] { return now_ns(); });
  }

  void advertise() {
    const rclcpp::QoS reliable(4);
    send_ = tern_ros::make_sender({*this, *onboard_, *topics_, options_, subscriptions_});
    if (!send_) {
      throw std::invalid_argument("parameter output = \"" + options_.output +
                                  "\" is refused: this node can send multidof, and mavros and px4 if it was built with "
                                  "mavros_msgs and px4_msgs");
    }
    markers_ = create_publisher<visualization_msgs::msg::MarkerArray>("tern/markers", reliable);
    map_ = create_publisher<sensor_msgs::msg::PointCloud2>("tern/obstacles", reliable);
    diagnostics_ = create_publisher<diagnostic_msgs::msg::DiagnosticArray>("/diagnostics", reliable);
    displays_ = create_wall_timer(std::chrono::duration<double>(1.0 / options_.display_rate), [this] { show(); });
  }

  template <typename Message>
  void stamp(Message& message, std::int64_t now) const {
    message.header.frame_id = options_.frame;
    tern_ros::set_stamp(message.header.stamp, now);
  }

  void show() {
    topics_->say();
    topics_->save();
    const std::int64_t now = now_ns();
    visualization_msgs::msg::MarkerArray markers;
    tern_ros::write_markers(*onboard_, now, markers);
    for (auto& marker : markers.markers) stamp(marker, now);
    markers_->publish(markers);
    diagnostic_msgs::msg::DiagnosticArray diagnostics;
    diagnostics.status.resize(1);
    tern_ros::write_diagnostics(*onboard_, now, diagnostics.status[0]);
    stamp(diagnostics, now);
    diagnostics_->publish(diagnostics);
    std::vector<tern::Vec3> obstacles;
    if (map_->get_subscription_count() == 0 || !onboard_->obstacles(obstacles)) return;
    sensor_msgs::msg::PointCloud2 cloud;
    tern_ros::write_cloud(obstacles, cloud);
    stamp(cloud, now);
    map_->publish(cloud);
  }

  tern_ros::Options options_;
  std::unique_ptr<tern_onboard::Onboard> onboard_;
  std::unique_ptr<tf2_ros::Buffer> buffer_;
  std::unique_ptr<tf2_ros::TransformListener> listener_;
  std::unique_ptr<tern_ros::FlightTopics> topics_;
  std::vector<rclcpp::SubscriptionBase::SharedPtr> subscriptions_;
  rclcpp_lifecycle::LifecyclePublisher<visualization_msgs::msg::MarkerArray>::SharedPtr markers_;
  rclcpp_lifecycle::LifecyclePublisher<sensor_msgs::msg::PointCloud2>::SharedPtr map_;
  rclcpp_lifecycle::LifecyclePublisher<diagnostic_msgs::msg::DiagnosticArray>::SharedPtr diagnostics_;
  rclcpp::TimerBase::SharedPtr displays_;
  tern_ros::Send send_;
  std::unique_ptr<tern_ros::TickLoop> loop_;
};

}  // namespace

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  const auto node = std::make_shared<Node>();
  if (node->parameter("autostart", true)) {
    node->configure();
    node->activate();
    using lifecycle_msgs::msg::State;
    if (node->get_current_state().id() != State::PRIMARY_STATE_ACTIVE) return EXIT_FAILURE;
  }
  rclcpp::spin(node->get_node_base_interface());
  rclcpp::shutdown();
  return EXIT_SUCCESS;
}
