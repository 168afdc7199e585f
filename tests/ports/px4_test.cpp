// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// port/px4's module, compiled with PX4's flags, run over stand-ins for PX4: a clock that its sleep lets run, and topics
// that are recorded.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "drivers/drv_hrt.h"
#include "parameters/param.h"
#include "px4_platform_common/tasks.h"
#include "uORB/topics/offboard_control_mode.h"
#include "uORB/topics/trajectory_setpoint.h"
#include "uORB/topics/vehicle_local_position.h"
#include "uORB/topics/vehicle_status.h"

extern "C" int tern_offboard_main(int argc, char* argv[]);

namespace {

/// PX4 as the module sees it.
struct Px4 {
  hrt_abstime now = 1000000;
  hrt_abstime offboard_at = 3000000;  ///< the pilot switches
  hrt_abstime end_at = 30000000;      ///< the pilot takes over again
  bool position_valid = true;
  int stack = 0;
  std::vector<trajectory_setpoint_s> setpoints;
  std::vector<offboard_control_mode_s> modes;
} px4;

int call(std::vector<std::string> words) {
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(&word[0]);
  return tern_offboard_main(static_cast<int>(argv.size()), argv.data());
}

double distance(const float* a, const float* b) {
  return std::hypot(std::hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]);
}

class Offboard : public testing::Test {
 protected:
  void SetUp() override { px4 = Px4{}; }
};

TEST_F(Offboard, StreamsAPlanInNorthEastDown) {
  ASSERT_EQ(call({"tern_offboard", "start", "10", "2", "2"}), 0);  // east, north, up
  EXPECT_GE(px4.stack, 10240);
  ASSERT_EQ(px4.setpoints.size(), px4.modes.size());
  ASSERT_GT(px4.setpoints.size(), 1000u);
  const float start[3] = {0.5f, -2.0f, -1.5f};
  const float goal[3] = {2.0f, 10.0f, -2.0f};
  EXPECT_LT(distance(px4.setpoints.front().position, start), 1e-6);
  EXPECT_LT(distance(px4.setpoints.back().position, goal), 1e-4);
  EXPECT_NEAR(px4.setpoints.front().yaw, 1.0, 1e-6);  // the vehicle's heading
  for (const offboard_control_mode_s& mode : px4.modes) EXPECT_TRUE(mode.position);
}

TEST_F(Offboard, HoversUntilThePilotSwitches) {
  ASSERT_EQ(call({"tern_offboard", "start", "10", "2", "2"}), 0);
  for (const trajectory_setpoint_s& setpoint : px4.setpoints) {
    if (setpoint.timestamp >= px4.offboard_at) break;
    EXPECT_EQ(distance(setpoint.position, px4.setpoints.front().position), 0.0);
  }
  const hrt_abstime waited = px4.offboard_at - px4.setpoints.front().timestamp;
  EXPECT_GT(waited, 1000000u);  // PX4 wants more than a second of setpoints before the switch
}

TEST_F(Offboard, KeepsTheRateTheLimitsAndTheDerivatives) {
  ASSERT_EQ(call({"tern_offboard", "start", "10", "2", "2"}), 0);
  double fastest = 0.0;
  for (std::size_t i = 1; i < px4.setpoints.size(); ++i) {
    const trajectory_setpoint_s& a = px4.setpoints[i - 1];
    const trajectory_setpoint_s& b = px4.setpoints[i];
    ASSERT_LE(b.timestamp - a.timestamp, 20000u);  // 50 Hz at least
    const double dt = static_cast<double>(b.timestamp - a.timestamp) * 1e-6;
    for (int k = 0; k < 3; ++k) {
      const double mean = 0.5 * (static_cast<double>(a.velocity[k]) + static_cast<double>(b.velocity[k]));
      EXPECT_NEAR((static_cast<double>(b.position[k]) - static_cast<double>(a.position[k])) / dt, mean, 2e-3);
    }
    const double speed = std::hypot(b.velocity[0], b.velocity[1]);
    fastest = std::max(fastest, speed);
    EXPECT_LE(std::hypot(b.acceleration[0], b.acceleration[1]), 3.0 + 1e-5);  // MPC_ACC_HOR
    EXPECT_LE(std::hypot(b.jerk[0], b.jerk[1]), 4.0 + 1e-5);                  // MPC_JERK_AUTO
  }
  EXPECT_LE(fastest, 2.5 + 1e-6);  // MPC_XY_VEL_MAX of this vehicle
  EXPECT_GT(fastest, 1.5);
}

TEST_F(Offboard, GoesRoundTheBox) {
  ASSERT_EQ(call({"tern_offboard", "start", "10", "0", "2"}), 0);
  for (const trajectory_setpoint_s& s : px4.setpoints) {
    // East 4 .. 5, north -3 .. 3, up 0 .. 5; the radius and the margin are 0.6 m.
    const double east = std::max({4.0 - s.position[1], s.position[1] - 5.0, 0.0});
    const double north = std::max({-3.0 - s.position[0], s.position[0] - 3.0, 0.0});
    const double up = std::max({-s.position[2] - 5.0, 0.0});
    EXPECT_GE(std::hypot(std::hypot(east, north), up), 0.6 - 1e-5);
  }
}

TEST_F(Offboard, SaysWhyThereIsNoStream) {
  ASSERT_EQ(call({"tern_offboard", "start", "4.5", "0", "2"}), 0);  // in the box
  EXPECT_TRUE(px4.setpoints.empty());
  px4.position_valid = false;
  ASSERT_EQ(call({"tern_offboard", "start", "10", "2", "2"}), 0);
  EXPECT_TRUE(px4.setpoints.empty());
  EXPECT_NE(call({"tern_offboard", "start", "10"}), 0);
  EXPECT_NE(call({"tern_offboard"}), 0);
}

}  // namespace

extern "C" {

hrt_abstime hrt_absolute_time() {
  return px4.now;
}

int px4_usleep(unsigned microseconds) {
  px4.now += microseconds;
  return 0;
}

px4_task_t px4_task_spawn_cmd(const char*, int, int, int stack_size, px4_main_t entry, char* const[]) {
  px4.stack = stack_size;
  entry(0, nullptr);
  return 1;
}

param_t param_find(const char* name) {
  return std::strcmp(name, "MPC_XY_VEL_MAX") == 0 ? 1 : 0;
}

int param_get(param_t param, void* value) {
  const float speed = 2.5f;
  if (param == 1) std::memcpy(value, &speed, sizeof speed);
  return param == 1 ? 0 : -1;
}

bool orb_publish(const orb_metadata* topic, const void* message) {
  if (std::strcmp(topic->name, "trajectory_setpoint") == 0) {
    px4.setpoints.push_back(*static_cast<const trajectory_setpoint_s*>(message));
  } else {
    px4.modes.push_back(*static_cast<const offboard_control_mode_s*>(message));
  }
  return true;
}

bool orb_copy(const orb_metadata* topic, void* message) {
  if (std::strcmp(topic->name, "vehicle_status") == 0) {
    const bool offboard = px4.now >= px4.offboard_at && px4.now < px4.end_at;
    *static_cast<vehicle_status_s*>(message) = {
        px4.now, offboard ? vehicle_status_s::NAVIGATION_STATE_OFFBOARD : vehicle_status_s::NAVIGATION_STATE_POSCTL};
    return true;
  }
  // North 0.5, east -2, down -1.5: that is (-2, 0.5, 1.5) in east, north, up.
  *static_cast<vehicle_local_position_s*>(message) = {px4.now, px4.position_valid, true, 0.5f, -2.0f, -1.5f, 1.0f};
  return true;
}

}  // extern "C"
