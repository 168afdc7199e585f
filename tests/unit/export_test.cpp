// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Plans for flight stacks: frames, bytes, and curves that are the plan's.
#include "tern/export.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <memory>

#include "support/yaw_case.hpp"

namespace {

using namespace tern;
using tern_test::Random;
using tern_test::scaled;
using tern_test::tangle;

constexpr double kQuarter = 1.57079632679489661923;

YawSample yaw_at(double angle, double rate = 0.0) {
  return {{std::cos(angle), std::sin(angle), rate}, 0.0, angle};
}

TEST(ExportFrames, EastNorthUpBecomesNorthEastDownAndBack) {
  const Vec3 ned = ned_from_enu({1.0, 2.0, 3.0});
  EXPECT_EQ(ned.x, 2.0);
  EXPECT_EQ(ned.y, 1.0);
  EXPECT_EQ(ned.z, -3.0);
  const Vec3 enu = ned_from_enu(ned);
  EXPECT_EQ(enu.x, 1.0);
  EXPECT_EQ(enu.z, 3.0);
}

TEST(ExportFrames, ALevelVehicleThatLooksEastHasYawNinetyDegrees) {
  const double east[4] = {1.0, 0.0, 0.0, 0.0};
  double ned[4];
  attitude_ned(east, ned);
  EXPECT_NEAR(ned[0], std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(ned[1], 0.0, 1e-15);
  EXPECT_NEAR(ned[2], 0.0, 1e-15);
  EXPECT_NEAR(ned[3], std::sqrt(0.5), 1e-15);
  const double north[4] = {std::sqrt(0.5), 0.0, 0.0, std::sqrt(0.5)};
  attitude_ned(north, ned);
  EXPECT_NEAR(ned[0], 1.0, 1e-15);
}

/// p turned by a quaternion.
Vec3 rotated(const double (&q)[4], const Vec3& p) {
  const double w = q[0], x = q[1], y = q[2], z = q[3];
  return {(1 - 2 * (y * y + z * z)) * p.x + 2 * (x * y - w * z) * p.y + 2 * (x * z + w * y) * p.z,
          2 * (x * y + w * z) * p.x + (1 - 2 * (x * x + z * z)) * p.y + 2 * (y * z - w * x) * p.z,
          2 * (x * z - w * y) * p.x + 2 * (y * z + w * x) * p.y + (1 - 2 * (x * x + y * y)) * p.z};
}

TEST(ExportFrames, AttitudesTurnEveryVectorAlike) {
  Random random(3);
  for (int i = 0; i < scaled(1000); ++i) {
    double enu[4];
    double square = 0.0;
    for (double& c : enu) {
      c = random.real(-1.0, 1.0);
      square += c * c;
    }
    for (double& c : enu) c /= std::sqrt(square);
    double ned[4];
    attitude_ned(enu, ned);
    const Vec3 body{random.real(-1.0, 1.0), random.real(-1.0, 1.0), random.real(-1.0, 1.0)};
    const Vec3 world = ned_from_enu(rotated(enu, body));
    const Vec3 again = rotated(ned, {body.x, -body.y, -body.z});  // right-down where Tern has left-up
    ASSERT_NEAR(world.x, again.x, 1e-14);
    ASSERT_NEAR(world.y, again.y, 1e-14);
    ASSERT_NEAR(world.z, again.z, 1e-14);
    ASSERT_GE(ned[0], 0.0);
  }
}

TEST(ExportFrames, SetpointsCountYawClockwiseFromNorth) {
  const Sample sample{{10.0, 20.0, 30.0}, {1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}, {7.0, 8.0, 9.0}, {}};
  const SetpointNed east = setpoint_ned(sample, yaw_at(0.0, 0.5), {1.0, 2.0, 3.0});
  EXPECT_EQ(east.position[0], 18.0f);
  EXPECT_EQ(east.position[1], 9.0f);
  EXPECT_EQ(east.position[2], -27.0f);
  EXPECT_EQ(east.velocity[0], 2.0f);
  EXPECT_EQ(east.acceleration[2], -6.0f);
  EXPECT_EQ(east.jerk[1], 7.0f);
  EXPECT_FLOAT_EQ(east.yaw, static_cast<float>(kQuarter));
  EXPECT_EQ(east.yaw_rate, -0.5f);
  EXPECT_NEAR(setpoint_ned(sample, yaw_at(kQuarter), {}).yaw, 0.0f, 1e-7f);
  EXPECT_NEAR(setpoint_ned(sample, yaw_at(2.0 * kQuarter), {}).yaw, static_cast<float>(-kQuarter), 1e-6f);
}

/// A CRC by the book, bit by bit: reflected polynomial 0x8408.
std::uint16_t crc_of(const std::uint8_t* bytes, int count, std::uint8_t extra) {
  std::uint16_t crc = 0xFFFF;
  for (int i = 0; i <= count; ++i) {
    crc = static_cast<std::uint16_t>(crc ^ (i < count ? bytes[i] : extra));
    for (int bit = 0; bit < 8; ++bit) crc = static_cast<std::uint16_t>((crc & 1) != 0 ? (crc >> 1) ^ 0x8408 : crc >> 1);
  }
  return crc;
}

TEST(ExportMavlink, FramesAreTheProtocols) {
  SetpointNed setpoint{};
  for (int a = 0; a < 3; ++a) {
    setpoint.position[a] = 1.5f + static_cast<float>(a);
    setpoint.velocity[a] = -0.25f * static_cast<float>(a + 1);
    setpoint.acceleration[a] = 3.0f;
  }
  setpoint.yaw = 0.5f;
  setpoint.yaw_rate = -0.125f;
  std::uint8_t frame[kMavlinkSetpointBytes];
  const std::int32_t length = mavlink_setpoint(setpoint, {255, 190, 1, 1, 42, 0x01020304}, frame);
  ASSERT_EQ(length, 65);
  const std::uint8_t head[] = {0xFD, 53, 0, 0, 42, 255, 190, 84, 0, 0, 0x04, 0x03, 0x02, 0x01};
  EXPECT_EQ(std::memcmp(frame, head, sizeof head), 0);
  float value;
  std::memcpy(&value, frame + 14, sizeof value);
  EXPECT_EQ(value, 1.5f);
  std::memcpy(&value, frame + 14 + 9 * 4, sizeof value);
  EXPECT_EQ(value, 0.5f);
  const std::uint8_t tail[] = {0, 0, 1, 1, 1};  // type mask, target system and component, LOCAL_NED
  EXPECT_EQ(std::memcmp(frame + 58, tail, sizeof tail), 0);
  const std::uint16_t crc = crc_of(frame + 1, 62, 143);
  EXPECT_EQ(frame[63], crc & 0xFF);
  EXPECT_EQ(frame[64], crc >> 8);
  EXPECT_EQ(crc, 0xdbb8) << "the frame that node-mavlink 2.3 decodes to these numbers";
}

double power_series(const float (&p)[8], double t) {
  double sum = 0.0;
  for (int k = 7; k >= 0; --k) sum = sum * t + p[k];
  return sum;
}

TEST(ExportCrazyflie, PiecesFlyThePlan) {
  const auto planner = std::make_unique<YawPlanner>();
  for (int seed = 0; seed < scaled(200); ++seed) {
    Random random(static_cast<std::uint64_t>(seed) + 1);
    const Trajectory trajectory = tangle(random);
    YawPlan yaw{};
    ASSERT_EQ(planner->plan(trajectory, yaw_request({1.0, 0.0}, 1.0, 2.0), yaw), Status::kOk);
    double begin = 0.0;
    for (int i = 0; i < trajectory.count; ++i) {
      Poly4d piece;
      ASSERT_EQ(poly4d(trajectory, &yaw, i, piece), Status::kOk);
      const double duration = trajectory.segments[i].duration;
      ASSERT_EQ(piece.duration, static_cast<float>(duration));
      for (int k = 0; k <= 20; ++k) {
        const double t = duration * k / 20 * (1.0 - 1e-9);
        const Vec3 at = evaluate(trajectory, begin + t).position;
        const double scale = 2e-5;  // floats, with terms that cancel
        ASSERT_NEAR(power_series(piece.p[0], t), at.x, scale * 20.0) << seed << ' ' << i;
        ASSERT_NEAR(power_series(piece.p[1], t), at.y, scale * 20.0);
        ASSERT_NEAR(power_series(piece.p[2], t), at.z, scale * 20.0);
      }
      for (const double part : {0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0}) {
        ASSERT_NEAR(power_series(piece.p[3], part * duration), evaluate(yaw, begin + part * duration).angle, 1e-3);
      }
      begin += duration;
    }
    Poly4d piece;
    EXPECT_EQ(poly4d(trajectory, nullptr, trajectory.count, piece), Status::kInvalidArgument);
    EXPECT_EQ(poly4d(trajectory, nullptr, -1, piece), Status::kInvalidArgument);
    ASSERT_EQ(poly4d(trajectory, nullptr, 0, piece), Status::kOk);
    for (const float coefficient : piece.p[3]) EXPECT_EQ(coefficient, 0.0f);
  }
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
  ASSERT_EQ(poly4d(trajectory, nullptr, 0, piece), Status::kOk);
  const float wanted[8] = {1.0f, 2.0f, 0.0f, -1.0f, 0.0f, 0.0f, 0.0f, 0.0f};
  for (int k = 0; k < 8; ++k) EXPECT_NEAR(piece.p[0][k], wanted[k], 1e-6f) << k;
}

TEST(ExportCrazyflie, CompressedPointsAreRoundedToMillimetres) {
  std::uint8_t bytes[crazyflie_compressed_bytes(kMaxSegments)];
  for (int seed = 0; seed < scaled(200); ++seed) {
    Random random(static_cast<std::uint64_t>(seed) + 5);
    const Trajectory trajectory = tangle(random);
    std::int32_t used = 0;
    ASSERT_EQ(crazyflie_compressed(trajectory, nullptr, bytes, sizeof bytes, used), Status::kOk);
    ASSERT_EQ(used, 8 + 45 * trajectory.count + 3);
    Trajectory read{};
    ASSERT_EQ(crazyflie_decompressed(bytes, used, trajectory, read), Status::kOk);
    ASSERT_EQ(read.count, trajectory.count);
    for (int i = 0; i < read.count; ++i) {
      ASSERT_NEAR(read.segments[i].duration, trajectory.segments[i].duration, 0.0005 + 1e-12);
      for (int k = 0; k < kControlPoints; ++k) {
        const Vec3& point = trajectory.segments[i].points[k];
        ASSERT_NEAR(read.segments[i].points[k].x, point.x + trajectory.origin.x, 0.0005 + 1e-12);
        ASSERT_NEAR(read.segments[i].points[k].z, point.z + trajectory.origin.z, 0.0005 + 1e-12);
      }
    }
    ASSERT_EQ(crazyflie_decompressed(bytes, used - 1, trajectory, read), Status::kInvalidArgument);
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
  ASSERT_EQ(crazyflie_compressed(trajectory, &yaw, bytes, sizeof bytes, used), Status::kOk);
  ASSERT_EQ(used, crazyflie_compressed_bytes(1));
  EXPECT_EQ(bytes[6] | bytes[7] << 8, 900);
  EXPECT_EQ(bytes[8], 0xFF);
  EXPECT_EQ(bytes[9] | bytes[10] << 8, 2000);
}

TEST(ExportCrazyflie, WhatDoesNotFitIsRefused) {
  std::uint8_t bytes[crazyflie_compressed_bytes(1)];
  std::int32_t used = -1;
  Trajectory far = tern_test::hover(1.0);
  far.origin = {32.768, 0.0, 0.0};
  EXPECT_EQ(crazyflie_compressed(far, nullptr, bytes, sizeof bytes, used), Status::kInvalidArgument);
  far.origin.x = std::nan("");
  EXPECT_EQ(crazyflie_compressed(far, nullptr, bytes, sizeof bytes, used), Status::kInvalidArgument);
  EXPECT_EQ(crazyflie_compressed(tern_test::hover(0.0009), nullptr, bytes, sizeof bytes, used),
            Status::kInvalidArgument);
  EXPECT_EQ(crazyflie_compressed(tern_test::hover(66.0), nullptr, bytes, sizeof bytes, used), Status::kInvalidArgument);
  EXPECT_EQ(crazyflie_compressed(tern_test::hover(1.0), nullptr, bytes, sizeof bytes - 1, used),
            Status::kInvalidArgument);
  EXPECT_EQ(crazyflie_compressed(Trajectory{}, nullptr, bytes, sizeof bytes, used), Status::kInvalidArgument);
  far.count = kMaxSegments + 1;
  EXPECT_EQ(crazyflie_compressed(far, nullptr, bytes, 1 << 20, used), Status::kInvalidArgument);
  EXPECT_EQ(used, -1);
  Poly4d piece{};
  EXPECT_EQ(poly4d(far, nullptr, 0, piece), Status::kInvalidArgument);
}

/// As many pieces as there may be, each of 45 bytes after 8 of the start, and what ends them.
TEST(ExportCrazyflie, AllPiecesAreReadAndNoMore) {
  Trajectory full{};
  full.count = kMaxSegments;
  for (Segment& segment : full.segments) segment.duration = 0.5;
  std::uint8_t bytes[crazyflie_compressed_bytes(kMaxSegments) + 45];
  std::int32_t used = 0;
  ASSERT_EQ(crazyflie_compressed(full, nullptr, bytes, sizeof bytes, used), Status::kOk);
  Trajectory read{};
  ASSERT_EQ(crazyflie_decompressed(bytes, used, full, read), Status::kOk);
  EXPECT_EQ(read.count, kMaxSegments);
  for (const std::int32_t end : {used - 2, used - 1}) {
    bytes[end] = 1;
    EXPECT_EQ(crazyflie_decompressed(bytes, used, full, read), Status::kInvalidArgument) << "the end has a duration";
    bytes[end] = 0;
  }
  std::memcpy(bytes + used - 3, bytes + 8, 45);
  std::memset(bytes + used + 42, 0, 3);
  EXPECT_EQ(crazyflie_decompressed(bytes, used + 45, full, read), Status::kInvalidArgument) << "one piece too many";
  const std::uint8_t nothing[11] = {};
  EXPECT_EQ(crazyflie_decompressed(nothing, 11, full, read), Status::kInvalidArgument) << "no piece";
}

TEST(ExportLimits, AreTheParameters) {
  const Limits px4 = limits_from_px4(px4_limits());
  EXPECT_EQ(px4.v_max.z, 3.0);
  EXPECT_EQ(px4.v_min.z, -1.5);
  EXPECT_EQ(px4.v_horizontal, 12.0);
  EXPECT_EQ(px4.a_min.z, -3.0);
  EXPECT_EQ(px4.a_max.z, 4.0);
  EXPECT_EQ(px4.j_horizontal, 4.0);
  const Limits ardupilot = limits_from_ardupilot(ardupilot_limits());
  EXPECT_EQ(ardupilot.v_horizontal, 10.0);
  EXPECT_EQ(ardupilot.v_min.z, -1.5);
  EXPECT_EQ(ardupilot.a_max.z, 1.0);
  EXPECT_EQ(ardupilot.j_max.z, 5.0);
}

}  // namespace
