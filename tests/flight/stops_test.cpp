// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Stops while a plan is about to take over. What is flown may be blocked beyond that takeover, and nothing would prove
// it again: the plan stays until a brake is proven.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/flight_room.hpp"
#include "support/random.hpp"

namespace {

using namespace tern;
using tern_test::FlightRoom;
using tern_test::Flying;

/// A plan that turns to a new goal is about to take over from one that a box beside the way blocks beyond that.
struct Turning : Flying {
  Box box{};
  bool is_ready = false;

  Turning(double ahead, double side) {
    const FlightState& s = state();
    flight.set_goal({position().x + 1.5, 6.125, 1.125});
    if (!tick_until([&] { return s.facts.plans.has_waiting && !s.facts.plans.waiting.evades; }, 60)) return;
    const Vec3 p = evaluate(s.facts.plans.in_flight.trajectory,
                            seconds_between(s.facts.plans.in_flight.begin(), s.facts.plans.waiting.begin()))
                       .position;
    box = {{p.x + ahead, p.y - 1.0, -2.0}, {p.x + ahead + kCell, p.y + side, 4.0}};
    mark(box);
    tick();
    is_ready = s.facts.plans.has_waiting && !s.facts.plans.waiting.evades && report.mode != FlightMode::kThreat &&
               is_blocked(s.facts.plans.in_flight);
  }
  bool is_blocked(const Commitment& flown) {
    const double from = std::max(0.0, seconds_between(flown.begin(), time));
    return clear_until(map().safe(), flown.trajectory, from, nullptr, Beyond::kSolid) < duration(flown.trajectory);
  }
  double gap() const {
    const Vec3 q = position();
    const double dx = std::max({box.lower.x - q.x, q.x - box.upper.x, 0.0});
    const double dy = std::max({box.lower.y - q.y, q.y - box.upper.y, 0.0});
    return std::hypot(dx, dy);
  }
  /// Until the vehicle rests, or a threat is reported.
  void expect_radius_or_threat() {
    for (int k = 0; k < 600 && report.mode != FlightMode::kThreat; ++k) {
      tick();
      ASSERT_TRUE(gap() >= kRadius - 1e-6 || report.mode == FlightMode::kThreat) << gap() << " m at " << speed();
    }
    EXPECT_TRUE(report.mode == FlightMode::kThreat || report.mode == FlightMode::kRest);
  }
};

/// Calls `end` with the plan so many ticks before its takeover, for boxes at many places; how many there were.
template <typename End>
int try_ends(int ticks_before, End end) {
  int tried = 0;
  constexpr double kSides[] = {-0.45, -0.3, -0.49, -0.4, -0.2};
  for (int k = 0; k < tern_test::scaled(5); ++k) {
    const double side = kSides[k];
    for (double ahead = 0.4; ahead < 2.2; ahead += 0.1) {
      Turning room(ahead, side);
      const FlightState& s = room.state();
      if (!room.is_ready) continue;
      while (s.facts.plans.has_waiting && s.facts.plans.waiting.begin() - room.time > ticks_before * room.spec.tick)
        room.tick();
      if (!s.facts.plans.has_waiting || room.report.mode == FlightMode::kThreat) continue;
      ++tried;
      end(room);
      room.expect_radius_or_threat();
      EXPECT_EQ(room.report.reason, FlightReason::kNoGoal) << ahead << ", " << side;
      if (testing::Test::HasFailure()) return tried;
    }
  }
  return tried;
}

TEST(FlightStops, PlanThatWaitsIsKeptUntilABrakeIsProven) {
  constexpr int kTicks[] = {2, 1, 3, 4, 6};
  for (int k = 0; k < tern_test::scaled(5); ++k) {
    const int tried = try_ends(kTicks[k], [](Turning& room) { room.flight.stop(); });
    EXPECT_GT(tried, 5) << kTicks[k];
  }
}

/// A mission that ends because its next point is in an obstacle.
TEST(FlightStops, PlanThatWaitsIsKeptWhereAMissionEnds) {
  const int tried = try_ends(4, [](Turning& room) {
    const Via points[2] = {{{1.0, 2.0, 1.0}}, {{2.0, 2.0, 1.0}}};
    room.flight.set_mission(points, 2, ViaPolicy::kEnd);
    EXPECT_TRUE(room.state().leave_out(0, FlightReason::kNoGoal));
  });
  EXPECT_GT(tried, 5);
}

/// No brake is proven in time: the plan takes over, and is braked from there.
TEST(FlightStops, StopIsTriedAgainFromThePlanThatTookOver) {
  Turning room(1.6, -0.45);
  FlightState& state = room.state();
  ASSERT_TRUE(room.is_ready);
  const std::int64_t begin = state.facts.plans.waiting.begin();
  const double end = seconds_between(0, begin) + duration(state.facts.plans.waiting.trajectory);
  ASSERT_GE(begin, room.time + kEvadeTicks * room.spec.tick);
  room.flight.stop();
  room.advance(tern_test::kNothing);
  ASSERT_TRUE(state.evasion.is_running);
  room.flight.stop();  // once more: the pending brake is the one
  ASSERT_TRUE(state.evasion.is_running);
  room.time = state.draft.deadline;
  room.advance(tern_test::kNothing);
  EXPECT_FALSE(state.is_busy());
  ASSERT_TRUE(state.facts.plans.has_waiting);
  EXPECT_EQ(state.facts.plans.waiting.begin(), begin);
  EXPECT_TRUE(state.evasion.stop_asked);
  room.time = begin;
  room.tick();
  EXPECT_TRUE(state.facts.plans.has_waiting || state.evasion.is_running);
  ASSERT_TRUE(room.tick_until([&] { return room.speed() == 0.0; }, 200));
  EXPECT_LT(seconds_between(0, room.time), end - 0.5);
}

/// A brake is about to take over: there is nothing left to stop, even where the map has changed and it was proven anew.
TEST(FlightStops, BrakeThatWaitsIsEnough) {
  for (const bool changes : {false, true}) {
    Flying room;
    FlightState& state = room.state();
    room.flight.stop();
    ASSERT_TRUE(room.tick_until([&] { return state.facts.plans.has_waiting; }, 10));
    const std::int64_t begin = state.facts.plans.waiting.begin();
    const std::uint32_t committed = state.report.committed;
    if (changes) room.mark({{-8.0, -8.0, 0.0}, {-7.75, -7.75, 2.0}});
    if (changes) room.watch(4000);
    EXPECT_NE(state.evasion.was_tried, changes);
    room.flight.stop();
    room.tick();
    ASSERT_TRUE(state.facts.plans.has_waiting);
    EXPECT_EQ(state.facts.plans.waiting.begin(), begin);
    EXPECT_EQ(state.report.committed, committed);
    EXPECT_EQ(room.fly(400), FlightReason::kNoGoal);
    EXPECT_EQ(state.report.committed, committed);
  }
}

}  // namespace
