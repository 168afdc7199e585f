// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/simulated_flight.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <vector>

#include "flight/flight_state.hpp"
#include "host/flight/assumed_ball.hpp"
#include "host/flight/commit_log.hpp"
#include "host/flight/flight_recorder.hpp"
#include "host/flight/flight_tape.hpp"
#include "host/flight/flight_watch.hpp"
#include "host/flight/full_knowledge.hpp"
#include "host/flight/mission_watch.hpp"
#include "host/flight/sensor.hpp"
#include "host/number.hpp"
#include "host/vehicle/vehicle.hpp"
#include "tern/flight.hpp"

namespace tern_host {
namespace {

constexpr double kAssumedVoxels = 6.0;                 ///< that the operator knows beyond the radius, if they are free
constexpr double kHorizon = 0.8;                       ///< of plans, in sensor ranges
constexpr double kYawSlack = 1e-9;                     ///< rad, rad/s and rad/s^2: rounding
constexpr double kLeastLook = 0.4;                     ///< metres: nearer points say nothing about where to look
constexpr double kScanPixels = 6.0 * 2.5 * 2.5 + 0.1;  ///< of a map with a scan_pixel of 1 rad
constexpr double kTurn = 6.28318530717958648;

int voxels(double metres, double cell) {
  return std::min(tern::kMaxDimension, static_cast<int>(std::ceil(metres / cell)));
}

/// The window around the start; from below the floor to above the ceiling, where that is within its height.
tern::MapSpec map_spec_of(const FlightWorld& world) {
  const FlightSettings& s = world.settings;
  const tern::Box& b = world.boundary;
  const double height = std::min(s.window.z, b.upper.z - b.lower.z + 4.0 * s.cell);
  const tern::Voxel dims{voxels(s.window.x, s.cell), voxels(s.window.y, s.cell), voxels(height, s.cell)};
  const double bottom = height < s.window.z ? b.lower.z - 2.0 * s.cell : world.start.z - 0.5 * height;
  const tern::Vec3 origin{world.start.x - 0.5 * s.window.x, world.start.y - 0.5 * s.window.y, bottom};
  tern::MapSpec spec = tern::map_spec(origin, s.cell, dims, radius_of(s));
  spec.range = s.sensor_range;
  spec.depth_margin = s.depth_margin + s.depth_noise * s.sensor_range;
  spec.pose_margin = s.pose_margin;
  spec.hits = s.hits;
  spec.support = s.support;
  spec.slack = 8;
  spec.pixels = s.width * s.height;
  if (s.sensor == "lidar") {
    spec.scan_pixel = s.scan_pixel;
    spec.pixels = static_cast<int>(std::ceil(kScanPixels / (s.scan_pixel * s.scan_pixel)));
  }
  return spec;
}

tern::FlightSpec flight_spec_of(const FlightSettings& s) {
  tern::FlightSpec spec = tern::flight_spec(limits_of(s));
  spec.tick = std::llround(1e9 / s.tick_hz);
  spec.work_per_tick = static_cast<std::uint32_t>(s.work_per_tick);
  spec.plan_work = 4 * spec.work_per_tick;
  spec.horizon = kHorizon * s.sensor_range;
  spec.yaw_rate = s.yaw_rate;
  return spec;
}

constexpr double kDegree = kTurn / 360.0;

/// How the flight plans its yaw, from the heading at the start on.
tern::FlightYaw flight_yaw_of(const FlightSettings& s, double start) {
  tern::FlightYaw yaw{};
  yaw.mode = tern::FlightYawMode::kTowardsUnseen;
  if (s.yaw == "motion") yaw.mode = tern::FlightYawMode::kAlongMotion;
  if (s.yaw == "point") yaw.mode = tern::FlightYawMode::kTowardsPoint;
  if (s.yaw == "heading") yaw.mode = tern::FlightYawMode::kFixed;
  yaw.acceleration_max = s.yaw_acceleration;
  yaw.view = kDegree * s.fov_horizontal;
  yaw.start = {std::cos(start), std::sin(start)};
  yaw.heading = {std::cos(kDegree * s.yaw_heading), std::sin(kDegree * s.yaw_heading)};
  yaw.point = s.yaw_point;
  return yaw;
}

class Simulation {
 public:
  Simulation(const FlightWorld& world, const FlightOnlooker& onlooker, std::string* record)
      : world_(world),
        onlooker_(onlooker),
        noise_(world.settings.seed),
        memory_(new tern::Workspace),
        planner_(memory_.get(), sizeof *memory_),
        map_spec_(map_spec_of(world)),
        fences_(fences_of(world.fences)),
        spec_(flight_spec_of(world.settings)),
        recorder_(world),
        tape_(record, frame_bytes(world.settings)),
        sensor_(world, map_spec_, map_, noise_, tape_) {
    start();
  }

  FlightResult fly() {
    const std::int64_t end = std::llround(1e9 * world_.settings.time_limit);
    std::string status = "timeout";
    while (time_ <= end && !tick(status)) move_on();
    tape_.finish();
    if (status == "timeout") reason_ = "still on its way at time_limit, " + brief(world_.settings.time_limit) + " s";
    if (status == "stuck") reason_ += last_plan();
    FlightResult result = recorder_.finish();
    result.status = status;
    result.reason = reason_;
    result.view_wait = static_cast<double>(view_waits_) / world_.settings.tick_hz;
    const WatchCounts& counts = watch_->counts();
    result.mission = mission_->points();
    result.commits = commits_.take();
    result.watched = {counts.ticks, counts.commits, counts.points, sensor_.watch().seen(), sensor_.watch().hits()};
    return result;
  }

 private:
  /// Why the last plan led nowhere, if there was none.
  std::string last_plan() const {
    if (report_.plan == tern::Status::kOk || report_.plan == tern::Status::kRunning) return "";
    return std::string("; the last plan: ") + tern::status_name(report_.plan);
  }

  void start() {
    spec_.fences = fences_.data();
    spec_.fence_count = static_cast<std::int32_t>(fences_.size());
    map_words_.resize(tern::map_words(map_spec_));
    words_.resize(tern::flight_words(map_spec_.dims));
    const tern::Status bound = map_.bind(map_spec_, map_words_.data(), map_words_.size());
    if (bound != tern::Status::kOk) {
      throw std::runtime_error(world_.name + ": no map can be made of this window and cell");
    }
    tern::FlightRecorder& record = tape_.recorder();
    record.bind(map_spec_, bound);
    const double most = radius_of(world_.settings) + kAssumedVoxels * map_spec_.cell;
    const double free = assumed_radius(world_, map_.safe().spec(), most);
    record.assume_free(world_.start, free, map_.assume_free(world_.start, free));
    const tern::Status begun = flight_.start(spec_, map_, planner_, words_.data(), words_.size(), world_.start, 0);
    record.start(spec_, world_.start, 0, begun);
    if (begun != tern::Status::kOk) {
      throw std::runtime_error(world_.name + ": the flight cannot begin: " + tern::status_name(begun));
    }
    set_wishes();
    vehicle_ = make_vehicle(vehicle_settings_of(world_.settings), setpoint(0.0));
    watch_ = std::make_unique<FlightWatch>(world_, spec_, map_, flight_);
    mission_ = std::make_unique<MissionWatch>(world_, flight_);
  }

  /// The mission, and how to turn on it.
  void set_wishes() {
    const std::vector<tern::Via> mission = mission_of(world_);
    const auto count = static_cast<std::int32_t>(mission.size());
    const tern::Status set = flight_.set_mission(mission.data(), count, world_.via_policy);
    tape_.recorder().set_mission(mission.data(), count, world_.via_policy, set);
    if (set != tern::Status::kOk) {
      throw std::runtime_error(world_.name + ": the mission is refused: " + tern::status_name(set));
    }
    const tern::Vec3& first = mission.front().position;
    yaw_ = std::atan2(first.y - world_.start.y, first.x - world_.start.x);
    plans_yaw_ = world_.settings.yaw != "gimbal";
    if (!plans_yaw_) return;
    const tern::FlightYaw yaw = flight_yaw_of(world_.settings, yaw_);
    const tern::Status turned = flight_.set_yaw(yaw);
    tape_.recorder().set_yaw(yaw, turned);
    if (turned != tern::Status::kOk) throw std::runtime_error(world_.name + ": the yaw is refused");
  }

  double seconds() const { return 1e-9 * static_cast<double>(time_); }

  Setpoint setpoint(double t) const {
    const std::int64_t at = std::llround(1e9 * t);
    const tern::Sample sample = flight_.command(at).sample;
    if (!plans_yaw_) return {sample, yaw_ + yaw_rate_ * (t - seconds()), yaw_rate_};
    const auto nose = flight_.yaw(at);
    return {sample, nose.angle, nose.yaw.rate};
  }

  /// True where the flight is over.
  bool tick(std::string& status) {
    sensor_.sense(time_, *vehicle_, yaw_);
    const tern::Status ticked = flight_.tick(time_, report_);
    tape_.recorder().tick(flight_, time_, report_, ticked);
    tape_.save();
    const tern::Command command = flight_.command(time_);
    recorder_.note(time_, command, *vehicle_, yaw_, report_);
    watch_->look(time_, report_);
    mission_->look(time_, report_);
    commits_.look(time_, report_, state());
    if (onlooker_) tell(command);
    if (!plans_yaw_) turn(command);
    watch_yaw();
    if (report_.waits_for_view) ++view_waits_;
    reason_ = tern::flight_reason_text(report_.reason);
    if (recorder_.clearance_now() < world_.settings.body_radius) {
      status = "collision";
      reason_ = "the body touched something";
      return true;
    }
    reason_ = watch_->broken() + sensor_.watch().broken() + mission_->broken() + yaw_broken_;
    if (!reason_.empty()) {
      status = "invariant";
      return true;
    }
    reason_ = tern::flight_reason_text(report_.reason);
    if (report_.mode != tern::FlightMode::kRest || report_.reason == tern::FlightReason::kNone) return false;
    status = report_.reason == tern::FlightReason::kArrived ? "reached" : "stuck";
    return true;
  }

  /// A flight's state lies in the first of its words.
  const tern::FlightState& state() const { return *reinterpret_cast<const tern::FlightState*>(words_.data()); }

  void tell(const tern::Command& command) {
    onlooker_({time_, report_, command, *vehicle_, yaw_, recorder_.clearance_now(), map_, flight_, planner_, state()});
  }

  /// To the next tick.
  void move_on() {
    const std::int64_t next = time_ + spec_.tick;
    vehicle_->fly_to(1e-9 * static_cast<double>(next), [this](double t) { return setpoint(t); });
    yaw_ = plans_yaw_ ? flight_.yaw(next).angle : yaw_ + yaw_rate_ / world_.settings.tick_hz;
    time_ = next;
  }

  /// Limits of the yaw, and no step in it, half a tick apart.
  void watch_yaw() {
    if (!plans_yaw_ || !yaw_broken_.empty()) return;
    const FlightSettings& s = world_.settings;
    for (const std::int64_t t : {time_, time_ + spec_.tick / 2}) {
      const tern::YawSample now = flight_.yaw(t);
      const double step = 0.5 / s.tick_hz;
      const bool within = std::abs(now.yaw.rate) <= s.yaw_rate + kYawSlack &&
                          std::abs(now.acceleration) <= s.yaw_acceleration + kYawSlack;
      const double turned = std::abs(std::remainder(now.angle - last_angle_, kTurn));
      const double changed = std::abs(now.yaw.rate - last_rate_);
      const bool smooth =
          time_ == 0 || (turned <= s.yaw_rate * step + kYawSlack && changed <= s.yaw_acceleration * step + kYawSlack);
      if (!within || !smooth) yaw_broken_ = "yaw: beyond its limits at " + std::to_string(seconds()) + " s";
      last_angle_ = now.angle;
      last_rate_ = now.yaw.rate;
    }
  }

  /// The camera turns to where the flight looks, as fast as it may.
  void turn(const tern::Command& command) {
    const double x = command.look_at.x - command.sample.position.x;
    const double y = command.look_at.y - command.sample.position.y;
    yaw_rate_ = 0.0;
    if (std::hypot(x, y) < kLeastLook) return;
    const double most = world_.settings.yaw_rate;
    yaw_rate_ = std::clamp(std::remainder(std::atan2(y, x) - yaw_, kTurn) * world_.settings.tick_hz, -most, most);
  }

  const FlightWorld& world_;
  const FlightOnlooker& onlooker_;
  Noise noise_;
  std::unique_ptr<tern::Workspace> memory_;
  tern::Planner planner_;
  tern::MapSpec map_spec_;
  std::vector<tern::Fence> fences_;
  tern::FlightSpec spec_;
  std::vector<std::uint64_t> map_words_;
  std::vector<std::uint64_t> words_;
  tern::RollingMap map_;
  tern::Flight flight_;
  tern::FlightReport report_{};
  std::unique_ptr<Vehicle> vehicle_;
  FlightRecorder recorder_;
  FlightTape tape_;
  std::unique_ptr<FlightWatch> watch_;
  std::unique_ptr<MissionWatch> mission_;
  Sensor sensor_;
  std::int64_t time_ = 0;
  double yaw_ = 0.0;
  double yaw_rate_ = 0.0;
  bool plans_yaw_ = false;
  double last_angle_ = 0.0, last_rate_ = 0.0;
  std::string yaw_broken_;
  CommitLog commits_;
  std::int64_t view_waits_ = 0;  // ticks
  std::string reason_;
};

}  // namespace

FlightResult simulate_flight(const FlightWorld& world, const FlightOnlooker& onlooker, std::string* record) {
  return std::make_unique<Simulation>(world, onlooker, record)->fly();
}

}  // namespace tern_host
