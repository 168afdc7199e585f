// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// From the switch to offboard to the hover at the end.
#pragma once

#include <px4_platform_common/log.h>

#include "planning.hpp"
#include "range_sensors.hpp"

namespace tern_offboard {

constexpr hrt_abstime kPeriod = 20000;  // us: 50 Hz
constexpr double kRestSpeed = 0.3;      // m/s

/// Says what to send, tick by tick. Proof of life is always sent, and setpoints only while the armed vehicle flies in
/// offboard.
class Offboard {
 public:
  /// `seen`: what the map was made for. `is_blind`: it flies by the map alone.
  Offboard(const Seen& seen, const tern::Vec3& goal, bool is_blind)
      : last_(seen.now), goal_(goal), is_blind_(is_blind) {
    remember(seen);
  }

  void tick(const Seen& seen, Topics& topics, RangeSensors& sensors) {
    const hrt_abstime step = phase_ == Phase::kFlying ? seen.now - last_ : 0;
    last_ = seen.now;
    topics.publish_mode();
    sensors.look(seen.now);
    if (!seen.offboard || !seen.flying) return leave();
    if (!seen.valid) {
      PX4_ERR("no valid estimate: the stream ends");
      is_over_ = true;
      return;
    }
    if (phase_ == Phase::kWaiting) hover_at(seen.here);
    if (phase_ == Phase::kHovering) hover(seen, topics, sensors);
    if (phase_ == Phase::kFlying) fly(seen, step, topics, sensors);
  }

  /// Comes to rest, and then ends the stream.
  void stop() { wants_end_ = true; }
  bool is_over() const { return is_over_; }

 private:
  enum class Phase { kWaiting, kHovering, kFlying };

  void remember(const Seen& seen) { memcpy(resets_, seen.resets, sizeof resets_); }
  bool is_reset(const Seen& seen) const { return memcmp(resets_, seen.resets, sizeof resets_) != 0; }

  /// The pilot took over, or the vehicle landed or disarmed: the next switch to offboard begins anew.
  void leave() {
    is_over_ = wants_end_ || has_arrived_;
    if (phase_ == Phase::kWaiting) return;
    PX4_INFO("left offboard");
    phase_ = Phase::kWaiting;
  }

  void hover_at(const Hover& here) {
    phase_ = Phase::kHovering;
    hover_ = here;
    is_refused_ = waits_ = false;
  }

  /// Until the vehicle rests and the flight can begin.
  void hover(const Seen& seen, Topics& topics, const RangeSensors& sensors) {
    if (is_reset(seen)) {
      remember(seen);
      needs_map_ = true;
      hover_at(seen.here);  // or the vehicle would fly as far as the estimate jumped
    }
    const bool rests = seen.speed <= kRestSpeed;
    if (wants_end_) {
      is_over_ = rests;
    } else if (rests && !is_refused_ && can_begin(seen, sensors)) {
      begin(seen);
      if (phase_ == Phase::kFlying) return;
    }
    tern::Sample sample{};
    sample.position = hover_.position;
    topics.publish(sample, yaw_at(hover_.heading));
  }

  bool can_begin(const Seen& seen, const RangeSensors& sensors) {
    if (is_blind_ || sensors.are_there(seen.now)) return true;
    if (!waits_) PX4_ERR("no range sensor: hovering");
    waits_ = true;
    return false;
  }

  void begin(const Seen& seen) {
    is_refused_ = !begin_flight(hover_, goal_, !is_blind_, needs_map_, seen.now);
    if (is_refused_) return;
    needs_map_ = is_lost_ = are_silent_ = has_stopped_ = has_arrived_ = false;
    shift_ = {0.0, 0.0, 0.0};
    report_ = tern::FlightReport{};
    phase_ = Phase::kFlying;
  }

  void fly(const Seen& seen, hrt_abstime step, Topics& topics, RangeSensors& sensors) {
    const int64_t now = nanoseconds(seen.now);
    if (step > kLongest) {
      the_flight().set_clock(now);  // or the setpoint would leap ahead
      end("the stream stood still");
    }
    if (is_reset(seen)) move_on(seen, now);
    if (wants_end_) end("stop");
    if (!is_lost_) the_flight().note_position(seen.here.position, nanoseconds(seen.stamp));  // strays: it flies slower
    if (!is_blind_ && !is_lost_) sensors.enter(the_map(), seen);
    send(now, topics);
    const tern::FlightReport before = report_;
    the_flight().tick(now, report_);
    say(before);
    if (!is_blind_ && !has_stopped_) watch_sensors(!sensors.are_there(seen.now));
    const bool rests = report_.mode == tern::FlightMode::kRest;
    has_arrived_ = rests && report_.reason == tern::FlightReason::kArrived;
    if (wants_end_ && rests) is_over_ = true;
  }

  /// The estimate has jumped, and the setpoints go with it: or the vehicle would fly as far. The map fits no longer.
  void move_on(const Seen& seen, int64_t now) {
    remember(seen);
    shift_ = difference(seen.here.position, the_flight().command(now).sample.position);
    hover_.heading = seen.here.heading;
    needs_map_ = is_lost_ = true;
    end("the estimator was reset");
  }

  /// Comes to rest, and does not go on.
  void end(const char* reason) {
    if (has_stopped_) return;
    PX4_ERR("%s: coming to rest", reason);
    has_stopped_ = true;
    the_flight().stop();
  }

  /// Comes to rest while the sensors are silent.
  void watch_sensors(bool are_silent) {
    if (are_silent == are_silent_) return;
    are_silent_ = are_silent;
    if (are_silent) {
      PX4_ERR("the range sensors are silent: coming to rest");
      the_flight().stop();
    } else {
      PX4_INFO("the range sensors are back: going on");
      the_flight().set_goal(goal_);
    }
  }

  void send(int64_t now, Topics& topics) const {
    tern::Sample at = the_flight().command(now).sample;
    at.position = {at.position.x + shift_.x, at.position.y + shift_.y, at.position.z + shift_.z};
    topics.publish(at, is_lost_ ? yaw_at(hover_.heading) : the_flight().yaw(now));
  }

  void say(const tern::FlightReport& before) const {
    if (report_.mode == before.mode && report_.reason == before.reason) return;
    PX4_INFO("%s: %s", tern::flight_mode_name(report_.mode), tern::flight_reason_text(report_.reason));
    if (report_.blocked_by == tern::BlockedBy::kNothing) return;
    const tern::Vec3& at = report_.blocked_at;
    PX4_INFO("in the way: %s at %.2f %.2f %.2f", tern::blocked_by_text(report_.blocked_by), at.x, at.y, at.z);
  }

  Phase phase_ = Phase::kWaiting;
  hrt_abstime last_;
  tern::Vec3 goal_;
  bool is_blind_;
  Hover hover_{};  ///< where to hover; in flight, its heading is that of a reset
  uint8_t resets_[5];
  tern::FlightReport report_{};
  tern::Vec3 shift_{};        ///< of the setpoints, since a reset
  bool needs_map_ = false;    ///< a reset has made it wrong
  bool is_lost_ = false;      ///< likewise, in this flight
  bool is_refused_ = false;   ///< no flight from this hover
  bool waits_ = false;        ///< it was said that sensors are missing
  bool are_silent_ = false;   ///< the sensors
  bool has_stopped_ = false;  ///< for good
  bool has_arrived_ = false;
  bool wants_end_ = false;
  bool is_over_ = false;
};

}  // namespace tern_offboard
