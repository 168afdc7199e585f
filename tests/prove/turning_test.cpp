// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Proofs of thrust, tilt and body rates: where a limit is reached is known by hand.
#include "prove/turning.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/grid_storage.hpp"
#include "support/random.hpp"
#include "support/vehicle_limits.hpp"
#include "tern/proof.hpp"

namespace {

using namespace tern;
using tern_test::Random;
using tern_test::scaled;

constexpr double kEnd = 4.0;
constexpr double kPiece = kEnd / (1 << kProofDepth) + 1e-6;

/// Four seconds from the middle of a large room, with acceleration `a` + `j` t.
Trajectory swaying(const Vec3& a, const Vec3& j) {
  Trajectory plan{};
  plan.count = 1;
  plan.origin = {500.0, 500.0, 500.0};
  plan.segments[0].duration = kEnd;
  for (int i = 0; i < kControlPoints; ++i) {
    const double square = kEnd * kEnd * i * (i - 1) / 42.0 / 2.0;
    const double cube = kEnd * kEnd * kEnd * i * (i - 1) * (i - 2) / 210.0 / 6.0;
    plan.segments[0].points[i] = {square * a.x + cube * j.x, square * a.y + cube * j.y, square * a.z + cube * j.z};
  }
  return plan;
}

struct Proven {
  double until;
  ProofReport report;
};

Proven prove(const Trajectory& plan, const Limits& limits) {
  static const tern_test::OwnedGrid room(tern_test::whole_grid({100, 100, 100}, 10.0, 0.3, {0.0, 0.0, 0.0}));
  Proven result{};
  result.until = clear_until(room.grid, plan, 0.0, &limits, Beyond::kEmpty, &result.report);
  return result;
}

constexpr Limits kWide{{900.0, 900.0, 900.0}, {900.0, 900.0, 900.0}};

void expect_end(const Proven& proven, double when, Finding finding, int axis) {
  EXPECT_NEAR(proven.until, when, kPiece);
  EXPECT_EQ(proven.report.finding, finding);
  EXPECT_EQ(proven.report.axis, axis);
  EXPECT_GT(proven.report.excess, 0.0);
}

TEST(ProveThrust, EndsWhereALimitIsReached) {
  const Trajectory plan = swaying(tern::Vec3{}, {3.0, 4.0, 0.0});  // 5 t, level
  Limits limits = kWide;
  limits.thrust_max = std::hypot(kGravity, 10.0);
  expect_end(prove(plan, limits), 2.0, Finding::kAcceleration, 4);
  limits = kWide;
  limits.tilt_tangent = 15.0 / kGravity;
  expect_end(prove(plan, limits), 3.0, Finding::kAcceleration, 5);
  limits.tilt_tangent = 20.0 / kGravity;
  EXPECT_EQ(prove(plan, limits).report.finding, Finding::kNone) << "reached at the end";
  const Trajectory sinking = swaying(tern::Vec3{}, {0.0, 0.0, -2.0});
  limits = kWide;
  limits.thrust_min = kGravity - 6.0;
  expect_end(prove(sinking, limits), 3.0, Finding::kAcceleration, 2);
  limits.thrust_min = 0.0;
  limits.tilt_tangent = 1.0;  // never downwards
  EXPECT_EQ(prove(swaying(tern::Vec3{}, {0.0, 0.0, -3.0}), limits).report.finding, Finding::kAcceleration);
}

TEST(ProveThrust, EndsWhereItTurnsTooFast) {
  // The thrust sways from -a to a: the rate j g / (g^2 + (j t - a)^2) is largest half-way.
  const double j = 9.0;
  const double a = 18.0;
  const Trajectory plan = swaying({-a, 0.0, 0.0}, {j, 0.0, 0.0});
  Limits limits = kWide;
  limits.thrust_min = 1.0;
  for (const double part : {0.5, 0.9, 0.999}) {
    limits.rate_max = part * j / kGravity;
    const Proven proven = prove(plan, limits);
    EXPECT_NEAR(proven.until, (a - std::sqrt(j * kGravity / limits.rate_max - kGravity * kGravity)) / j, kPiece);
    EXPECT_EQ(proven.report.finding, Finding::kBodyRate);
    EXPECT_EQ(proven.report.derivative, 4);
    EXPECT_GE(proven.report.excess, 0.0);
  }
  limits.rate_max = j / kGravity;
  const Proven touching = prove(plan, limits);
  EXPECT_EQ(touching.report.finding, Finding::kNone) << "touched at one instant";
  EXPECT_DOUBLE_EQ(touching.until, kEnd);
  limits.rate_max *= 1.0 - 1e-6;
  EXPECT_EQ(prove(plan, limits).report.finding, Finding::kBodyRate);
}

/// No rule that a sample breaks is ever allowed, and rules with room to spare are, on small pieces.
TEST(ProveThrust, AgreesWithSamples) {
  Random random(31);
  int allowed = 0;
  int refused = 0;
  for (int i = 0; i < scaled(2000); ++i) {
    Segment segment{};
    segment.duration = random.real(0.2, 2.0);
    const double size = random.real(0.001, 0.3);
    for (Vec3& p : segment.points) p = {random.real(-size, size), random.real(-size, size), random.real(-size, size)};
    const double begin = random.real(0.0, 0.9);
    const double end = begin + random.real(0.001, 0.1);
    double most = 0.0;
    for (int k = 0; k <= 50; ++k) most = std::fmax(most, turning_at(segment, begin + (end - begin) * k / 50));
    const double rate = most * random.real(0.5, 2.0);
    const bool is_allowed = turning_allowed(segment, begin, end, {rate, 0.0});
    EXPECT_FALSE(is_allowed && rate < most * (1.0 - 1e-12)) << i;
    (is_allowed ? allowed : refused) += 1;
  }
  EXPECT_GT(allowed, scaled(2000) / 3);
  EXPECT_GT(refused, scaled(2000) / 4);
}

}  // namespace
