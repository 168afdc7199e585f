// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros1/flown_world.hpp"

#include <geometry_msgs/PoseStamped.h>
#include <mavros_msgs/State.h>
#include <ros/callback_queue.h>
#include <rosgraph_msgs/Clock.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "host/flight/assumed_ball.hpp"
#include "host/flight/flight_recorder.hpp"
#include "tern_ros/inputs.hpp"

namespace tern_test {
namespace {

constexpr double kStuck = 40.0;   // seconds at rest
constexpr double kMargin = 0.01;  // m that the margin is above the vehicle's error: for extrapolation between setpoints

/// A window around the start that the world's height fits in.
tern::Vec3 window_of(const tern_host::FlightWorld& world) {
  const tern::Box& b = world.boundary;
  const double half = std::max(world.start.z - b.lower.z, b.upper.z - world.start.z) + 2.0 * world.settings.cell;
  return {world.settings.window.x, world.settings.window.y, 2.0 * half};
}

/// As far around the start as space is truly free, on the node's voxels.
double free_radius_of(const tern_host::FlightWorld& world) {
  const tern_host::FlightSettings& s = world.settings;
  const tern::Vec3 window = window_of(world);
  tern::GridSpec grid{};
  grid.cell = s.cell;
  grid.origin = {world.start.x - 0.5 * window.x, world.start.y - 0.5 * window.y, world.start.z - 0.5 * window.z};
  grid.radius = s.body_radius + s.pose_margin;
  grid.tracking_margin = kMargin + s.tracking_margin;
  return tern_host::assumed_radius(world, grid, grid.radius + grid.tracking_margin + 6.0 * s.cell);
}

}  // namespace

FlownWorld::FlownWorld(const std::string& member, const FlownSettings& settings)
    : world_(tern_host::read_flight_world(member, {})),
      settings_(settings),
      noise_(world_.settings.seed),
      sensors_(world_, settings.sensors, settings.spoilt, noise_, outlet_, node_),
      displays_(world_, node_) {
  setpoint_.sample.position = world_.start;
  setpoint_.yaw = std::atan2(world_.goal.y - world_.start.y, world_.goal.x - world_.start.x);
  vehicle_ = tern_host::make_vehicle(tern_host::vehicle_settings_of(world_.settings), setpoint_);
  clock_ = node_.advertise<rosgraph_msgs::Clock>("/clock", 100);
  odometry_ = node_.advertise<nav_msgs::Odometry>("odometry", 100);
  goal_ = node_.advertise<geometry_msgs::PoseStamped>("goal", 1);
  tf_ = node_.advertise<tf2_msgs::TFMessage>("/tf_static", 1, true);
  mode_ = node_.advertise<mavros_msgs::State>("mavros/state", 10);
  const auto quick = ros::TransportHints().tcpNoDelay();
  setpoints_ = settings.mavros ? node_.subscribe("mavros/setpoint_raw/local", 100, &FlownWorld::on_target, this, quick)
                               : node_.subscribe("command/trajectory", 100, &FlownWorld::on_setpoint, this, quick);
}

void FlownWorld::set_parameters() const {
  const tern_host::FlightSettings& s = world_.settings;
  const tern::Vec3 window = window_of(world_);
  const std::map<std::string, double> parameters = {{"cell", s.cell},
                                                    {"window_x", window.x},
                                                    {"window_y", window.y},
                                                    {"window_z", window.z},
                                                    {"radius", s.body_radius + s.pose_margin},
                                                    {"tracking_margin", kMargin + s.tracking_margin},
                                                    {"pose_margin", 0.0},
                                                    {"angle_margin", 0.0},
                                                    {"range", s.sensor_range},
                                                    {"depth_margin", s.depth_margin + s.depth_noise * s.sensor_range},
                                                    {"free_radius", free_radius_of(world_)},
                                                    {"speed", s.v_max},
                                                    {"climb", s.v_max},
                                                    {"sink", s.v_max},
                                                    {"acceleration", s.a_max},
                                                    {"acceleration_z", s.a_max},
                                                    {"jerk", s.j_max},
                                                    {"horizon", 0.8 * s.sensor_range},
                                                    {"yaw_rate", s.yaw_rate},
                                                    {"yaw_acceleration", s.yaw_acceleration},
                                                    {"setpoint_rate", 100.0},
                                                    {"display_rate", 20.0},
                                                    {"heading_jump", 1.0},
                                                    {"slow_when_straying", 0.0},  // it uses the margin up
                                                    {"stray", 5.0}};
  for (const auto& [name, value] : parameters) ros::param::set("/tern/" + name, value);
  sensors_.set_parameters();
  ros::param::set("/tern/output", settings_.mavros ? "mavros" : "multidof");
  ros::param::set("/use_sim_time", !settings_.real_time);
}

bool FlownWorld::connect() {
  for (int k = 0; k < 2000; ++k) {
    const bool clock = settings_.real_time || clock_.getNumSubscribers() > 0;
    if (clock && sensors_.connected() && odometry_.getNumSubscribers() > 0 && goal_.getNumSubscribers() > 0 &&
        tf_.getNumSubscribers() > 0 && setpoints_.getNumPublishers() > 0 && displays_.connected()) {
      return true;
    }
    ros::spinOnce();
    ros::WallDuration(0.01).sleep();
  }
  return false;
}

Flown FlownWorld::fly() {
  int before_goal = 50;  // ticks: so that pose and frames are there
  // Where messages are spoilt, tf is late, too: frames must wait for it.
  int before_tf = settings_.spoilt.share > 0.0 ? 100 : 0;
  if (settings_.real_time) now_ = begin_ = static_cast<std::int64_t>(ros::Time::now().toNSec());
  publish_clock();
  ros::WallDuration(0.1).sleep();  // the clock's topic is not the others'
  while (flown_.end == "timeout" && seconds() < world_.settings.time_limit && flown_.late < 100) {
    if (before_tf-- == 0) outlet_.publish(tf_, sensors_.mountings(), now_);
    step();
    if (before_goal-- == 0) publish_goal();
    const std::string end = judge();
    if (!end.empty()) flown_.end = end;
  }
  if (flown_.late >= 100) flown_.end = "silent";
  flown_.time = seconds();
  for (int k = 0; k < 200 && outlet_.records(); ++k) step();  // a node that is played the bag may be later
  return flown_;
}

/// To the next tick.
void FlownWorld::step() {
  publish_pose();
  publish_mode();
  sensors_.step(vehicle_->position(), yaw(), seconds(), now_);
  publish_clock();
  if (settings_.real_time ? !wait_for_clock() : !wait_for_setpoint()) ++flown_.late;
  move();
}

double FlownWorld::yaw() const {
  return setpoint_at(seconds()).yaw;
}

void FlownWorld::publish_clock() {
  rosgraph_msgs::Clock clock;
  clock.clock = time_of(now_);
  if (!settings_.real_time) outlet_.publish(clock_, clock, now_);
}

void FlownWorld::publish_pose() {
  const Spoilt& spoilt = settings_.spoilt;
  if (spoilt.jump > 0.0 && seconds() > 3.0) jumped_.y = spoilt.jump;
  if (noise_.chance(spoilt.share)) return;
  nav_msgs::Odometry odometry;
  odometry.header.frame_id = "map";
  odometry.child_frame_id = "base_link";
  odometry.header.stamp = time_of(now_);
  const tern::Vec3 p = vehicle_->estimate();
  odometry.pose.pose.position.x = p.x + jumped_.x;
  odometry.pose.pose.position.y = p.y + jumped_.y;
  odometry.pose.pose.position.z = p.z + jumped_.z;
  odometry.pose.pose.orientation.w = std::cos(0.5 * yaw());
  odometry.pose.pose.orientation.z = std::sin(0.5 * yaw());
  outlet_.publish(odometry_, odometry, now_);
  if (noise_.chance(spoilt.share)) outlet_.publish(odometry_, odometry, now_);
  if (noise_.chance(spoilt.share)) outlet_.publish(odometry_, earlier_, now_);
  earlier_ = odometry;
}

/// The pilot switches the mode shortly before there is a goal.
void FlownWorld::publish_mode() {
  if (!settings_.mavros) return;
  mavros_msgs::State state;
  state.header.stamp = time_of(now_);
  state.armed = 1;
  state.mode = seconds() < 0.4 ? "POSCTL" : "OFFBOARD";
  mode_.publish(state);
}

void FlownWorld::publish_goal() {
  geometry_msgs::PoseStamped goal;
  goal.header.frame_id = "map";
  goal.pose.position.x = world_.goal.x;
  goal.pose.position.y = world_.goal.y;
  goal.pose.position.z = world_.goal.z;
  goal.pose.orientation.w = 1.0;
  outlet_.publish(goal_, goal, now_);
}

void FlownWorld::on_setpoint(const trajectory_msgs::MultiDOFJointTrajectory& message) {
  using tern_ros::vector_of;
  outlet_.note(setpoints_.getTopic(), message, now_);
  const auto& point = message.points.at(0);
  const auto& q = point.transforms.at(0).rotation;
  const auto &velocity = point.velocities.at(0), &acceleration = point.accelerations.at(0);
  tern_host::Setpoint setpoint{};
  setpoint.sample = {
      vector_of(point.transforms[0].translation), vector_of(velocity.linear), vector_of(acceleration.linear), {}, {}};
  setpoint.yaw = 2.0 * std::atan2(q.z, q.w);
  setpoint.yaw_rate = velocity.angular.z;
  take_setpoint(setpoint, message.header.stamp);
}

void FlownWorld::on_target(const mavros_msgs::PositionTarget& message) {
  using tern_ros::vector_of;
  if (message.type_mask != 0 || message.coordinate_frame != mavros_msgs::PositionTarget::FRAME_LOCAL_NED) return;
  tern_host::Setpoint setpoint{};
  setpoint.sample = {
      vector_of(message.position), vector_of(message.velocity), vector_of(message.acceleration_or_force), {}, {}};
  setpoint.yaw = static_cast<double>(message.yaw);
  setpoint.yaw_rate = static_cast<double>(message.yaw_rate);
  take_setpoint(setpoint, message.header.stamp);
}

void FlownWorld::take_setpoint(const tern_host::Setpoint& setpoint, const ros::Time& stamp) {
  setpoint_stamp_ = static_cast<std::int64_t>(stamp.toNSec());
  // Before the flight somebody else holds the vehicle, and setpoints are where it is.
  const std::string& told = displays_.told();
  if (told.empty() || told == "no pose" || told == "ready") return;
  setpoint_time_ = 1e-9 * static_cast<double>(setpoint_stamp_ - begin_);
  // After a jump of the estimate, setpoints are in its old frame until the node knows. A vehicle with inertia hardly
  // moves in that time.
  const tern::Vec3 p = setpoint.sample.position, before = setpoint_.sample.position;
  const auto step = [&](const tern::Vec3& jump) {
    return std::hypot(p.x - jump.x - before.x, std::hypot(p.y - jump.y - before.y, p.z - jump.z - before.z));
  };
  if (step(jumped_) < step(known_jump_)) known_jump_ = jumped_;
  const double yaw = setpoint_.yaw + std::remainder(setpoint.yaw - setpoint_.yaw, 2.0 * std::acos(-1.0));
  setpoint_ = setpoint;
  setpoint_.sample.position = {p.x - known_jump_.x, p.y - known_jump_.y, p.z - known_jump_.z};
  setpoint_.yaw = yaw;
}

/// The setpoint for now: the clock stands still until it is there.
bool FlownWorld::wait_for_setpoint() {
  for (int k = 0; k < 1000; ++k) {
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(2e-4));
    if (setpoint_stamp_ >= now_) return true;
  }
  return false;
}

/// The end of this tick, by the computer's clock. False if the last setpoint is older than 50 ms by then.
bool FlownWorld::wait_for_clock() {
  const ros::Time end = time_of(now_ + kTick);
  for (ros::Time at = ros::Time::now(); at < end; at = ros::Time::now()) {
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(std::min(2e-3, (end - at).toSec())));
  }
  return now_ - setpoint_stamp_ < 5 * kTick;
}

/// Between setpoints, as an autopilot extrapolates them.
tern_host::Setpoint FlownWorld::setpoint_at(double t) const {
  const double dt = std::clamp(t - setpoint_time_, -0.05, 0.2);
  const auto& s = setpoint_.sample;
  const auto at = [dt](double p, double v, double a) { return p + dt * (v + 0.5 * dt * a); };
  tern_host::Setpoint setpoint = setpoint_;
  setpoint.sample.position = {at(s.position.x, s.velocity.x, s.acceleration.x),
                              at(s.position.y, s.velocity.y, s.acceleration.y),
                              at(s.position.z, s.velocity.z, s.acceleration.z)};
  setpoint.sample.velocity = {s.velocity.x + dt * s.acceleration.x, s.velocity.y + dt * s.acceleration.y,
                              s.velocity.z + dt * s.acceleration.z};
  setpoint.yaw += dt * setpoint_.yaw_rate;
  return setpoint;
}

void FlownWorld::move() {
  constexpr int kParts = 5;
  for (int k = 1; k <= kParts; ++k) {
    const double t = 1e-9 * static_cast<double>(now_ - begin_ + k * kTick / kParts);
    vehicle_->fly_to(t, [this](double at) { return setpoint_at(at); });
    flown_.clearance = std::min(flown_.clearance, tern_host::clearance(world_, vehicle_->position()));
  }
  now_ += kTick;
  const tern::Vec3 p = vehicle_->position(), s = setpoint_at(seconds()).sample.position;
  flown_.off = std::max(flown_.off, std::hypot(p.x - s.x, std::hypot(p.y - s.y, p.z - s.z)));
}

std::string FlownWorld::judge() {
  if (flown_.clearance < world_.settings.body_radius) return "contact";
  const tern::Vec3 &s = setpoint_.sample.position, &v = setpoint_.sample.velocity, &goal = world_.goal;
  rested_ = std::hypot(v.x, std::hypot(v.y, v.z)) < 1e-3 ? rested_ + 1e-9 * kTick : 0.0;
  const double away =
      std::hypot(s.x + jumped_.x - goal.x, std::hypot(s.y + jumped_.y - goal.y, s.z + jumped_.z - goal.z));
  if (away < 0.02 && rested_ > 0.2) return "reached";
  return rested_ > kStuck ? "stuck" : "";
}

}  // namespace tern_test
