// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tern_onboard/onboard.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <utility>

#include "tern/self_test.hpp"
#include "tern_onboard/map_spec.hpp"
#include "tern_onboard/parameters.hpp"

namespace tern_onboard {
namespace {

std::int64_t nanoseconds(double seconds) {
  return std::llround(1e9 * seconds);
}

std::string at(const tern::Vec3& v) {
  char text[80];
  std::snprintf(text, sizeof text, " at %.2f %.2f %.2f", v.x, v.y, v.z);
  return text;
}

}  // namespace

const char* state_name(State state) {
  static const char* const kNames[] = {"no pose", "ready", "flying", "lost"};
  return kNames[static_cast<std::size_t>(state)];
}

std::string describe(const Status& status) {
  if (status.state != State::kFlying) return state_name(status.state);
  std::string text =
      std::string(tern::flight_mode_name(status.report.mode)) + ": " + tern::flight_reason_text(status.report.reason);
  if (status.report.blocked_by == tern::BlockedBy::kNothing) return text;
  return text + "; in the way: " + tern::blocked_by_text(status.report.blocked_by) +
         at(plus(status.report.blocked_at, status.offset));
}

Onboard::Onboard(const Settings& settings, std::unique_ptr<Detector> detector)
    : settings_(settings),
      map_spec_(map_spec_of(settings.map)),
      spec_(flight_spec_of(settings)),
      workspace_(new tern::Workspace),
      planner_(workspace_.get(), sizeof *workspace_),
      map_words_(tern::map_words(map_spec_)),
      flight_words_(tern::flight_words(map_spec_.dims)),
      poses_(settings.watch),
      detector_(std::move(detector)),
      sensors_(settings.watch, map_spec_.pixels, detector_.get()),
      things_(settings.things),
      wish_(settings.fly) {
  const std::string fault = settings_fault(settings);
  if (!fault.empty()) throw std::invalid_argument(fault);
  const std::string& clusters = settings.things.clusters;
  if (clusters != "none" && detector_ == nullptr) {
    throw std::invalid_argument("parameter clusters = \"" + clusters +
                                "\" is refused: this program was built without Tern's tracker. Build Tern with "
                                "TERN_BUILD_TRACKER, which needs Boost, and the program again");
  }
  if (slow_for_beyond(settings, spec_) != tern::Status::kOk) {
    throw std::invalid_argument(
        "parameter detector_range is refused: the vehicle could not stop in it for a thing of beyond_speed, however "
        "slowly it flies. Raise it, or lower beyond_speed, beyond_size or detector_delay");
  }
  if (tern::self_test(tern::kConfigurationHash, nullptr) != tern::Status::kOk) {
    throw std::invalid_argument("Tern's self-test failed: compile it without -ffast-math and with one configuration");
  }
  fence_.planes = planes_;
  fence_.count = height_planes(settings, planes_);
  spec_.fences = fence_.count > 0 ? &fence_ : nullptr;
  spec_.fence_count = fence_.count > 0 ? 1 : 0;
  try_settings();
  if (clusters == "none") return;
  const bool is_ground_known = settings.fly.ground > kNoGround;
  notices_.say(
      "what the sensors see move is tracked, as of class " + clusters +
          (is_ground_known ? "" : "; ground is not set, so what they see of it within free_radius counts, too"),
      !is_ground_known);
}

/// Begins a flight anywhere: what it refuses now, it would refuse in the air.
void Onboard::try_settings() {
  const double keeps = settings_.map.radius + settings_.map.tracking_margin;
  const double lowest = settings_.fly.ground > kNoGround ? settings_.fly.ground + keeps : 0.0;
  const tern::Vec3 position{0.0, 0.0, std::min(std::max(lowest, 0.0), settings_.fly.ceiling)};
  tern::FlightRefusal refusal;
  const tern::Status begun = start_flight(position, 0, &refusal);
  const tern::Status turned =
      begun == tern::Status::kOk ? wish_.send_yaw(flight_, recording_.recorder(), 0.0, {}) : begun;
  flight_ = tern::Flight();
  if (turned == tern::Status::kOk) return;
  throw std::invalid_argument(std::string("the parameters make no flight: ") + tern::status_name(turned) + ", " +
                              tern::field_name(refusal.field) + ": " + tern::status_meaning(turned));
}

tern::Status Onboard::start_flight(const tern::Vec3& position, std::int64_t now, tern::FlightRefusal* refusal) {
  map_spec_.origin = minus(position, times(settings_.map.window, 0.5));
  const tern::Status bound = map_.bind(map_spec_, map_words_.data(), map_words_.size(), &refusal->field);
  if (bound != tern::Status::kOk) return bound;
  recording_.begin(now);
  tern::FlightRecorder& record = recording_.recorder();
  record.bind(map_spec_, bound);
  const double free = settings_.map.free_radius;
  record.assume_free(position, free, map_.assume_free(position, free));
  known_marked_ = 0;
  mark_known();
  const tern::Status begun =
      flight_.start(spec_, map_, planner_, flight_words_.data(), flight_words_.size(), position, now, refusal);
  record.start(spec_, position, now, begun);
  if (begun != tern::Status::kOk) recording_.cancel();
  return begun;
}

void Onboard::mark_known() {
  if (known_marked_ == known_points_.size() || map_.busy()) return;
  std::vector<tern::Vec3> points(known_points_.begin() + static_cast<std::ptrdiff_t>(known_marked_),
                                 known_points_.end());
  for (tern::Vec3& point : points) point = minus(point, poses_.offset());
  recording_.recorder().mark_points(points.data(), points.size(), map_.mark_points(points.data(), points.size()));
  known_marked_ = known_points_.size();
}

void Onboard::add_pose(const StampedPose& pose, std::int64_t now, std::uint32_t resets) {
  const std::lock_guard lock(mutex_);
  const tern::Vec3 before = poses_.offset();
  const bool taken = poses_.add(pose, resets, now, notices_);
  if (poses_.heading_jumped() && status_.state == State::kFlying) {
    return lose(Fault::kHeadingJump, now, "the estimated heading jumped: the map is wrong now, and the flight ends");
  }
  if (!taken) return;
  pose_stamp_ = pose.stamp;
  if (status_.state != State::kFlying) {
    hold_.position = plus(hold_.position, poses_.offset());
    poses_.rebase();
    if (following_.value_or(false) && !hold_.valid) hold_here();
  }
  if (status_.state == State::kNoPose) status_.state = State::kReady;
  status_.offset = poses_.offset();
  if (length(minus(status_.offset, before)) > 0.0 && status_.state == State::kFlying) send_wish();
  watch_stray(*poses_.newest(), now);
}

Answer Onboard::begin(std::int64_t now) {
  const std::lock_guard lock(mutex_);
  return begin_locked(now);
}

Answer Onboard::begin_locked(std::int64_t now) {
  const auto refuse = [&](const std::string& text) {
    notices_.count(Fault::kRefused);
    return Answer{false, "the flight cannot begin: " + text};
  };
  if (status_.state == State::kFlying) return refuse("one is under way");
  if (!following_.value_or(true))
    return refuse("the autopilot does not follow setpoints. Arm it and switch its mode first");
  const StampedPose* newest = poses_.newest();
  if (newest == nullptr || now - newest->stamp > nanoseconds(settings_.watch.pose_age)) {
    return refuse("there is no pose, or it is older than pose_age");
  }
  poses_.rebase();
  return begin_at(*newest, now);
}

Answer Onboard::begin_at(const StampedPose& start, std::int64_t now) {
  tern::FlightRefusal refusal;
  // The setpoint that the vehicle holds is where it goes on.
  const tern::Vec3 position = hold_.valid ? hold_.position : start.pose.position;
  const tern::Status begun = start_flight(position, now, &refusal);
  if (begun != tern::Status::kOk) {
    notices_.count(Fault::kRefused);
    std::string text =
        std::string("the flight cannot begin: ") + tern::status_name(begun) + ", " + tern::status_meaning(begun);
    if (begun == tern::Status::kStartFenced)
      text += ": the vehicle is below ground + radius + tracking_margin, or above ceiling. Take off first";
    if (refusal.blocked_by != tern::BlockedBy::kNothing) {
      text += std::string(": ") + tern::blocked_by_text(refusal.blocked_by) + at(refusal.blocked_at) + " is " +
              metres(refusal.distance) + " away, and must be " + metres(refusal.needed) +
              ". Go away from there, or state what is free with free_radius";
    }
    return {false, text};
  }
  wish_.send_yaw(flight_, recording_.recorder(), heading_of(start.pose.quaternion), {});
  sensors_.restart();
  things_.begin_flight();
  time_ = now;
  flown_count_ = 0;
  corridor_.count = 0;
  status_.report = {};
  status_.stray = status_.stray_max = 0.0;
  status_.state = State::kFlying;
  hold_.valid = pose_lost_ = false;
  progress_.restart();
  notices_.say("the flight begins" + at(position) + "; " + narrowest_way_text(settings_.map));
  return {true, "the flight begins" + at(position)};
}

void Onboard::set_following(bool following) {
  const std::lock_guard lock(mutex_);
  if (following_ == following) return;
  following_ = following;
  hold_.valid = false;
  if (following) {
    if (status_.state != State::kFlying) hold_here();
    return;
  }
  if (status_.state == State::kFlying) notices_.say("the autopilot does not follow any more: the flight ends");
  if (status_.state == State::kFlying || status_.state == State::kLost) status_.state = State::kReady;
  wish_.clear();
  poses_.rebase();
}

Answer Onboard::send_wish() {
  const auto done = static_cast<std::size_t>(std::max(0, status_.report.leg));
  const tern::Status sent = wish_.send(flight_, recording_.recorder(), done, poses_.offset());
  status_.report.leg = 0;
  if (sent == tern::Status::kOk) return {true, "it is taken over at the next tick"};
  notices_.count(Fault::kRefused);
  wish_.clear();
  return {false, std::string("the mission is refused: ") + tern::status_name(sent) + ", " + tern::status_meaning(sent)};
}

Answer Onboard::set_goal(const tern::Vec3& goal, std::int64_t now) {
  tern::Via via{};
  via.position = goal;
  return set_mission({via}, tern::ViaPolicy::kEnd, now);
}

Answer Onboard::set_mission(const std::vector<tern::Via>& points, tern::ViaPolicy policy, std::int64_t now) {
  const std::lock_guard lock(mutex_);
  const std::string fault = mission_fault(points, settings_);
  if (!fault.empty()) {
    notices_.count(Fault::kRefused);
    return {false, "the mission is refused: " + fault};
  }
  if (status_.state != State::kFlying) {
    const Answer begun = begin_locked(now);
    if (!begun.ok) return begun;
  }
  wish_.set_mission(points, policy);
  progress_.restart();
  status_.report.leg = 0;
  if (pose_lost_) return {true, "it is taken over when poses come again"};
  return send_wish();
}

Answer Onboard::stop() {
  const std::lock_guard lock(mutex_);
  wish_.clear();
  if (status_.state != State::kFlying) return {true, "there is no flight to stop"};
  recording_.recorder().stop(flight_.stop());
  return {true, "the vehicle brakes and forgets its goal"};
}

Answer Onboard::set_yaw(tern::FlightYawMode mode, const tern::Vec3& point, double heading) {
  const std::lock_guard lock(mutex_);
  if (mode > tern::FlightYawMode::kFixed || !is_finite(point) || !std::isfinite(heading)) {
    notices_.count(Fault::kRefused);
    return {false, "the yaw is refused: it must be unseen, motion, point or heading, with finite numbers"};
  }
  wish_.set_yaw(mode, point, heading);
  if (status_.state == State::kFlying) wish_.send_yaw(flight_, recording_.recorder(), 0.0, poses_.offset());
  return {true, "it is taken over at the next tick"};
}

void Onboard::record_flights(std::size_t room) {
  const std::lock_guard lock(mutex_);
  recording_.turn_on(room);
}

std::vector<RecordPart> Onboard::take_record() {
  const std::lock_guard lock(mutex_);
  return recording_.take();
}

std::vector<Notice> Onboard::take_notices() {
  const std::lock_guard lock(mutex_);
  return notices_.take();
}

}  // namespace tern_onboard
