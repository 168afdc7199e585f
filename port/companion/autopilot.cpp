// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "companion/autopilot.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "companion/ned.hpp"

namespace tern_companion {
namespace {

constexpr std::int64_t kHeartbeatPeriod = kSecond, kTimePeriod = kSecond / 5, kRequestPeriod = kSecond / 2;
constexpr int kTries = 5;                             // of a request without an answer
constexpr std::int64_t kReboot = 1000;                // ms that the autopilot's time falls by
constexpr std::int64_t kLongestCarry = kSecond / 10;  // from a position to the attitude beside it

/// A message that the companion wants, and how often.
struct Wish {
  std::uint32_t id;
  double hz;
  bool for_odometry, for_pair;  // of autopilots with ODOMETRY, and of those without
};
constexpr Wish kWishes[] = {{Odometry::kId, 50.0, true, false},
                            {AttitudeQuaternion::kId, 50.0, false, true},
                            {LocalPositionNed::kId, 50.0, false, true},
                            {ExtendedSysState::kId, 5.0, true, true},
                            {GpsGlobalOrigin::kId, 0.2, true, true}};

}  // namespace

Autopilot::Autopilot(std::uint8_t system, Send send, Say say, TakePose take_pose)
    : send_(std::move(send)), say_(std::move(say)), take_pose_(std::move(take_pose)) {
  state_.system = system;
}

bool Autopilot::read(const Frame& frame, std::int64_t now) {
  if (frame.id == Heartbeat::kId) return take_heartbeat(frame, now);
  if (is_autopilot(frame)) take_message(frame, now);
  return false;
}

bool Autopilot::take_heartbeat(const Frame& frame, std::int64_t now) {
  const auto beat = parse<Heartbeat>(frame);
  if (frame.component != kAutopilotComponent || beat.autopilot == kInvalidAutopilot || beat.type == kGroundStation)
    return false;
  if (state_.system != 0 && frame.system != state_.system) return false;
  const ModeRules* const rules = rules_of(beat.autopilot);
  if (rules == nullptr) {
    if (state_.heartbeat_at == 0)
      say_("autopilot " + std::to_string(beat.autopilot) + " is neither PX4 (12) nor ArduPilot (3)");
    state_.heartbeat_at = now;
    return false;
  }
  if (state_.rules == nullptr) say_(std::string(rules->name) + ", system " + std::to_string(frame.system));
  state_.rules = rules;
  state_.system = sender_.system = frame.system;
  state_.armed = (beat.base_mode & kArmedFlag) != 0;
  state_.in_mode = rules->is_in(beat);
  if (!rules->says_landed) state_.in_air = state_.armed && beat.system_status == kStateActive;
  state_.heartbeat_at = now;
  return true;
}

void Autopilot::take_message(const Frame& frame, std::int64_t now) {
  switch (frame.id) {
    case SystemTime::kId: {
      const auto time = parse<SystemTime>(frame);
      note_boot_time(time.time_boot_ms);
      if (time.time_unix_usec != 0) {
        state_.unix_boot = 1000 * static_cast<std::int64_t>(time.time_unix_usec) -
                           1000000 * static_cast<std::int64_t>(time.time_boot_ms);
      }
      return;
    }
    case AttitudeQuaternion::kId:
      return take(parse<AttitudeQuaternion>(frame), now);
    case LocalPositionNed::kId:
      return take(parse<LocalPositionNed>(frame));
    case Odometry::kId:
      return take(parse<Odometry>(frame), now);
    case CommandAck::kId:
      return take(parse<CommandAck>(frame));
    case ExtendedSysState::kId:
      if (state_.rules->says_landed) {
        const std::uint8_t landed = parse<ExtendedSysState>(frame).landed_state;
        state_.in_air = landed == kLandedInAir || landed == kLandedTakingOff || landed == kLandedLanding;
      }
      return;
    case GpsGlobalOrigin::kId:
      state_.origin = parse<GpsGlobalOrigin>(frame);
      state_.origin_known = true;
      return;
    case TimeSync::kId: {
      const auto sync = parse<TimeSync>(frame);
      if (sync.tc1 == 0) {
        time_request_ = sync;
        return;
      }
      const bool is_mine = sync.target_system == 0 ||
                           (sync.target_system == sender_.system && sync.target_component == sender_.component);
      if (is_mine) clock_.answered(sync.ts1, sync.tc1, now);
      if (clock_.restarts() != clock_restarts_) ++state_.resets;
      clock_restarts_ = clock_.restarts();
      return;
    }
    default:
      return;
  }
}

/// Time that falls is a restart: what was known of its clock and of its frame is of another life.
void Autopilot::note_boot_time(std::int64_t boot_ms) {
  if (boot_ms < boot_ms_ - kReboot) {
    say_("the autopilot was restarted");
    clock_ = {};
    clock_restarts_ = 0;
    position_ns_ = state_.unix_boot = 0;
    any_odometry_ = state_.in_air = state_.origin_known = false;
    ++state_.resets;
    request_ = 0;
    boot_ms_ = boot_ms;
  }
  boot_ms_ = std::max(boot_ms_, boot_ms);
}

void Autopilot::take(const LocalPositionNed& position) {
  note_boot_time(position.time_boot_ms);
  if (any_odometry_) return;
  state_.pose.pose.position = enu_from_ned(position.position);
  state_.velocity = enu_from_ned(position.velocity);
  position_ns_ = 1000000 * static_cast<std::int64_t>(position.time_boot_ms);
}

/// The pose is that of the attitude's time, with the position carried there: attitudes turn faster than velocities.
void Autopilot::take(const AttitudeQuaternion& attitude, std::int64_t now) {
  note_boot_time(attitude.time_boot_ms);
  const std::int64_t at = 1000000 * static_cast<std::int64_t>(attitude.time_boot_ms);
  const std::int64_t carry = at - position_ns_;
  if (any_odometry_ || position_ns_ == 0 || std::abs(carry) > kLongestCarry) return;
  const tern::Vec3 there = state_.pose.pose.position;
  state_.pose.pose.position =
      tern_onboard::plus(there, tern_onboard::times(state_.velocity, 1e-9 * static_cast<double>(carry)));
  publish(at, attitude.q, now);
  state_.pose.pose.position = there;
}

void Autopilot::take(const Odometry& odometry, std::int64_t now) {
  note_boot_time(static_cast<std::int64_t>(odometry.time_usec / 1000));
  if (odometry.frame_id != kLocalNed) return;  // of another frame, for example of a camera's
  if (any_odometry_ && odometry.reset_counter != reset_counter_) ++state_.resets;
  reset_counter_ = odometry.reset_counter;
  any_odometry_ = true;
  state_.pose.pose.position = enu_from_ned(odometry.position);
  tern::Vec3 velocity = enu_from_ned(odometry.velocity);
  if (odometry.child_frame_id == kBodyFrd) {
    double q[4];
    enu_from_ned(odometry.q, q);
    velocity = tern_onboard::turn(q, {odometry.velocity[0], -odometry.velocity[1], -odometry.velocity[2]});
  }
  state_.velocity = velocity;
  publish(1000 * static_cast<std::int64_t>(odometry.time_usec), odometry.q, now);
}

void Autopilot::publish(std::int64_t boot_ns, const std::array<float, 4>& q, std::int64_t now) {
  enu_from_ned(q, state_.pose.pose.quaternion);
  if (!clock_.known()) return;
  state_.pose.stamp = clock_.to_own(boot_ns);
  state_.estimate_at = now;
  take_pose_(state_);
}

void Autopilot::take(const CommandAck& ack) {
  if (ack.command == kSetMessageInterval && request_ < std::size(kWishes) && tries_ > 0) {
    if (ack.result != kAccepted && kWishes[request_].hz > 1.0) {
      say_("the autopilot refuses to send message " + std::to_string(kWishes[request_].id));
    }
    ++request_;
    tries_ = 0;
    request_due_ = 0;
  }
  if (ack.command == kDoSetMode && ack.result != kAccepted) {
    say_(std::string("the autopilot refuses the mode ") + state_.rules->mode_name);
  }
}

void Autopilot::command(std::uint16_t number, float first, float second, float third) {
  CommandLong command;
  command.command = number;
  command.params = {first, second, third};
  command.target_system = state_.system;
  command.target_component = kAutopilotComponent;
  send(command);
}

/// One message after the other, because an answer does not say which message it is about.
void Autopilot::request_next(std::int64_t now) {
  const bool odometry = state_.rules->has_odometry;
  const auto is_wanted = [&](const Wish& wish) { return odometry ? wish.for_odometry : wish.for_pair; };
  while (request_ < std::size(kWishes) && !is_wanted(kWishes[request_])) ++request_;
  if (request_ == std::size(kWishes) || now < request_due_) return;
  if (tries_ == kTries) {
    say_("no answer to the request of message " + std::to_string(kWishes[request_].id));
    ++request_;
    tries_ = 0;
    return;
  }
  ++tries_;
  request_due_ = now + kRequestPeriod;
  const Wish& wish = kWishes[request_];
  command(kSetMessageInterval, static_cast<float>(wish.id), static_cast<float>(1e6 / wish.hz));
}

void Autopilot::tick(std::int64_t now) {
  if (now >= heartbeat_due_) {
    heartbeat_due_ = now + kHeartbeatPeriod;
    send(Heartbeat{0, kOnboardController, kInvalidAutopilot, 0, kStateActive, 3});
  }
  if (state_.rules == nullptr) return;
  if (now >= time_due_) {
    time_due_ = now + kTimePeriod;
    send(TimeSync{0, now, state_.system, kAutopilotComponent});
  }
  request_next(now);
}

void Autopilot::answer_time(std::int64_t now) {
  if (time_request_) send(TimeSync{now, time_request_->ts1, state_.system, kAutopilotComponent});
  time_request_.reset();
}

std::optional<std::int64_t> Autopilot::unix_time(std::int64_t now) const {
  if (state_.unix_boot == 0 || !clock_.known()) return {};
  return state_.unix_boot + (now - clock_.to_own(0));
}

void Autopilot::ask_for_mode() {
  const ModeRules* const rules = state_.rules;
  if (rules != nullptr) command(kDoSetMode, kCustomModeFlag, rules->main_mode, rules->sub_mode);
}

void Autopilot::say_to_ground(std::uint8_t severity, const std::string& text) {
  StatusText message;
  message.severity = severity;
  const std::string line = "Tern: " + text;
  std::copy_n(line.begin(), std::min(line.size(), message.text.size()), message.text.begin());
  send(message);
}

}  // namespace tern_companion
