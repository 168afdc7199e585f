// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The capacity of yaw plans, reached: longer pieces, and every promise kept.
#include <gtest/gtest.h>

#include <cmath>

#include "support/yaw_case.hpp"

namespace {

using namespace tern;

TEST(TinyYaw, LongerPiecesBeyondTheCapacity) {
  static YawPlanner planner;
  YawPlan plan{};
  YawRequest request = yaw_request({1.0, 0.0}, 50.0, 1000.0);
  request.mode = YawMode::kFixed;
  request.heading = {0.0, 1.0};
  ASSERT_EQ(planner.plan(tern_test::hover(0.5), request, plan), Status::kOk);
  EXPECT_LT(plan.count, kMaxYawPieces);
  EXPECT_LE(plan.step, 0.1);
  ASSERT_EQ(planner.plan(tern_test::hover(60.0), request, plan), Status::kOk);
  EXPECT_EQ(plan.count, kMaxYawPieces);
  EXPECT_GT(plan.step, 0.1);
  for (double t = 0.0; t < duration(plan); t += 0.01) {
    EXPECT_LE(std::fabs(evaluate(plan, t).yaw.rate), 50.0);
    EXPECT_LE(std::fabs(evaluate(plan, t).acceleration), 1000.0);
  }
  EXPECT_NEAR(evaluate(plan, duration(plan)).yaw.sine, 1.0, 1e-3);
}

}  // namespace
