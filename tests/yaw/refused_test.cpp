// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Requests for yaw plans that are refused, each with its status, and the plan left as it was.
#include <gtest/gtest.h>

#include "support/numbers.hpp"
#include "support/yaw_case.hpp"

namespace {

using namespace tern;
using tern_test::hover;
using tern_test::kNan;

YawRequest good(YawMode mode) {
  YawRequest request = yaw_request({1.0, 0.0}, 1.0, 2.0);
  request.mode = mode;
  return request;
}

void expect_refused(const YawRequest& request, Status expected, const Trajectory& trajectory = hover(1.0)) {
  static YawPlanner planner;
  YawPlan plan{};
  plan.count = -7;
  EXPECT_EQ(planner.plan(trajectory, request, plan), expected);
  EXPECT_EQ(plan.count, -7);
}

TEST(YawFaults, Numbers) {
  for (double YawRequest::*number : {&YawRequest::rate_max, &YawRequest::acceleration_max, &YawRequest::start_rate,
                                     &YawRequest::start_acceleration, &YawRequest::least_speed}) {
    YawRequest request = good(YawMode::kAlongMotion);
    request.*number = kNan;
    expect_refused(request, Status::kNonFiniteInput);
  }
  YawRequest request = good(YawMode::kAlongMotion);
  request.start.sine = kNan;
  expect_refused(request, Status::kNonFiniteInput);
  request = good(YawMode::kTowardsPoint);
  request.point.y = kNan;
  expect_refused(request, Status::kNonFiniteInput);
  request = good(YawMode::kTowardsPoint);
  request.least_distance = kNan;
  expect_refused(request, Status::kNonFiniteInput);
  request = good(YawMode::kFixed);
  request.heading.cosine = kNan;
  expect_refused(request, Status::kNonFiniteInput);
  Trajectory endless = hover(kNan);
  expect_refused(good(YawMode::kFixed), Status::kNonFiniteInput, endless);
}

TEST(YawFaults, Limits) {
  for (const double rate : {0.0, -1.0, 0.009, 101.0}) {
    YawRequest request = good(YawMode::kFixed);
    request.rate_max = rate;
    expect_refused(request, Status::kLimitsInvalid);
    request = good(YawMode::kFixed);
    request.acceleration_max = 10.0 * rate;
    if (rate <= 0.0 || rate > 100.0) expect_refused(request, Status::kLimitsInvalid);
  }
  YawRequest request = good(YawMode::kFixed);
  request.start_acceleration = 2.1;
  expect_refused(request, Status::kStartExceedsLimits);
  request = good(YawMode::kFixed);
  request.start_rate = -101.0;
  expect_refused(request, Status::kStartExceedsLimits);
}

TEST(YawFaults, Arguments) {
  expect_refused(good(static_cast<YawMode>(9)), Status::kInvalidArgument);
  YawRequest request = good(YawMode::kFixed);
  request.start = {0.0, 0.0};
  expect_refused(request, Status::kInvalidArgument);
  request = good(YawMode::kAlongMotion);
  request.least_speed = 0.0;
  expect_refused(request, Status::kInvalidArgument);
  request = good(YawMode::kTowardsPoint);
  request.least_distance = -1.0;
  expect_refused(request, Status::kInvalidArgument);
  expect_refused(good(YawMode::kFixed), Status::kInvalidArgument, Trajectory{});
  Trajectory many{};
  many.count = kMaxSegments + 1;
  expect_refused(good(YawMode::kFixed), Status::kInvalidArgument, many);
}

TEST(YawFaults, TimedHeadings) {
  expect_refused(good(YawMode::kTimed), Status::kInvalidArgument);
  TimedHeading timed[2] = {{1.0, {1.0, 0.0}}, {1.0, {0.0, 1.0}}};
  YawRequest request = good(YawMode::kTimed);
  request.timed = timed;
  expect_refused(request, Status::kInvalidArgument);  // none of them
  request.timed_count = 2;
  expect_refused(request, Status::kInvalidArgument);
  timed[1].time = kNan;
  expect_refused(request, Status::kNonFiniteInput);
  timed[1] = {2.0, {0.0, 0.0}};
  expect_refused(request, Status::kInvalidArgument);
  timed[0].time = -1.0;
  expect_refused(request, Status::kInvalidArgument);
}

TEST(YawFaults, CallsOutOfOrder) {
  static YawPlanner planner;
  YawPlan plan{};
  EXPECT_EQ(planner.step(10), Status::kInvalidArgument);
  EXPECT_EQ(planner.finish(plan), Status::kInvalidArgument);
  YawRequest request = good(YawMode::kFixed);
  const Trajectory trajectory = hover(1.0);
  ASSERT_EQ(planner.begin(trajectory, request), Status::kRunning);
  request.rate_max = kNan;
  EXPECT_EQ(planner.begin(trajectory, request), Status::kNonFiniteInput);
  EXPECT_EQ(planner.step(10), Status::kInvalidArgument);
}

}  // namespace
