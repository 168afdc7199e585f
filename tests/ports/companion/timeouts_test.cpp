// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the autopilots do once the companion program has crashed in flight: the facts behind COM_OF_LOSS_T and
// GUID_TIMEOUT, with the settings that docs/integration gives.
#include <gtest/gtest.h>

#include <cmath>

#include "autopilot/companion_flight.hpp"
#include "tern_onboard/pose.hpp"

namespace tern_autopilot {
namespace {

constexpr double kCrash = 6.0;  // s, at full speed

double apart(const tern::Vec3& a, const tern::Vec3& b) {
  return tern_onboard::length(tern_onboard::minus(a, b));
}

/// What happens after the crash.
struct After {
  double speed_before = 0.0;                ///< of the vehicle, m/s
  double left_at = 1e9;                     ///< when the mode was left, s
  double speed_until = 0.0, speed_now = 0;  ///< of the target: until the time-out, and at the end
  double led_on = 0.0;                      ///< how far the target moved on until the time-out, m
  double went_on = 0.0;                     ///< how far the vehicle did until the end, m
};

class CompanionCrashes : public testing::Test {
 protected:
  /// Flies until some seconds after the crash.
  FlightOutcome fly_with(bool is_px4, double timeout) {
    tern_host::FlightWorld world = tern_host::read_flight_world("P49@2:3", companion_world_settings());
    world.goal = {-16.0, 1.0, 1.5};
    CompanionFlight flight;
    flight.program = TERN_TEST_COMPANION;
    flight.autopilot.is_px4 = is_px4;
    flight.autopilot.loss_time = flight.autopilot.guided_timeout = timeout;
    flight.after_end = timeout + 5.0;
    bool is_over = false;
    tern::Vec3 led_from{}, from{};
    flight.pilot = [&](double t, const FlightHands& hands) {
      if (t < kCrash) plain_pilot(t, hands);
      const tern_host::Setpoint target = hands.autopilot.target(t);
      if (t >= kCrash && !is_over) {
        is_over = true;
        led_from = target.sample.position;
        from = hands.autopilot.vehicle().position();
        after_.speed_before = tern_onboard::length(hands.autopilot.vehicle().velocity());
        hands.companion.crash();
      }
      if (!is_over) return;
      if (!hands.autopilot.follows()) after_.left_at = std::min(after_.left_at, t);
      after_.speed_now = tern_onboard::length(target.sample.velocity);
      if (t < kCrash + timeout - 0.03) {
        after_.speed_until = after_.speed_now;
        after_.led_on = apart(target.sample.position, led_from);
      }
      after_.went_on = apart(hands.autopilot.vehicle().position(), from);
    };
    return fly(world, flight);
  }

  After after_;
};

TEST_F(CompanionCrashes, Px4LeavesOffboardAfterItsLossTimeAndHoldsTheLastSetpointUntilThen) {
  for (const double timeout : {0.5, 1.0}) {
    after_ = {};
    const FlightOutcome outcome = fly_with(true, timeout);
    EXPECT_GT(after_.speed_before, 1.0);
    EXPECT_GT(after_.left_at, kCrash + timeout - 0.03);
    EXPECT_LT(after_.left_at, kCrash + timeout + 0.03);
    EXPECT_EQ(outcome.counts.failsafes, 1u);
    EXPECT_EQ(after_.led_on, 0.0);
    EXPECT_GT(after_.speed_until, 1.0) << "but the velocity of that setpoint goes on";
    EXPECT_LT(outcome.speed_at_end, 0.3);
    EXPECT_FALSE(outcome.touched);
    std::printf("PX4, %.1f s: %.2f m on from %.2f m/s\n", timeout, after_.went_on, after_.speed_before);
  }
}

TEST_F(CompanionCrashes, ArdupilotGoesOnUntilItsTimeoutAndStaysInGuided) {
  for (const double timeout : {0.3, 3.0}) {
    after_ = {};
    const FlightOutcome outcome = fly_with(false, timeout);
    EXPECT_GT(after_.speed_before, 1.0);
    EXPECT_EQ(after_.left_at, 1e9);
    EXPECT_EQ(outcome.counts.failsafes, 1u);
    EXPECT_GT(after_.led_on, 0.8 * after_.speed_before * (timeout - 0.05));
    EXPECT_EQ(after_.speed_now, 0.0);
    std::printf("ArduPilot, %.1f s: %.2f m on from %.2f m/s, %s\n", timeout, after_.went_on, after_.speed_before,
                outcome.touched ? "touched" : "clear");
  }
}

}  // namespace
}  // namespace tern_autopilot
