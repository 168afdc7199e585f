// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// From the switch to offboard to the hover at the end.
#pragma once

#include <math.h>
#include <px4_platform_common/log.h>

#include "planning.hpp"

namespace tern_offboard {

constexpr hrt_abstime kPeriod = 20000;     // us: 50 Hz
constexpr hrt_abstime kPlanning = 10000;   // us of each period, while a plan is made in flight
constexpr double kStartTolerance = 0.1;    // m from the plan's start at the switch; farther away, a new plan is made
constexpr double kStartHeading = 0.2;      // rad, likewise
constexpr double kRestSpeed = 0.3;         // m/s
constexpr double kStopDeceleration = 3.0;  // m/s^2

inline tern::Vec3 difference(const tern::Vec3& a, const tern::Vec3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

inline double length(const tern::Vec3& v) {
  return sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
}

/// Says what to send, tick by tick. Proof of life is always sent, and setpoints only while the armed vehicle flies in
/// offboard.
class Flight {
 public:
  /// The plan that is made leads from the hover that was seen.
  explicit Flight(const Seen& seen) : last_(seen.now), from_(seen.here), has_plan_(true) { remember(seen); }

  void tick(const Seen& seen, Topics& topics) {
    hrt_abstime step = seen.now - last_;
    last_ = seen.now;
    topics.publish_mode();
    if (!seen.offboard || !seen.flying) return leave();
    if (!seen.valid) {
      PX4_ERR("no valid estimate: the stream ends");
      is_over_ = true;
      return;
    }
    if (phase_ == Phase::kWaiting) {
      enter(seen);
      step = 0;
    }
    if (phase_ == Phase::kHovering) return hover(seen, topics);
    if (is_reset(seen)) slow_down(seen, "the estimator was reset", true);
    if (step > kLongest) slow_down(seen, "the stream stood still", true);
    if (wants_end_) slow_down(seen, "stop", false);
    fly(step > kLongest ? kPeriod : step, topics);
  }

  /// Comes to rest, and then ends the stream.
  void stop() { wants_end_ = true; }
  bool is_over() const { return is_over_; }

 private:
  enum class Phase { kWaiting, kHovering, kFlying, kStopping };

  void remember(const Seen& seen) { memcpy(resets_, seen.resets, sizeof resets_); }
  bool is_reset(const Seen& seen) const { return memcmp(resets_, seen.resets, sizeof resets_) != 0; }

  /// At rest at the start of the plan, in the frame that it was made in.
  bool is_at_start(const Seen& seen) const {
    const double turned = fabs(remainder(seen.here.heading - from_.heading, 6.28318530717958648));
    return length(difference(seen.here.position, from_.position)) <= kStartTolerance && turned <= kStartHeading &&
           seen.speed <= kRestSpeed && !is_reset(seen);
  }

  /// The pilot took over, or the vehicle landed or disarmed: the next switch to offboard begins anew.
  void leave() {
    is_over_ = wants_end_ || has_arrived_;
    if (phase_ == Phase::kWaiting) return;
    PX4_INFO("left offboard");
    has_plan_ = false;
    phase_ = Phase::kWaiting;
  }

  void enter(const Seen& seen) {
    if (has_plan_ && is_at_start(seen)) return begin();
    PX4_INFO("not at rest at the plan's start: a new plan from here");
    hover_at(seen.here, true);
    remember(seen);
  }

  void begin() {
    PX4_INFO("plan of %d ms", static_cast<int>(1000.0 * tern::duration(the_plan())));
    phase_ = Phase::kFlying;
    time_ = 0.0;
    rate_ = 1.0;
    shift_ = {0.0, 0.0, 0.0};
  }

  void hover_at(const Hover& hover, bool wants_plan) {
    phase_ = Phase::kHovering;
    from_ = hover;
    wants_plan_ = wants_plan;
    is_planning_ = false;
  }

  void hover(const Seen& seen, Topics& topics) {
    if (is_reset(seen)) hover_at(seen.here, wants_plan_);  // or the vehicle would fly as far as the estimate jumped
    remember(seen);
    tern::Sample sample{};
    sample.position = from_.position;
    topics.publish(sample, yaw_at(from_.heading));
    if (wants_end_) {
      is_over_ = seen.speed <= kRestSpeed;
    } else if (wants_plan_) {
      plan_on(seen);
    }
  }

  void plan_on(const Seen& seen) {
    if (!is_planning_) {
      if (!is_at_start(seen)) return;
      status_ = begin_plan(from_);
      is_planning_ = true;
    }
    while (status_ == tern::Status::kRunning && hrt_absolute_time() - seen.now < kPlanning) status_ = advance_plan(20);
    if (status_ == tern::Status::kRunning) return;
    wants_plan_ = false;
    if (finish_plan(from_)) begin();
  }

  /// Comes to rest along the plan, whose path is clear. Where the estimate or the time has jumped, it goes on along a
  /// path of the same form from where the vehicle is.
  void slow_down(const Seen& seen, const char* reason, bool has_jumped) {
    const tern::Sample at = tern::evaluate(the_plan(), time_);
    if (has_jumped) shift_ = difference(seen.here.position, at.position);
    remember(seen);
    if (phase_ == Phase::kStopping) return;
    PX4_ERR("%s: coming to rest", reason);
    phase_ = Phase::kStopping;
    heading_ = seen.here.heading;
    stop_time_ = fmax(0.5, length(at.velocity) / kStopDeceleration);
  }

  void fly(hrt_abstime step, Topics& topics) {
    const double dt = static_cast<double>(step) * 1e-6;
    const bool stops = phase_ == Phase::kStopping;
    const double rate = stops ? fmax(0.0, rate_ - dt / stop_time_) : 1.0;  // seconds of the plan in a second
    time_ += 0.5 * (rate_ + rate) * dt;
    rate_ = rate;
    tern::Sample at = tern::evaluate(the_plan(), time_);
    at.position = {at.position.x + shift_.x, at.position.y + shift_.y, at.position.z + shift_.z};
    if (!stops) {
      topics.publish(at, tern::evaluate(the_yaw_plan(), time_));
      if (!has_arrived_ && time_ >= tern::duration(the_plan())) PX4_INFO("arrived");
      has_arrived_ = time_ >= tern::duration(the_plan());
      return;
    }
    const double brake = rate > 0.0 ? 1.0 / stop_time_ : 0.0;
    const tern::Vec3 v = at.velocity;
    const tern::Vec3 a = at.acceleration;
    at.velocity = {rate * v.x, rate * v.y, rate * v.z};
    at.acceleration = {rate * rate * a.x - brake * v.x, rate * rate * a.y - brake * v.y,
                       rate * rate * a.z - brake * v.z};
    at.jerk = {0.0, 0.0, 0.0};
    topics.publish(at, yaw_at(heading_));
    if (!(rate > 0.0)) hover_at({at.position, heading_}, false);
  }

  Phase phase_ = Phase::kWaiting;
  hrt_abstime last_;
  Hover from_;  ///< where the plan begins, or where to hover
  uint8_t resets_[5];
  bool has_plan_;
  bool wants_plan_ = false;
  bool is_planning_ = false;
  tern::Status status_ = tern::Status::kOk;  ///< of the plan that is made
  double time_ = 0.0;                        ///< on the plan, s
  double rate_ = 1.0;
  double stop_time_ = 1.0;  ///< s from full speed to rest
  double heading_ = 0.0;    ///< while coming to rest
  tern::Vec3 shift_{};      ///< of the plan
  bool has_arrived_ = false;
  bool wants_end_ = false;
  bool is_over_ = false;
};

}  // namespace tern_offboard
