// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tern_onboard/latency.hpp"

#include <algorithm>
#include <cstdio>

namespace tern_onboard {
namespace {

constexpr std::size_t kMost = 4096;  // two minutes of frames at 30 Hz

}  // namespace

void Durations::add(std::int64_t duration) {
  if (last_.size() < kMost) {
    last_.push_back(duration);
  } else {
    last_[added_ % kMost] = duration;
  }
  ++added_;
}

std::string Durations::text() const {
  if (last_.empty()) return "none";
  std::vector<std::int64_t> sorted = last_;
  std::sort(sorted.begin(), sorted.end());
  const auto at = [&](double share) {
    return 1e-6 * static_cast<double>(sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))]);
  };
  char line[96];
  std::snprintf(line, sizeof line, "%.1f / %.1f / %.1f ms (%llu)", at(0.5), at(0.99), at(1.0),
                static_cast<unsigned long long>(added_));
  return line;
}

void Latency::ticked(std::int64_t newest, std::uint32_t committed, bool at_rest, std::int64_t now) {
  // At rest, frames lead to no plan for a long time, and say nothing. With fewer plans, it is another flight.
  if (at_rest || committed < committed_) in_map_.clear();
  if (committed > committed_) {
    resting_.insert(resting_.end(), in_map_.begin(), in_map_.end());
    in_map_.clear();
  }
  committed_ = committed;
  if (newest <= last_) return;
  last_ = newest;
  to_map_.add(now - newest);
  if (!at_rest) in_map_.push_back(newest);  // what was committed in this tick did not see it
}

void Latency::sent(std::int64_t now) {
  for (const std::int64_t stamp : resting_) to_setpoint_.add(now - stamp);
  resting_.clear();
}

}  // namespace tern_onboard
