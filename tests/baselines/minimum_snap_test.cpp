// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "baselines/minimum_snap.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "host/scenario.hpp"
#include "support/random.hpp"

namespace {

using tern::Vec3;

TEST(MinimumSnap, UnitFormIsTheKnownIntegers) {
  // Position and velocity rows of the degree-7 Hermite form of the squared fourth derivative.
  const double expected[2][8] = {{100800, 50400, 10080, 840, -100800, 50400, -10080, 840},
                                 {50400, 25920, 5400, 480, -50400, 24480, -4680, 360}};
  double form[8][8];
  tern_bench::snap_form_of_unit_segment(form);
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 8; ++j) EXPECT_NEAR(form[i][j], expected[i][j], 1e-6) << i << ", " << j;
  }
  for (int i = 0; i < 8; ++i) {
    for (int j = 0; j < 8; ++j) EXPECT_NEAR(form[i][j], form[j][i], 1e-6);
  }
}

TEST(MinimumSnap, OneSegmentIsTheKnownPolynomial) {
  // From rest to rest: 35 u^4 - 84 u^5 + 70 u^6 - 20 u^7, 1/2 at u = 1/2, with snap integral 100800 L^2 / T^7.
  const tern::Trajectory t = tern_bench::minimum_snap({{1.0, 2.0, 3.0}, {3.0, 2.0, 3.0}}, {2.0});
  ASSERT_EQ(t.count, 1);
  EXPECT_NEAR(tern::evaluate(t, 1.0).position.x, 2.0, 1e-12);
  const double u = 0.25;
  const double part = 35 * std::pow(u, 4) - 84 * std::pow(u, 5) + 70 * std::pow(u, 6) - 20 * std::pow(u, 7);
  EXPECT_NEAR(tern::evaluate(t, 0.5).position.x, 1.0 + 2.0 * part, 1e-12);
  EXPECT_NEAR(tern::snap_cost(t), 100800.0 * 4.0 / 128.0, 1e-6);
}

TEST(MinimumSnap, GoesThroughEveryWaypointAndIsContinuousToJerk) {
  tern_test::Random random(3);
  for (int k = 0; k < 50; ++k) {
    std::vector<Vec3> points;
    std::vector<double> durations;
    const int count = random.integer(3, 12);
    for (int i = 0; i < count; ++i) points.push_back({random.real(-5, 5), random.real(-5, 5), random.real(0, 3)});
    for (int i = 1; i < count; ++i) durations.push_back(random.real(0.5, 3.0));
    const tern::Trajectory t = tern_bench::minimum_snap(points, durations);
    double at = 0.0;
    for (int i = 0; i + 1 < count; ++i) {
      at += durations[static_cast<std::size_t>(i)];
      const tern::Sample before = tern::evaluate(t, at - 1e-9);
      const tern::Sample after = tern::evaluate(t, at + 1e-9);
      const Vec3& p = points[static_cast<std::size_t>(i) + 1];
      EXPECT_NEAR(before.position.x, p.x, 1e-6);
      EXPECT_NEAR(before.position.z, p.z, 1e-6);
      if (i + 2 == count) break;
      EXPECT_NEAR(before.velocity.y, after.velocity.y, 1e-5);
      EXPECT_NEAR(before.acceleration.y, after.acceleration.y, 1e-4);
      EXPECT_NEAR(before.jerk.y, after.jerk.y, 1e-3 * (1.0 + std::fabs(after.jerk.y)));
    }
    EXPECT_NEAR(tern::evaluate(t, 0.0).velocity.x, 0.0, 1e-9);
  }
}

TEST(MinimumSnap, NoOtherSplineThroughTheWaypointsHasLessSnap) {
  // A minimum of a convex cost: a waypoint less to go through can only lower it, one more on the curve keeps it.
  const std::vector<Vec3> points{{0, 0, 0}, {1, 2, 0}, {3, 1, 1}, {4, 4, 1}};
  const tern::Trajectory t = tern_bench::minimum_snap(points, {1.0, 1.5, 2.0});
  const Vec3 middle = tern::evaluate(t, 1.75).position;
  const tern::Trajectory same =
      tern_bench::minimum_snap({points[0], points[1], middle, points[2], points[3]}, {1.0, 0.75, 0.75, 2.0});
  EXPECT_NEAR(tern::snap_cost(same), tern::snap_cost(t), 1e-6 * tern::snap_cost(t));
  const tern::Trajectory bent = tern_bench::minimum_snap(
      {points[0], points[1], {middle.x + 0.1, middle.y, middle.z}, points[2], points[3]}, {1.0, 0.75, 0.75, 2.0});
  EXPECT_GT(tern::snap_cost(bent), tern::snap_cost(t));
}

TEST(MinimumSnap, RefusesWhatIsNoQuestion) {
  EXPECT_THROW(tern_bench::minimum_snap({{0, 0, 0}}, {}), std::invalid_argument);
  EXPECT_THROW(tern_bench::minimum_snap({{0, 0, 0}, {1, 0, 0}}, {0.0}), std::invalid_argument);
  EXPECT_THROW(tern_bench::minimum_snap({{0, 0, 0}, {1, 0, 0}}, {1.0, 1.0}), std::invalid_argument);
}

TEST(MendCollisions, PullsTheCurveBackToItsLegs) {
  // The polynomial swings out of a sharp turn into the block behind it.
  const tern_host::Scenario scenario = tern_host::parse_scenario(
      "boundary -1 -3 -1 6 6 1\nblock -1 -1.5 -1 6 -0.45 1\nstart 0 4 0\ngoal 4 4 0\nradius 0.1\n", "turn");
  const std::vector<Vec3> way{{0, 4, 0}, {0.5, -0.3, 0}, {4, -0.3, 0}, {4, 4, 0}};
  const std::vector<double> durations{2.5, 2.5, 2.5};
  const tern_bench::MendedPolynomial once = tern_bench::mend_collisions(way, durations, scenario, 1);
  EXPECT_FALSE(once.clear);
  EXPECT_EQ(once.solves, 1);
  const tern_bench::MendedPolynomial mended = tern_bench::mend_collisions(way, durations, scenario, 20);
  EXPECT_TRUE(mended.clear);
  EXPECT_GT(mended.inserted, 0);
  EXPECT_NEAR(tern::duration(mended.trajectory), 7.5, 1e-9);
}

TEST(StretchedToLimits, MeetsTheTighterLimitExactly) {
  const tern_host::Scenario scenario =
      tern_host::parse_scenario("boundary 0 0 0 9 9 9\nstart 0 0 0\ngoal 4 0 0\nv_max 2\na_max 100\n", "free");
  // Peak speed of the rest-to-rest polynomial is 35/16 L/T: 8.75 m/s here, so that the time grows to 4.375 s.
  const tern::Trajectory t = tern_bench::minimum_snap({{0, 0, 0}, {4, 0, 0}}, {1.0});
  EXPECT_NEAR(tern::duration(tern_bench::stretched_to_limits(t, scenario)), 4.375, 1e-4);
}

}  // namespace
