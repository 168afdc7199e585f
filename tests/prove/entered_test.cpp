// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The check of a plan that enters its trajectory at a later time than the beginning: only what is flown is asked about,
// and the start is met where the plan enters.
#include <gtest/gtest.h>

#include <algorithm>

#include "support/check_world.hpp"
#include "support/random.hpp"

namespace tern_test {
namespace {

using tern::Finding;
using tern::Status;
using tern::Vec3;

class EnteredPlan : public CheckWorld {
 protected:
  void enter_at(double time) {
    const tern::Sample at = evaluate(*trajectory_, time);
    query_.entered = time;
    query_.start = {at.position, at.velocity, at.acceleration, at.jerk};
  }
};

TEST_F(EnteredPlan, MeetsTheStateThatEvaluateGives) {
  Random random(38);
  const double joint = trajectory_->segments[0].duration;
  const double end = duration(*trajectory_);
  for (int i = 0; i < scaled(2000); ++i) {
    const double times[] = {random.real(0.0, end), joint - random.real(0.0, 1e-9), joint, end * (1.0 - 1e-12)};
    enter_at(times[random.integer(0, 3)]);
    ASSERT_EQ(run(), Status::kOk) << query_.entered;
  }
}

TEST_F(EnteredPlan, MeetsNoOtherState) {
  for (const double time : {1.5, 4.0, 5.0}) {
    for (int order = 0; order < 4; ++order) {
      enter_at(time);
      Vec3* const states[] = {&query_.start.position, &query_.start.velocity, &query_.start.acceleration,
                              &query_.start.jerk};
      states[order]->y += 1e-6;
      const tern::ProofReport& found = expect(Finding::kBoundary, time < 4.0 ? 0 : 1);
      EXPECT_EQ(found.derivative, order);
      EXPECT_EQ(found.axis, 1);
      EXPECT_NEAR(found.excess, 1e-6, 1e-9);
      EXPECT_EQ(found.until, time < 4.0 ? 0.0 : 4.0);
    }
  }
  enter_at(1.5);
  query_.entered = 1.4;
  expect(Finding::kBoundary, 0);
}

TEST_F(EnteredPlan, IsNotAskedAboutWhatLiesBefore) {
  // Too near to the wall, and too fast.
  trajectory_->segments[0] = straight({0.5, 0.5, 1.0}, {3.0, 1.5, 1.0}, 4.0, 0);
  query_.limits.v_max.x = 1.0;
  for (const double time : {5.0, 4.0, 3.9}) {
    enter_at(time);
    EXPECT_EQ(run(), Status::kOk) << time;
  }
  enter_at(1.0);
  expect(Finding::kVelocity, 0);
  query_.limits.v_max.x = 2.0;
  expect(Finding::kObstacle, 0);
  // A jump of velocity at the joint.
  trajectory_->segments[0].points[6].y += 1e-4;
  enter_at(3.9);
  EXPECT_EQ(expect(Finding::kJoint, 1).derivative, 1);
  enter_at(4.0);
  EXPECT_EQ(run(), Status::kOk);
}

TEST_F(EnteredPlan, IsAskedAboutAllThatIsFlown) {
  for (const double time : {0.0, 1.0, 3.9, 4.0, 5.0, 5.9}) {
    enter_at(time);
    query_.goal.position.z += 1e-6;
    expect(Finding::kBoundary, 1);
    query_.goal.position.z -= 1e-6;
    if (time >= 4.0) continue;
    trajectory_->segments[1].points[3].z += 1e-4;
    expect(Finding::kJoint, 1);
    trajectory_->segments[1].points[3].z -= 1e-4;
  }
  // The peak of the second segment's velocity is half-way: behind it, it is kept.
  query_.limits.v_max.y = 35.0 / 16.0 * 1.0 / 2.0 * (1.0 - 1e-6);
  for (const double time : {0.0, 3.0, 4.5, 4.99}) {
    enter_at(time);
    const tern::ProofReport& found = expect(Finding::kVelocity, 1);
    EXPECT_EQ(found.axis, 1);
    EXPECT_NEAR(found.until, 5.0, 0.01);
  }
  enter_at(5.01);
  EXPECT_EQ(run(), Status::kOk);
}

}  // namespace
}  // namespace tern_test
