// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A flight in a room that is known to be free, with its state in sight. Lengths are sums of powers of two, so that they
// add up without rounding.
#ifndef TERN_TESTS_SUPPORT_FLIGHT_ROOM_HPP
#define TERN_TESTS_SUPPORT_FLIGHT_ROOM_HPP

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <new>
#include <vector>

#include "flight/flight_state.hpp"
#include "support/owned_map.hpp"
#include "tern/flight.hpp"

namespace tern_test {

/// 32 x 32 x 6 m around the origin, cells of 0.25 m, and a radius of 0.5 m. The vehicle rests in a voxel's centre.
class FlightRoom {
 public:
  static constexpr double kCell = 0.25;
  static constexpr double kRadius = 0.5;

  static tern::MapSpec map_spec() { return tern::map_spec({-16.0, -16.0, -2.0}, kCell, {128, 128, 24}, kRadius); }
  static tern::FlightSpec flight_spec(std::uint32_t work_per_tick = 4000) {
    const tern::Limits limits{{3.0, 3.0, 2.0}, {6.0, 6.0, 6.0}};
    tern::FlightSpec spec = tern::flight_spec(limits);
    spec.work_per_tick = work_per_tick;
    spec.plan_work = 4 * work_per_tick;
    spec.stale_after = 0;  // nothing is seen here
    return spec;
  }

  explicit FlightRoom(const tern::FlightSpec& how = flight_spec(), const std::vector<tern::Box>& solid = {},
                      const tern::MapSpec& mapped = map_spec())
      : spec(how), owned(mapped), memory(new tern::Workspace), planner(memory.get(), sizeof *memory) {
    EXPECT_EQ(map().assume_free(start, 40.0), tern::Status::kOk);
    for (const tern::Box& box : solid) mark(box);
    words.resize(tern::flight_words(map_spec().dims));
    EXPECT_EQ(flight.start(spec, map(), planner, words.data(), words.size(), start, 0), tern::Status::kOk);
  }

  tern::RollingMap& map() { return owned.map; }
  void mark(const tern::Box& box) { EXPECT_EQ(map().mark_box(box), tern::Status::kOk); }
  /// In the first of the flight's words.
  tern::FlightState& state() { return *std::launder(reinterpret_cast<tern::FlightState*>(words.data())); }

  void tick() {
    EXPECT_EQ(flight.tick(time, report), tern::Status::kOk);
    time += spec.tick;
  }
  /// Ticks until it holds; false where it never does in so many.
  template <typename Condition>
  bool tick_until(Condition holds, int most = 2000) {
    for (int k = 0; k < most; ++k) {
      tick();
      if (holds()) return true;
    }
    return false;
  }
  /// Until the vehicle rests for a reason.
  tern::FlightReason fly(int most = 2000) {
    tick_until([&] { return report.mode == tern::FlightMode::kRest && report.reason != tern::FlightReason::kNone; },
               most);
    return report.reason;
  }
  tern::Vec3 position() const { return flight.command(time).sample.position; }
  double speed() const {
    const tern::Vec3 v = flight.command(time).sample.velocity;
    return std::hypot(v.x, std::hypot(v.y, v.z));
  }

  const tern::Vec3 start{0.125, 0.125, 1.125};
  tern::FlightSpec spec;
  OwnedMap owned;
  std::unique_ptr<tern::Workspace> memory;
  tern::Planner planner;
  std::vector<std::uint64_t> words;
  tern::Flight flight;
  tern::FlightReport report{};
  std::int64_t time = 0;
};

/// No work, so that no piece of anything is done.
constexpr std::uint32_t kNothing = 0;

/// On the way to 8 m along x, with all of it committed, and parts of ticks.
struct Flying : FlightRoom {
  explicit Flying(const tern::FlightSpec& how = flight_spec()) : FlightRoom(how) {
    flight.set_goal({8.125, 0.125, 1.125});
    EXPECT_TRUE(
        tick_until([&] { return speed() > 2.5 && !state().is_busy() && !state().facts.plans.has_waiting; }, 400));
  }
  void watch(std::uint32_t units) {
    state().tick_work = tern::Work{units};
    state().facts.time = time;
    state().run_watch();
  }
  void advance(std::uint32_t units) {
    state().tick_work = tern::Work{units};
    state().facts.time = time;
    state().advance();
  }
};

}  // namespace tern_test

#endif
