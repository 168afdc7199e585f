// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Flights in empty space up to 10 km from the grid's origin: what a plan is does not depend on where it is.
#include <gtest/gtest.h>

#include <cmath>

#include "support/random.hpp"
#include "support/world.hpp"

namespace tern_test {
namespace {

using tern::Status;
using tern::Vec3;

double power_of_ten(Random& random, double lo, double hi) {
  return std::pow(10.0, random.real(lo, hi));
}

/// 512 voxels along x, of which the last tenth is up to 512 * cell metres from the origin.
class FarPlans : public testing::TestWithParam<double> {
 protected:
  FarPlans() : world_({512, 40, 16}, GetParam(), 0.1), random_(static_cast<std::uint64_t>(1e3 * GetParam())) {
    world_.grid.inflate();
  }

  Vec3 far_point() { return {512 * GetParam() * random_.real(0.8, 0.9), 20 * GetParam(), 8 * GetParam()}; }

  Vec3 beside(const Vec3& point, double move) {
    return {point.x + move * random_.real(-1.0, 1.0), point.y + move * random_.real(-1.0, 1.0),
            point.z + move * random_.real(-1.0, 1.0)};
  }

  World world_;
  Random random_;
};

TEST_P(FarPlans, MovingStartsAtEveryIterationBudget) {
  for (const std::uint32_t budget : {0u, 20u, 60u, 0xFFFFFFFFu}) {
    world_.request.budget.trajectory = budget;
    for (int i = 0; i < scaled(40); ++i) {
      const double v = random_.real(2.0, 10.0);
      const double a = random_.real(2.0, 8.0);
      world_.request.limits = {{v, v, v}, {a, a, a}};
      world_.request.start.position = far_point();
      // So slow along y and z that braking has room: 8 voxels up or down.
      const double side = 0.5 * std::fmin(v, std::sqrt(a * GetParam()));
      world_.request.start.velocity = {random_.real(-0.5, 0.5) * v, random_.real(-1.0, 1.0) * side,
                                       random_.real(-1.0, 1.0) * side};
      world_.request.start.acceleration = {random_.real(-0.5, 0.5) * a, random_.real(-0.1, 0.1) * a, 0.0};
      world_.request.goal.position = beside(world_.request.start.position, 8.0 * GetParam() * 0.5);
      ASSERT_EQ(world_.replan(), Status::kOk) << "budget " << budget << ", case " << i;
    }
  }
}

TEST_P(FarPlans, MovesFromAPicometreUp) {
  for (int exponent = -12; exponent <= 0; ++exponent) {
    for (int i = 0; i < scaled(20); ++i) {
      const double v = power_of_ten(random_, -1.5, 1.5);
      const double a = power_of_ten(random_, -1.5, 1.0);
      world_.request.limits = {{v, power_of_ten(random_, -2.0, 2.0), v}, {a, a, power_of_ten(random_, -2.0, 1.0)}};
      world_.request.time_weight = i % 3 == 0 ? power_of_ten(random_, -3.0, 6.0) : tern::kDefaultTimeWeight;
      world_.request.start.position = far_point();
      world_.request.goal.position = beside(world_.request.start.position, std::pow(10.0, exponent));
      ASSERT_EQ(world_.replan(), Status::kOk) << "10^" << exponent << " m, case " << i;
      const tern::Sample last = tern::evaluate(world_.trajectory, 1e9);
      const double ulp = 2.3e-16 * world_.request.goal.position.x;
      ASSERT_NEAR(last.position.x, world_.request.goal.position.x, ulp);
    }
  }
}

/// The same flight at the origin and far away has the same control points, to the last bit where the differences of the
/// coordinates are exact.
TEST_P(FarPlans, PlansAreTheSameEverywhere) {
  const double cell = GetParam();
  const Vec3 here{100.5 * cell, 20.5 * cell, 8.5 * cell};
  const Vec3 move{7.0 * cell, -3.0 * cell, 2.0 * cell};
  tern::Trajectory plans[2];
  for (int i = 0; i < 2; ++i) {
    const Vec3 start{here.x + 256 * cell * i, here.y, here.z};
    world_.request.start.position = start;
    world_.request.goal.position = {start.x + move.x, start.y + move.y, start.z + move.z};
    ASSERT_EQ(world_.replan(), Status::kOk);
    plans[i] = world_.trajectory;
  }
  ASSERT_EQ(plans[0].count, plans[1].count);
  for (int s = 0; s < plans[0].count; ++s) {
    EXPECT_EQ(plans[0].segments[s].duration, plans[1].segments[s].duration);
    for (int k = 0; k < tern::kControlPoints; ++k) {
      EXPECT_EQ(plans[0].segments[s].points[k].x, plans[1].segments[s].points[k].x);
    }
  }
}

// Cells that are powers of two: lattice coordinates are exact. The last reach 10 km.
INSTANTIATE_TEST_SUITE_P(Cells, FarPlans, testing::Values(0.25, 1.0, 4.0, 16.0));

}  // namespace
}  // namespace tern_test
