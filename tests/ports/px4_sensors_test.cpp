// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// port/px4's module with range sensors: what they show, and what the vehicle then does.
#include <gtest/gtest.h>

#include <algorithm>

#include "simulated_ranges.hpp"
#include "stand_in.hpp"

namespace {

double from_goal() {
  return px4.setpoints.empty() ? 100.0 : distance(px4.setpoints.back().position, kGoal);
}

class Sensors : public testing::Test {
 protected:
  void SetUp() override { px4 = Px4{}; }
};

TEST_F(Sensors, ThePillarIsInTheWayOfAFlightThatDoesNotSeeIt) {
  ASSERT_EQ(fly_with(kOpen, switch_mode, true), 0);
  EXPECT_LT(from_goal(), 1e-4);
  EXPECT_EQ(least_distance(kPillar), 0.0);
}

TEST_F(Sensors, FliesRoundWhatOnlyASensorSaw) {
  const std::function<void()> sensors[] = {
      [] { send(px4.distances[3], [] { return ahead(kPillar, 0.5f, 0.5f); }); },
      [] { send(px4.distances[1], [] { return ahead_by_quaternion(kPillar); }); },
      [] { send(px4.ring, [] { return around(kPillar, obstacle_distance_s::MAV_FRAME_BODY_FRD); }); },
      [] { send(px4.ring, [] { return around(kPillar, obstacle_distance_s::MAV_FRAME_LOCAL_NED); }); }};
  for (const auto& sensor : sensors) {
    px4 = Px4{};
    ASSERT_EQ(fly_with(kOpen,
                       [&](double t) {
                         switch_mode(t);
                         sensor();
                       }),
              0);
    EXPECT_LT(from_goal(), 1e-4);
    EXPECT_LT(largest_step(), 1e-3);
    EXPECT_GT(least_distance(kPillar), 0.3);
    EXPECT_EQ(count_setpoints([](double t) { return t < kSwitch || t > kEnd + 0.02; }), 0u);
    for (const trajectory_setpoint_s& s : px4.setpoints) {  // no higher and no lower than the sensor looks
      EXPECT_GE(-s.position[2], 1.2f - 1e-4f);
      EXPECT_LE(-s.position[2], 2.3f + 1e-4f);
    }
  }
}

/// The map has a wall that is not there: a sensor refutes it that is wide enough to show voxels free.
TEST_F(Sensors, OpensAWallOfTheMapThatAWideSensorRefutes) {
  for (const bool is_wide : {false, true}) {
    px4 = Px4{};
    const float field = is_wide ? 1.6f : 0.8f;
    ASSERT_EQ(fly_with(
                  std::string(kOpen) + "block 3 -12 0 3.4 12 8\n",
                  [&](double t) {
                    switch_mode(t);
                    send(px4.distances[0], [&] {
                      distance_sensor_s sensor = ahead(kPillar, field, field);
                      sensor.current_distance = -1.0f;  // as PX4's drivers say that nothing came back
                      sensor.signal_quality = 0;
                      return sensor;
                    });
                  },
                  !is_wide),
              0);
    if (is_wide) {
      EXPECT_LT(from_goal(), 1e-4);
    } else {
      EXPECT_GT(from_goal(), 7.0);
    }
  }
}

TEST_F(Sensors, HoversWithoutSensors) {
  const std::function<void()> sensors[] = {[] {},
                                           [] {  // too narrow
                                             send(px4.distances[0], [] { return ahead(kPillar, 0.06f, 0.06f); });
                                           },
                                           [] {  // it looks back
                                             send(px4.distances[0], [&] {
                                               distance_sensor_s back = ahead(kPillar, 0.5f, 0.5f);
                                               back.orientation = 4;
                                               return back;
                                             });
                                           },
                                           [] {  // the height above ground is no range ahead
                                             send(px4.distances[0], [&] {
                                               distance_sensor_s down = ahead(kPillar, 0.5f, 0.5f);
                                               down.orientation = distance_sensor_s::ROTATION_DOWNWARD_FACING;
                                               return down;
                                             });
                                           },
                                           [] {
                                             send(px4.distances[0], [&] {
                                               distance_sensor_s invalid = ahead(kPillar, 0.5f, 0.5f);
                                               invalid.signal_quality = 0;
                                               return invalid;
                                             });
                                           },
                                           [] {
                                             send(px4.distances[0], [&] {
                                               distance_sensor_s old = ahead(kPillar, 0.5f, 0.5f);
                                               old.timestamp = px4.now - 300000;
                                               return old;
                                             });
                                           }};
  for (const auto& sensor : sensors) {
    px4 = Px4{};
    ASSERT_EQ(fly_with(kOpen,
                       [&](double t) {
                         switch_mode(t);
                         sensor();
                       }),
              0);
    ASSERT_GT(px4.setpoints.size(), 1000u);
    for (const trajectory_setpoint_s& s : px4.setpoints) EXPECT_EQ(distance(s.position, kStart), 0.0);
  }
}

TEST_F(Sensors, ComesToRestWhenSensorsAreSilentAndGoesOnWhenTheyAreBack) {
  for (const bool comes_back : {false, true}) {
    px4 = Px4{};
    ASSERT_EQ(fly_with(kOpen,
                       [&](double t) {
                         switch_mode(t);
                         if (t < kMiddle || (comes_back && t > 15.0)) {
                           send(px4.distances[0], [] { return ahead(kPillar, 0.5f, 0.5f); });
                         }
                       }),
              0);
    for (const trajectory_setpoint_s& s : px4.setpoints) {
      const double t = 1e-6 * static_cast<double>(s.timestamp);
      if (t > kMiddle + 3.0 && t < 15.0) {
        EXPECT_EQ(speed(s), 0.0) << t;
      }
    }
    EXPECT_GT(least_distance(kPillar), 0.3);
    if (comes_back) {
      EXPECT_LT(from_goal(), 1e-4);
    } else {
      EXPECT_GT(from_goal(), 2.0);
    }
  }
}

/// Also in the next flight, which has a new map.
TEST_F(Sensors, SeesThePillarAgainAfterAReset) {
  bool jumped = false;
  ASSERT_EQ(fly_with(kOpen,
                     [&](double t) {
                       switch_mode(t);
                       send(px4.ring, [] { return around(kPillar, obstacle_distance_s::MAV_FRAME_BODY_FRD); });
                       if (t > 15.0 && t < 16.0) px4.status.nav_state = kPosition;
                       if (t < 5.0 || jumped) return;
                       jumped = true;
                       px4.local.xy_reset_counter = 1;
                       px4.local.y -= 0.4f;
                     }),
            0);
  EXPECT_GT(count_setpoints([](double t) { return t > 8.0 && t < 15.0; }), 340u);
  EXPECT_LT(from_goal(), 1e-4);
  EXPECT_GT(least_distance(kPillar), 0.3);
}

/// 0.25 m beside the setpoint, of a margin of 0.3 m.
TEST_F(Sensors, FliesSlowerWhereTheVehicleStrays) {
  ASSERT_EQ(fly_with(
                kOpen,
                [](double t) {
                  switch_mode(t);
                  if (!px4.setpoints.empty() && t > kSwitch) px4.local.x += 0.25f;
                },
                true),
            0);
  double fastest = 0.0;
  for (const trajectory_setpoint_s& s : px4.setpoints) {
    if (s.timestamp > 1e6 * (kSwitch + 4.0)) fastest = std::max(fastest, speed(s));
  }
  EXPECT_LT(fastest, 0.3);
  EXPECT_GT(fastest, 0.2);
}

}  // namespace
