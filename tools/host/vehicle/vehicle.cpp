// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/vehicle/vehicle.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <stdexcept>

#include "host/vehicle/ardupilot_cascade.hpp"
#include "host/vehicle/geometric_controller.hpp"
#include "host/vehicle/pose_error.hpp"
#include "host/vehicle/px4_cascade.hpp"
#include "host/vehicle/smooth_error.hpp"
#include "host/vehicle/wind.hpp"
#include "tern/flatness.hpp"

namespace tern_host {
namespace {

/// Steps of the rigid body and of the fastest loop.
constexpr double kStep = 1e-3;
constexpr std::int64_t kHoverSteps = 30000;

tern::Vec3 vec3(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

tern::Vec3 sum(const tern::Vec3& a, const tern::Vec3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

tern::Vec3 difference(const tern::Vec3& a, const tern::Vec3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

/// Where it believes to be is off the command by the tracking error, and off the truth by the estimate's error. It is
/// turned as the command says.
class ShiftedVehicle : public Vehicle {
 public:
  ShiftedVehicle(const VehicleSettings& s, const Setpoint& start)
      : noise_(s.seed),
        tracking_(s.kind == "perfect" ? 0.0 : s.tracking_margin, noise_),
        estimating_(s.pose_margin, s.pose_jumps, s.pose_drift, s.seed, noise_) {
    place(0.0, start);
  }

  void fly_to(double t, const Setpoints& setpoints) override { place(t, setpoints(t)); }
  tern::Vec3 position() const override { return position_; }
  tern::Vec3 velocity() const override { return velocity_; }
  std::array<double, 4> attitude() const override { return attitude_; }
  tern::Vec3 estimate() const override { return estimate_; }

 private:
  void place(double t, const Setpoint& setpoint) {
    const tern::Sample& sample = setpoint.sample;
    estimate_ = sum(sample.position, tracking_.at(t));
    position_ = difference(estimate_, estimating_.at(t));
    velocity_ = difference(sum(sample.velocity, tracking_.rate_at(t)), estimating_.rate_at(t));
    const tern::Yaw yaw{std::cos(setpoint.yaw), std::sin(setpoint.yaw), setpoint.yaw_rate};
    const tern::FlatState flat = tern::flat_state(sample, yaw);
    std::copy(std::begin(flat.quaternion), std::end(flat.quaternion), attitude_.begin());
  }

  Noise noise_;
  SmoothError tracking_;
  PoseError estimating_;
  std::array<double, 4> attitude_{};
  tern::Vec3 estimate_{};
  tern::Vec3 position_{};
  tern::Vec3 velocity_{};
};

/// Flies `body` by what is believed of it.
class FlownBody : public Vehicle {
 public:
  FlownBody(const VehicleSettings& s, const Setpoint& start)
      : noise_(s.seed),
        estimating_(s.pose_margin, s.pose_jumps, s.pose_drift, s.seed, noise_),
        wind_(s.air, s.seed),
        step_(is_stack(s.kind) && s.air.wind > 0.0 ? -kHoverSteps : 0),
        lag_(static_cast<std::size_t>(s.pose_lag / kStep + 0.5)),
        controller_(controller_of(s, start, kStep * static_cast<double>(step_))),
        body_(to_eigen(difference(start.sample.position, estimating_.at(0.0))),
              to_eigen(difference({}, estimating_.rate_at(0.0))), start.yaw, s.air.drag) {
    Setpoint still{};
    still.sample.position = start.sample.position;
    still.yaw = start.yaw;
    note();
    if (step_ < 0) fly_to(0.0, [&](double) { return still; });
  }

  void fly_to(double t, const Setpoints& setpoints) override {
    // The steps' number is fixed by the time, so that rounding does not add one.
    const auto last = static_cast<std::int64_t>(std::floor(t / kStep + 0.5));
    for (; step_ < last; ++step_) {
      body_.command(controller_->control(believed(), kStep * static_cast<double>(step_), kStep, setpoints));
      body_.advance(kStep, wind_.advance(kStep));
      note();
    }
  }
  tern::Vec3 position() const override { return vec3(body_.position()); }
  tern::Vec3 velocity() const override { return vec3(body_.velocity()); }
  std::array<double, 4> attitude() const override {
    const Eigen::Quaterniond q = body_.attitude();
    return {q.w(), q.x(), q.y(), q.z()};
  }
  tern::Vec3 estimate() const override { return vec3(believed().position); }

 private:
  struct Place {
    Eigen::Vector3d position, velocity;
  };

  static std::unique_ptr<Controller> controller_of(const VehicleSettings& s, const Setpoint& start, double begin) {
    if (s.kind == "px4") return std::make_unique<Px4Cascade>(begin, s.tick, s.stack_speed);
    if (s.kind == "ardupilot") return std::make_unique<ArdupilotCascade>(start, begin, s.tick, s.stack_speed);
    return std::make_unique<GeometricController>();
  }

  /// What was flown so far, as far back as the estimate lags.
  void note() {
    flown_.push_back({body_.position(), body_.velocity()});
    if (flown_.size() > lag_ + 1) flown_.pop_front();
  }

  /// While it still hovers, the estimate's error stands still.
  Believed believed() const {
    const double t = std::max(0.0, kStep * static_cast<double>(step_));
    return {flown_.front().position + to_eigen(estimating_.at(t)),
            flown_.front().velocity + to_eigen(estimating_.rate_at(t)), body_.attitude(), body_.body_rates()};
  }

  Noise noise_;
  PoseError estimating_;
  Wind wind_;
  std::int64_t step_;
  std::size_t lag_;
  std::unique_ptr<Controller> controller_;
  RigidBody body_;
  std::deque<Place> flown_;
};

}  // namespace

const std::vector<std::string>& vehicle_kinds() {
  static const std::vector<std::string> kinds{"perfect", "bounded", "quadrotor", "px4", "ardupilot"};
  return kinds;
}

bool is_rigid_body(const std::string& kind) {
  return kind == "quadrotor" || is_stack(kind);
}

bool is_stack(const std::string& kind) {
  return kind == "px4" || kind == "ardupilot";
}

std::unique_ptr<Vehicle> make_vehicle(const VehicleSettings& settings, const Setpoint& start) {
  if (settings.kind == "perfect" || settings.kind == "bounded") {
    return std::make_unique<ShiftedVehicle>(settings, start);
  }
  if (is_rigid_body(settings.kind)) return std::make_unique<FlownBody>(settings, start);
  throw std::runtime_error("there is no vehicle " + settings.kind);
}

}  // namespace tern_host
