// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a planning node does, without ROS: a map from clouds, a pose, and a plan for each goal.
#ifndef TERN_ROS_PLANNING_HPP
#define TERN_ROS_PLANNING_HPP

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "tern/tern.hpp"
#include "tern_ros/messages.hpp"

namespace tern_ros {

/// World frame, SI units.
struct Settings {
  std::string frame = "map";  ///< all messages must be in it
  /// Its lower face is the ground. The centre of the vehicle stays radius + tracking_margin above it.
  tern::Box world = {{-10.0, -10.0, 0.0}, {10.0, 10.0, 4.0}};
  double cell = 0.1;
  double radius = 0.3;           ///< of the body
  double tracking_margin = 0.1;  ///< how far the vehicle may be off the plan
  double speed = 2.0;
  double acceleration = 2.0;
  double yaw_rate = 1.0;
  double rate = 50.0;         ///< points of the trajectory message in a second
  double pose_timeout = 1.0;  ///< seconds: plans do not begin at a pose that is older
};

class Planning {
 public:
  explicit Planning(const Settings& settings) : settings_(settings), planner_(memory_.get(), sizeof *memory_) {
    const tern::Box& world = settings.world;
    tern::GridSpec spec{};
    spec.origin = world.lower;
    spec.cell = settings.cell;
    spec.dims = {cells(world.upper.x - world.lower.x), cells(world.upper.y - world.lower.y),
                 cells(world.upper.z - world.lower.z)};
    spec.boundary = room_of(settings);
    spec.radius = settings.radius;
    spec.tracking_margin = settings.tracking_margin;
    words_.resize(tern::grid_words(spec.dims));
    ready_ = tern::self_test(tern::kConfigurationHash, nullptr) == tern::Status::kOk &&
             grid_.bind(spec, words_.data(), words_.size()) == tern::Status::kOk;
    grid_.inflate();
  }

  /// False if the settings make no grid, or the machine's arithmetic is not sound.
  bool ready() const { return ready_; }
  const Settings& settings() const { return settings_; }

  /// Adds a cloud to the map. False if it is in another frame or malformed; `why` then says which, if it is not null.
  template <typename PointCloud2>
  bool add_cloud(const PointCloud2& cloud, std::string* why = nullptr) {
    std::string fault = frame_fault(cloud.header.frame_id);
    if (fault.empty() && !read_points(cloud, points_)) {
      fault = "it has no x, y and z of type FLOAT32, is big-endian, or its sizes do not agree";
    }
    if (fault.empty() && grid_.mark_points(points_.data(), points_.size()) != tern::Status::kOk) fault = "not ready";
    if (fault.empty()) grid_.inflate();
    if (why != nullptr) *why = fault;
    return fault.empty();
  }

  /// The vehicle's pose, at whose position plans begin at rest. `seconds` is when it came, by the clock of plan_to().
  /// "ok"; or why it is refused. No plan begins after a pose that was refused until the next good one.
  template <typename PoseStamped>
  std::string set_pose(const PoseStamped& pose, double seconds = 0.0) {
    position_ = {pose.pose.position.x, pose.pose.position.y, pose.pose.position.z};
    pose_time_ = seconds;
    pose_fault_ = frame_fault(pose.header.frame_id);
    const bool known = std::isfinite(position_.x) && std::isfinite(position_.y) && std::isfinite(position_.z);
    if (pose_fault_.empty() && !known) pose_fault_ = "it is not finite";
    return pose_fault_.empty() ? "ok" : pose_fault_;
  }

  /// Plans to a goal and fills the messages. `seconds` is the time now. The answer says why there is no plan, or "ok".
  template <typename PoseStamped, typename MultiDofTrajectory, typename Marker>
  std::string plan_to(const PoseStamped& goal, MultiDofTrajectory& trajectory, Marker& marker, double seconds = 0.0) {
    if (!ready_) return "not ready";
    const std::string fault = frame_fault(goal.header.frame_id);
    if (!fault.empty()) return "the goal is refused: " + fault;
    if (!pose_fault_.empty()) return "there is no pose to begin at: " + pose_fault_;
    if (seconds - pose_time_ > settings_.pose_timeout) {
      return "the last pose came " + metres(seconds - pose_time_) + " s ago";
    }
    const tern::Vec3 to{goal.pose.position.x, goal.pose.position.y, goal.pose.position.z};
    const std::string low = height_fault(to);
    if (!low.empty()) return low;
    const tern::Status status = plan(to);
    if (status != tern::Status::kOk) {
      return std::string(tern::status_name(status)) + ": " + tern::status_meaning(status) + hint(status);
    }
    write_trajectory(plan_, yaw_, settings_.rate, trajectory);
    write_marker(plan_, marker);
    return "ok";
  }

  const tern::Trajectory& plan() const { return plan_; }

 private:
  std::int32_t cells(double length) const { return static_cast<std::int32_t>(std::lround(length / settings_.cell)); }

  /// Where the vehicle's centre may be: the world, but for the layer above the ground in which the body would touch it.
  static tern::Box room_of(const Settings& settings) {
    tern::Box room = settings.world;
    room.lower.z += settings.radius + settings.tracking_margin;
    return room;
  }

  static std::string metres(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2f", value);
    return text;
  }

  /// Empty if a message's frame is the settings'.
  std::string frame_fault(const std::string& frame) const {
    if (frame == settings_.frame) return {};
    return "it is in frame \"" + frame + "\", not \"" + settings_.frame + "\"; transform it with tf2 first";
  }

  /// Tools that set goals on a floor plan leave z = 0, and a vehicle on the ground has not taken off.
  std::string height_fault(const tern::Vec3& goal) const {
    const double least = room_of(settings_).lower.z;
    const auto text = [least](const char* what, double height) {
      return std::string(what) + metres(height) + " m, and the body stays above the ground from " + metres(least) +
             " m on";
    };
    if (position_.z < least) return text("take off first: the vehicle is at a height of ", position_.z);
    if (goal.z < least) return text("the goal is at a height of ", goal.z);
    return {};
  }

  std::string hint(tern::Status status) const {
    if (status != tern::Status::kStartOccupied) return {};
    return ": a cloud has points within " + metres(settings_.radius + settings_.tracking_margin) +
           " m of the vehicle. If they are its own body, filter them out.";
  }

  tern::Status plan(const tern::Vec3& goal) {
    const double v = settings_.speed, a = settings_.acceleration;
    tern::Request request{};
    request.start.position = position_;
    request.goal.position = goal;
    request.limits = {{v, v, v}, {a, a, a}};
    tern::Report report;
    const tern::Status status = planner_.plan(grid_, request, plan_, report);
    if (status != tern::Status::kOk) return status;
    return yaw_planner_->plan(plan_, tern::yaw_request({1.0, 0.0}, settings_.yaw_rate, settings_.yaw_rate), yaw_);
  }

  Settings settings_;
  std::unique_ptr<tern::Workspace> memory_{new tern::Workspace};  // not initialised: it is large
  std::vector<std::uint64_t> words_;
  std::vector<tern::Vec3> points_;
  std::unique_ptr<tern::YawPlanner> yaw_planner_ = std::make_unique<tern::YawPlanner>();
  tern::Grid grid_;
  tern::Planner planner_;
  tern::Trajectory plan_{};
  tern::YawPlan yaw_{};
  tern::Vec3 position_{};
  double pose_time_ = 0.0;
  std::string pose_fault_ = "none came yet";  ///< empty if the last pose was good
  bool ready_ = false;
};

}  // namespace tern_ros

#endif
