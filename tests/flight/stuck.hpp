// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A vehicle at rest before voxels that nobody saw.
#ifndef TERN_TESTS_FLIGHT_STUCK_HPP
#define TERN_TESTS_FLIGHT_STUCK_HPP

#include <gtest/gtest.h>

#include <vector>

#include "base/math.hpp"
#include "base/work.hpp"
#include "support/flight_room.hpp"
#include "support/same.hpp"

namespace tern_test {

inline constexpr tern::Vec3 kLookoutGoal{8.125, 0.125, 1.125};

/// At rest before a plane of voxels that nobody saw, from 3 m to 3.5 m along x.
struct Stuck : FlightRoom {
  explicit Stuck(const std::vector<tern::Box>& solid = {}) : FlightRoom(flight_spec(), solid) {
    EXPECT_EQ(flight.set_goal(kLookoutGoal), tern::Status::kOk);
    set_seen(false);
    state().facts.time = 10 * std::int64_t{1000000000};
    look().note_tick(state().facts, {0, 0});
  }
  tern::Lookouts& look() { return state().lookouts; }
  void set_seen(bool seen) {
    tern::Grid safe = map().safe();
    const tern::Box box{{3.0, -16.0, -2.0}, {3.5, 16.0, 4.0}};
    EXPECT_EQ(seen ? safe.clear_box(box) : safe.mark_box(box), tern::Status::kOk);
    safe.inflate();
  }
  /// So many nanoseconds, plans and frames later.
  bool is_called_for(std::int64_t later, std::uint32_t plans, std::uint64_t frames, std::uint32_t dropped = 0) {
    state().facts.time = 10 * std::int64_t{1000000000} + later;
    state().facts.frames = frames;
    return look().is_called_for(state().facts, state().nose, {plans, dropped});
  }
  /// Searches, in as many slices of `units` as it takes.
  int search(std::uint32_t units = 100000) {
    look().begin(state().facts, state().nose, kLookoutGoal);
    int slices = 0;
    for (; look().is_searching() && slices < 100000; ++slices) {
      tern::Work work(units);
      look().advance(state().facts, work);
    }
    return slices;
  }
  void follow(std::int64_t later) {
    state().facts.time += later;
    look().follow(state().facts, state().nose, {state().report.asked, 0});
  }
};

}  // namespace tern_test

#endif
