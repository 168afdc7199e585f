// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The thread that ticks: it sleeps until the next tick or setpoint is due, and publishes setpoints.
#ifndef TERN_ROS_TICK_LOOP_HPP
#define TERN_ROS_TICK_LOOP_HPP

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <functional>
#include <thread>
#include <utility>

#include "tern_onboard/onboard.hpp"

namespace tern_ros {

/// The clock and the publisher of a node. They are called from the loop's thread.
struct Loop {
  std::function<std::int64_t()> now;              ///< nanoseconds of ROS time
  std::function<void(std::int64_t)> sleep_until;  ///< returns early on shutdown
  std::function<bool()> ok;                       ///< false on shutdown
  std::function<void(std::int64_t now, const tern_onboard::Setpoint&)> publish;
};

class TickLoop {
 public:
  TickLoop(tern_onboard::Onboard& onboard, double setpoint_rate, Loop loop)
      : onboard_(onboard),
        period_(std::llround(1e9 / setpoint_rate)),
        loop_(std::move(loop)),
        thread_([this] { run(); }) {}
  ~TickLoop() {
    ends_ = true;
    thread_.join();
  }
  TickLoop(const TickLoop&) = delete;
  TickLoop& operator=(const TickLoop&) = delete;

 private:
  void run() {
    std::int64_t due = loop_.now();
    while (!ends_ && loop_.ok()) {
      const std::int64_t now = loop_.now();
      onboard_.tick(now);
      if (now >= due || due - now > period_) {  // the second: the clock went back
        loop_.publish(now, onboard_.setpoint(now));
        onboard_.sent(now);
        due = due <= now && now < due + period_ ? due + period_ : now + period_;
      }
      loop_.sleep_until(std::min(onboard_.next_tick(now), due));
    }
  }

  tern_onboard::Onboard& onboard_;
  std::int64_t period_;
  Loop loop_;
  std::atomic<bool> ends_{false};
  std::thread thread_;
};

}  // namespace tern_ros

#endif
