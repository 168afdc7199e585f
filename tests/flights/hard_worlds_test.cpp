// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Flights that went wrong once, in campaigns of thousands: each must reach its goal, with all invariants.
#include <gtest/gtest.h>

#include <iterator>
#include <string>
#include <vector>

#include "host/flight/simulated_flight.hpp"
#include "support/random.hpp"

namespace {

struct HardWorld {
  const char* name;
  const char* what;
  std::vector<std::string> settings = {};  // besides those of a campaign
};

const HardWorld kHardWorlds[] = {
    {"P25@8:68", "braked towards a tree that it knew: only the plan that was to take over was blocked"},
    {"P25@8:85", "a brake along the path exceeded the limit of jerk"},
    {"C@6:8", "gave up before voxels that were too near to be seen: above the camera's view"},
    {"C@8:97", "likewise"},
    {"C@8:991", "came back to its start, where the operator had called a wall's outermost 4 cm free"},
    {"C@8:339", "left a place within the radius of an outlier while that was a threat: the watch knew no such place"},
    {"P25@5:7008",
     "rested at the goal, and a plan that led 7e-24 m away took over: the watch missed it",
     {"sensor=lidar", "speckle_filter=0", "hits=4"}},
    {"M:1200234",
     "sought ways through walls above and below what it had seen of them, and was on its way for 120 s",
     {"sensor=d435"}},
};

TEST(HardWorlds, AreCrossed) {
  for (int k = 0; k < tern_test::scaled(static_cast<int>(std::size(kHardWorlds))); ++k) {
    const HardWorld& hard = kHardWorlds[k];
    SCOPED_TRACE(std::string(hard.name) + " " + hard.what);
    std::vector<std::string> settings{"tracking=bounded", "tracking_margin=0.1", "depth_noise=0.01", "outliers=0.01"};
    settings.insert(settings.end(), hard.settings.begin(), hard.settings.end());
    const tern_host::FlightWorld world = tern_host::read_flight_world(hard.name, settings);
    const tern_host::FlightResult result = tern_host::simulate_flight(world);
    EXPECT_EQ(result.status, "reached") << result.reason;
    EXPECT_GT(result.min_clearance, world.settings.body_radius);
  }
}

}  // namespace
