// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/simulated_flight.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <deque>
#include <memory>
#include <stdexcept>
#include <vector>

#include "host/flight/depth_camera.hpp"
#include "host/number.hpp"
#include "tern/flight.hpp"

namespace tern_host {
namespace {

constexpr double kSlowest = 2.0;        ///< m/s and
constexpr double kGentlest = 6.0;       ///< m/s^2 up and down at most
constexpr double kAssumedVoxels = 6.0;  ///< that the operator knows to be free beyond the radius
constexpr double kHorizon = 0.8;        ///< of plans, in sensor ranges
constexpr double kLeastLook = 0.4;      ///< metres: nearer points say nothing about where to look
constexpr double kTurn = 6.28318530717958648;

double radius_of(const FlightSettings& s) {
  return s.body_radius + s.tracking_margin + s.pose_margin;
}

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
  spec.slack = 8;
  spec.pixels = s.width * s.height;
  return spec;
}

tern::FlightSpec flight_spec_of(const FlightSettings& s) {
  tern::Limits limits{{s.v_max, s.v_max, std::min(s.v_max, kSlowest)},
                      {s.a_max, s.a_max, std::min(s.a_max, kGentlest)}};
  limits.v_horizontal = s.v_max;
  limits.a_horizontal = s.a_max;
  tern::FlightSpec spec = tern::flight_spec(limits);
  spec.limits.j_max = {s.j_max, s.j_max, s.j_max};
  spec.tick = std::llround(1e9 / s.tick_hz);
  spec.work_per_tick = static_cast<std::uint32_t>(s.work_per_tick);
  spec.plan_work = 4 * spec.work_per_tick;
  spec.horizon = kHorizon * s.sensor_range;
  spec.yaw_rate = s.yaw_rate;
  return spec;
}

/// An error of the vehicle that is smooth, seeded, and at most as large as its margin.
class TrackingError {
 public:
  TrackingError(const FlightSettings& s, Noise& noise) : size_(s.tracking == "perfect" ? 0.0 : s.tracking_margin) {
    for (Wave& wave : waves_) wave = {noise.within(0.5, 3.0), noise.within(0.0, kTurn)};
  }
  tern::Vec3 at(double t) const {
    const double each = size_ / std::sqrt(3.0);
    return {each * waves_[0].at(t), each * waves_[1].at(t), each * waves_[2].at(t)};
  }
  tern::Vec3 rate_at(double t) const {
    const double each = size_ / std::sqrt(3.0);
    return {each * waves_[0].rate_at(t), each * waves_[1].rate_at(t), each * waves_[2].rate_at(t)};
  }

 private:
  struct Wave {
    double rate;
    double phase;
    double at(double t) const { return std::sin(rate * t + phase); }
    double rate_at(double t) const { return rate * std::cos(rate * t + phase); }
  };
  double size_;
  Wave waves_[3]{};
};

tern::Vec3 sum(const tern::Vec3& a, const tern::Vec3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

double distance(const tern::Vec3& a, const tern::Vec3& b) {
  return std::hypot(a.x - b.x, std::hypot(a.y - b.y, a.z - b.z));
}

void append(std::string& row, const tern::Vec3& v) {
  for (const double number : {v.x, v.y, v.z}) row += "," + exact(number);
}

const char* mode_name(tern::FlightMode mode) {
  constexpr const char* kNames[] = {"rest", "look", "fly", "stop", "threat"};
  return kNames[static_cast<int>(mode)];
}

class Simulation {
 public:
  explicit Simulation(const FlightWorld& world)
      : world_(world),
        noise_(world.settings.seed),
        error_(world.settings, noise_),
        memory_(new tern::Workspace),
        planner_(memory_.get(), sizeof *memory_),
        spec_(flight_spec_of(world.settings)) {
    start();
  }

  FlightResult fly() {
    const std::int64_t end = std::llround(1e9 * world_.settings.time_limit);
    result_.status = "timeout";
    result_.min_clearance = clearance(world_, truth());
    result_.samples =
        "t,true_x,true_y,true_z,true_v_x,true_v_y,true_v_z,set_p_x,set_p_y,set_p_z,set_v_x,set_v_y,set_v_z,"
        "set_a_x,set_a_y,set_a_z,set_j_x,set_j_y,set_j_z,yaw,tick_work,state,event\n";
    while (time_ <= end && !tick()) time_ += spec_.tick;
    finish();
    return std::move(result_);
  }

 private:
  void start() {
    const tern::MapSpec spec = map_spec_of(world_);
    map_words_.resize(tern::map_words(spec));
    words_.resize(tern::flight_words(spec.dims));
    if (map_.bind(spec, map_words_.data(), map_words_.size()) != tern::Status::kOk) {
      throw std::runtime_error(world_.name + ": no map can be made of this window and cell");
    }
    map_.assume_free(world_.start, radius_of(world_.settings) + kAssumedVoxels * spec.cell);
    const tern::Status begun = flight_.start(spec_, map_, planner_, words_.data(), words_.size(), world_.start, 0);
    if (begun != tern::Status::kOk) {
      throw std::runtime_error(world_.name + ": the flight cannot begin: " + tern::status_name(begun));
    }
    flight_.set_goal(world_.goal);
    yaw_ = std::atan2(world_.goal.y - world_.start.y, world_.goal.x - world_.start.x);
  }

  double seconds() const { return 1e-9 * static_cast<double>(time_); }
  tern::Vec3 truth() const { return sum(flight_.command(time_).sample.position, error_.at(seconds())); }

  /// True where the flight is over.
  bool tick() {
    sense();
    const std::uint32_t committed = report_.committed;
    flight_.tick(time_, report_);
    const tern::Command command = flight_.command(time_);
    note(command, report_.committed != committed ? "commit" : "");
    turn(command);
    if (clearance(world_, truth()) < world_.settings.body_radius) {
      result_.status = "collision";
      return true;
    }
    if (report_.mode != tern::FlightMode::kRest || report_.reason == tern::FlightReason::kNone) return false;
    result_.status = report_.reason == tern::FlightReason::kArrived ? "reached" : "stuck";
    return true;
  }

  /// Frames are taken at the sensor's rate, arrive late or not at all, and enter the map when it is ready.
  void sense() {
    const FlightSettings& s = world_.settings;
    if (static_cast<double>(taken_) <= seconds() * s.sensor_hz) {
      ++taken_;
      if (!noise_.chance(s.dropout)) waiting_.push_back(take_frame(world_, truth(), yaw_, time_, noise_));
    }
    const std::int64_t latency = std::llround(1e9 * s.sensor_latency);
    // Of those that have arrived, only the last one counts.
    while (waiting_.size() > 1 && waiting_[1].taken + latency <= time_) waiting_.pop_front();
    if (map_.busy() || waiting_.empty() || waiting_.front().taken + latency > time_) return;
    entered_ = std::move(waiting_.front());
    waiting_.pop_front();
    map_.begin_frame(entered_.view, entered_.pose, entered_.taken);
  }

  void turn(const tern::Command& command) {
    const double x = command.look_at.x - command.sample.position.x;
    const double y = command.look_at.y - command.sample.position.y;
    if (std::hypot(x, y) < kLeastLook) return;
    const double most = world_.settings.yaw_rate / world_.settings.tick_hz;
    yaw_ += std::clamp(std::remainder(std::atan2(y, x) - yaw_, kTurn), -most, most);
  }

  void note(const tern::Command& command, const char* event) {
    const tern::Sample& set = command.sample;
    const tern::Vec3 p = truth();
    result_.min_clearance = std::min(result_.min_clearance, clearance(world_, p));
    if (rows_++ > 0) result_.length += distance(p, last_);
    last_ = p;
    result_.seconds_in[static_cast<std::size_t>(report_.mode)] += 1e-9 * static_cast<double>(spec_.tick);
    work_.push_back(report_.work);
    hash(set);
    std::string& rows = result_.samples;
    rows += exact(seconds());
    append(rows, p);
    append(rows, sum(set.velocity, error_.rate_at(seconds())));
    for (const tern::Vec3& v : {set.position, set.velocity, set.acceleration, set.jerk}) append(rows, v);
    rows += "," + exact(yaw_) + "," + std::to_string(report_.work) + "," + mode_name(report_.mode) + "," + event + "\n";
  }

  void hash(const tern::Sample& sample) {
    unsigned char bytes[sizeof sample];
    std::memcpy(bytes, &sample, sizeof sample);
    for (const unsigned char byte : bytes) hash_ = (hash_ ^ byte) * 0x100000001B3u;
  }

  void finish() {
    result_.time = seconds();
    result_.asked = report_.asked;
    result_.committed = report_.committed;
    result_.dropped = report_.dropped;
    result_.failed = report_.failed;
    result_.commands_hash = hash_;
    std::sort(work_.begin(), work_.end());
    if (work_.empty()) return;
    result_.work_max = work_.back();
    result_.work_p99 = work_[work_.size() * 99 / 100];
  }

  const FlightWorld& world_;
  Noise noise_;
  TrackingError error_;
  std::unique_ptr<tern::Workspace> memory_;
  tern::Planner planner_;
  tern::FlightSpec spec_;
  std::vector<std::uint64_t> map_words_;
  std::vector<std::uint64_t> words_;
  tern::RollingMap map_;
  tern::Flight flight_;
  tern::FlightReport report_{};
  std::deque<DepthFrame> waiting_;
  DepthFrame entered_;  // in work in the map
  std::int64_t time_ = 0;
  std::int64_t taken_ = 0;
  std::int64_t rows_ = 0;
  tern::Vec3 last_{};
  double yaw_ = 0.0;
  std::vector<std::uint32_t> work_;
  std::uint64_t hash_ = 0xCBF29CE484222325u;
  FlightResult result_;
};

}  // namespace

FlightResult simulate_flight(const FlightWorld& world) {
  return std::make_unique<Simulation>(world)->fly();
}

}  // namespace tern_host
