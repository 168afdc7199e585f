// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_ONBOARD_LATENCY_HPP
#define TERN_ONBOARD_LATENCY_HPP

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace tern_onboard {

/// Times of a kind, to be told as a median, a 99th percentile and the largest. Nanoseconds.
class Durations {
 public:
  void add(std::int64_t duration);
  /// "12.3 / 20.1 / 25.0 ms (440)", or "none". Of the last 4096.
  std::string text() const;

 private:
  std::vector<std::int64_t> last_;
  std::uint64_t added_ = 0;
};

/// How old frames are on their way to a setpoint, as median / 99 % / most (how many).
struct FrameAges {
  std::string to_arrival, to_map, to_setpoint;
};

/// How old a frame is when the first setpoint is sent that rests on it. A setpoint rests on a frame if the plan that it
/// follows was committed after the frame had entered the map: what proved the plan saw the frame.
class Latency {
 public:
  void arrived(std::int64_t stamp, std::int64_t now) { to_arrival_.add(now - stamp); }
  /// After a tick: the stamp of the newest frame in the map, and how many plans the flight has committed.
  void ticked(std::int64_t newest, std::uint32_t committed, bool at_rest, std::int64_t now);
  void sent(std::int64_t now);
  FrameAges ages() const { return {to_arrival_.text(), to_map_.text(), to_setpoint_.text()}; }

 private:
  std::int64_t last_ = 0;
  std::uint32_t committed_ = 0;
  std::vector<std::int64_t> in_map_, resting_;
  Durations to_arrival_, to_map_, to_setpoint_;
};

}  // namespace tern_onboard

#endif
