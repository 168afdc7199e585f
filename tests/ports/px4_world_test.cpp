// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The maps that port/px4's module refuses.
#include <gtest/gtest.h>

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

}  // namespace
