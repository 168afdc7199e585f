// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Simulated flight stacks beside measurements of PX4's own controllers (docs/simulator.md).
#include "host/flight/stack_margin.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "margins/flown.hpp"

namespace {

using tern_bench::largest_error;
using tern_bench::stack_settings;

/// Largest errors in metres: without wind and with drag 0.1, then in a wind of 5 m/s with drag 0.3, each with an
/// MPC_XY_VEL_MAX of 12 and of v.
struct MeasuredRow {
  double v, jerk;
  double calm, calm_clipped, windy, windy_clipped;
};

double flown_error(const std::vector<tern::Trajectory>& plans, double speed, double drag, double wind) {
  tern_host::FlightSettings settings = stack_settings("px4", speed, drag, wind);
  settings.air.has_angle = settings.air.has_gusts = true;
  return largest_error(plans, settings, 1);
}

TEST(StackMargin, SimulatedPx4StraysAsPx4sOwnControllersDo) {
  const MeasuredRow rows[] = {{5.0, 0.0, 0.73, 0.68, 0.77, 1.70}, {5.0, 5.0, 0.58, 0.65, 0.77, 1.61}};
  tern_bench::Plans plans;
  for (const MeasuredRow& row : rows) {
    const std::vector<tern::Trajectory> flown = plans.of(tern_bench::equal_limits(row.v, row.jerk));
    EXPECT_NEAR(flown_error(flown, 12.0, 0.1, 0.0), row.calm, 0.2 * row.calm) << row.jerk;
    EXPECT_NEAR(flown_error(flown, row.v, 0.1, 0.0), row.calm_clipped, 0.2 * row.calm_clipped) << row.jerk;
    EXPECT_NEAR(flown_error(flown, 12.0, 0.3, 5.0), row.windy, 0.2 * row.windy) << row.jerk;
    EXPECT_NEAR(flown_error(flown, row.v, 0.3, 5.0), row.windy_clipped, 0.2 * row.windy_clipped) << row.jerk;
  }
}

TEST(StackMargin, HoldsTheWorstOfAllSeedsAndTheEstimate) {
  tern_bench::Plans plans;
  const tern::Trajectory plan = plans.of(tern_bench::preset_limits("ardupilot", 2.0)).front();
  tern_host::FlightSettings settings = stack_settings("ardupilot", 4.0, 0.1, 5.0);
  settings.pose_margin = 0.1;
  settings.seed = 4;
  const tern_host::StackMargin margin = tern_host::measure_margin(plan, settings, 3);
  EXPECT_EQ(margin.flights, 3);
  EXPECT_LE(margin.estimate, 0.1 + 1e-9);
  EXPECT_GT(margin.estimate, 0.05);
  double worst = 0.0;
  for (settings.seed = 4; settings.seed < 7; ++settings.seed) {
    const double error = tern_host::fly_plan(plan, settings).tracking_max;
    EXPECT_EQ(settings.seed == margin.worst_seed, error == margin.controller);
    worst = std::max(worst, error);
  }
  EXPECT_EQ(margin.controller, worst);
  EXPECT_GE(margin.needed(), margin.controller + margin.estimate - 1e-9);
  EXPECT_LT(margin.needed(), margin.controller + margin.estimate + 0.01);
  EXPECT_DOUBLE_EQ(tern_host::up_to_centimetres(0.12), 0.12);
  EXPECT_DOUBLE_EQ(tern_host::up_to_centimetres(0.1201), 0.13);
}

}  // namespace
