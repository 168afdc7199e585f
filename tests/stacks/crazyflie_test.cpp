// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Plans for the Crazyflie: raw and compressed forms fly the plan, within the error that they state.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <memory>

#include "support/yaw_case.hpp"
#include "tern_stacks/stacks.hpp"

namespace {

using namespace tern;
using tern_test::Random;
using tern_test::scaled;
using tern_test::tangle;
using tern_test::tangle_at;

/// A plan in motion with its origin anywhere.
/// What the firmware flies at time t after the start, by its own rule: the piece is the first that is not over.
struct FlownState {
  Vec3 position, velocity, acceleration;
  double yaw, yaw_rate;
};

double slope(const float (&p)[8], double t, int order) {
  double sum = 0.0;
  for (int k = 7; k >= order; --k)
    sum = sum * t + static_cast<double>(p[k]) * (order > 0 ? k : 1) * (order > 1 ? k - 1 : 1);
  return sum;
}

FlownState firmware_at(const Poly4d* pieces, std::int32_t count, double t) {
  std::int32_t i = 0;
  for (; i + 1 < count && t > pieces[i].duration; ++i) t -= pieces[i].duration;
  const auto& p = pieces[i].p;
  const auto vector = [&](int order) {
    return Vec3{slope(p[0], t, order), slope(p[1], t, order), slope(p[2], t, order)};
  };
  return {vector(0), vector(1), vector(2), slope(p[3], t, 0), slope(p[3], t, 1)};
}

double norm(const Vec3& a, const Vec3& b, const Vec3& origin = {}) {
  const Vec3 d{a.x + origin.x - b.x, a.y + origin.y - b.y, a.z + origin.z - b.z};
  return std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
}

void expect_within(const ExportError& error, const FlownState& flown, const Vec3& origin, const Sample& sample,
                   const YawSample& yaw) {
  const double rounding = 1e-9 + 1e-9 * std::abs(origin.y);
  EXPECT_LE(norm(flown.position, sample.position, origin), error.position + rounding);
  EXPECT_LE(norm(flown.velocity, sample.velocity), error.velocity + 1e-9);
  EXPECT_LE(norm(flown.acceleration, sample.acceleration), error.acceleration + 1e-9);
  EXPECT_LE(std::abs(flown.yaw - yaw.angle), error.yaw + 1e-9);
  EXPECT_LE(std::abs(flown.yaw_rate - yaw.yaw.rate), error.yaw_rate + 1e-9);
}

TEST(ExportCrazyflie, PiecesFlyThePlanWithinTheirError) {
  const auto planner = std::make_unique<YawPlanner>();
  for (int seed = 0; seed < scaled(200); ++seed) {
    Random random(static_cast<std::uint64_t>(seed) + 1);
    const Vec3 origin{random.real(-1e6, 1e6), 0.0, 0.0};
    const Trajectory trajectory = tangle_at(random, origin);
    YawPlan yaw{};
    ASSERT_EQ(planner->plan(trajectory, yaw_request({1.0, 0.0}, 1.0, 2.0), yaw), Status::kOk);
    Poly4d pieces[kCrazyfliePieces];
    std::int32_t count = 0;
    ExportError error{};
    ASSERT_EQ(crazyflie_raw(trajectory, &yaw, origin, pieces, kCrazyfliePieces, count, error), Status::kOk);
    ASSERT_GE(count, trajectory.count);
    EXPECT_LT(error.position, 4e-4);
    EXPECT_TRUE(error.yaw <= kCrazyflieYaw || count == kCrazyfliePieces) << seed << ": " << error.yaw;
    const double end = duration(trajectory);
    for (int k = 0; k < 400; ++k) {
      const double t = end * k / 400;
      expect_within(error, firmware_at(pieces, count, t), origin, evaluate(trajectory, t), evaluate(yaw, t));
    }
    ASSERT_FALSE(HasFailure()) << seed;
  }
}

TEST(ExportCrazyflie, WithoutAYawPlanThereIsAPieceASegmentAndYawIsZero) {
  Random random(3);
  const Trajectory trajectory = tangle(random);
  Poly4d pieces[kCrazyfliePieces];
  std::int32_t count = 0;
  ExportError error{};
  ASSERT_EQ(crazyflie_raw(trajectory, nullptr, {}, pieces, kCrazyfliePieces, count, error), Status::kOk);
  ASSERT_EQ(count, trajectory.count);
  EXPECT_EQ(error.yaw, 0.0);
  for (const float coefficient : pieces[0].p[3]) EXPECT_EQ(coefficient, 0.0f);
  count = -1;
  EXPECT_EQ(crazyflie_raw(trajectory, nullptr, {}, pieces, trajectory.count - 1, count, error),
            Status::kInvalidArgument);
  EXPECT_EQ(crazyflie_raw(trajectory, nullptr, {}, nullptr, kCrazyfliePieces, count, error), Status::kInvalidArgument);
  EXPECT_EQ(crazyflie_raw(Trajectory{}, nullptr, {}, pieces, kCrazyfliePieces, count, error), Status::kInvalidArgument);
  EXPECT_EQ(count, -1);
}

TEST(ExportCrazyflie, AnEmptyYawPlanIsYawZeroAndASegmentWithoutDurationIsRefused) {
  const Trajectory trajectory = tern_test::hover(3.0);
  Poly4d pieces[kCrazyfliePieces];
  std::int32_t count = 0;
  ExportError error{};
  YawPlan yaw{};
  for (const std::int32_t spline : {0, kMaxYawPieces + 1}) {
    yaw.count = spline;
    ASSERT_EQ(crazyflie_raw(trajectory, &yaw, {}, pieces, kCrazyfliePieces, count, error), Status::kOk);
    EXPECT_EQ(count, 1);
    EXPECT_EQ(error.yaw, 0.0);
    EXPECT_EQ(pieces[0].p[3][0], 0.0f);
    EXPECT_EQ(setpoint_error(trajectory, &yaw, {}).yaw_rate, 0.0);
  }
  for (const double duration : {0.0, -1.0, std::nan("")}) {
    EXPECT_EQ(crazyflie_raw(tern_test::hover(duration), nullptr, {}, pieces, kCrazyfliePieces, count, error),
              Status::kInvalidArgument);
  }
}

/// After a first polynomial that rests at 0, the spline swings to and fro. Halves of the piece would be too short.
TEST(ExportCrazyflie, AYawTooFastForItsPieceIsWithinTheErrorThatSaysSo) {
  const YawPlan yaw{9, 0.01, {}, 0.02, {0.0, 0.0, 0.0, 1.0, -1.0, 1.0, -1.0, 1.0, -1.0, 0.0, 0.0, 0.0}};
  Poly4d pieces[2];
  std::int32_t count = 0;
  ExportError error{};
  ASSERT_EQ(crazyflie_raw(tern_test::hover(0.19), &yaw, {}, pieces, 2, count, error), Status::kOk);
  EXPECT_EQ(count, 1);
  double most = 0.0;
  for (double t = 0.0; t < 0.19; t += 0.001) {
    most = std::fmax(most, std::abs(firmware_at(pieces, 1, t).yaw - evaluate(yaw, t).angle));
  }
  EXPECT_GT(most, kCrazyflieYaw);
  EXPECT_LE(most, error.yaw);
}

/// Far from the origin, floats are coarse: the error says so.
TEST(ExportCrazyflie, TheErrorShowsCoordinatesThatAreTooLarge) {
  Random random(4);
  const Trajectory trajectory = tangle_at(random, {1e9, 0.0, 0.0});
  Poly4d pieces[kCrazyfliePieces];
  std::int32_t count = 0;
  ExportError error{};
  ASSERT_EQ(crazyflie_raw(trajectory, nullptr, {}, pieces, kCrazyfliePieces, count, error), Status::kOk);
  EXPECT_GT(error.position, 1.0);
  ASSERT_EQ(crazyflie_raw(trajectory, nullptr, {1e9, 0.0, 0.0}, pieces, kCrazyfliePieces, count, error), Status::kOk);
  EXPECT_LT(error.position, 1e-4);
}

/// x(t) = 1 + 2 t - t^3 over 2 s.
TEST(ExportCrazyflie, AKnownPolynomialHasItsCoefficients) {
  Trajectory trajectory{};
  trajectory.count = 1;
  trajectory.origin = {1.0, 0.0, 0.0};
  trajectory.segments[0].duration = 2.0;
  // p(u) = 4 u - 8 u^3 relative to the origin: b_i = 4 i / 7 - 8 C(i, 3) / C(7, 3).
  const double cubes[8] = {0.0, 0.0, 0.0, 1.0, 4.0, 10.0, 20.0, 35.0};
  for (int i = 0; i < 8; ++i) trajectory.segments[0].points[i] = {4.0 * i / 7.0 - 8.0 * cubes[i] / 35.0, 0.0, 0.0};
  Poly4d piece;
  std::int32_t count = 0;
  ExportError error{};
  ASSERT_EQ(crazyflie_raw(trajectory, nullptr, {}, &piece, 1, count, error), Status::kOk);
  const float wanted[8] = {1.0f, 2.0f, 0.0f, -1.0f, 0.0f, 0.0f, 0.0f, 0.0f};
  for (int k = 0; k < 8; ++k) EXPECT_NEAR(piece.p[0][k], wanted[k], 1e-6f) << k;
}

TEST(ExportCrazyflie, CompressedCurvesAreNearThePlanAtEveryTime) {
  const auto planner = std::make_unique<YawPlanner>();
  std::uint8_t bytes[crazyflie_compressed_bytes(kMaxSegments)];
  for (int seed = 0; seed < scaled(200); ++seed) {
    Random random(static_cast<std::uint64_t>(seed) + 5);
    const Vec3 origin{4e6, -5e5, 0.0};
    const Trajectory trajectory = tangle_at(random, origin);
    YawPlan yaw{};
    ASSERT_EQ(planner->plan(trajectory, yaw_request({1.0, 0.0}, 1.0, 2.0), yaw), Status::kOk);
    const bool has_yaw = seed % 2 == 0;
    std::int32_t used = 0;
    ExportError error{};
    ASSERT_EQ(crazyflie_compressed(trajectory, has_yaw ? &yaw : nullptr, origin, bytes, sizeof bytes, used, error),
              Status::kOk);
    Trajectory read{};
    ASSERT_EQ(crazyflie_decompressed(bytes, used, origin, read), Status::kOk);
    EXPECT_EQ(used, 8 + (has_yaw ? 59 : 45) * read.count + 3);
    ASSERT_GE(read.count, trajectory.count);
    if (trajectory.count == 1) {
      EXPECT_LT(error.position, 1e-3) << "half a millimetre an axis, where no joint is sharp";
    }
    const double end = duration(trajectory);
    EXPECT_NEAR(duration(read), end, 0.0005 + 1e-9);
    for (int k = 0; k < 400; ++k) {
      const double t = (end - 1e-3) * k / 400;
      const Sample flown = evaluate(read, t);
      const Sample planned = evaluate(trajectory, t);
      ASSERT_LE(norm(flown.position, planned.position), error.position + 1e-8) << seed;
      ASSERT_LE(norm(flown.velocity, planned.velocity), error.velocity + 1e-8);
      ASSERT_LE(norm(flown.acceleration, planned.acceleration), error.acceleration + 1e-8);
      ASSERT_LE(norm(flown.jerk, planned.jerk), error.jerk + 1e-8);
    }
    ASSERT_EQ(crazyflie_decompressed(bytes, used - 1, origin, read), Status::kInvalidArgument);
  }
}

/// 48 segments of 0.4 ms too much each would end 19 ms early, were each duration rounded on its own.
TEST(ExportCrazyflie, CompressedTimesDoNotAddTheirRounding) {
  Trajectory trajectory{};
  trajectory.count = kMaxSegments;
  for (Segment& segment : trajectory.segments) segment.duration = 0.5004;
  std::uint8_t bytes[crazyflie_compressed_bytes(kMaxSegments)];
  std::int32_t used = 0;
  ExportError error{};
  ASSERT_EQ(crazyflie_compressed(trajectory, nullptr, {}, bytes, sizeof bytes, used, error), Status::kOk);
  Trajectory read{};
  ASSERT_EQ(crazyflie_decompressed(bytes, used, {}, read), Status::kOk);
  double flown = 0.0;
  for (int i = 0; i < kMaxSegments; ++i) {
    flown += read.segments[i].duration;
    EXPECT_NEAR(flown, 0.5004 * (i + 1), 0.0005 + 1e-9) << i;
  }
}

TEST(ExportCrazyflie, CompressedYawIsInTenthsOfADegree) {
  const auto planner = std::make_unique<YawPlanner>();
  YawPlan yaw{};
  const Trajectory trajectory = tern_test::hover(2.0);
  YawRequest request = yaw_request({0.0, 1.0}, 1.0, 2.0);
  request.mode = YawMode::kFixed;
  request.heading = {0.0, 1.0};
  ASSERT_EQ(planner->plan(trajectory, request, yaw), Status::kOk);
  std::uint8_t bytes[crazyflie_compressed_bytes(1)];
  std::int32_t used = 0;
  ExportError error{};
  ASSERT_EQ(crazyflie_compressed(trajectory, &yaw, {}, bytes, sizeof bytes, used, error), Status::kOk);
  EXPECT_LT(error.yaw, 1e-3);
  ASSERT_EQ(used, crazyflie_compressed_bytes(1));
  EXPECT_EQ(bytes[6] | bytes[7] << 8, 900);
  EXPECT_EQ(bytes[8], 0xFF);
  EXPECT_EQ(bytes[9] | bytes[10] << 8, 2000);
}

TEST(ExportCrazyflie, WhatDoesNotFitIsRefused) {
  std::uint8_t bytes[crazyflie_compressed_bytes(1)];
  std::int32_t used = -1;
  ExportError error{};
  Trajectory far = tern_test::hover(1.0);
  far.origin = {32.768, 0.0, 0.0};
  EXPECT_EQ(crazyflie_compressed(far, nullptr, {}, bytes, sizeof bytes, used, error), Status::kInvalidArgument);
  std::int32_t near_used = 0;
  EXPECT_EQ(crazyflie_compressed(far, nullptr, {1.0, 0.0, 0.0}, bytes, sizeof bytes, near_used, error), Status::kOk);
  far.origin.x = std::nan("");
  EXPECT_EQ(crazyflie_compressed(far, nullptr, {}, bytes, sizeof bytes, used, error), Status::kInvalidArgument);
  EXPECT_EQ(crazyflie_compressed(tern_test::hover(0.0004), nullptr, {}, bytes, sizeof bytes, used, error),
            Status::kInvalidArgument);
  for (const double longer : {66.0, 3e6}) {
    EXPECT_EQ(crazyflie_compressed(tern_test::hover(longer), nullptr, {}, bytes, sizeof bytes, used, error),
              Status::kInvalidArgument);
  }
  EXPECT_EQ(crazyflie_compressed(tern_test::hover(1.0), nullptr, {}, bytes, sizeof bytes - 1, used, error),
            Status::kInvalidArgument);
  EXPECT_EQ(crazyflie_compressed(Trajectory{}, nullptr, {}, bytes, sizeof bytes, used, error),
            Status::kInvalidArgument);
  far.count = kMaxSegments + 1;
  EXPECT_EQ(crazyflie_compressed(far, nullptr, {}, bytes, 1 << 20, used, error), Status::kInvalidArgument);
  EXPECT_EQ(used, -1);
  Poly4d pieces[kCrazyfliePieces];
  EXPECT_EQ(crazyflie_raw(far, nullptr, {}, pieces, kCrazyfliePieces, used, error), Status::kInvalidArgument);
}

/// As many pieces as there may be, each of 45 bytes after 8 of the start, and what ends them.
TEST(ExportCrazyflie, AllPiecesAreReadAndNoMore) {
  Trajectory full{};
  full.count = kMaxSegments;
  for (Segment& segment : full.segments) segment.duration = 0.5;
  std::uint8_t bytes[crazyflie_compressed_bytes(kMaxSegments) + 45];
  std::int32_t used = 0;
  ExportError error{};
  ASSERT_EQ(crazyflie_compressed(full, nullptr, {}, bytes, sizeof bytes, used, error), Status::kOk);
  Trajectory read{};
  ASSERT_EQ(crazyflie_decompressed(bytes, used, {}, read), Status::kOk);
  EXPECT_EQ(read.count, kMaxSegments);
  for (const std::int32_t end : {used - 2, used - 1}) {
    bytes[end] = 1;
    EXPECT_EQ(crazyflie_decompressed(bytes, used, {}, read), Status::kInvalidArgument) << "the end has a duration";
    bytes[end] = 0;
  }
  std::memcpy(bytes + used - 3, bytes + 8, 45);
  std::memset(bytes + used + 42, 0, 3);
  EXPECT_EQ(crazyflie_decompressed(bytes, used + 45, {}, read), Status::kInvalidArgument) << "one piece too many";
  const std::uint8_t nothing[11] = {};
  EXPECT_EQ(crazyflie_decompressed(nothing, 11, {}, read), Status::kInvalidArgument) << "no piece";
}

}  // namespace
