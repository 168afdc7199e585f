// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Plans for flight stacks: frames, bytes, and curves that are the plan's.
#include <gtest/gtest.h>

#include <algorithm>
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
  const SetpointNed any = setpoint_ned(sample, {1.0, 2.0, 3.0});
  EXPECT_TRUE(std::isnan(any.yaw) && std::isnan(any.yaw_rate));
  EXPECT_EQ(any.position[2], -27.0f);
}

/// A plan in motion with its origin anywhere.
double apart(const SetpointNed& setpoint, const Vec3& position, const Vec3& origin) {
  const Vec3 ned = ned_from_enu({position.x - origin.x, position.y - origin.y, position.z - origin.z});
  return std::sqrt((setpoint.position[0] - ned.x) * (setpoint.position[0] - ned.x) +
                   (setpoint.position[1] - ned.y) * (setpoint.position[1] - ned.y) +
                   (setpoint.position[2] - ned.z) * (setpoint.position[2] - ned.z));
}

TEST(ExportFrames, TheErrorOfSetpointsIsABoundAndSmallNearTheOrigin) {
  const auto planner = std::make_unique<YawPlanner>();
  for (int seed = 0; seed < scaled(50); ++seed) {
    Random random(static_cast<std::uint64_t>(seed) + 9);
    const Vec3 utm{500000.0 + random.real(0.0, 10.0), 4000000.0 + random.real(0.0, 10.0), 101.0};
    const Trajectory trajectory = tangle_at(random, utm);
    YawPlan yaw{};
    ASSERT_EQ(planner->plan(trajectory, yaw_request({1.0, 0.0}, 1.0, 2.0), yaw), Status::kOk);
    for (const Vec3& origin : {Vec3{0.0, 0.0, 0.0}, utm}) {
      const ExportError error = setpoint_error(trajectory, &yaw, origin);
      double most = 0.0;
      for (int k = 0; k <= 500; ++k) {
        const double t = duration(trajectory) * k / 500;
        const Sample sample = evaluate(trajectory, t);
        const SetpointNed setpoint = setpoint_ned(sample, evaluate(yaw, t), origin);
        most = std::max(most, apart(setpoint, sample.position, origin));
        ASSERT_LE(std::abs(setpoint.velocity[0] - sample.velocity.y), error.velocity);
        ASSERT_LE(std::abs(setpoint.acceleration[1] - sample.acceleration.x), error.acceleration);
        ASSERT_LE(std::abs(setpoint.jerk[2] + sample.jerk.z), error.jerk);
        ASSERT_LE(std::abs(setpoint.yaw_rate + evaluate(yaw, t).yaw.rate), error.yaw_rate);
      }
      EXPECT_LE(most, error.position);
      EXPECT_LT(error.yaw, 2e-7);
      if (origin.x > 0.0) {
        EXPECT_LT(error.position, 1e-5);
      } else {
        EXPECT_GT(most, 0.005);
        EXPECT_LT(error.position, 0.3);
      }
    }
  }
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

TEST(ExportFrames, TheErrorOfAMalformedPlanReadsNothingBeyondIt) {
  Trajectory trajectory{};
  trajectory.count = kMaxSegments + 1;
  for (Segment& segment : trajectory.segments) segment.duration = 1.0;
  EXPECT_LT(setpoint_error(trajectory, nullptr, {}).jerk, 1e-40);
  EXPECT_TRUE(std::isnan(setpoint_error(trajectory, nullptr, {std::nan(""), 0.0, 0.0}).position));
}

int mask_of(const SetpointNed& setpoint) {
  std::uint8_t frame[kMavlinkSetpointBytes];
  EXPECT_EQ(mavlink_setpoint(setpoint, {255, 190, 1, 1, 0, 0}, frame), 65);
  return frame[58] | frame[59] << 8;
}

TEST(ExportMavlink, WhatIsNotANumberIsMaskedAndWhatIsInfiniteRefused) {
  const Sample sample{{1.0, 2.0, 3.0}, {1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}, {7.0, 8.0, 9.0}, {}};
  EXPECT_EQ(mask_of(setpoint_ned(sample, yaw_at(0.0), {})), 0);
  EXPECT_EQ(mask_of(setpoint_ned(sample, {})), 3072) << "yaw and yaw rate";
  const SetpointNed whole = setpoint_ned(sample, yaw_at(0.0), {});
  const float nan = std::nanf("");
  for (int a = 0; a < 3; ++a) {
    SetpointNed part = whole;
    part.position[a] = nan;
    EXPECT_EQ(mask_of(part), 1 << a);
    part = whole;
    part.velocity[a] = nan;
    EXPECT_EQ(mask_of(part), 8 << a);
    part = whole;
    part.acceleration[a] = nan;
    part.jerk[a] = nan;
    EXPECT_EQ(mask_of(part), 64 << a);
  }
  SetpointNed part = whole;
  part.yaw = nan;
  EXPECT_EQ(mask_of(part), 1024);
  std::uint8_t frame[kMavlinkSetpointBytes];
  part.yaw_rate = -HUGE_VALF;
  EXPECT_EQ(mavlink_setpoint(part, {255, 190, 1, 1, 0, 0}, frame), 0);
  part = whole;
  part.position[0] = HUGE_VALF;  // finite numbers after it do not mend that
  EXPECT_EQ(mavlink_setpoint(part, {255, 190, 1, 1, 0, 0}, frame), 0);
}

}  // namespace
