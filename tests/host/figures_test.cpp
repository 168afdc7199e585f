// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Tables, figures and peaks of trajectories that are known by hand.
#include "host/figures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "host/peaks.hpp"
#include "host/plan_file.hpp"
#include "support/random.hpp"

namespace {

/// One segment from rest at x = 0 to rest at x = 1 in `duration` seconds.
tern::Trajectory unit_step(double duration) {
  tern::Trajectory trajectory{};
  trajectory.count = 1;
  trajectory.segments[0].duration = duration;
  for (int i = 4; i < tern::kControlPoints; ++i) trajectory.segments[0].points[i].x = 1.0;
  return trajectory;
}

TEST(TrajectoryCsv, HasARowAStepAndTheEndOnce) {
  const std::string csv = tern_host::trajectory_csv(unit_step(0.3), 0.1);
  std::istringstream lines(csv);
  std::vector<std::string> rows;
  for (std::string line; std::getline(lines, line);) rows.push_back(line);
  ASSERT_EQ(rows.size(), 5u);
  EXPECT_EQ(rows[0], "t,px,py,pz,vx,vy,vz,ax,ay,az,jx,jy,jz,sx,sy,sz");
  EXPECT_EQ(rows[1].substr(0, 6), "0,0,0,");
  EXPECT_EQ(rows[2].substr(0, 4), "0.10");
  EXPECT_NE(rows[4].find(",1,0,0,0,0,0,"), std::string::npos) << rows[4];
  for (const std::string& row : rows) EXPECT_EQ(std::count(row.begin(), row.end(), ','), 15) << row;
}

TEST(TrajectoryCsv, RefusesStepsThatMakeNoTable) {
  EXPECT_THROW(tern_host::trajectory_csv(unit_step(1.0), 0.0), std::invalid_argument);
  EXPECT_THROW(tern_host::trajectory_csv(unit_step(1.0), -1.0), std::invalid_argument);
  EXPECT_THROW(tern_host::trajectory_csv(unit_step(1.0), 1e-9), std::invalid_argument);
  EXPECT_THROW(tern_host::trajectory_csv(unit_step(1.0), std::numeric_limits<double>::quiet_NaN()),
               std::invalid_argument);
}

TEST(Figures, AreMeasuredFromSamplesAndTheBlocksAsWritten) {
  tern_host::Scenario scenario;
  scenario.blocks.push_back({{{0.5, 0.3, -1.0}, {0.6, 1.0, 1.0}}, false});
  const tern_host::Figures figures = tern_host::measure(unit_step(2.0), scenario);
  EXPECT_DOUBLE_EQ(figures.duration, 2.0);
  EXPECT_NEAR(figures.length, 1.0, 1e-9);
  EXPECT_NEAR(figures.clearance, 0.3, 1e-9);
  // The degree-7 step's top speed is 35/16 of the mean speed, in the middle.
  EXPECT_NEAR(figures.speed, 35.0 / 16.0 / 2.0, 1e-5);
  EXPECT_NEAR(figures.v_peak.x, figures.speed, 1e-12);
  EXPECT_DOUBLE_EQ(figures.v_peak.y, 0.0);
}

TEST(Figures, ClearanceIsTheLeastOfAllSamples) {
  tern_test::Random random(5);
  for (int trial = 0; trial < 20; ++trial) {
    tern_host::Scenario scenario;
    for (int i = 0; i < 10; ++i) {
      const tern::Vec3 at{random.real(-0.5, 1.5), random.real(0.1, 1.0), random.real(-1.0, 1.0)};
      scenario.blocks.push_back({{at, {at.x + 0.2, at.y + 0.2, at.z + 0.2}}, false});
    }
    const tern::Trajectory step = unit_step(2.0);
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= 2000; ++i) {
      const tern::Vec3 position = tern::evaluate(step, 2.0 * i / 2000).position;
      least = std::min(least, tern_host::distance_to_blocks(position, scenario));
    }
    EXPECT_DOUBLE_EQ(tern_host::measure(step, scenario).clearance, least);
  }
}

TEST(Peaks, StandBesideTheLimitOfTheirDirection) {
  const tern_host::PeakRange peaks{{-0.5, -1.25, 0.0}, {1.5, 1.0, 0.25}, 1.75};
  const tern_host::LimitRange equal{{-2, -2, -2}, {2, 2, 2}, 0.0};
  const std::vector<tern_host::LimitedPeak> both = tern_host::limited_peaks(peaks, equal, 2);
  ASSERT_EQ(both.size(), 3u);
  EXPECT_EQ(both[0].text, "1.50 of 2.00");
  EXPECT_EQ(both[1].text, "1.25 of 2.00");  // backwards
  const tern_host::LimitRange unequal{{-2, -2, -1}, {2, 2, 3}, 1.8};
  const std::vector<tern_host::LimitedPeak> each = tern_host::limited_peaks(peaks, unequal, 2);
  ASSERT_EQ(each.size(), 4u);
  EXPECT_EQ(each[2].text, "0.25 of 3.00, 0.00 of -1.00");
  EXPECT_EQ(each[3].name, "horizontal");
  EXPECT_EQ(each[3].text, "1.75 of 1.80");
}

TEST(Figures, DistanceToBlocksIsEuclidean) {
  tern_host::Scenario scenario;
  EXPECT_TRUE(std::isinf(tern_host::distance_to_blocks({0, 0, 0}, scenario)));
  scenario.blocks.push_back({{{1, 1, 1}, {2, 2, 2}}, false});
  EXPECT_DOUBLE_EQ(tern_host::distance_to_blocks({0, 0, 0}, scenario), std::sqrt(3.0));
  EXPECT_DOUBLE_EQ(tern_host::distance_to_blocks({1.5, 1.5, 5}, scenario), 3.0);
  EXPECT_DOUBLE_EQ(tern_host::distance_to_blocks({1.5, 1.5, 1.5}, scenario), 0.0);
}

}  // namespace
