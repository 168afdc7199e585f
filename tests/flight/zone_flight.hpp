// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A flight among boxes that are fences, for a while or always.
#ifndef TERN_TESTS_FLIGHT_ZONE_FLIGHT_HPP
#define TERN_TESTS_FLIGHT_ZONE_FLIGHT_HPP

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <vector>

#include "base/math.hpp"
#include "base/work.hpp"
#include "flight/closing.hpp"
#include "support/flight_room.hpp"
#include "support/random.hpp"
#include "tern/fence.hpp"

namespace tern_test {

/// Fences of boxes, which stay where they are.
class Zones {
 public:
  void add(tern::FenceKind kind, const tern::Box& box, double from, double until, double clock_error = 0.0) {
    planes_.emplace_back();
    tern::box_planes(box, planes_.back().of);
    boxes.push_back(box);
    list.push_back({planes_.back().of, tern::kBoxPlanes, kind, static_cast<std::int64_t>(from * 1e9),
                    static_cast<std::int64_t>(until * 1e9), clock_error});
  }
  std::vector<tern::Fence> list;
  std::vector<tern::Box> boxes;

 private:
  struct Planes {
    tern::Halfspace of[tern::kBoxPlanes];
  };
  std::deque<Planes> planes_;
};

inline double gap(const tern::Box& box, const tern::Vec3& p) {
  double square = 0.0;
  for (int a = 0; a < 3; ++a) {
    const double off =
        std::max({tern::axis(box.lower, a) - tern::axis(p, a), tern::axis(p, a) - tern::axis(box.upper, a), 0.0});
    square += off * off;
  }
  return std::sqrt(square);
}

/// A flight in the room whose commands are held against the zones at each tick.
struct ZoneFlight : FlightRoom {
  explicit ZoneFlight(const Zones& around, std::int64_t tick = kTick) : FlightRoom(with(around, tick)), zones(around) {}

  static constexpr std::int64_t kTick = 10000000;
  static tern::FlightSpec with(const Zones& zones, std::int64_t tick = kTick) {
    tern::FlightSpec how = flight_spec();
    how.tick = tick;
    how.fences = zones.list.data();
    how.fence_count = static_cast<std::int32_t>(zones.list.size());
    return how;
  }
  /// The fence that the vehicle breaks where it is; tern::kNoFence if it breaks none.
  std::int32_t broken() const {
    const tern::Vec3 p = position();
    bool has_chain = false;
    bool is_in = false;
    for (std::size_t k = 0; k < zones.list.size(); ++k) {
      const tern::Fence& fence = zones.list[k];
      const bool holds = !tern::is_timed(fence) || (time > fence.from && time < fence.until);
      const bool keeps_out = fence.kind == tern::FenceKind::kKeepOut;
      if (keeps_out && holds && gap(zones.boxes[k], p) < kRadius - 1e-6) return static_cast<std::int32_t>(k);
      has_chain = has_chain || (!keeps_out && tern::is_timed(fence));
      is_in = is_in || (!keeps_out && holds && gap(zones.boxes[k], p) < 1e-6);
    }
    return has_chain && !is_in ? 0 : tern::kNoFence;
  }
  /// Ticks to a time; false as soon as a fence is broken.
  bool fly_to(double seconds) {
    while (time < static_cast<std::int64_t>(seconds * 1e9)) {
      tick();
      if (broken() != tern::kNoFence) return false;
    }
    return true;
  }
  bool is_at(const tern::Vec3& place) const { return tern::length(position() - place) < 1e-3; }

  const Zones& zones;
};

}  // namespace tern_test

#endif
