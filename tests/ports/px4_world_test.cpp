// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The map of port/px4's module: what is refused, and what it keeps.
#include <gtest/gtest.h>

#include "simulated_ranges.hpp"
#include "stand_in.hpp"

namespace {

TEST(World, IsRefusedIfItCannotBeReadOrFlownIn) {
  px4 = Px4{};
  px4.script = [] { switch_mode(px4.seconds()); };
  const std::string open = kOpen;
  const std::string lines[] = {"boundary -5 -10 0.5 15 10 6\nresolution 0.25\nradius 0.3\nv_horizontal 1\n",
                               open + "block 4 0 0 5 6\n",
                               open + "block 5 0 0 4 6 3\n",
                               open + "block 4 0 0 5 6 three\n",
                               open + "block 4 0 0 5 6 nan\n",
                               open + "block 1 2 3 4 5 6 7 8 9 10\n",
                               open + "resolution 0\n",
                               open + "via 1 2 3\n",
                               open + "octomap wood.bt\n",
                               open + "# " + std::string(300, '.') + "\n",
                               open + "resolution 0.02\n",              // too many voxels
                               open + "block -3 -1 0 -1 1 5\n",         // the vehicle is in it
                               open + "boundary 0 -10 0.5 15 10 6\n",   // and outside
                               open + "block 9 1 0 11 3 5\n",           // the goal is in it
                               open + "boundary -5 -10 0.5 9 10 6\n"};  // and outside
  for (const std::string& text : lines) {
    EXPECT_EQ(fly_with(text, switch_mode), 0);
    EXPECT_TRUE(px4.modes.empty()) << text;
  }
  EXPECT_EQ(call({"tern_offboard", "start", "10", "2", "2", "/nowhere/map.txt", "blind"}), 0);
  EXPECT_TRUE(px4.modes.empty());
  EXPECT_NE(call({"tern_offboard", "start", "10", "2", "2", std::string(200, 'm'), "blind"}), 0);
  EXPECT_NE(call({"tern_offboard", "start", "10", "2", "2", TERN_PX4_WORLD, "deaf"}), 0);
}

/// A ring that shows the pillar until `until` and then nothing: it adds obstacles, and refutes none.
void send_ring(double t, double until) {
  constexpr Solid kNothing = {{1e4, 1e4, 1e4}, {2e4, 2e4, 2e4}};
  const Solid& there = t < until ? kPillar : kNothing;
  send(px4.ring, [&there] { return around(there, obstacle_distance_s::MAV_FRAME_BODY_FRD); });
}

double from_goal() {
  return px4.setpoints.empty() ? 100.0 : distance(px4.setpoints.back().position, kGoal);
}

/// The pilot takes over once the pillar was seen, flies back and switches again: no sensor shows it any more.
TEST(World, KeepsForTheNextFlightWhatSensorsSaw) {
  px4 = Px4{};
  constexpr double kAgain = 15.0;
  ASSERT_EQ(fly_with(kOpen,
                     [](double t) {
                       switch_mode(t);
                       if (t >= kMiddle && t < kAgain) px4.status.nav_state = kPosition;
                       if (t >= kMiddle && t < kAgain) px4.local = Px4::hover();
                       send_ring(t, kMiddle);
                     }),
            0);
  EXPECT_GT(count_setpoints([](double t) { return t > kSwitch && t < kMiddle; }), 100u);
  EXPECT_LT(from_goal(), 1e-4);
  EXPECT_GT(least_distance(kPillar, kAgain), 0.3);
  // The next start knows the file alone.
  px4 = Px4{};
  ASSERT_EQ(fly_with(kOpen,
                     [](double t) {
                       switch_mode(t);
                       send_ring(t, 0.0);
                     }),
            0);
  EXPECT_LT(from_goal(), 1e-4);
  EXPECT_EQ(least_distance(kPillar), 0.0);
}

/// A companion writes what it knows into the file: each start reads it, also after a restart.
TEST(World, IsReadFromTheFileAtEachStart) {
  const std::string pillar = std::string(kOpen) + "block 3 0.6 0 3.6 1.6 5\n";
  for (const std::string& text : {std::string(kOpen), pillar, pillar}) {
    px4 = Px4{};
    ASSERT_EQ(fly_with(text, switch_mode, true), 0);
    EXPECT_LT(from_goal(), 1e-4);
    if (text == kOpen) {
      EXPECT_EQ(least_distance(kPillar), 0.0);
    } else {
      EXPECT_GT(least_distance(kPillar), 0.3);
    }
  }
}

}  // namespace
