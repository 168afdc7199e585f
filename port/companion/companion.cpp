// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "companion/companion.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <utility>

#include "tern_stacks/stacks.hpp"
#ifdef TERN_COMPANION_HAS_TRACKER
#include "tern_tracker/cluster_detector.hpp"
#endif

namespace tern_companion {
namespace {

constexpr std::int64_t kSetpointPeriod = kSecond / 50;
constexpr std::int64_t kHeartbeatLost = 3 * kSecond, kFramesLost = kSecond, kPoseLost = kSecond / 2;
constexpr std::int64_t kRestFor = kSecond / 2, kRetry = kSecond, kHoverAtEnd = kSecond, kSave = kSecond / 2;
constexpr double kRestSpeed = 0.3;  // m/s

constexpr char kNoFramesText[] = "no frames of depth come: it stays in what it has seen";

std::unique_ptr<tern_onboard::Detector> detector_of([[maybe_unused]] const tern_onboard::Settings& settings) {
#ifdef TERN_COMPANION_HAS_TRACKER
  return tern_tracker::detector_of(settings);
#else
  return nullptr;  // Onboard says what is missing
#endif
}

/// The flight goes no further by itself.
bool is_final(tern::FlightReason reason) {
  using Reason = tern::FlightReason;
  return reason != Reason::kNone && reason != Reason::kNoGoal && reason != Reason::kMapStale;
}

}  // namespace

Companion::Companion(const CompanionSettings& settings, Outputs outputs)
    : settings_(settings),
      outputs_(std::move(outputs)),
      autopilot_(
          settings.system, outputs_.send, outputs_.say,
          [this](const AutopilotState& state) { onboard_.add_pose(state.pose, state.estimate_at, state.resets); }),
      onboard_(settings.onboard, detector_of(settings.onboard)),
      record_(onboard_, settings.record),
      sensors_(onboard_),
      traffic_(settings.traffic),
      mission_(settings.mission) {
  onboard_.set_following(false);
}

bool Companion::read(const std::uint8_t* bytes, std::size_t count, std::int64_t now) {
  reader_.feed(bytes, count);
  Frame frame;
  bool is_autopilot = false;
  while (reader_.next(frame)) {
    is_autopilot = autopilot_.read(frame, now) || is_autopilot;
    const AutopilotState& state = autopilot_.state();
    if (state.rules == nullptr) continue;
    const LocalFrame local{state.origin, state.rules->projection};
    const auto goal = read_goal(frame, autopilot_.sender(), state.origin_known ? &local : nullptr);
    if (goal) take_goal(*goal, frame);
    take_traffic(frame, state.origin_known ? &local : nullptr, now);
  }
  warn_about_frames();
  return is_autopilot;
}

void Companion::warn_about_frames() {
  const FrameCounts& counts = reader_.counts();
  if (counts.version_1 > 0 && counts.frames == 0) {
    say_once("the autopilot speaks MAVLink 1. Set it to version 2: MAV_PROTO_VER 2, or SERIALn_PROTOCOL 2");
  }
  if (counts.with_signature > 0) {
    say_once("the autopilot signs its messages, which is not supported: turn signing off on this link");
  }
}

void Companion::say_once(const std::string& text) {
  if (said_.insert(text).second) outputs_.say(text);
}

void Companion::take_goal(const GoalMessage& message, const Frame& frame) {
  using Kind = GoalMessage::Kind;
  if (message.kind == Kind::kRefused) outputs_.say("a goal is refused: " + message.reason);
  if (message.kind == Kind::kStop) {
    paused_ = true;
    onboard_.stop();
    begun_ = false;
  }
  if (message.kind == Kind::kContinue) paused_ = false;
  if (message.kind == Kind::kGoal) {
    tern::Via via{};
    via.position = message.goal;
    mission_ = {via};
    paused_ = begun_ = false;
    new_goal_ = true;
    retry_at_ = arrived_at_ = 0;
  }
  if (message.command == 0) return;
  CommandAck ack;
  ack.command = message.command;
  ack.result = message.kind == Kind::kRefused ? kDenied : kAccepted;
  ack.target_system = frame.system;
  ack.target_component = frame.component;
  outputs_.send(pack(autopilot_.sender(), ack));
}

void Companion::take_traffic(const Frame& frame, const LocalFrame* local, std::int64_t now) {
  const AutopilotState& state = autopilot_.state();
  TrafficView view{now, autopilot_.unix_time(now), local, nullptr, state.system};
  if (state.estimate_at != 0) view.here = &state.pose.pose.position;
  std::string why;
  const auto sighting = traffic_.read(frame, view, why);
  if (sighting) onboard_.add_sighting(*sighting, now);
  if (!why.empty()) say_once(why);
}

void Companion::take_depth(const tern_depth_header& header, const std::uint8_t* payload, std::int64_t now) {
  frame_at_ = std::max(frame_at_, header.stamp_ns);
  const std::string fault = sensors_.take(header, payload, now);
  if (!fault.empty()) say_once(fault);
}

Facts Companion::facts(std::int64_t now) {
  const AutopilotState& state = autopilot_.state();
  if (tern_onboard::length(state.velocity) > kRestSpeed) moved_at_ = now;
  Facts f;
  f.was_heard = state.rules != nullptr;
  f.heartbeat = f.was_heard && now - state.heartbeat_at <= kHeartbeatLost;
  f.time = autopilot_.clock().known();
  f.pose = f.time && state.estimate_at != 0 && now - state.pose.stamp <= kPoseLost;
  f.frames = frame_at_ != 0 && now - frame_at_ <= kFramesLost;
  f.armed = state.armed;
  f.in_air = state.in_air;
  f.in_mode = state.in_mode;
  f.rests = now - moved_at_ >= kRestFor;
  f.has_goal = !mission_.empty() && !paused_;
  f.begun = begun_;
  f.lost = onboard_.status(now).state == tern_onboard::State::kLost;
  f.ending = ending_;
  return f;
}

void Companion::tick(std::int64_t now) {
  autopilot_.tick(now);
  const Facts f = facts(now);
  onboard_.set_following(has_vehicle(f));
  const Phase phase = phase_of(f);
  if (phase != phase_) enter(phase, now);
  steer(now);
  onboard_.tick(now);
  relay_notices();
  if (now >= save_at_) {
    save();
    save_at_ = now + kSave;
  }
  const tern_onboard::Status status = onboard_.status(now);
  tell_of_map(status);
  if (now >= setpoint_due_) {
    setpoint_due_ = std::max(setpoint_due_ + kSetpointPeriod, now - kSetpointPeriod);
    send_setpoint(now);
  }
  judge(status, now);
}

void Companion::enter(Phase phase, std::int64_t now) {
  const bool had = phase_ >= Phase::kSettling, has = phase >= Phase::kSettling;
  if (has && !had) moved_at_ = now;
  if (phase == Phase::kGivenUp) new_goal_ = false;
  if (!has || phase == Phase::kGivenUp) begun_ = false;
  if (phase == Phase::kEnding || phase == Phase::kLinkLost) {
    onboard_.stop();
    begun_ = false;
  }
  outputs_.say(phase_text(phase));
  if (has || had) autopilot_.say_to_ground(phase == Phase::kLinkLost ? 4 : 6, phase_text(phase));
  phase_ = phase;
}

/// Asks for the mode, and begins the flight.
void Companion::steer(std::int64_t now) {
  if (phase_ == Phase::kOtherMode && settings_.asks_for_mode && now >= mode_due_ && !ending_) {
    // PX4 wants setpoints for a second before it takes the mode.
    if (mode_due_ != 0) autopilot_.ask_for_mode();
    mode_due_ = now + 2 * kSecond;
  }
  const bool is_wanted = phase_ == Phase::kSettling || (phase_ == Phase::kGivenUp && new_goal_);
  if (is_wanted) begin(now);
}

void Companion::begin(std::int64_t now) {
  const Facts f = facts(now);
  if (!f.rests || !f.has_goal || !f.frames || now < retry_at_) return;
  const tern_onboard::Answer answer = onboard_.set_mission(mission_, tern::ViaPolicy::kEnd, now);
  begun_ = answer.ok;
  new_goal_ = new_goal_ && !answer.ok;
  retry_at_ = now + kRetry;
  if (!answer.ok) say_once(answer.text);
}

void Companion::save() {
  const std::string fault = record_.save();
  if (!fault.empty()) outputs_.say(fault);
}

void Companion::relay_notices() {
  for (const tern_onboard::Notice& notice : onboard_.take_notices()) {
    outputs_.say(notice.text);
    if (notice.bad) autopilot_.say_to_ground(4, notice.text);
  }
}

void Companion::tell_of_map(const tern_onboard::Status& status) {
  if (status.state != tern_onboard::State::kFlying) return;
  if (status.report.map_stale == map_stale_) return;
  map_stale_ = status.report.map_stale;
  outputs_.say(map_stale_ ? kNoFramesText : "frames of depth come again");
  autopilot_.say_to_ground(map_stale_ ? 4 : 6, map_stale_ ? kNoFramesText : "frames of depth come again");
}

void Companion::send_setpoint(std::int64_t now) {
  const AutopilotState& state = autopilot_.state();
  const bool has = phase_ >= Phase::kSettling;
  if (state.rules == nullptr || (!has && !(state.rules->streams_before && phase_ > Phase::kNoPose))) return;
  const tern_onboard::Setpoint setpoint = onboard_.setpoint(now);
  if (!setpoint.valid) return;
  tern::Sample sample{};
  sample.position = setpoint.position;
  sample.velocity = setpoint.velocity;
  sample.acceleration = setpoint.acceleration;
  tern::YawSample yaw{};
  yaw.yaw = {std::cos(setpoint.yaw), std::sin(setpoint.yaw), setpoint.yaw_rate};
  Sender& sender = autopilot_.sender();
  const tern::MavlinkHeader header{sender.system,       sender.component, state.system,
                                   kAutopilotComponent, sender.sequence,  static_cast<std::uint32_t>(now / 1000000)};
  std::vector<std::uint8_t> frame(tern::kMavlinkSetpointBytes);
  const std::int32_t bytes = tern::mavlink_setpoint(tern::setpoint_ned(sample, yaw, {}), header, frame.data());
  if (bytes == 0) return;
  ++sender.sequence;
  frame.resize(static_cast<std::size_t>(bytes));
  outputs_.send(frame);
  ++setpoints_;
  onboard_.sent(now);
}

/// Whether the program is over.
void Companion::judge(const tern_onboard::Status& status, std::int64_t now) {
  const bool at_rest = status.report.mode == tern::FlightMode::kRest;
  const bool flies = status.state == tern_onboard::State::kFlying;
  if (ending_) {
    if (ended_at_ == 0 && (!flies || at_rest)) ended_at_ = now;
    if (ended_at_ != 0 && (phase_ < Phase::kSettling || now - ended_at_ >= kHoverAtEnd)) outcome_ = 1;
    return;
  }
  if (!settings_.ends_at_goal || phase_ != Phase::kFlying || !at_rest || !is_final(status.report.reason)) {
    arrived_at_ = 0;
    return;
  }
  if (arrived_at_ == 0) {
    arrived_at_ = now;
    outputs_.say(tern_onboard::describe(status));
  }
  if (now - arrived_at_ >= kHoverAtEnd) outcome_ = status.report.reason == tern::FlightReason::kArrived ? 0 : 1;
}

std::string Companion::summary(std::int64_t now) const {
  const tern_onboard::Status status = onboard_.status(now);
  const FrameCounts& counts = reader_.counts();
  char line[240];
  std::snprintf(
      line, sizeof line,
      "%llu setpoints; %u plans committed, %u late, %u failed; %llu ticks skipped; largest tracking error %.2f m\n"
      "MAVLink: %llu messages, %llu with a wrong checksum, %llu of version 1, %llu signed\n",
      static_cast<unsigned long long>(setpoints_), status.report.committed, status.report.dropped, status.report.failed,
      static_cast<unsigned long long>(status.ticks_skipped), status.stray_max,
      static_cast<unsigned long long>(counts.frames), static_cast<unsigned long long>(counts.bad_checksum),
      static_cast<unsigned long long>(counts.version_1), static_cast<unsigned long long>(counts.with_signature));
  const tern_onboard::FrameAges ages = onboard_.frame_ages();
  return line + ("from an image's stamp, median / 99 % / most (images): to its arrival " + ages.to_arrival +
                 ", to its entry into the map " + ages.to_map + ", to the first setpoint that rests on it " +
                 ages.to_setpoint);
}

}  // namespace tern_companion
