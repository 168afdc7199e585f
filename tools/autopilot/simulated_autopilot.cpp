// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "autopilot/simulated_autopilot.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "companion/ned.hpp"
#include "tern_onboard/pose.hpp"

namespace tern_autopilot {
namespace {

using namespace tern_companion;
using tern::Vec3;

constexpr std::uint32_t kHoldOfPx4 = 4u << 16 | 3u << 24, kLoiterOfArdupilot = 5;
constexpr double kSlowestStream = 0.5;  // PX4 counts setpoints as a stream from 2 Hz on, s
constexpr double kStreamFor = 1.0;      // and wants it for so long before the switch, s
constexpr std::uint16_t kForce = 1u << 9, kNoYaw = 1u << 10, kNoYawRate = 1u << 11, kAccelerations = 7u << 6;
constexpr double kEarly = 1e-6;
constexpr double kPi = 3.14159265358979323846;

std::array<float, 3> ned(const Vec3& enu) {
  const Vec3 v = tern::ned_from_enu(enu);
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

bool is_finite(const std::array<float, 3>& v) {
  return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

double heading_of(const tern_host::Vehicle& vehicle) {
  const std::array<double, 4> a = vehicle.attitude();
  const double q[4] = {a[0], a[1], a[2], a[3]};
  return tern_onboard::heading_of(q);
}

}  // namespace

SimulatedAutopilot::SimulatedAutopilot(const AutopilotSettings& settings, const tern_host::VehicleSettings& vehicle,
                                       const Vec3& start, double yaw, Send send)
    : settings_(settings),
      rules_(settings.is_px4 ? kPx4Rules : kArdupilotRules),
      jumps_(vehicle.pose_jumps),
      send_(std::move(send)) {
  sender_.system = settings.system;
  sender_.component = kAutopilotComponent;
  hold_.sample.position = start;
  hold_.yaw = yaw;
  vehicle_ = tern_host::make_vehicle(vehicle, hold_);
}

void SimulatedAutopilot::receive(const std::uint8_t* bytes, std::size_t count) {
  reader_.feed(bytes, count);
  Frame frame;
  while (reader_.next(frame)) take(frame);
}

void SimulatedAutopilot::take(const Frame& frame) {
  if (frame.id == Heartbeat::kId) ++counts_.heartbeats;
  if (frame.id == SetPositionTarget::kId) return take(parse<SetPositionTarget>(frame));
  if (frame.id == CommandLong::kId) return take(parse<CommandLong>(frame));
  if (frame.id == StatusText::kId) texts_.push_back(parse<StatusText>(frame));
  if (frame.id == TimeSync::kId) {
    const auto sync = parse<TimeSync>(frame);
    if (sync.tc1 != 0 && sync.ts1 == step_) step_done_ = true;
    if (sync.tc1 == 0) send(TimeSync{time_, sync.ts1, frame.system, frame.component});
  }
}

void SimulatedAutopilot::take(const SetPositionTarget& target) {
  if (target.target_system != settings_.system) return;
  ++counts_.setpoints;
  const double now = seconds();
  if (target.coordinate_frame != kLocalNed || (target.type_mask & kForce) != 0 || !is_finite(target.position) ||
      !is_finite(target.velocity) || !is_finite(target.acceleration)) {
    ++counts_.refused;
    return;
  }
  if (now - last_at_ > kSlowestStream) stream_since_ = now;
  last_at_ = now;
  if (!follows_) return;
  if (last_) {
    counts_.longest_gap = std::max(counts_.longest_gap, now - followed_at_);
    const Vec3 led_to = tern_onboard::plus(enu_from_ned(last_->position),
                                           tern_onboard::times(enu_from_ned(last_->velocity), now - followed_at_));
    counts_.largest_step = std::max(counts_.largest_step,
                                    tern_onboard::length(tern_onboard::minus(enu_from_ned(target.position), led_to)));
  }
  ++counts_.followed;
  last_ = target;
  followed_at_ = now;
}

void SimulatedAutopilot::take(const CommandLong& command) {
  if (command.target_system != settings_.system) return;
  CommandAck ack;
  ack.command = command.command;
  ack.result = kUnsupported;
  if (command.command == kSetMessageInterval) {
    const auto message = static_cast<std::uint32_t>(command.params[0]);
    // ArduPilot has no ODOMETRY to send.
    if (settings_.is_px4 || message != Odometry::kId) {
      periods_[message] = 1e-6 * static_cast<double>(command.params[1]);
      ack.result = kAccepted;
    }
  }
  if (command.command == kDoSetMode) ack.result = sets_mode(command) ? kAccepted : kDenied;
  send(ack);
}

bool SimulatedAutopilot::sets_mode(const CommandLong& command) {
  return command.params[1] == rules_.main_mode && switch_to_companion();
}

bool SimulatedAutopilot::switch_to_companion() {
  if (follows_) return true;
  const double now = seconds();
  const bool streams = now - last_at_ <= kSlowestStream && now - stream_since_ >= kStreamFor;
  if (rules_.streams_before && !streams) return false;
  hold_here();
  follows_ = true;
  last_.reset();
  return true;
}

void SimulatedAutopilot::switch_to_pilot() {
  follows_ = false;
  hold_here();
}

void SimulatedAutopilot::hold_here() {
  hold_ = {};
  hold_.sample.position = vehicle_->estimate();
  hold_.yaw = heading_of(*vehicle_);
}

/// What each does about a stream that ended.
void SimulatedAutopilot::watch_stream() {
  if (!follows_ || !last_) return;
  const double gap = seconds() - followed_at_;
  if (settings_.is_px4 && gap > settings_.loss_time) {
    ++counts_.failsafes;
    switch_to_pilot();
  }
  if (!settings_.is_px4 && gap > settings_.guided_timeout) {
    ++counts_.failsafes;
    last_.reset();
    hold_here();
  }
}

tern_host::Setpoint SimulatedAutopilot::target(double t) const {
  if (!follows_ || !last_) return hold_;
  tern_host::Setpoint wanted{};
  tern::Sample& s = wanted.sample;
  s.position = enu_from_ned(last_->position);
  s.velocity = enu_from_ned(last_->velocity);
  if ((last_->type_mask & kAccelerations) == 0) s.acceleration = enu_from_ned(last_->acceleration);
  wanted.yaw = (last_->type_mask & kNoYaw) != 0 ? hold_.yaw : 0.5 * kPi - static_cast<double>(last_->yaw);
  wanted.yaw_rate = (last_->type_mask & kNoYawRate) != 0 ? 0.0 : -static_cast<double>(last_->yaw_rate);
  if (settings_.is_px4) return wanted;  // it holds what came last; ArduPilot goes on from there
  const double on = std::max(0.0, t - followed_at_);
  s.position = tern_onboard::plus(s.position, tern_onboard::plus(tern_onboard::times(s.velocity, on),
                                                                 tern_onboard::times(s.acceleration, 0.5 * on * on)));
  s.velocity = tern_onboard::plus(s.velocity, tern_onboard::times(s.acceleration, on));
  return wanted;
}

void SimulatedAutopilot::fly_to(std::int64_t t) {
  vehicle_->fly_to(1e-9 * static_cast<double>(t), [this](double at) { return target(at); });
  time_ = t;
  watch_stream();
}

std::vector<std::uint8_t> SimulatedAutopilot::step_request(std::int64_t step) {
  step_ = step;
  step_done_ = false;
  return pack(sender_, TimeSync{0, step, 0, 0});
}

bool SimulatedAutopilot::take_step_answer() {
  return std::exchange(step_done_, false);
}

/// True if it was asked for and its time has come.
bool SimulatedAutopilot::is_due(std::uint32_t message, double default_hz) {
  const auto asked = periods_.find(message);
  const double period = asked != periods_.end() ? asked->second : default_hz > 0.0 ? 1.0 / default_hz : 0.0;
  double& due = due_[message];
  if (!(period > 0.0) || seconds() < due - kEarly) return false;
  due = std::max(due + period, seconds());
  return true;
}

void SimulatedAutopilot::report() {
  const auto boot_ms = static_cast<std::uint32_t>(time_ / 1000000);
  if (is_due(Heartbeat::kId, 1.0)) {
    Heartbeat beat;
    beat.custom_mode = follows_ ? rules_.mode : (settings_.is_px4 ? kHoldOfPx4 : kLoiterOfArdupilot);
    beat.type = 2;
    beat.autopilot = rules_.autopilot;
    beat.base_mode = static_cast<std::uint8_t>(kCustomModeFlag | (armed_ ? kArmedFlag : 0));
    beat.system_status = armed_ && (in_air_ || settings_.is_px4) ? kStateActive : kStateStandby;
    send(beat);
  }
  if (is_due(SystemTime::kId, 1.0)) send(SystemTime{0, boot_ms});
  if (is_due(ExtendedSysState::kId, 1.0)) send(ExtendedSysState{0, in_air_ ? kLandedInAir : kLandedOnGround});
  const std::array<double, 4> attitude = vehicle_->attitude();
  double q[4];
  tern::attitude_ned(attitude.data(), q);
  std::array<float, 4> turned{};
  for (std::size_t k = 0; k < 4; ++k) turned[k] = static_cast<float>(q[k]);
  if (is_due(LocalPositionNed::kId, 1.0)) {
    send(LocalPositionNed{boot_ms, ned(vehicle_->estimate()), ned(vehicle_->velocity())});
  }
  if (is_due(AttitudeQuaternion::kId, 1.0)) send(AttitudeQuaternion{boot_ms, turned, {}, {}});
  if (is_due(Odometry::kId, 0.0)) {
    Odometry odometry;
    odometry.time_usec = static_cast<std::uint64_t>(time_ / 1000);
    odometry.position = ned(vehicle_->estimate());
    odometry.velocity = ned(vehicle_->velocity());
    odometry.q = turned;
    odometry.frame_id = odometry.child_frame_id = kLocalNed;
    if (jumps_.size > 0.0) odometry.reset_counter = static_cast<std::uint8_t>(seconds() / jumps_.every + 1e-9);
    send(odometry);
  }
}

}  // namespace tern_autopilot
