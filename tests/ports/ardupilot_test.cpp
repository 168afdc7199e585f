// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// port/ardupilot's library and its hooks, compiled with ArduPilot's flags, run at 50 Hz over stand-ins for ArduPilot.
// What they do is read off the targets that they send.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <vector>

#include "AP_HAL/AP_HAL.h"
#include "AP_Tern.h"
#include "AP_Vehicle/AP_Vehicle.h"
#include "Copter.h"

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

const Vector3f kHere(0.5f, -2.0f, -1.5f);
const Vector3f kGoal(2.0f, 10.0f, -2.0f);
using State = AP_Tern::State;

double length(const Vector3f& v) {
  return std::hypot(std::hypot(v.x, v.y), v.z);
}

class Guided : public testing::Test {
 protected:
  void SetUp() override {
    ardupilot = ArduPilot{};
    vehicle = {true, kHere, Vector3f()};
    words.resize(tern_grid_words(kSpec.dims));
    tern.reset(new AP_Tern(workspace.get(), sizeof *workspace, words.data(), words.size()));
    ASSERT_TRUE(tern->set_map(kSpec, &kWall, 1));
  }
  /// Runs the scheduler's task; the vehicle follows. `each` runs before each update, with the seconds since now.
  void run(
      double seconds, const std::function<void(double)>& each = [](double) {}) {
    for (int i = 0; i < 50 * seconds; ++i) {
      each(0.02 * i);
      const std::size_t before = ardupilot.targets.size();
      tern->update(vehicle);
      if (ardupilot.targets.size() > before) vehicle.position = ardupilot.targets.back().position;
      if (ardupilot.targets.size() > before) vehicle.velocity = ardupilot.targets.back().velocity;
      ardupilot.now += 20000;
    }
  }
  void fly(double seconds) {
    ASSERT_TRUE(tern->fly_to(kGoal));
    run(seconds);
    ASSERT_EQ(tern->state(), State::FLYING);
  }
  /// At rest, short of the goal, and still sending; from target `first` on, there is no step.
  void expect_rest(std::size_t first) {
    EXPECT_EQ(tern->state(), State::STOPPING);
    const std::vector<Target>& all = ardupilot.targets;
    EXPECT_EQ(all.back().time, ardupilot.now - 20000);
    EXPECT_EQ(length(all.back().velocity), 0.0);
    EXPECT_EQ(length(all.back().acceleration), 0.0);
    EXPECT_GT(length(all.back().position - kGoal), 1.0);
    for (std::size_t i = first; i < all.size(); ++i) {
      const double fastest = std::max(length(all[i - 1].velocity), length(all[i].velocity));
      EXPECT_LE(length(all[i].position - all[i - 1].position), 0.02 * fastest + 1e-3);
      EXPECT_LE(length(all[i].velocity), length(all[i - 1].velocity) + 1e-3);
    }
  }

  AP_Tern::Vehicle vehicle;
  std::unique_ptr<tern::Workspace> workspace = std::make_unique<tern::Workspace>();
  std::vector<std::uint64_t> words;
  std::unique_ptr<AP_Tern> tern;
};

TEST_F(Guided, PlansInSlicesArrivesAndGoesOnSending) {
  ASSERT_TRUE(tern->fly_to(kGoal));
  tern->update(vehicle);
  EXPECT_EQ(tern->state(), State::PLANNING);  // one slice is not all
  EXPECT_TRUE(ardupilot.targets.empty());
  run(60.0);
  ASSERT_EQ(tern->state(), State::ARRIVED) << tern->status();
  EXPECT_LT(length(ardupilot.targets.front().position - kHere), 1e-6);
  const Target& last = ardupilot.targets.back();
  EXPECT_EQ(last.time, ardupilot.now - 20000);
  EXPECT_LT(length(last.position - kGoal), 1e-5);
  EXPECT_EQ(length(last.velocity), 0.0);
  EXPECT_EQ(length(last.acceleration), 0.0);
}

TEST_F(Guided, KeepsBelowArduPilotsLimitsAndTheRadius) {
  tern->parameters.wpnav_speed_m_s = 2.0;
  ASSERT_TRUE(tern->fly_to(Vector3f(0.0f, 10.0f, -2.0f)));
  run(60.0);
  ASSERT_GT(ardupilot.targets.size(), 200u);
  for (std::size_t i = 1; i < ardupilot.targets.size(); ++i) {
    const Target& a = ardupilot.targets[i - 1];
    const Target& b = ardupilot.targets[i];
    EXPECT_EQ(b.time - a.time, 20000u);
    EXPECT_LE(std::hypot(b.velocity.x, b.velocity.y), 2.0 + 1e-5);
    // The mean jerk between two targets; PSC_JERK_XY is 5 m/s^3, and plans use 0.9 of it.
    EXPECT_LE(std::hypot(b.acceleration.x - a.acceleration.x, b.acceleration.y - a.acceleration.y) / 0.02, 4.5 + 1e-3);
    const double east = std::max({4.0 - b.position.y, b.position.y - 5.0, 0.0});
    const double north = std::max({-3.0 - b.position.x, b.position.x - 3.0, 0.0});
    const double up = std::max({-b.position.z - 5.0, 0.0});
    EXPECT_GE(std::hypot(std::hypot(east, north), up), 0.6 - 1e-5);
  }
}

TEST_F(Guided, PlansFromWhereTheVehicleRests) {
  ASSERT_TRUE(tern->fly_to(kGoal));
  const Vector3f moved(1.1f, -2.0f, -1.5f);
  run(5.0, [&](double t) {
    if (t < 1.0) vehicle.velocity = Vector3f(1.0f, 0.0f, 0.0f);  // it does not rest
    if (t == 1.0) vehicle.velocity = Vector3f();
    if (t > 1.03 && ardupilot.targets.empty()) vehicle.position = moved;  // while the plan is made
  });
  ASSERT_FALSE(ardupilot.targets.empty());
  EXPECT_GE(ardupilot.targets.front().time, 6000000u);
  EXPECT_LT(length(ardupilot.targets.front().position - moved), 1e-6);
}

TEST_F(Guided, IsSilentWhereTheVehicleIsNotReady) {
  ASSERT_TRUE(tern->fly_to(kGoal));
  vehicle.ready = false;
  run(1.0);
  EXPECT_EQ(tern->state(), State::FAILED);
  EXPECT_TRUE(ardupilot.targets.empty());
  vehicle.ready = true;
  fly(3.0);
  const std::size_t sent = ardupilot.targets.size();
  vehicle.ready = false;
  run(1.0);
  vehicle.ready = true;  // the pilot's mode is over: the flight is not taken up again
  run(1.0);
  EXPECT_EQ(tern->state(), State::FAILED);
  EXPECT_STRNE(tern->reason(), "");
  EXPECT_EQ(ardupilot.targets.size(), sent);
}

TEST_F(Guided, EndsWhereArduPilotRefuses) {
  fly(3.0);
  ardupilot.guided = false;
  run(1.0);
  EXPECT_EQ(tern->state(), State::FAILED);
}

TEST_F(Guided, StopsAlongThePlan) {
  fly(3.5);
  const std::size_t sent = ardupilot.targets.size();
  tern->stop();
  run(0.1);
  EXPECT_FALSE(tern->fly_to(kGoal));  // it still moves
  run(4.0);
  expect_rest(sent);
  EXPECT_STREQ(tern->reason(), "stop");
  ASSERT_TRUE(tern->fly_to(kGoal));
  run(30.0);
  EXPECT_EQ(tern->state(), State::ARRIVED);
}

TEST_F(Guided, ComesToRestFromWhereTheVehicleIs) {
  for (const bool strays : {true, false}) {
    SetUp();
    fly(4.0);
    const std::size_t sent = ardupilot.targets.size();
    vehicle.position.z -= strays ? 1.5f : 0.5f;
    if (!strays) ardupilot.now += 500000;  // it flew on with the last velocity
    const Vector3f there = vehicle.position;
    run(4.0);
    EXPECT_LT(length(ardupilot.targets[sent].position - there), 0.08);
    expect_rest(sent + 1);
  }
}

TEST_F(Guided, SaysWhyThereIsNoPlan) {
  ASSERT_TRUE(tern->fly_to(Vector3f(0.0f, 4.5f, -2.0f)));  // in the wall
  run(2.0);
  EXPECT_EQ(tern->state(), State::FAILED);
  EXPECT_STREQ(tern->status(), "goal_occupied");
  EXPECT_TRUE(ardupilot.targets.empty());
  tern->parameters.wpnav_speed_m_s = 1000.0;  // centimetres
  EXPECT_FALSE(tern->fly_to(kGoal));
  EXPECT_STREQ(tern->reason(), "a parameter is out of range; they are in metres");
  AP_Tern without(nullptr, 0, words.data(), words.size());
  EXPECT_FALSE(without.fly_to(kGoal));
}

TEST_F(Guided, UserHooksConstructAndCallTheLibrary) {
  Mode mode;
  Motors motors;
  Copter copter{};
  copter.flightmode = &mode;
  copter.motors = &motors;
  copter.ahrs.position = kHere;
  const auto run_hook = [&](int updates) {
    for (int i = 0; i < updates; ++i) {
      copter.userhook_50Hz();
      if (!ardupilot.targets.empty()) copter.ahrs.position = ardupilot.targets.back().position;
      ardupilot.now += 20000;
    }
  };
  copter.userhook_init();
  run_hook(100);
  EXPECT_TRUE(ardupilot.targets.empty());  // nobody asked
  motors.is_armed = false;
  copter.userhook_auxSwitch1(RC_Channel::AuxSwitchPos::HIGH);
  run_hook(100);
  EXPECT_TRUE(ardupilot.targets.empty());
  motors.is_armed = true;
  copter.userhook_auxSwitch1(RC_Channel::AuxSwitchPos::HIGH);
  run_hook(2000);
  ASSERT_FALSE(ardupilot.targets.empty());
  EXPECT_LT(length(ardupilot.targets.back().position - kGoal), 1e-5);
  mode.number = Mode::Number::LOITER;
  const std::size_t sent = ardupilot.targets.size();
  run_hook(50);
  EXPECT_EQ(ardupilot.targets.size(), sent);
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
