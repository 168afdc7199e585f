// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_FLIGHT_FLOWN_PAST_HPP
#define TERN_HOST_FLIGHT_FLOWN_PAST_HPP

#include <cstdint>
#include <deque>

#include "flight/flight_state.hpp"
#include "host/nanoseconds.hpp"
#include "tern/flight.hpp"

namespace tern_host {

/// What was flown before the last tick: a flight itself commands nothing that is past. For flights that start at 0.
class FlownPast {
 public:
  /// To be called after every tick.
  void note(const tern::FlightState& state) {
    const tern::Commitment& in_flight = state.facts.plans.in_flight;
    last_tick_ = state.facts.time;
    if (!flown_.empty() && flown_.back().begin == in_flight.begin()) flown_.pop_back();
    flown_.push_back({in_flight.begin(), in_flight.trajectory});
    if (flown_.size() > kTakeovers) flown_.pop_front();
  }
  bool holds(std::int64_t t) const { return !flown_.empty() && t < last_tick_; }
  tern::Sample at(std::int64_t t) const {
    std::size_t k = flown_.size() - 1;
    while (k > 0 && flown_[k].begin > t) --k;
    return tern::evaluate(flown_[k].flown, seconds_of(t - flown_[k].begin));
  }

 private:
  static constexpr std::size_t kTakeovers = 16;
  struct Flown {
    std::int64_t begin;
    tern::Trajectory flown;
  };

  std::deque<Flown> flown_;
  std::int64_t last_tick_ = 0;
};

}  // namespace tern_host

#endif
