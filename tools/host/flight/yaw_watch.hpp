// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_FLIGHT_YAW_WATCH_HPP
#define TERN_HOST_FLIGHT_YAW_WATCH_HPP

#include <cstdint>
#include <functional>
#include <string>

#include "host/flight/flight_world.hpp"
#include "tern/yaw.hpp"

namespace tern_host {

/// Holds the planned yaw to its limits, and to be without a step, at two instants of every tick.
class YawWatch {
 public:
  using Yaw = std::function<tern::YawSample(std::int64_t)>;  ///< at a time in nanoseconds

  /// `tick`: nanoseconds. The settings must outlive the watch.
  YawWatch(const FlightSettings& settings, std::int64_t tick, Yaw yaw)
      : settings_(settings), tick_(tick), yaw_(std::move(yaw)) {}

  /// To be called after every tick.
  void look(std::int64_t t);
  /// What did not hold first; empty while all holds.
  const std::string& broken() const { return broken_; }

 private:
  void check(std::int64_t t);

  const FlightSettings& settings_;
  std::int64_t tick_;
  Yaw yaw_;
  bool has_last_ = false;
  std::int64_t last_time_ = 0;
  double last_angle_ = 0.0, last_rate_ = 0.0;
  std::string broken_;
};

}  // namespace tern_host

#endif
