// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What flights are compared with: the straight way at the limits.
#include "host/flight/straight_way.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace {

/// 3 m/s and 6 m/s^2; up and down at most 2 m/s and 6 m/s^2.
double time_to(const tern::Vec3& goal, const std::vector<tern::Vec3>& vias = {}) {
  tern_host::FlightWorld world;
  world.goal = goal;
  for (const tern::Vec3& at : vias) {
    world.vias.emplace_back();
    world.vias.back().position = at;
  }
  return straight_time(world);
}

TEST(StraightTime, IsAtTheLimits) {
  EXPECT_NEAR(time_to({30.0, 0.0, 0.0}), 10.0 + 0.5, 1e-12);
  EXPECT_NEAR(time_to({0.0, 0.0, -4.0}), 2.0 + 1.0 / 3.0, 1e-12);
  EXPECT_NEAR(time_to({0.6, 0.8, 0.0}), 2.0 * std::sqrt(1.0 / 6.0), 1e-12);  // it does not come to its speed
  EXPECT_NEAR(time_to({6.0, 0.0, 4.0}), 2.0 + std::sqrt(13.0) / std::sqrt(52.0), 1e-12);
  EXPECT_EQ(time_to({0.0, 0.0, 0.0}), 0.0);
}

TEST(StraightTime, LeadsThroughAllPoints) {
  EXPECT_NEAR(time_to({0.0, 0.0, 2.0}, {{9.0, 0.0, 0.0}, {9.0, 0.0, 2.0}}), 3.0 + 1.0 + 3.0 + 0.5, 1e-12);
}

}  // namespace
