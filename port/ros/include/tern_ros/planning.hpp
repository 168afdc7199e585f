// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a planning node does, without ROS: a map from clouds, a pose, and a plan for each goal.
#ifndef TERN_ROS_PLANNING_HPP
#define TERN_ROS_PLANNING_HPP

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "tern/tern.hpp"
#include "tern_ros/messages.hpp"

namespace tern_ros {

/// World frame, SI units.
struct Settings {
  std::string frame = "map";  ///< all messages must be in it
  tern::Box world = {{-10.0, -10.0, 0.0}, {10.0, 10.0, 4.0}};
  double cell = 0.1;
  double radius = 0.3;           ///< of the body
  double tracking_margin = 0.1;  ///< how far the vehicle may be off the plan
  double speed = 2.0;
  double acceleration = 2.0;
  double yaw_rate = 1.0;
  double rate = 50.0;  ///< points of the trajectory message in a second
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
    spec.boundary = world;
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

  /// Adds a cloud to the map. False if it is in another frame or malformed.
  template <typename PointCloud2>
  bool add_cloud(const PointCloud2& cloud) {
    if (cloud.header.frame_id != settings_.frame || !read_points(cloud, points_)) return false;
    const bool marked = grid_.mark_points(points_.data(), points_.size()) == tern::Status::kOk;
    grid_.inflate();
    return marked;
  }

  /// The vehicle's position, from which plans begin at rest.
  template <typename PoseStamped>
  void set_pose(const PoseStamped& pose) {
    position_ = {pose.pose.position.x, pose.pose.position.y, pose.pose.position.z};
    has_position_ = true;
  }

  /// Plans to a goal and fills the messages. The answer says why there is none, or "ok".
  template <typename PoseStamped, typename MultiDofTrajectory, typename Marker>
  std::string plan_to(const PoseStamped& goal, MultiDofTrajectory& trajectory, Marker& marker) {
    if (!ready_) return "not ready";
    if (!has_position_) return "no pose yet";
    if (goal.header.frame_id != settings_.frame) return "goal in frame " + goal.header.frame_id;
    const tern::Vec3 to{goal.pose.position.x, goal.pose.position.y, goal.pose.position.z};
    const tern::Status status = plan(to);
    if (status != tern::Status::kOk)
      return std::string(tern::status_name(status)) + ": " + tern::status_meaning(status);
    write_trajectory(plan_, yaw_, settings_.rate, trajectory);
    write_marker(plan_, marker);
    return "ok";
  }

  const tern::Trajectory& plan() const { return plan_; }

 private:
  std::int32_t cells(double length) const { return static_cast<std::int32_t>(std::lround(length / settings_.cell)); }

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
  bool has_position_ = false;
  bool ready_ = false;
};

}  // namespace tern_ros

#endif
