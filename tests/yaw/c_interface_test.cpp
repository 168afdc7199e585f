// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Yaw plans through C: the same bits as through C++, and an answer to every call that comes too early or is wrong.
#include <gtest/gtest.h>

#include <cstring>
#include <memory>

#include "support/yaw_case.hpp"
#include "tern/tern_yaw.h"

namespace {

constexpr std::uint8_t kOk = 0;
constexpr auto kRunning = static_cast<std::uint8_t>(tern::Status::kRunning);
constexpr auto kInvalid = static_cast<std::uint8_t>(tern::Status::kInvalidArgument);

tern_yaw_request request() {
  tern_yaw_request result{};
  const tern_heading start{0.0, 1.0};
  tern_yaw_request_init(&result, &start, 1.0, 2.0);
  return result;
}

TEST(YawC, EqualsThePlanInCpp) {
  const tern_trajectory trajectory = tern_test::polyline({{0, 0, 0}, {8, 0, 0}, {8, 8, 0}}, 4.0);
  const tern_yaw_request asked = request();
  const auto planner = std::make_unique<tern_yaw_planner>();
  const auto other = std::make_unique<tern::YawPlanner>();
  tern_yaw_plan whole{};
  tern_yaw_plan sliced{};
  tern::YawPlan expected{};
  ASSERT_EQ(tern_plan_yaw(planner.get(), &trajectory, &asked, &whole), kOk);
  ASSERT_EQ(other->plan(trajectory, asked, expected), tern::Status::kOk);
  ASSERT_EQ(tern_yaw_plan_begin(planner.get(), &trajectory, &asked), kRunning);
  while (tern_yaw_plan_step(planner.get(), 3) == kRunning) {
  }
  ASSERT_EQ(tern_yaw_plan_finish(planner.get(), &sliced), kOk);
  for (int i = 0; i < expected.count + 3; ++i) {
    EXPECT_EQ(whole.points[i], expected.points[i]);
    EXPECT_EQ(sliced.points[i], expected.points[i]);
  }
  EXPECT_EQ(tern_yaw_duration(&whole), tern::duration(expected));
  tern_yaw_sample sample{};
  tern_yaw_evaluate(&whole, 3.3, &sample);
  EXPECT_EQ(sample.angle, tern::evaluate(expected, 3.3).angle);
}

TEST(YawC, NullAndCallsOutOfOrder) {
  const tern_trajectory trajectory = tern_test::hover(1.0);
  tern_yaw_request asked = request();
  const auto planner = std::make_unique<tern_yaw_planner>();
  tern_yaw_plan plan{};
  EXPECT_EQ(tern_plan_yaw(nullptr, &trajectory, &asked, &plan), kInvalid);
  EXPECT_EQ(tern_plan_yaw(planner.get(), nullptr, &asked, &plan), kInvalid);
  EXPECT_EQ(tern_plan_yaw(planner.get(), &trajectory, nullptr, &plan), kInvalid);
  EXPECT_EQ(tern_plan_yaw(planner.get(), &trajectory, &asked, nullptr), kInvalid);
  EXPECT_EQ(tern_yaw_plan_step(planner.get(), 1), kInvalid);
  EXPECT_EQ(tern_yaw_plan_finish(planner.get(), &plan), kInvalid);
  EXPECT_EQ(tern_yaw_plan_step(nullptr, 1), kInvalid);
  EXPECT_EQ(tern_yaw_plan_finish(nullptr, &plan), kInvalid);
  EXPECT_EQ(tern_yaw_duration(nullptr), 0.0);
  tern_yaw_sample sample{};
  tern_yaw_evaluate(nullptr, 1.0, &sample);
  EXPECT_EQ(sample.yaw.cosine, 1.0);
  tern_yaw_evaluate(&plan, 1.0, nullptr);
  tern_yaw_request_init(nullptr, nullptr, 1.0, 1.0);
  tern_yaw_request_init(&asked, nullptr, 7.0, 7.0);
  EXPECT_EQ(asked.rate_max, 1.0);
  ASSERT_EQ(tern_yaw_plan_begin(planner.get(), &trajectory, &asked), kRunning);
  EXPECT_EQ(tern_yaw_plan_finish(planner.get(), nullptr), kInvalid);
  EXPECT_EQ(tern_yaw_plan_finish(planner.get(), &plan), kOk);
  asked.mode = static_cast<tern::YawMode>(77);
  EXPECT_EQ(tern_plan_yaw(planner.get(), &trajectory, &asked, &plan), kInvalid);
}

}  // namespace
