// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// port/ardupilot's library, compiled with ArduPilot's flags, run at 50 Hz over stand-ins for ArduPilot.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "AP_HAL/AP_HAL.h"
#include "AP_Tern.h"
#include "AP_Vehicle/AP_Vehicle.h"

namespace {

struct Target {
  std::uint64_t time;
  Vector3f position, velocity, acceleration;
};

struct ArduPilot {
  std::uint64_t now = 5000000;
  bool guided = true;
  std::vector<Target> targets;
} ardupilot;

constexpr tern::GridSpec kSpec = {{-5, -10, -1}, 0.2, {100, 100, 35}, {{-5, -10, 0.5}, {15, 10, 6}}, 0.3, 0.3};
constexpr tern::Box kWall = {{4, -3, 0}, {5, 3, 5}};

const Vector3f here(0.5f, -2.0f, -1.5f);

class Guided : public testing::Test {
 protected:
  void SetUp() override {
    ardupilot = ArduPilot{};
    words.resize(tern_grid_words(kSpec.dims));
    tern.reset(new AP_Tern(workspace.get(), sizeof *workspace, words.data(), words.size()));
    ASSERT_TRUE(tern->set_map(kSpec, &kWall, 1));
  }
  /// Runs the scheduler's task for up to `seconds`.
  void run(double seconds) {
    for (int i = 0; i < 50 * seconds && tern->state() != AP_Tern::State::ARRIVED; ++i) {
      tern->update();
      ardupilot.now += 20000;
    }
  }

  std::unique_ptr<tern::Workspace> workspace = std::make_unique<tern::Workspace>();
  std::vector<std::uint64_t> words;
  std::unique_ptr<AP_Tern> tern;
};

TEST_F(Guided, PlansInSlicesAndArrives) {
  ASSERT_TRUE(tern->fly_to(here, Vector3f(2.0f, 10.0f, -2.0f)));
  tern->update();
  EXPECT_EQ(tern->state(), AP_Tern::State::PLANNING);  // one slice is not all
  run(60.0);
  ASSERT_EQ(tern->state(), AP_Tern::State::ARRIVED) << tern->status();
  const Target& last = ardupilot.targets.back();
  EXPECT_NEAR(last.position.x, 2.0, 1e-5);
  EXPECT_NEAR(last.position.y, 10.0, 1e-5);
  EXPECT_NEAR(last.position.z, -2.0, 1e-5);
  EXPECT_NEAR(ardupilot.targets.front().position.y, -2.0, 1e-6);
}

TEST_F(Guided, KeepsArduPilotsLimitsAndTheRadius) {
  tern->parameters.wpnav_speed_m_s = 2.0;
  ASSERT_TRUE(tern->fly_to(here, Vector3f(0.0f, 10.0f, -2.0f)));
  run(60.0);
  ASSERT_GT(ardupilot.targets.size(), 200u);
  for (std::size_t i = 1; i < ardupilot.targets.size(); ++i) {
    const Target& a = ardupilot.targets[i - 1];
    const Target& b = ardupilot.targets[i];
    EXPECT_EQ(b.time - a.time, 20000u);
    EXPECT_LE(std::hypot(b.velocity.x, b.velocity.y), 2.0 + 1e-5);
    // The mean jerk between two targets; PSC_JERK_XY is 5 m/s^3.
    EXPECT_LE(std::hypot(b.acceleration.x - a.acceleration.x, b.acceleration.y - a.acceleration.y) / 0.02, 5.0 + 1e-3);
    const double east = std::max({4.0 - b.position.y, b.position.y - 5.0, 0.0});
    const double north = std::max({-3.0 - b.position.x, b.position.x - 3.0, 0.0});
    const double up = std::max({-b.position.z - 5.0, 0.0});
    EXPECT_GE(std::hypot(std::hypot(east, north), up), 0.6 - 1e-5);
  }
}

TEST_F(Guided, StopsWhereGuidedModeEnds) {
  ASSERT_TRUE(tern->fly_to(here, Vector3f(2.0f, 10.0f, -2.0f)));
  run(3.0);
  ASSERT_EQ(tern->state(), AP_Tern::State::FLYING);
  ardupilot.guided = false;
  run(1.0);
  EXPECT_EQ(tern->state(), AP_Tern::State::FAILED);
}

TEST_F(Guided, SaysWhyThereIsNoPlan) {
  ASSERT_TRUE(tern->fly_to(here, Vector3f(0.0f, 4.5f, -2.0f)));  // in the wall
  run(2.0);
  EXPECT_EQ(tern->state(), AP_Tern::State::FAILED);
  EXPECT_STREQ(tern->status(), "goal_occupied");
  EXPECT_TRUE(ardupilot.targets.empty());
  AP_Tern without(nullptr, 0, words.data(), words.size());
  EXPECT_FALSE(without.fly_to(here, Vector3f(2.0f, 10.0f, -2.0f)));
}

}  // namespace

std::uint64_t AP_HAL::micros64() {
  return ardupilot.now;
}

AP_Vehicle* AP::vehicle() {
  static AP_Vehicle vehicle;
  return &vehicle;
}

bool AP_Vehicle::set_target_posvelaccel_NED(const Vector3f& target_pos, const Vector3f& target_vel,
                                            const Vector3f& target_accel, bool, float, bool, float, bool) {
  if (ardupilot.guided) ardupilot.targets.push_back({ardupilot.now, target_pos, target_vel, target_accel});
  return ardupilot.guided;
}
