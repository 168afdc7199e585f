// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The caller's clock, which may show any number. A flight counts its own nanoseconds, from 0 at its start.
#ifndef TERN_FLIGHT_FLIGHT_CLOCK_HPP
#define TERN_FLIGHT_FLIGHT_CLOCK_HPP

#include <cstdint>

namespace tern {

/// The largest distance of a flight's times from its start, nanoseconds: 73 years. Sums with leads and durations stay
/// in range.
constexpr std::int64_t kFarthest = std::int64_t{1} << 61;

/// Seconds from `begin` to `t`.
inline double seconds_between(std::int64_t begin, std::int64_t t) noexcept {
  return static_cast<double>(t - begin) * 1e-9;
}

/// The time, or the nearest one that is at most kFarthest from the start.
inline std::int64_t within_farthest(std::int64_t time) noexcept {
  if (time > kFarthest) return kFarthest;
  return time < -kFarthest ? -kFarthest : time;
}

class FlightClock {
 public:
  /// From now on the clock shows `shown` at `time`.
  void set(std::int64_t shown, std::int64_t time) noexcept {
    shown_ = shown;
    time_ = within_farthest(time);
  }

  /// The flight's time when the clock shows `shown`.
  std::int64_t time_of(std::int64_t shown) const noexcept {
    const bool is_later = shown >= shown_;
    // The difference may not fit into 63 bits; unsigned, it is exact.
    const auto a = static_cast<std::uint64_t>(shown);
    const auto b = static_cast<std::uint64_t>(shown_);
    const std::uint64_t apart = is_later ? a - b : b - a;
    const std::int64_t part = apart < std::uint64_t{kFarthest} ? static_cast<std::int64_t>(apart) : kFarthest;
    return within_farthest(is_later ? time_ + part : time_ - part);
  }

  /// What the clock shows at `time`, or the nearest number that 64 bits can hold.
  std::int64_t shown_at(std::int64_t time) const noexcept {
    const std::int64_t after = time - time_;
    if (after > 0 && shown_ > INT64_MAX - after) return INT64_MAX;
    if (after < 0 && shown_ < INT64_MIN - after) return INT64_MIN;
    return shown_ + after;
  }

 private:
  std::int64_t shown_ = 0;
  std::int64_t time_ = 0;
};

}  // namespace tern

#endif
