// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What holds between two samples of a plan, on plans whose every derivative is known.
#include "host/flight/curve_pieces.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace {

using tern_host::CurveCheck;

constexpr std::int64_t kSecond = 1000000000;

/// 4 m along x in 2 s from rest to rest, with the step of degree 7; then the same back, or as far to the side.
tern::Trajectory there_and_on(bool turns) {
  tern::Trajectory plan{};
  plan.count = 2;
  plan.origin = {20.0, -30.0, 2.0};
  for (int s = 0; s < 2; ++s) {
    plan.segments[s].duration = 2.0;
    for (int i = 0; i < tern::kControlPoints; ++i) {
      const double way = i < tern::kControlPoints / 2 ? 0.0 : 4.0;
      tern::Vec3& point = plan.segments[s].points[i];
      point.x = s == 0 ? way : 4.0;
      if (s == 1) (turns ? point.y : point.x) += turns ? way : -way;
    }
  }
  return plan;
}

tern::Limits limits_of(double velocity, double acceleration, double jerk) {
  tern::Limits limits{{velocity, velocity, 2.0}, {acceleration, acceleration, 6.0}};
  limits.v_horizontal = velocity;
  limits.a_horizontal = acceleration;
  limits.j_max = {jerk, jerk, jerk};
  return limits;
}

/// What the check says of the plan's four seconds, in stretches of `step`.
std::string judged(const tern::Trajectory& plan, const tern::Limits& limits, std::int64_t step) {
  const auto commands = [&plan](std::int64_t t) { return evaluate(plan, 1e-9 * static_cast<double>(t)); };
  CurveCheck check(commands, limits);
  for (std::int64_t t = 0; t < 4 * kSecond; t += step) check.look({t, commands(t)}, {t + step, commands(t + step)});
  return check.fault().what == nullptr ? "" : check.fault().what;
}

/// The step of degree 7 over d in T: at most 35/16 d/T, 84 sqrt(5) / 25 d/T^2 and 105/2 d/T^3.
const double kFastest = 35.0 / 16.0 * 2.0;
const double kSharpest = 84.0 * std::sqrt(5.0) / 25.0;
constexpr double kJerkiest = 105.0 / 4.0;

TEST(CurveCheck, KnowsTheLargestDerivativesBetweenSamples) {
  for (const bool turns : {false, true}) {
    const tern::Trajectory plan = there_and_on(turns);
    for (const std::int64_t step : {2 * kSecond, 4 * kSecond, kSecond / 3 * 2, kSecond / 100}) {
      SCOPED_TRACE(step);
      EXPECT_EQ(judged(plan, limits_of(kFastest, kSharpest, kJerkiest), step), "");
      const double less = 1.0 - 1e-5;
      EXPECT_EQ(judged(plan, limits_of(less * kFastest, kSharpest, kJerkiest), step), "is faster than its limit");
      EXPECT_EQ(judged(plan, limits_of(kFastest, less * kSharpest, kJerkiest), step), "accelerates beyond its limit");
      EXPECT_EQ(judged(plan, limits_of(kFastest, kSharpest, less * kJerkiest), step), "jerks beyond its limit");
    }
  }
}

/// Without a limit on jerk, the largest one may lie between two samples, too.
TEST(CurveCheck, NeedsNoLimitOnJerk) {
  EXPECT_EQ(judged(there_and_on(true), limits_of(kFastest, kSharpest, 0.0), kSecond / 15), "");
}

/// A piece that begins elsewhere than the one before it ended, by so many metres.
TEST(CurveCheck, NoticesGapsBetweenPieces) {
  for (const double gap : {1e-10, 1e-6, 0.1}) {
    tern::Trajectory plan = there_and_on(true);
    for (tern::Vec3& point : plan.segments[1].points) point.z += gap;
    EXPECT_EQ(judged(plan, limits_of(10.0, 20.0, 100.0), kSecond / 7), "is not smooth") << gap;
  }
}

/// The same for jerk alone: the fourth control point moves the jerk and what follows.
TEST(CurveCheck, NoticesStepsOfJerk) {
  for (const double step : {0.1, 1.0, 50.0}) {
    tern::Trajectory plan = there_and_on(true);
    plan.segments[1].points[3].z += step * 8.0 / 210.0;
    EXPECT_EQ(judged(plan, limits_of(10.0, 100.0, 1000.0), kSecond / 7), "is not smooth") << step;
  }
}

/// What the check says where the jerk is 3 m/s^3 larger for so long.
std::string judged_with_bump(std::int64_t duration, std::uint64_t& slivers) {
  const tern::Trajectory plan = there_and_on(true);
  const auto commands = [&plan, duration](std::int64_t t) {
    tern::Sample sample = evaluate(plan, 1e-9 * static_cast<double>(t));
    if (t >= kSecond && t < kSecond + duration) sample.jerk.x += 3.0;
    return sample;
  };
  const tern::Limits limits = limits_of(10.0, 100.0, 1000.0);
  CurveCheck check(commands, limits);
  check.look({kSecond, commands(kSecond)}, {kSecond + 2 * duration, commands(kSecond + 2 * duration)});
  slivers = check.slivers();
  return check.fault().what == nullptr ? "" : check.fault().what;
}

/// A plan that was cut 20 us behind a joint: the jerk of the piece between is rounding. It is none of 3 ms.
TEST(CurveCheck, TellsSliversFromSteps) {
  std::uint64_t slivers = 0;
  EXPECT_EQ(judged_with_bump(20000, slivers), "");
  EXPECT_GT(slivers, 0u);
  EXPECT_EQ(judged_with_bump(3000000, slivers), "is not smooth");
}

}  // namespace
