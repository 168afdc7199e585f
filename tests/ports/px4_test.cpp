// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// port/px4's module, compiled with PX4's flags, run over stand-ins for PX4. What it does is read off the messages that
// it sends.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "stand_in.hpp"

namespace {

void expect_arrival() {
  ASSERT_FALSE(px4.setpoints.empty());
  EXPECT_LT(distance(px4.setpoints.back().position, kGoal), 1e-4);
  EXPECT_LT(speed(px4.setpoints.back()), 1e-6);
  EXPECT_LT(largest_step(), 1e-3);
}

/// The setpoints end at rest, short of the goal.
void expect_rest() {
  ASSERT_FALSE(px4.setpoints.empty());
  EXPECT_EQ(speed(px4.setpoints.back()), 0.0);
  EXPECT_GT(distance(px4.setpoints.back().position, kGoal), 1.0);
}

/// Rate, limits, and each setpoint's agreement with its neighbours.
void expect_kept(double most) {
  double fastest = 0.0;
  for (std::size_t i = 1; i < px4.setpoints.size(); ++i) {
    const trajectory_setpoint_s& a = px4.setpoints[i - 1];
    const trajectory_setpoint_s& b = px4.setpoints[i];
    ASSERT_EQ(b.timestamp - a.timestamp, 20000u);
    for (int k = 0; k < 3; ++k) {
      const double mean = 0.5 * (static_cast<double>(a.velocity[k]) + static_cast<double>(b.velocity[k]));
      EXPECT_NEAR((static_cast<double>(b.position[k]) - static_cast<double>(a.position[k])) / 0.02, mean, 2e-3);
    }
    fastest = std::max(fastest, std::hypot(static_cast<double>(b.velocity[0]), static_cast<double>(b.velocity[1])));
    EXPECT_LE(std::hypot(b.acceleration[0], b.acceleration[1]), 3.0 + 1e-5);  // MPC_ACC_HOR
    EXPECT_LE(std::hypot(b.jerk[0], b.jerk[1]), 4.0 + 1e-5);                  // MPC_JERK_AUTO
  }
  EXPECT_LE(fastest, most + 1e-6);
  EXPECT_GT(fastest, 0.95 * most);
}

class Offboard : public testing::Test {
 protected:
  void SetUp() override { px4 = Px4{}; }
};

TEST_F(Offboard, StreamsAPlanInNorthEastDown) {
  ASSERT_EQ(fly(switch_mode), 0);
  EXPECT_GE(px4.stack, 10240);
  ASSERT_GT(px4.setpoints.size(), 1000u);
  EXPECT_LT(distance(px4.setpoints.front().position, kStart), 1e-6);
  EXPECT_NEAR(px4.setpoints.front().yaw, 1.0, 1e-6);  // the vehicle's heading
  expect_arrival();
}

TEST_F(Offboard, ProofOfLifeComesAlwaysAndSetpointsOnlyInOffboard) {
  ASSERT_EQ(fly(switch_mode), 0);
  EXPECT_EQ(count_setpoints([](double t) { return t < kSwitch || t > kEnd + 0.02; }), 0u);
  EXPECT_EQ(px4.modes.front().timestamp, 1000000u);
  for (std::size_t i = 1; i < px4.modes.size(); ++i) {
    EXPECT_EQ(px4.modes[i].timestamp - px4.modes[i - 1].timestamp, 20000u);
    EXPECT_TRUE(px4.modes[i].position);
  }
}

TEST_F(Offboard, BeginsOnlyArmedAndInTheAir) {
  ASSERT_EQ(fly([](double t) {
              switch_mode(t);
              px4.status.arming_state = t < 5.0 ? kDisarmed : kArmed;
              px4.land.landed = t < 6.0;
            }),
            0);
  EXPECT_EQ(count_setpoints([](double t) { return t < 6.0; }), 0u);
  EXPECT_LT(distance(px4.setpoints.front().position, kStart), 1e-6);
  expect_arrival();
}

TEST_F(Offboard, HoldsTheGoalUntilThePilotTakesOverAndEndsThen) {
  ASSERT_EQ(fly(switch_mode), 0);
  EXPECT_GT(count_setpoints([](double t) { return t > kEnd - 5.0; }), 245u);
  EXPECT_NEAR(px4.seconds(), kEnd, 0.1);
}

/// Return, a landing and a disarming end the plan; the next switch plans from where the vehicle is then.
TEST_F(Offboard, IsSilentInOtherModesAndBeginsAnewAtTheNextSwitch) {
  const std::function<void(bool)> leaves[] = {[](bool away) { px4.status.nav_state = away ? kReturn : kOffboard; },
                                              [](bool away) { px4.status.arming_state = away ? kDisarmed : kArmed; },
                                              [](bool away) { px4.land.landed = away; }};
  for (const auto& leave : leaves) {
    px4 = Px4{};
    float back[3] = {};
    ASSERT_EQ(fly([&](double t) {
                switch_mode(t);
                if (t < kMiddle || t >= kEnd) return;
                leave(t < kMiddle + 3.0);
                if (t < kMiddle + 3.0) px4.local = Px4::hover();  // PX4 flies it elsewhere
                px4.local.y -= t < kMiddle + 3.0 ? 1.0f : 0.0f;
                if (t < kMiddle + 3.0) std::copy_n(&px4.local.x, 3, back);
              }),
              0);
    EXPECT_EQ(count_setpoints([](double t) { return t >= kMiddle && t < kMiddle + 3.0; }), 0u);
    const auto again = std::find_if(px4.setpoints.begin(), px4.setpoints.end(),
                                    [](const auto& s) { return s.timestamp >= 1e6 * (kMiddle + 3.0); });
    ASSERT_NE(again, px4.setpoints.end());
    EXPECT_LT(distance(again->position, back), 1e-6);
    EXPECT_LT(distance(px4.setpoints.back().position, kGoal), 1e-4);
  }
}

TEST_F(Offboard, PlansAnewWhereTheVehicleHasMovedBeforeTheSwitch) {
  px4.call_time = 100;  // us: the new plan takes more than one period
  const float moved[3] = {-0.1f, -2.0f, -1.5f};
  ASSERT_EQ(fly([](double t) {
              switch_mode(t);
              if (t < kSwitch) px4.local.x = -0.1f;  // 0.6 m off
            }),
            0);
  EXPECT_LT(distance(px4.setpoints.front().position, moved), 1e-6);
  expect_arrival();
}

TEST_F(Offboard, ComesToRestBeforeItPlansWhereTheVehicleMovesAtTheSwitch) {
  ASSERT_EQ(fly([](double t) {
              switch_mode(t);
              if (t < kSwitch + 2.0) px4.local.vx = 1.0f;
            }),
            0);
  for (const trajectory_setpoint_s& s : px4.setpoints) {
    if (s.timestamp < 5000000u) EXPECT_EQ(distance(s.position, px4.setpoints.front().position), 0.0);
  }
  expect_arrival();
}

TEST_F(Offboard, PlansAnewAfterATurnOrAResetBeforeTheSwitch) {
  for (const bool is_reset : {false, true}) {
    px4 = Px4{};
    ASSERT_EQ(fly([&](double t) {
                switch_mode(t);
                if (t < 2.0) return;
                px4.local.heading = is_reset ? 1.1f : -3.0f;
                px4.local.heading_reset_counter = is_reset ? 1 : 0;
              }),
              0);
    EXPECT_NEAR(px4.setpoints.front().yaw, is_reset ? 1.1 : -3.0, 1e-6);
    expect_arrival();
  }
}

TEST_F(Offboard, ComesToRestWhenTheEstimatorIsReset) {
  uint8_t vehicle_local_position_s::*const counters[] = {
      &vehicle_local_position_s::xy_reset_counter, &vehicle_local_position_s::z_reset_counter,
      &vehicle_local_position_s::vxy_reset_counter, &vehicle_local_position_s::vz_reset_counter,
      &vehicle_local_position_s::heading_reset_counter};
  for (const auto counter : counters) {
    px4 = Px4{};
    px4.local.*counter = 255;  // the counters wrap
    bool jumped = false;
    float there[3] = {};
    ASSERT_EQ(fly([&](double t) {
                switch_mode(t);
                if (t < kMiddle || jumped) return;
                jumped = true;
                px4.local.*counter = 0;
                px4.local.x += 0.8f;
                std::copy_n(&px4.local.x, 3, there);
              }),
              0);
    expect_rest();
    const auto first = std::find_if(px4.setpoints.begin(), px4.setpoints.end(),
                                    [](const auto& s) { return s.timestamp >= 1e6 * kMiddle; });
    EXPECT_LT(distance(first->position, there), 0.06);  // on from where the vehicle is, a period on
    EXPECT_GT(count_setpoints([](double t) { return t > kEnd - 1.0; }), 45u);
    for (auto s = first + 1; s != px4.setpoints.end(); ++s) {
      EXPECT_LE(speed(*s), speed(s[-1]) + 1e-3);
      if (s->timestamp > 1e6 * (kMiddle + 1.5)) EXPECT_EQ(speed(*s), 0.0);
    }
  }
}

TEST_F(Offboard, EndsTheStreamWithoutAnEstimate) {
  const std::function<void()> losses[] = {
      [] { px4.local.xy_valid = false; },   [] { px4.local.z_valid = false; },
      [] { px4.local.v_xy_valid = false; }, [] { px4.local.v_z_valid = false; },
      [] { px4.is_stale = true; },          [] { px4.local.z = std::numeric_limits<float>::quiet_NaN(); }};
  for (const auto& lose : losses) {
    px4 = Px4{};
    ASSERT_EQ(fly([&](double t) {
                switch_mode(t);
                if (t >= kMiddle) lose();
              }),
              0);
    EXPECT_LE(px4.seconds(), kMiddle + 0.3);
    EXPECT_EQ(count_setpoints([](double t) { return t > kMiddle + 0.21; }), 0u);
    px4.setpoints.clear();  // and it does not begin without one
    px4.status.nav_state = kPosition;
    ASSERT_EQ(fly(switch_mode), 0);
    EXPECT_TRUE(px4.setpoints.empty());
  }
}

/// And goes on from there, with a new plan, where the pilot switches off and on.
TEST_F(Offboard, ComesToRestWhenTheStreamStoodStill) {
  for (const bool again : {false, true}) {
    px4 = Px4{};
    bool stood = false;
    ASSERT_EQ(fly([&](double t) {
                switch_mode(t);
                if (again && t > 15.0 && t < 16.0) px4.status.nav_state = kPosition;
                if (t < kMiddle || stood) return;
                stood = true;
                px4.now += 500000;
              }),
              0);
    if (!again) expect_rest();
    if (again) expect_arrival();
  }
}

TEST_F(Offboard, StopsAlongThePlanAndEndsThere) {
  ASSERT_EQ(fly([&](double t) {
              switch_mode(t);
              if (t >= kMiddle) call({"tern_offboard", "stop"});
            }),
            0);
  expect_rest();
  EXPECT_LT(largest_step(), 1e-3);
  EXPECT_LT(px4.seconds(), kMiddle + 2.0);
  for (std::size_t i = 1; i + 1 < px4.setpoints.size(); ++i) {
    const trajectory_setpoint_s& a = px4.setpoints[i - 1];
    const trajectory_setpoint_s& b = px4.setpoints[i];
    if (1e-6 * static_cast<double>(a.timestamp) < kMiddle + 0.03 || speed(b) < 0.02) continue;
    for (int k = 0; k < 3; ++k) EXPECT_NEAR((b.velocity[k] - a.velocity[k]) / 0.02f, a.acceleration[k], 0.2);
  }
  px4 = Px4{};
  ASSERT_EQ(fly([&](double t) {
              if (t >= 2.0) call({"tern_offboard", "stop"});
            }),
            0);
  EXPECT_TRUE(px4.setpoints.empty());
  EXPECT_LT(px4.seconds(), 2.1);
}

/// v_horizontal of the map, or 0.7 of MPC_XY_VEL_MAX where that is less.
TEST_F(Offboard, KeepsTheRateTheLimitsAndTheDerivatives) {
  for (const float parameter : {12.0f, 1.0f}) {
    px4 = Px4{};
    px4.speed_parameter = parameter;
    ASSERT_EQ(fly(switch_mode), 0);
    expect_kept(std::min(1.0, 0.7 * static_cast<double>(parameter)));
  }
}
TEST_F(Offboard, GoesRoundTheBox) {
  px4.script = [] { switch_mode(px4.seconds()); };
  ASSERT_EQ(call({"tern_offboard", "start", "10", "0", "2", TERN_PX4_WORLD, "blind"}), 0);
  ASSERT_GT(px4.setpoints.size(), 1000u);
  for (const trajectory_setpoint_s& s : px4.setpoints) {
    // East 4 .. 5, north -3 .. 3, up 0 .. 5; the radius and the margin are 1 m.
    const double east = std::max({4.0 - s.position[1], s.position[1] - 5.0, 0.0});
    const double north = std::max({-3.0 - s.position[0], s.position[0] - 3.0, 0.0});
    const double up = std::max({-s.position[2] - 5.0, 0.0});
    EXPECT_GE(std::hypot(std::hypot(east, north), up), 1.0 - 1e-5);
  }
}

TEST_F(Offboard, RefusesWhatItCannotFly) {
  px4.script = [] { switch_mode(px4.seconds()); };
  EXPECT_EQ(call({"tern_offboard", "start", "4.5", "0", "2", TERN_PX4_WORLD, "blind"}), 0);  // in the box
  for (const float speed : {0.0f, -1.0f, 1200.0f, std::numeric_limits<float>::quiet_NaN()}) {
    px4.speed_parameter = speed;
    EXPECT_EQ(fly(switch_mode), 0);
  }
  px4 = Px4{};
  px4.status.nav_state = kOffboard;  // somebody else's
  EXPECT_EQ(fly([](double) {}), 0);
  for (const char* word : {"", "1O", "2,5", "nan", "1e9"}) {
    EXPECT_NE(call({"tern_offboard", "start", "10", word, "2", TERN_PX4_WORLD}), 0) << word;
  }
  EXPECT_NE(call({"tern_offboard", "start", "10", "2", "2"}), 0);  // no map
  EXPECT_NE(call({"tern_offboard"}), 0);
  EXPECT_TRUE(px4.setpoints.empty());
  EXPECT_TRUE(px4.modes.empty());
  px4 = Px4{};
  ASSERT_EQ(fly([](double t) {
              switch_mode(t);
              if (t < kEnd) EXPECT_NE(call({"tern_offboard", "start", "10", "0", "2"}), 0);  // it is running
            }),
            0);
  expect_arrival();
}

}  // namespace
