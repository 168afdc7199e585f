// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_COMPANION_LATENCY_HPP
#define TERN_COMPANION_LATENCY_HPP

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

namespace tern_companion {

/// Times of a kind, to be told as a median, a 99th percentile and the largest. Nanoseconds.
class Durations {
 public:
  void add(std::int64_t duration) { all_.push_back(duration); }
  std::size_t count() const { return all_.size(); }
  /// "12.3 / 20.1 / 25.0 ms (440)", or "none".
  std::string text() const {
    if (all_.empty()) return "none";
    std::vector<std::int64_t> sorted = all_;
    std::sort(sorted.begin(), sorted.end());
    const auto at = [&](double share) {
      return 1e-6 *
             static_cast<double>(sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))]);
    };
    char line[80];
    std::snprintf(line, sizeof line, "%.1f / %.1f / %.1f ms (%zu)", at(0.5), at(0.99), at(1.0), sorted.size());
    return line;
  }

 private:
  std::vector<std::int64_t> all_;
};

/// How old an image is when the first setpoint is sent that rests on it. A setpoint rests on an image if the plan that
/// it follows was committed after the image had entered the map: what proved the plan saw the image.
class Latency {
 public:
  void arrived(std::int64_t stamp, std::int64_t now) { to_arrival_.add(now - stamp); }
  /// The newest image in the map has this stamp.
  void entered(std::int64_t stamp, std::int64_t now) {
    if (stamp <= last_) return;
    last_ = stamp;
    to_map_.add(now - stamp);
    in_map_.push_back(stamp);
  }
  void committed() {
    resting_.insert(resting_.end(), in_map_.begin(), in_map_.end());
    in_map_.clear();
  }
  void sent(std::int64_t now) {
    for (const std::int64_t stamp : resting_) to_setpoint_.add(now - stamp);
    resting_.clear();
  }
  /// The flight rests: its images lead to no plan for a long time, and say nothing.
  void rested() { in_map_.clear(); }
  std::string text() const {
    return "from an image's stamp, median / 99 % / most (images): to its arrival " + to_arrival_.text() +
           ", to its entry into the map " + to_map_.text() + ", to the first setpoint that rests on it " +
           to_setpoint_.text();
  }

 private:
  std::int64_t last_ = 0;
  std::vector<std::int64_t> in_map_, resting_;
  Durations to_arrival_, to_map_, to_setpoint_;
};

}  // namespace tern_companion

#endif
