// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The flight node for ROS 1: poses, frames of sensors, goals and missions in, setpoints, markers, the map and
// diagnostics out.
#include <diagnostic_msgs/DiagnosticArray.h>
#include <geometry_msgs/PoseStamped.h>
#include <nav_msgs/Odometry.h>
#include <nav_msgs/Path.h>
#include <ros/ros.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>
#include <std_msgs/Empty.h>
#include <tf2_ros/transform_listener.h>
#include <trajectory_msgs/MultiDOFJointTrajectory.h>
#include <visualization_msgs/MarkerArray.h>
#if __has_include(<mavros_msgs/PositionTarget.h>)
#include <mavros_msgs/PositionTarget.h>
#include <mavros_msgs/State.h>
#define TERN_ROS_HAS_MAVROS
#endif
#if __has_include(<vision_msgs/Detection3DArray.h>)
#include <vision_msgs/Detection3DArray.h>
#define TERN_ROS_HAS_VISION
#endif

#include <cstdlib>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "tern_ros/displays.hpp"
#include "tern_ros/flight_topics.hpp"
#include "tern_ros/parameters.hpp"
#include "tern_ros/tick_loop.hpp"
#include "tern_ros/tracking.hpp"

namespace {

using trajectory_msgs::MultiDOFJointTrajectory;

std::int64_t now_ns() {
  return static_cast<std::int64_t>(ros::Time::now().toNSec());
}

ros::Time time_of(std::int64_t ns) {
  ros::Time time;
  time.fromNSec(static_cast<std::uint64_t>(ns < 0 ? 0 : ns));
  return time;
}

/// A parameter, or the default if there is none.
auto parameters_of(const ros::NodeHandle& own) {
  return [&own](const std::string& name, auto value) {
    if (own.hasParam(name) && !own.getParam(name, value)) {
      using Value = decltype(value);
      const char* const kind = std::is_same_v<Value, double> ? "number" : std::is_same_v<Value, bool> ? "bool" : "text";
      throw std::invalid_argument("parameter " + name + " is refused: it is no " + kind);
    }
    return value;
  };
}

class Node {
 public:
  Node()
      : options_(tern_ros::read_options(parameters_of(own_))),
        settings_(tern_ros::read_settings(parameters_of(own_))),
        onboard_(settings_, tern_ros::detector_of(settings_, options_)),
        listener_(buffer_),
        topics_(
            onboard_, options_, [this](auto&&... args) { return find(args...); },
            [](bool bad, const std::string& text) {
              if (bad) {
                ROS_WARN_STREAM(text);
              } else {
                ROS_INFO_STREAM(text);
              }
            }) {
    listen();
    advertise();
    loop_ = std::make_unique<tern_ros::TickLoop>(
        onboard_, options_.setpoint_rate,
        tern_ros::Loop{now_ns, [](std::int64_t t) { ros::Time::sleepUntil(time_of(t)); }, [] { return ros::ok(); },
                       [this](std::int64_t now, const tern_onboard::Setpoint& setpoint) { send_(now, setpoint); }});
  }

 private:
  bool find(const std::string& parent, const std::string& child, tern::Pose& pose, std::string& why) const {
    try {
      pose = tern_ros::pose_of_transform(buffer_.lookupTransform(parent, child, ros::Time(0)).transform);
      return true;
    } catch (const tf2::TransformException& exception) {
      why = exception.what();
      return false;
    }
  }

  /// Calls `handle` with each message of a topic. Small messages are not held back to be sent together.
  template <typename Message, typename Handle>
  void on(const std::string& topic, std::uint32_t queue, Handle handle) {
    subscribers_.push_back(node_.subscribe<Message>(
        topic, queue, boost::function<void(const typename Message::ConstPtr&)>([handle](const auto& m) { handle(*m); }),
        ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay()));
  }

  void listen() {
    int sensor = 0;
    for (const std::string& name : tern_ros::words_of(options_.cameras)) {
      topics_.add_sensor(name, tern_onboard::SensorKind::kDepth,
                         tern_ros::read_sensor_settings(name + "/", parameters_of(own_)));
      on<sensor_msgs::CameraInfo>(name + "/camera_info", 2,
                                  [this, sensor](const auto& m) { topics_.on_lens(sensor, m); });
      on<sensor_msgs::Image>(name + "/image", 2,
                             [this, sensor](const auto& m) { topics_.on_image(sensor, m, now_ns()); });
      ++sensor;
    }
    for (const std::string& name : tern_ros::words_of(options_.lidars)) {
      topics_.add_sensor(name, tern_onboard::SensorKind::kPoints,
                         tern_ros::read_sensor_settings(name + "/", parameters_of(own_)));
      on<sensor_msgs::PointCloud2>(name + "/points", 2,
                                   [this, sensor](const auto& m) { topics_.on_scan(sensor, m, now_ns()); });
      ++sensor;
    }
    on<nav_msgs::Odometry>("odometry", 20, [this](const auto& m) { topics_.on_odometry(m, now_ns()); });
    on<geometry_msgs::PoseStamped>("pose", 20, [this](const auto& m) { topics_.on_pose(m, now_ns()); });
    on<sensor_msgs::PointCloud2>("known", 4, [this](const auto& m) { topics_.on_known(m); });
    on<geometry_msgs::PoseStamped>("goal", 1, [this](const auto& m) { topics_.on_goal(m, now_ns()); });
    on<nav_msgs::Path>("mission", 1, [this](const auto& m) { topics_.on_mission(m, now_ns()); });
    on<std_msgs::Empty>("stop", 1, [this](const auto&) { topics_.on_stop(); });
    tern_ros::use_tracker(topics_, options_);
    listen_to_detections();
  }

  void listen_to_detections() {
    const std::string& kind = options_.detections.kind;
    if (kind.empty()) return;
#ifdef TERN_ROS_HAS_VISION
    if (kind == "vision") {
      return on<vision_msgs::Detection3DArray>("detections", 4,
                                               [this](const auto& m) { topics_.on_detections(m, now_ns()); });
    }
#endif
    throw std::invalid_argument("parameter detections = \"" + kind +
                                "\" is refused: this node can read vision if it was built with vision_msgs");
  }

  void advertise() {
    send_ = sender();
    if (!send_) {
      throw std::invalid_argument("parameter output = \"" + options_.output +
                                  "\" is refused: this node can send multidof, and mavros if it was built with "
                                  "mavros_msgs");
    }
    markers_ = node_.advertise<visualization_msgs::MarkerArray>("tern/markers", 1);
    map_ = node_.advertise<sensor_msgs::PointCloud2>("tern/obstacles", 1);
    diagnostics_ = node_.advertise<diagnostic_msgs::DiagnosticArray>("diagnostics", 4);
    displays_ = node_.createTimer(ros::Duration(1.0 / options_.display_rate), [this](const auto&) { show(); });
  }

  template <typename Message>
  void publish(const ros::Publisher& publisher, std::int64_t now, Message& message) const {
    message.header.frame_id = options_.frame;
    message.header.stamp = time_of(now);
    publisher.publish(message);
  }

  using Send = std::function<void(std::int64_t now, const tern_onboard::Setpoint&)>;

  /// What sends setpoints in the form of the parameter `output`; nothing if the node cannot.
  Send sender() {
    if (options_.output == "mavros") return mavros_sender();
    if (options_.output != "multidof") return {};
    return [this, publisher = node_.advertise<MultiDOFJointTrajectory>("command/trajectory", 4)](
               std::int64_t now, const tern_onboard::Setpoint& setpoint) {
      if (!setpoint.valid) return;
      MultiDOFJointTrajectory message;
      tern_ros::write_setpoint(setpoint, message);
      publish(publisher, now, message);
    };
  }

  Send mavros_sender() {
#ifdef TERN_ROS_HAS_MAVROS
    onboard_.set_following(false);  // until the autopilot says so
    on<mavros_msgs::State>("mavros/state", 4,
                           [this](const auto& m) { onboard_.set_following(tern_ros::follows_setpoints(m)); });
    return [this, publisher = node_.advertise<mavros_msgs::PositionTarget>("mavros/setpoint_raw/local", 4)](
               std::int64_t now, const tern_onboard::Setpoint& setpoint) {
      if (!setpoint.valid) return;
      mavros_msgs::PositionTarget message;
      tern_ros::write_position_target(setpoint, message);
      publish(publisher, now, message);
    };
#else
    return {};
#endif
  }

  void show() {
    topics_.say();
    topics_.save();
    const std::int64_t now = now_ns();
    visualization_msgs::MarkerArray markers;
    tern_ros::write_markers(onboard_, now, markers);
    for (auto& marker : markers.markers) {
      marker.header.frame_id = options_.frame;
      marker.header.stamp = time_of(now);
    }
    markers_.publish(markers);
    diagnostic_msgs::DiagnosticArray diagnostics;
    diagnostics.status.resize(1);
    tern_ros::write_diagnostics(onboard_, now, diagnostics.status[0]);
    publish(diagnostics_, now, diagnostics);
    std::vector<tern::Vec3> obstacles;
    if (map_.getNumSubscribers() == 0 || !onboard_.obstacles(obstacles)) return;
    sensor_msgs::PointCloud2 cloud;
    tern_ros::write_cloud(obstacles, cloud);
    publish(map_, now, cloud);
  }

  ros::NodeHandle node_, own_{"~"};
  tern_ros::Options options_;
  tern_onboard::Settings settings_;
  tern_onboard::Onboard onboard_;
  tf2_ros::Buffer buffer_;
  tf2_ros::TransformListener listener_;
  tern_ros::FlightTopics topics_;
  std::vector<ros::Subscriber> subscribers_;
  ros::Publisher markers_, map_, diagnostics_;
  Send send_;
  ros::Timer displays_;
  std::unique_ptr<tern_ros::TickLoop> loop_;  // the last member: its thread ends first
};

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "tern");
  const ros::NodeHandle log;  // without any handle, ROS ends, and nothing is logged
  try {
    Node node;
    ros::spin();
  } catch (const std::invalid_argument& fault) {
    ROS_FATAL_STREAM(fault.what());
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
