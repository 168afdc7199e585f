// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Scenario files: what is read, and that every error names the file, the line and the reason (F23).

#include "host/scenario.hpp"

#include <gtest/gtest.h>

#include <clocale>
#include <string>

#include "host/grid_layout.hpp"
#include "host/scenario_errors.hpp"

namespace {

using tern_host::parse_scenario;
using tern_host::Scenario;
using tern_test::error_of;
using tern_test::kMinimal;

void expect_vec(const tern::Vec3& v, double x, double y, double z) {
  EXPECT_DOUBLE_EQ(v.x, x);
  EXPECT_DOUBLE_EQ(v.y, y);
  EXPECT_DOUBLE_EQ(v.z, z);
}

TEST(Scenario, DefaultsHoldWhereNothingIsSaid) {
  const Scenario s = parse_scenario(kMinimal, "map.txt");
  EXPECT_EQ(s.name, "map.txt");
  EXPECT_DOUBLE_EQ(s.resolution, 0.1);
  EXPECT_DOUBLE_EQ(s.radius, 0.25);
  expect_vec(s.limits.v_max, 2, 2, 2);
  expect_vec(s.limits.a_max, 2, 2, 2);
  expect_vec(s.start.velocity, 0, 0, 0);
  expect_vec(s.goal.acceleration, 0, 0, 0);
  expect_vec(s.boundary.upper, 4, 3, 2);
  EXPECT_TRUE(s.blocks.empty());
}

TEST(Scenario, EveryRecordIsRead) {
  const Scenario s = parse_scenario(
      "# a map\n"
      "boundary -1 -2 -3 4 5 6   # trailing comment\r\n"
      "\n"
      "\tblock 0 0 0 1 1 1\n"
      "block 1 1 1 2 2 2 255 0 12.5\n"
      "keepout 2 2 2 3 3 3\n"
      "start .5 1. -1e-1\n"
      "goal +2 3 4E0\n"
      "start_velocity 0.1 0.2 0.3\nstart_acceleration 0.4 0.5 0.6\n"
      "goal_velocity 1 2 3\ngoal_acceleration 4 5 6\n"
      "start_jerk 0.7 0.8 0.9\ngoal_jerk 7 8 9\nj_max 5 6 7\nj_horizontal 4.5\n"
      "resolution 0.05\nradius 0\ntracking_margin 0.15\nv_max 3\na_max 1 2 3\n"
      "v_min -1 -2 -0.5\na_min -4\nv_horizontal 2.5\na_horizontal 1.5\ntime_weight 7",
      "m");
  ASSERT_EQ(s.blocks.size(), 3u);
  EXPECT_FALSE(s.blocks[1].keepout);
  EXPECT_TRUE(s.blocks[2].keepout);
  expect_vec(s.blocks[1].box.upper, 2, 2, 2);
  expect_vec(s.start.position, 0.5, 1, -0.1);
  expect_vec(s.goal.position, 2, 3, 4);
  expect_vec(s.start.velocity, 0.1, 0.2, 0.3);
  expect_vec(s.start.acceleration, 0.4, 0.5, 0.6);
  expect_vec(s.goal.velocity, 1, 2, 3);
  expect_vec(s.goal.acceleration, 4, 5, 6);
  expect_vec(s.start.jerk, 0.7, 0.8, 0.9);
  expect_vec(s.goal.jerk, 7, 8, 9);
  expect_vec(s.limits.j_max, 5, 6, 7);
  EXPECT_DOUBLE_EQ(s.limits.j_horizontal, 4.5);
  EXPECT_DOUBLE_EQ(s.resolution, 0.05);
  EXPECT_DOUBLE_EQ(s.radius, 0);
  EXPECT_DOUBLE_EQ(s.tracking_margin, 0.15);
  EXPECT_DOUBLE_EQ(s.clearance(), 0.15);
  expect_vec(s.limits.v_max, 3, 3, 3);
  expect_vec(s.limits.a_max, 1, 2, 3);
  expect_vec(s.limits.v_min, -1, -2, -0.5);
  expect_vec(s.limits.a_min, -4, -4, -4);
  EXPECT_DOUBLE_EQ(s.limits.v_horizontal, 2.5);
  EXPECT_DOUBLE_EQ(s.limits.a_horizontal, 1.5);
  EXPECT_DOUBLE_EQ(s.time_weight, 7);
}

TEST(Scenario, LimitsAreWrittenOutWhereTheyAreNotGiven) {
  const Scenario s = parse_scenario(kMinimal + "v_max 1 2 3\nv_min 0 0 -0.5\na_horizontal 1\n", "m");
  const tern_host::LimitRange velocity = tern_host::velocity_range(s.limits);
  expect_vec(velocity.upper, 1, 2, 3);
  expect_vec(velocity.lower, -1, -2, -0.5);
  EXPECT_DOUBLE_EQ(velocity.horizontal, 0);
  const tern_host::LimitRange acceleration = tern_host::acceleration_range(s.limits);
  expect_vec(acceleration.lower, -2, -2, -2);
  EXPECT_DOUBLE_EQ(acceleration.horizontal, 1);
}

TEST(Scenario, NumbersDoNotFollowTheLocale) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  const bool comma = std::setlocale(LC_ALL, "de_DE.UTF-8") != nullptr;
  const Scenario s = parse_scenario(kMinimal + "resolution 0.25\n", "m");
  std::setlocale(LC_ALL, before.c_str());
  EXPECT_DOUBLE_EQ(s.resolution, 0.25);
  if (!comma) GTEST_SKIP() << "no locale with a decimal comma is installed; read in the C locale only";
}

TEST(Scenario, AGridThatIsTooLargeComesWithAResolutionThatFits) {
  const std::string ends = "start 1 1 1\ngoal 2 2 1\n";
  const std::string maps[] = {
      "boundary 0 0 0 100 100 100\n",                                // too many voxels
      "boundary 0 0 0 1e5 3 3\n",                                    // too many along an axis
      "boundary 0 0 0 777 77 7\nblock -1 0 0 3 3 3\nradius 31.4\n",  // padded for the radius
      "boundary 0 0 0 1e300 3 3\n",                                  // none fits
  };
  for (const std::string& map : maps) {
    const std::string message = error_of(map + ends, {"resolution=0.01"});
    const std::size_t at = message.find("; a resolution of ");
    if (map.find("1e300") != std::string::npos) {
      EXPECT_EQ(at, std::string::npos) << message;
      continue;
    }
    ASSERT_NE(at, std::string::npos) << message;
    const double fitting = std::stod(message.substr(at + 18));
    EXPECT_EQ(error_of(map + ends, {"resolution=" + std::to_string(fitting)}), "") << message;
    // Not much finer than that.
    EXPECT_NE(error_of(map + ends, {"resolution=" + std::to_string(0.85 * fitting)}), "") << message;
  }
}

TEST(Scenario, ViasHaveAToleranceAStopOrAVelocity) {
  const Scenario s =
      parse_scenario(kMinimal +
                         "via 1 2 1\nvia 2 2 1 0.25\nvia 3 2 1 stop\nvia 3 1 1 0.5 stop\n"
                         "via 2 1 1 0.1 velocity 1 -0.5 0\nvia 1 1 1 dwell 2.5\nvia 1 1 1 0.1 stop dwell 0\n",
                     "map.txt");
  ASSERT_EQ(s.vias.size(), 7u);
  expect_vec(s.vias[0].position, 1, 2, 1);
  EXPECT_EQ(s.vias[0].tolerance, 0.0);
  EXPECT_FALSE(s.vias[0].stop);
  EXPECT_EQ(s.vias[1].tolerance, 0.25);
  EXPECT_TRUE(s.vias[2].stop);
  EXPECT_EQ(s.vias[2].tolerance, 0.0);
  EXPECT_TRUE(s.vias[3].stop);
  EXPECT_EQ(s.vias[3].tolerance, 0.5);
  EXPECT_TRUE(s.vias[4].has_velocity);
  EXPECT_FALSE(s.vias[4].stop);
  expect_vec(s.vias[4].velocity, 1, -0.5, 0);
  EXPECT_TRUE(s.vias[5].stop);
  EXPECT_EQ(s.vias[5].dwell, 2.5);
  EXPECT_TRUE(s.vias[6].stop);
  EXPECT_EQ(s.vias[6].tolerance, 0.1);
}

TEST(Scenario, ViasThatAreNoneSayWhy) {
  EXPECT_EQ(error_of(kMinimal + "via 1 2\n"), "map.txt:4: 'via' needs 3 numbers, or 4 with a tolerance, found 2");
  EXPECT_NE(error_of(kMinimal + "via 1 2 1 stop 3\n"), "");
  EXPECT_NE(error_of(kMinimal + "via 1 2 1 velocity 3\n"), "");
  EXPECT_NE(error_of(kMinimal + "via 1 2 1 slowly\n"), "");
  EXPECT_EQ(error_of(kMinimal + "via 1 2 1 dwell\n"), "map.txt:4: 'dwell' needs 1 number of seconds, found 0");
  EXPECT_EQ(error_of(kMinimal + "via 1 2 1 dwell -1\n"), "map.txt:4: 'dwell' is 0 to 3600 seconds, found '-1'");
  EXPECT_NE(error_of(kMinimal + "via 1 2 1 dwell nan\n"), "");
  EXPECT_NE(error_of(kMinimal + "via 1 2 1 dwell 3601\n"), "");
  EXPECT_NE(error_of(kMinimal + "via 1 2 1 dwell 3 stop\n"), "");
  EXPECT_NE(error_of(kMinimal + "via 1 2 1 velocity 1 0 0 dwell 3\n"), "");
  std::string many = kMinimal;
  for (int v = 0; v <= tern::kMaxVias; ++v) many += "via 1 2 1\n";
  EXPECT_EQ(error_of(many), "map.txt:20: more than 16 vias");
}

TEST(Scenario, OverridesReplaceOrCompleteRecords) {
  const Scenario s = parse_scenario(kMinimal + "radius 0.5\n", "m",
                                    {"radius=0.1", "goal=1,2,0.5", "start=0.5 1 1", "v_max=1,2, 3", "a_max=4"});
  EXPECT_DOUBLE_EQ(s.radius, 0.1);
  expect_vec(s.goal.position, 1, 2, 0.5);
  expect_vec(s.start.position, 0.5, 1, 1);
  expect_vec(s.limits.v_max, 1, 2, 3);
  expect_vec(s.limits.a_max, 4, 4, 4);
  const Scenario completed = parse_scenario("boundary 0 0 0 1 1 1\nstart 0 0 0\n", "m", {"goal=1,1,1"});
  expect_vec(completed.goal.position, 1, 1, 1);
}

TEST(GridLayout, CoversTheBoundaryFromItsLowerCorner) {
  const tern::GridSpec exact = tern_host::lay_out_grid(parse_scenario(kMinimal, "m"));
  EXPECT_EQ(exact.dims.x, 40);
  EXPECT_EQ(exact.dims.y, 30);
  EXPECT_EQ(exact.dims.z, 20);
  expect_vec(exact.origin, 0, 0, 0);
  EXPECT_DOUBLE_EQ(exact.radius, 0.25);
  const tern::GridSpec rounded_up = tern_host::lay_out_grid(parse_scenario(kMinimal, "m", {"resolution=0.3"}));
  EXPECT_EQ(rounded_up.dims.x, 14);
  EXPECT_EQ(rounded_up.dims.y, 10);
  EXPECT_EQ(rounded_up.dims.z, 7);
}

TEST(GridLayout, WidensForBlocksBeyondTheBoundary) {
  const Scenario inside = parse_scenario(kMinimal + "block 0 0 0 4 3 1\n", "m");
  EXPECT_EQ(tern_host::lay_out_grid(inside).dims.x, 40);
  // 0.25 m are 2.5 voxels: three whole ones and one more on every side.
  const Scenario beyond = parse_scenario(kMinimal + "block 4.1 0 0 4.2 3 1\n", "m");
  const tern::GridSpec spec = tern_host::lay_out_grid(beyond);
  EXPECT_EQ(spec.dims.x, 48);
  EXPECT_EQ(spec.dims.y, 38);
  EXPECT_EQ(spec.dims.z, 28);
  expect_vec(spec.origin, -0.4, -0.4, -0.4);
  expect_vec(spec.boundary.lower, 0, 0, 0);
  expect_vec(spec.boundary.upper, 4, 3, 2);
}

}  // namespace
