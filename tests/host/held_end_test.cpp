// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A nose that still turns when the trajectory ends: files go on until it rests.
#include "host/export/held_end.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <string>

#include "host/export/plan_export.hpp"

namespace {

using tern_host::PlanResult;

constexpr double kHeading = 3.1;
constexpr double kHalfPi = 1.57079632679489662;
const tern::Vec3 kOrigin{0.0, 0.0, 0.0};

/// Across a room in some seconds, while the nose turns for some sixteen.
PlanResult slow_turn(const std::string& records = "", double rate_max = 0.2) {
  const std::string room = "boundary 0 0 0 8 6 3\nstart 1 1 1\ngoal 7 5 1\nyaw fixed 3.1\nyaw_rate_max ";
  PlanResult result =
      tern_host::Session().plan(tern_host::parse_scenario(room + std::to_string(rate_max) + "\n" + records, "map.txt"));
  EXPECT_TRUE(result.ok());
  EXPECT_NE(result.yaw, nullptr);
  return result;
}

/// A number in the last MAVLink frame's payload, which begins 10 bytes after the frame's beginning.
float last_float(const std::string& frames, int offset) {
  const std::size_t begin = frames.rfind('\xFD', frames.size() - 50);
  float value = 0.0f;
  std::memcpy(&value, frames.data() + begin + 10 + offset, sizeof value);
  return value;
}

double power_sum(const float (&row)[8], double t, int derivative) {
  double sum = 0.0;
  for (int k = 7; k >= derivative; --k) sum = sum * t + static_cast<double>(row[k]) * (derivative == 1 ? k : 1);
  return sum;
}

TEST(HeldEnd, PositionIsHeldUntilTheYawPlanEnds) {
  const PlanResult result = slow_turn();
  const double end = tern::duration(result.trajectory);
  EXPECT_GT(tern::evaluate(*result.yaw, end).yaw.rate, 0.19);
  EXPECT_DOUBLE_EQ(tern_host::export_end(result), tern::duration(*result.yaw));
  const tern::Trajectory held = tern_host::held_trajectory(result);
  EXPECT_NEAR(tern::duration(held), tern::duration(*result.yaw), 1e-9);
  for (const double share : {0.1, 0.5, 1.0}) {
    const tern::Sample sample = tern::evaluate(held, end + share * (tern::duration(held) - end));
    EXPECT_NEAR(sample.position.x, 7.0, 1e-6);
    EXPECT_NEAR(sample.position.y, 5.0, 1e-6);
    EXPECT_EQ(sample.velocity.x, 0.0);
  }
}

TEST(HeldEnd, WithoutYawFilesEndWithTheTrajectory) {
  PlanResult result = slow_turn();
  result.yaw = nullptr;
  EXPECT_EQ(tern_host::export_end(result), tern::duration(result.trajectory));
  EXPECT_EQ(tern_host::held_trajectory(result).count, result.trajectory.count);
}

TEST(HeldEnd, LastSetpointsRestAtTheHeading) {
  const PlanResult result = slow_turn();
  const tern_host::SetpointStream mavlink = tern_host::mavlink_stream(result, 50.0, kOrigin);
  EXPECT_EQ(mavlink.count, static_cast<int>(std::ceil(50.0 * tern::duration(*result.yaw))) + 1);
  EXPECT_NEAR(last_float(mavlink.content, 4), 5.0f, 1e-5f);  // north is y
  EXPECT_NEAR(std::remainder(static_cast<double>(last_float(mavlink.content, 40)) - (kHalfPi - kHeading), 4 * kHalfPi),
              0.0, 1e-5);
  EXPECT_EQ(last_float(mavlink.content, 44), 0.0f);
  const tern_host::SetpointStream multidof = tern_host::multidof_yaml(result, 50.0, kOrigin);
  EXPECT_EQ(multidof.count, mavlink.count);
  const std::string last = multidof.content.substr(multidof.content.rfind("- transforms"));
  EXPECT_NE(last.find("angular: {x: 0, y: 0, z: 0}"), std::string::npos) << last;
}

TEST(HeldEnd, CrazyfliePiecesEndAtTheHeading) {
  const PlanResult result = slow_turn();
  const tern_host::RawForm raw = tern_host::crazyflie_raw(result, kOrigin);
  double duration = 0.0;
  for (const tern::Poly4d& piece : raw.pieces) duration += static_cast<double>(piece.duration);
  EXPECT_NEAR(duration, tern::duration(*result.yaw), 1e-5);
  const tern::Poly4d& last = raw.pieces.back();
  const double t = static_cast<double>(last.duration);
  EXPECT_NEAR(power_sum(last.p[0], t, 0), 7.0, 1e-5);
  EXPECT_NEAR(power_sum(last.p[3], t, 0), kHeading, 1e-4);
  EXPECT_NEAR(power_sum(last.p[3], t, 1), 0.0, 1e-4);
  EXPECT_LE(raw.error.yaw, tern::kCrazyflieYaw);
}

TEST(HeldEnd, CompressedPiecesEndAtTheHeading) {
  const PlanResult result = slow_turn("", 0.03);  // for longer than the 65.535 s of a piece
  const tern_host::CompressedForm form = tern_host::crazyflie_compressed(result, kOrigin);
  EXPECT_GT(tern::duration(form.curve), 100.0);
  EXPECT_NEAR(tern::duration(form.curve), tern::duration(*result.yaw), 1e-3);
  EXPECT_NEAR(tern::evaluate(form.curve, 100.0).position.x, 7.0, 1e-3);
  EXPECT_LE(form.error.yaw, tern::kCrazyflieYaw);
  const auto* yaw = reinterpret_cast<const std::uint8_t*>(form.bytes.data() + form.bytes.size() - 5);
  EXPECT_NEAR((yaw[0] | yaw[1] << 8) / 10.0, kHeading * 90.0 / kHalfPi, 0.1);  // tenths of a degree
}

TEST(HeldEnd, APlanThatEndsInMotionIsNotHeld) {
  const PlanResult result = slow_turn("goal_velocity 0.2 0 0\n");
  EXPECT_FALSE(tern_host::ends_at_rest(result.trajectory));
  EXPECT_EQ(tern_host::export_end(result), tern::duration(result.trajectory));
  EXPECT_EQ(tern_host::held_trajectory(result).count, result.trajectory.count);
}

TEST(HeldEnd, NoRoomToHoldIsRefused) {
  PlanResult result = slow_turn();
  result.trajectory.count = tern::kMaxSegments;
  for (int i = 1; i < tern::kMaxSegments; ++i) result.trajectory.segments[i] = result.trajectory.segments[0];
  for (tern::Segment& segment : result.trajectory.segments) {
    segment.duration = 0.01;
    std::fill(std::begin(segment.points), std::end(segment.points), tern::Vec3{});
  }
  EXPECT_THROW(tern_host::held_trajectory(result), std::runtime_error);
  EXPECT_THROW(tern_host::crazyflie_compressed(result, kOrigin), std::runtime_error);
  result.trajectory.count = tern::kCrazyfliePieces;
  try {
    tern_host::crazyflie_raw(result, kOrigin);
    ADD_FAILURE() << "a piece too many";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("32 segments, 1 of them to hold the position"), std::string::npos);
  }
}

}  // namespace
