// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The C interface of exports: null pointers and bytes that are none of a plan.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/random.hpp"
#include "tern_stacks/stacks.h"

namespace {

constexpr std::uint8_t kInvalid = static_cast<std::uint8_t>(tern::Status::kInvalidArgument);

tern_trajectory hover() {
  tern_trajectory plan{};
  plan.count = 1;
  plan.segments[0].duration = 1.0;
  return plan;
}

TEST(ExportC, NullPointersHaveAnswers) {
  tern_setpoint setpoint{};
  setpoint.yaw = 7.0f;
  tern_setpoint_ned(nullptr, nullptr, nullptr, &setpoint);
  EXPECT_EQ(setpoint.position[0], 0.0f);
  EXPECT_TRUE(std::isnan(setpoint.yaw) && std::isnan(setpoint.yaw_rate));
  tern_setpoint_ned(nullptr, nullptr, nullptr, nullptr);
  tern_attitude_ned(nullptr, nullptr);
  std::uint8_t frame[TERN_MAVLINK_SETPOINT_BYTES];
  const tern_mavlink_header header{};
  EXPECT_EQ(tern_mavlink_setpoint(nullptr, &header, frame), 0);
  EXPECT_EQ(tern_mavlink_setpoint(&setpoint, nullptr, frame), 0);
  EXPECT_EQ(tern_mavlink_setpoint(&setpoint, &header, nullptr), 0);
  EXPECT_GT(tern_mavlink_setpoint(&setpoint, &header, frame), 12);
  const tern_trajectory plan = hover();
  tern_crazyflie_piece pieces[TERN_CRAZYFLIE_PIECES];
  constexpr std::int32_t room = TERN_CRAZYFLIE_PIECES;
  std::int32_t count = 0;
  tern_export_error error{};
  EXPECT_EQ(tern_setpoint_error(nullptr, nullptr, nullptr, &error), kInvalid);
  EXPECT_EQ(tern_setpoint_error(&plan, nullptr, nullptr, nullptr), kInvalid);
  EXPECT_EQ(tern_setpoint_error(&plan, nullptr, nullptr, &error), 0);
  EXPECT_EQ(tern_crazyflie_raw(nullptr, nullptr, nullptr, pieces, room, &count, &error), kInvalid);
  EXPECT_EQ(tern_crazyflie_raw(&plan, nullptr, nullptr, nullptr, room, &count, &error), kInvalid);
  EXPECT_EQ(tern_crazyflie_raw(&plan, nullptr, nullptr, pieces, room, nullptr, &error), kInvalid);
  EXPECT_EQ(tern_crazyflie_raw(&plan, nullptr, nullptr, pieces, room, &count, nullptr), kInvalid);
  EXPECT_EQ(tern_crazyflie_raw(&plan, nullptr, nullptr, pieces, room, &count, &error), 0);
  EXPECT_EQ(count, 1);
  std::uint8_t bytes[TERN_CRAZYFLIE_COMPRESSED_BYTES(1)];
  std::int32_t used = 0;
  EXPECT_EQ(tern_crazyflie_compressed(nullptr, nullptr, nullptr, bytes, sizeof bytes, &used, &error), kInvalid);
  EXPECT_EQ(tern_crazyflie_compressed(&plan, nullptr, nullptr, nullptr, sizeof bytes, &used, &error), kInvalid);
  EXPECT_EQ(tern_crazyflie_compressed(&plan, nullptr, nullptr, bytes, sizeof bytes, nullptr, &error), kInvalid);
  EXPECT_EQ(tern_crazyflie_compressed(&plan, nullptr, nullptr, bytes, sizeof bytes, &used, nullptr), kInvalid);
  tern_trajectory read;
  EXPECT_EQ(tern_crazyflie_decompressed(nullptr, 100, nullptr, &read), kInvalid);
  EXPECT_EQ(tern_crazyflie_decompressed(bytes, 100, nullptr, nullptr), kInvalid);
  tern_px4_defaults(nullptr);
  tern_crazyflie_defaults(nullptr);
  tern_ardupilot_defaults(nullptr);
  EXPECT_EQ(tern_limits_from_px4(nullptr, nullptr, nullptr), kInvalid);
  EXPECT_EQ(tern_limits_from_ardupilot(nullptr, nullptr, nullptr), kInvalid);
}

TEST(ExportC, ArgumentsAreUsed) {
  tern_sample sample{};
  sample.position = {1.0, 2.0, 3.0};
  const tern_vec3 origin{1.0, 1.0, 1.0};
  const tern_yaw_sample north{{0.0, 1.0, 0.0}, 0.0, 0.0};
  tern_setpoint setpoint{};
  tern_setpoint_ned(&sample, &north, &origin, &setpoint);
  EXPECT_NEAR(setpoint.position[0], 1.0f, 1e-6f);
  EXPECT_NEAR(setpoint.position[1], 0.0f, 1e-6f);
  EXPECT_NEAR(setpoint.position[2], -2.0f, 1e-6f);
  EXPECT_NEAR(setpoint.yaw, 0.0f, 1e-6f);
  tern_trajectory plan = hover();
  plan.origin = {4e6, 0.0, 0.0};
  tern_export_error far{};
  tern_export_error near{};
  ASSERT_EQ(tern_setpoint_error(&plan, nullptr, nullptr, &far), 0);
  ASSERT_EQ(tern_setpoint_error(&plan, nullptr, &plan.origin, &near), 0);
  EXPECT_GT(far.position, 0.1);
  EXPECT_LT(near.position, 1e-8);
  tern_crazyflie_piece piece;
  std::int32_t count = 0;
  ASSERT_EQ(tern_crazyflie_raw(&plan, nullptr, &plan.origin, &piece, 1, &count, &near), 0);
  EXPECT_EQ(piece.p[0][0], 0.0f);
  const double level[4] = {1.0, 0.0, 0.0, 0.0};
  double ned[4] = {7.0, 7.0, 7.0, 7.0};
  tern_attitude_ned(level, nullptr);
  tern_attitude_ned(level, ned);
  EXPECT_NEAR(ned[0] * ned[0] + ned[3] * ned[3], 1.0, 1e-12);
  EXPECT_NEAR(std::abs(ned[0]), std::abs(ned[3]), 1e-12);
}

TEST(ExportC, ParametersBecomeLimits) {
  tern_px4_parameters px4{};
  tern_px4_defaults(&px4);
  tern_limits limits{};
  std::uint8_t field = 99;
  EXPECT_EQ(tern_limits_from_px4(&px4, nullptr, nullptr), kInvalid);
  ASSERT_EQ(tern_limits_from_px4(&px4, &limits, &field), 0);
  EXPECT_EQ(field, 0);
  tern_limits of_px4{};
  ASSERT_EQ(tern::limits_from_px4(tern::px4_limits(), of_px4), tern::Status::kOk);
  EXPECT_EQ(limits.v_max.z, of_px4.v_max.z);
  EXPECT_GT(limits.v_max.z, 0.0);
  tern_ardupilot_parameters ardupilot{};
  tern_ardupilot_defaults(&ardupilot);
  EXPECT_EQ(tern_limits_from_ardupilot(&ardupilot, nullptr, nullptr), kInvalid);
  ASSERT_EQ(tern_limits_from_ardupilot(&ardupilot, &limits, nullptr), 0);
  EXPECT_EQ(limits.a_max.x, 2.5);
  tern_crazyflie_parameters crazyflie{};
  tern_crazyflie_defaults(&crazyflie);
  EXPECT_EQ(tern_limits_from_crazyflie(&crazyflie, nullptr, nullptr), kInvalid);
  tern_limits of_crazyflie{};
  ASSERT_EQ(tern_limits_from_crazyflie(&crazyflie, &of_crazyflie, nullptr), 0);
  EXPECT_EQ(of_crazyflie.v_max.z, 1.0);
  ardupilot.wpnav_speed_m_s = 1000.0;
  EXPECT_STREQ(tern_status_name(tern_limits_from_ardupilot(&ardupilot, &limits, &field)), "limits_invalid");
  EXPECT_STREQ(tern_field_name(field), "v_horizontal");
  EXPECT_EQ(limits.a_max.x, 2.5);
}

TEST(ExportC, CompressedBytesEndWithAnEmptyPiece) {
  const tern_trajectory plan = hover();
  std::uint8_t bytes[TERN_CRAZYFLIE_COMPRESSED_BYTES(1)];
  std::int32_t used = 0;
  tern_export_error error{};
  ASSERT_EQ(tern_crazyflie_compressed(&plan, nullptr, nullptr, bytes, sizeof bytes, &used, &error), 0);
  tern_trajectory read{};
  ASSERT_EQ(tern_crazyflie_decompressed(bytes, used, nullptr, &read), 0);
  EXPECT_EQ(read.count, 1);
  EXPECT_EQ(tern_crazyflie_decompressed(bytes, used, nullptr, nullptr), kInvalid);
  for (const int wrong : {1, 2}) {
    bytes[used - wrong] ^= 1;
    EXPECT_EQ(tern_crazyflie_decompressed(bytes, used, nullptr, &read), kInvalid) << wrong;
    bytes[used - wrong] ^= 1;
  }
  EXPECT_EQ(tern_crazyflie_decompressed(bytes, used - 1, nullptr, &read), kInvalid);
}

TEST(ExportC, HostileBytesAreReadWithinTheirLengthAndRefusedOrAPlan) {
  tern_test::Random random(11);
  for (int i = 0; i < tern_test::scaled(20000); ++i) {
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(random.integer(0, 400)));
    for (std::uint8_t& byte : bytes) {
      byte = static_cast<std::uint8_t>(random.chance(0.3) ? 0x3F : random.chance(0.3) ? 0 : random.integer(0, 255));
    }
    tern_trajectory read;
    const auto count = static_cast<std::int32_t>(bytes.size());
    if (tern_crazyflie_decompressed(bytes.data(), count, nullptr, &read) != 0) continue;
    ASSERT_GT(read.count, 0);
    ASSERT_LE(read.count, tern::kMaxSegments);
  }
}

}  // namespace
