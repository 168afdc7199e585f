// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Limits, continuity and ends of random yaw plans, by dense sampling.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "support/yaw_case.hpp"

namespace {

using namespace tern;
using tern_test::heading;
using tern_test::Random;
using tern_test::scaled;
using tern_test::tangle;

constexpr int kTimed = 5;

YawRequest random_request(Random& random, TimedHeading* timed) {
  YawRequest request =
      yaw_request(heading(random.real(-4.0, 4.0)), std::exp(random.real(-3.0, 2.0)), std::exp(random.real(-3.0, 3.0)));
  request.mode = static_cast<YawMode>(random.integer(0, 3));
  request.heading = heading(random.real(-4.0, 4.0));
  request.point = {random.real(-10.0, 10.0), random.real(-10.0, 10.0), 0.0};
  if (random.chance(0.5)) request.start_rate = random.real(-1.0, 1.0) * request.rate_max;
  double t = 0.0;
  for (int i = 0; i < kTimed; ++i) timed[i] = {t += random.real(0.01, 5.0), heading(random.real(-4.0, 4.0))};
  request.timed = timed;
  request.timed_count = kTimed;
  return request;
}

/// Samples, and instants just beside the joints of pieces.
void expect_sound(const YawPlan& plan, const YawRequest& request, int seed) {
  const double end = duration(plan);
  const double rate = request.rate_max * (1.0 + 1e-9);
  const double acceleration = request.acceleration_max * (1.0 + 1e-9);
  for (int i = 0; i <= 300; ++i) {
    const YawSample s = evaluate(plan, end * i / 300);
    ASSERT_LE(std::fabs(s.yaw.rate), rate) << seed;
    ASSERT_LE(std::fabs(s.acceleration), acceleration) << seed;
    ASSERT_NEAR(std::hypot(s.yaw.cosine, s.yaw.sine), 1.0, 1e-14);
  }
  for (int i = 0; i <= plan.count; ++i) {
    const double joint = plan.lead + i * plan.step;
    const double before = std::max(0.0, joint - 1e-9);
    const YawSample a = evaluate(plan, before);
    const YawSample b = evaluate(plan, joint + 1e-9);
    ASSERT_NEAR(a.angle, b.angle, 3e-9 * rate + 1e-12) << seed;
    ASSERT_NEAR(a.yaw.rate, b.yaw.rate, 3e-9 * acceleration + 1e-11) << seed;
    ASSERT_NEAR(a.acceleration, b.acceleration, 1e-6 * acceleration / std::min(plan.step, 1.0) + 1e-9) << seed;
  }
}

TEST(YawLimits, HoldForAllTimes) {
  const auto planner = std::make_unique<YawPlanner>();
  YawPlan plan{};
  TimedHeading timed[kTimed];
  for (int seed = 0; seed < scaled(4000); ++seed) {
    Random random(static_cast<std::uint64_t>(seed) + 1);
    const Trajectory trajectory = tangle(random);
    const YawRequest request = random_request(random, timed);
    ASSERT_EQ(planner->plan(trajectory, request, plan), Status::kOk) << seed;
    ASSERT_GE(duration(plan), duration(trajectory));
    expect_sound(plan, request, seed);
    const YawSample begin = evaluate(plan, 0.0);
    ASSERT_NEAR(begin.yaw.cosine, request.start.cosine, 1e-14);
    ASSERT_NEAR(begin.yaw.rate, request.start_rate, 1e-12);
    ASSERT_EQ(evaluate(plan, duration(plan)).yaw.rate, 0.0);
  }
}

/// A plan from a state of another one: the three numbers agree where it takes over, and the limits hold on.
TEST(YawLimits, HoldAfterReplans) {
  const auto planner = std::make_unique<YawPlanner>();
  TimedHeading timed[kTimed];
  for (int seed = 0; seed < scaled(2000); ++seed) {
    Random random(static_cast<std::uint64_t>(seed) + 500001);
    const YawRequest first = random_request(random, timed);
    YawPlan plan{};
    ASSERT_EQ(planner->plan(tangle(random), first, plan), Status::kOk);
    const YawSample now = evaluate(plan, random.unit() * duration(plan));
    YawRequest second = random_request(random, timed);
    second.rate_max = first.rate_max;
    second.acceleration_max = first.acceleration_max;
    second.start = {now.yaw.cosine, now.yaw.sine};
    second.start_rate = now.yaw.rate;
    second.start_acceleration = now.acceleration;
    ASSERT_EQ(planner->plan(tangle(random), second, plan), Status::kOk) << seed;
    const YawSample begin = evaluate(plan, 0.0);
    ASSERT_EQ(begin.yaw.rate, now.yaw.rate);
    ASSERT_EQ(begin.acceleration, now.acceleration);
    ASSERT_NEAR(std::remainder(begin.angle - now.angle, 2.0 * 3.14159265358979323846), 0.0, 1e-12);
    expect_sound(plan, second, seed);
  }
}

/// Fixed headings are reached, whatever the start does.
TEST(YawLimits, FixedHeadingsAreReached) {
  const auto planner = std::make_unique<YawPlanner>();
  YawPlan plan{};
  for (int seed = 0; seed < scaled(1000); ++seed) {
    Random random(static_cast<std::uint64_t>(seed) + 900001);
    TimedHeading timed[kTimed];
    YawRequest request = random_request(random, timed);
    request.mode = YawMode::kFixed;
    ASSERT_EQ(planner->plan(tangle(random), request, plan), Status::kOk);
    const Yaw end = evaluate(plan, duration(plan)).yaw;
    ASSERT_GT(end.cosine * request.heading.cosine + end.sine * request.heading.sine, std::cos(0.02)) << seed;
  }
}

/// Slices of any size give the same bits, and a plan that is taken early keeps the limits.
TEST(YawLimits, SlicesAndEarlyPlans) {
  const auto planner = std::make_unique<YawPlanner>();
  const auto other = std::make_unique<YawPlanner>();
  TimedHeading timed[kTimed];
  for (int seed = 0; seed < scaled(300); ++seed) {
    Random random(static_cast<std::uint64_t>(seed) + 700001);
    const Trajectory trajectory = tangle(random);
    const YawRequest request = random_request(random, timed);
    YawPlan whole{};
    YawPlan sliced{};
    ASSERT_EQ(planner->plan(trajectory, request, whole), Status::kOk);
    ASSERT_EQ(other->begin(trajectory, request), Status::kRunning);
    const auto slice = static_cast<std::uint32_t>(random.integer(1, 40));
    while (other->step(slice) == Status::kRunning) {
    }
    ASSERT_EQ(other->finish(sliced), Status::kOk);
    for (int i = 0; i < whole.count + 3; ++i) ASSERT_EQ(whole.points[i], sliced.points[i]);
    ASSERT_EQ(other->begin(trajectory, request), Status::kRunning);
    other->step(static_cast<std::uint32_t>(random.integer(0, whole.count + 20)));
    ASSERT_EQ(other->finish(sliced), Status::kOk);
    expect_sound(sliced, request, seed);
  }
}

}  // namespace
