// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a sensor sees of a voxel: its view and its lines of sight, worked out by hand.
#include "lookout/optics.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/math.hpp"
#include "lookout/tried.hpp"
#include "lookout/wanted.hpp"
#include "support/lookout_map.hpp"
#include "support/random.hpp"

namespace {

using namespace tern;
using tern_test::LookoutMap;
using tern_test::Random;
using tern_test::scaled;

constexpr double kRight = 1.5707963267948966;  // rad

/// A camera of 90 by 90 degrees.
FlightSensor square_camera() {
  FlightSensor sensor = kLevelCamera;
  sensor.horizontal = sensor.vertical = kRight;
  return sensor;
}

MapSpec plain_map() {
  MapSpec spec = LookoutMap::spec_of_map();
  spec.range = 10.0;
  return spec;
}

/// Of a camera at the origin that looks along x, whose view ends at 45 degrees: a cube of 0.25 m whose nearest face is
/// 4 m away may reach 4 m to the side.
TEST(LookoutOptics, ACameraSeesAPyramid) {
  const Optics optics(square_camera(), plain_map());
  const SensorPose pose = optics.pose({0.0, 0.0, 0.0}, {1.0, 0.0}, {5.0, 0.0, 0.0});
  EXPECT_TRUE(optics.in_view(pose, {4.125, 3.87, 0.0}));
  EXPECT_FALSE(optics.in_view(pose, {4.125, 3.88, 0.0}));
  EXPECT_TRUE(optics.in_view(pose, {4.125, 0.0, -3.87}));
  EXPECT_FALSE(optics.in_view(pose, {4.125, 0.0, -3.88}));
  EXPECT_FALSE(optics.in_view(pose, {-4.125, 0.0, 0.0})) << "behind";
  EXPECT_TRUE(optics.in_view(pose, {9.87, 0.0, 0.0}));
  EXPECT_FALSE(optics.in_view(pose, {9.88, 0.0, 0.0})) << "beyond the range";
  EXPECT_FALSE(optics.in_view(pose, {0.2, 0.0, 0.0})) << "too near";
}

/// The margins of pose, angle and depth make the view smaller.
TEST(LookoutOptics, KeepsMargins) {
  MapSpec spec = plain_map();
  spec.pose_margin = 0.1;
  spec.angle_margin = 0.01;
  spec.depth_margin = 0.2;
  spec.depth_margin_square = 0.01;
  const Optics optics(square_camera(), spec);
  const SensorPose pose = optics.pose({0.0, 0.0, 0.0}, {1.0, 0.0}, {5.0, 0.0, 0.0});
  // 4.125 m away the pose counts 0.14125 m: a face at 3.85875, an edge at 0.26625 from the centre.
  EXPECT_TRUE(optics.in_view(pose, {4.125, 0.0, 3.54}));
  EXPECT_FALSE(optics.in_view(pose, {4.125, 0.0, 3.6}));
  // 8.6 + 0.125 + 0.186 + 0.2 + 0.7396 = 9.8506 is within the range; with 8.8 m it is 10.09.
  EXPECT_TRUE(optics.in_view(pose, {8.6, 0.0, 0.0}));
  EXPECT_FALSE(optics.in_view(pose, {8.8, 0.0, 0.0}));
}

/// A gimbal pitches the camera up to what it should look at, as far as it can.
TEST(LookoutOptics, AGimbalTurnsUp) {
  FlightSensor sensor = square_camera();
  sensor.pitch_max = 1.0;
  const Optics level(square_camera(), plain_map());
  const Optics turning(sensor, plain_map());
  const Vec3 above{1.0, 0.0, 3.0};
  EXPECT_FALSE(level.in_view(level.pose({0.0, 0.0, 0.0}, {1.0, 0.0}, above), above));
  const SensorPose pose = turning.pose({0.0, 0.0, 0.0}, {1.0, 0.0}, above);
  EXPECT_TRUE(turning.in_view(pose, above));
  EXPECT_NEAR(pose.ahead.z, std::sin(1.0), 1e-12);
  EXPECT_NEAR(dot(pose.ahead, pose.right), 0.0, 1e-15);
  EXPECT_NEAR(dot(pose.ahead, pose.down), 0.0, 1e-15);
}

/// A camera that looks down all the time, ahead of the vehicle's centre.
TEST(LookoutOptics, AMountIsPitchedAndOff) {
  FlightSensor sensor = square_camera();
  sensor.pitch_min = sensor.pitch_max = -0.5;
  sensor.offset = {0.5, 0.25, -0.125};
  const Optics optics(sensor, plain_map());
  const SensorPose pose = optics.pose({10.0, 10.0, 5.0}, {0.0, 1.0}, {0.0, 0.0, 0.0});
  EXPECT_NEAR(pose.eye.x, 9.75, 1e-12);
  EXPECT_NEAR(pose.eye.y, 10.5, 1e-12);
  EXPECT_NEAR(pose.eye.z, 4.875, 1e-12);
  EXPECT_NEAR(pose.ahead.y, std::cos(0.5), 1e-12);
  EXPECT_NEAR(pose.ahead.z, -std::sin(0.5), 1e-12);
}

/// A scanner sees all around, up to 30 degrees up and down.
TEST(LookoutOptics, AScannerSeesARing) {
  FlightSensor sensor = kLevelCamera;
  sensor.horizontal = 6.283185307179586;
  sensor.vertical = 2.0 * kRight / 3.0;
  const Optics optics(sensor, plain_map());
  EXPECT_TRUE(optics.is_scanner());
  const SensorPose pose = optics.pose({0.0, 0.0, 0.0}, {1.0, 0.0}, {5.0, 0.0, 0.0});
  for (int k = 0; k < 16; ++k) {
    const double angle = 0.25 * kRight * k;
    EXPECT_TRUE(optics.in_view(pose, {5.0 * std::cos(angle), 5.0 * std::sin(angle), 2.2})) << k;
    EXPECT_FALSE(optics.in_view(pose, {5.0 * std::cos(angle), 5.0 * std::sin(angle), 2.9})) << k;
  }
  sensor.horizontal = 2.0 * kRight + 0.2;  // of half a turn and a little
  const Optics half(sensor, plain_map());
  EXPECT_TRUE(half.in_view(pose, {5.0, 0.0, 0.0}));
  EXPECT_FALSE(half.in_view(pose, {-5.0, 0.0, 0.0}));
}

/// Random cubes that a scanner sees have all corners between its lowest and its highest beams.
TEST(LookoutOptics, AScannerMayBeRaised) {
  Random random(6);
  int seen = 0;
  int missed = 0;
  for (int n = 0; n < scaled(4000); ++n) {
    FlightSensor sensor = kLevelCamera;
    sensor.horizontal = 6.283185307179586;
    sensor.vertical = random.real(0.5, 1.2);
    sensor.raised = random.real(-1.0, 1.0);
    const Optics optics(sensor, plain_map());
    const Vec3 centre{random.real(-8.0, 8.0), random.real(-8.0, 8.0), random.real(-5.0, 5.0)};
    const SensorPose pose = optics.pose({0.0, 0.0, 0.0}, {1.0, 0.0}, centre);
    const double middle = std::atan2(centre.z, std::hypot(centre.x, centre.y));
    const bool is_deep = std::abs(middle - sensor.raised) < 0.5 * sensor.vertical - 0.3 && std::abs(middle) < 1.0 &&
                         std::hypot(centre.x, centre.y, centre.z) < 9.0 && std::hypot(centre.x, centre.y) > 1.5;
    if (!optics.in_view(pose, centre)) {
      EXPECT_FALSE(is_deep) << n;
      ++missed;
      continue;
    }
    ++seen;
    for (int k = 0; k < 8; ++k) {
      const double z = centre.z + (k / 4 == 0 ? -0.125 : 0.125);
      const double flat =
          std::hypot(centre.x + (k % 2 == 0 ? -0.125 : 0.125), centre.y + (k / 2 % 2 == 0 ? -0.125 : 0.125));
      EXPECT_LE(std::abs(std::atan2(z, flat) - sensor.raised), 0.5 * sensor.vertical + 1e-12) << n;
    }
  }
  EXPECT_GT(seen, scaled(4000) / 50);
  EXPECT_GT(missed, scaled(4000) / 50);
}

/// Cubes whose corners are all in view and within the range are in view, and only those.
TEST(LookoutOptics, SeesWholeCubes) {
  Random random(5);
  int seen = 0;
  for (int n = 0; n < scaled(4000); ++n) {
    FlightSensor sensor = kLevelCamera;
    sensor.horizontal = random.real(0.5, 2.5);
    sensor.vertical = random.real(0.5, 2.0);
    sensor.pitch_min = random.real(-0.5, 0.0);
    sensor.pitch_max = sensor.pitch_min + random.real(0.0, 0.5);
    const Optics optics(sensor, plain_map());
    const double turn = random.real(-3.0, 3.0);
    const Vec3 centre{random.real(-8.0, 8.0), random.real(-8.0, 8.0), random.real(-5.0, 5.0)};
    const SensorPose pose = optics.pose({0.0, 0.0, 0.0}, {std::cos(turn), std::sin(turn)}, centre);
    if (!optics.in_view(pose, centre)) continue;
    ++seen;
    for (int k = 0; k < 8; ++k) {
      const Vec3 corner{centre.x + (k % 2 == 0 ? -0.125 : 0.125), centre.y + (k / 2 % 2 == 0 ? -0.125 : 0.125),
                        centre.z + (k / 4 == 0 ? -0.125 : 0.125)};
      const double depth = dot(corner, pose.ahead);
      EXPECT_GE(depth, sensor.nearest - 1e-12);
      EXPECT_LE(depth, 10.0 + 1e-12);
      EXPECT_LE(std::abs(dot(corner, pose.right)), std::tan(0.5 * sensor.horizontal) * depth + 1e-12);
      EXPECT_LE(std::abs(dot(corner, pose.down)), std::tan(0.5 * sensor.vertical) * depth + 1e-12);
    }
  }
  EXPECT_GT(seen, scaled(4000) / 50);
}

/// What was not seen hides nothing. A wall does, in front of a voxel or right behind it, and a wide line of sight meets
/// an edge that a thin one passes.
TEST(LookoutOptics, AWallIsInTheWay) {
  LookoutMap room;
  const Optics optics(square_camera(), LookoutMap::spec_of_map());
  Work work;
  const SensorPose pose = optics.pose({2.125, 8.125, 4.125}, {1.0, 0.0}, {6.125, 8.125, 4.125});
  const auto sees = [&](bool wide) {
    const Vec3 voxel{6.125, 8.125, 4.125};
    return wide ? optics.in_wide_sight(room.map(), pose, voxel, 0.0, work)
                : optics.in_sight(room.map(), pose.eye, voxel, work);
  };
  EXPECT_TRUE(sees(true));
  room.mark({{5.5, 8.25, 0.0}, {5.75, 12.0, 8.0}});  // beside the line, half a voxel from it
  EXPECT_FALSE(sees(true));
  EXPECT_TRUE(sees(false));
  room.mark({{6.25, 0.0, 0.0}, {6.5, 16.0, 8.0}});  // right behind the voxel
  EXPECT_FALSE(sees(false));
  EXPECT_LT(work.operations(), 0);
}

/// A floor 0.25 m below a cube, 2 m away. The ray over the lower edge of the cube's near face falls by (h - 0.25)
/// / 1.875 a metre, where h is the eye's height above the floor. At the far face, 2.125 m away, it must be a twentieth
/// of a voxel above the floor, as all lines of sight: h - 2.125 (h - 0.25) / 1.875 > 0.0125, so h < 2.031.
///
/// A cube on the floor is in no wide sight. Lines that are narrower by three quarters of a voxel pass its middle:
/// h - 2.125 (h - 0.125) / 1.875 > 0.0125, so h < 0.969.
TEST(LookoutOptics, AFloorHidesWhatIsRightAboveIt) {
  LookoutMap room;
  room.mark({{0.0, 0.0, 0.0}, {32.0, 16.0, 1.0}});
  MapSpec spec = LookoutMap::spec_of_map();
  spec.angle_margin = spec.depth_margin_square = 0.0;
  const Optics optics(square_camera(), spec);
  const auto sees = [&](double z, double height, double narrower) {
    Work work;
    const SensorPose pose = optics.pose({2.125, 8.125, 1.0 + height}, {1.0, 0.0}, {4.125, 8.125, z});
    return optics.in_wide_sight(room.map(), pose, {4.125, 8.125, z}, narrower, work);
  };
  EXPECT_TRUE(sees(1.375, 0.5, 0.0));
  EXPECT_TRUE(sees(1.375, 2.03, 0.0));
  EXPECT_FALSE(sees(1.375, 2.04, 0.0));
  for (const double height : {0.25, 0.5, 1.0, 2.0}) EXPECT_FALSE(sees(1.125, height, 0.0)) << height;
  EXPECT_TRUE(sees(1.125, 0.96, 0.75));
  EXPECT_FALSE(sees(1.125, 0.98, 0.75));
}

/// In empty space all within the radius is wanted of a place, once; then the next place's.
TEST(LookoutWanted, IsWhatIsNear) {
  LookoutMap room;
  room.see_free({4.0, 6.0, 2.0}, {8.0, 10.0, 6.0});
  Wanted wanted{};
  wanted.clear();
  Work work;
  wanted.add_around(room.map(), {6.125, 8.125, 4.125}, 0.5, 0, 1, work);
  EXPECT_EQ(wanted.count, 0);
  wanted.add_around(room.map(), {7.625, 8.125, 4.125}, 0.5, 1, 1, work);
  // Beyond the face at 8 m, 0.375 m away: cubes whose face is less than sqrt(0.25 - 0.140625) = 0.331 m to the sides.
  // The nearest edges of the rows beside the middle one are 0.125 m and 0.375 m off it: 3 x 3, of which all count, as
  // 0.125^2 + 0.125^2 < 0.109375.
  EXPECT_EQ(wanted.count, 9);
  EXPECT_EQ(wanted.dense, 9);
  for (std::int32_t k = 0; k < wanted.count; ++k) EXPECT_DOUBLE_EQ(wanted.voxel[k].centre.x, 8.125);
  wanted.add_around(room.map(), {7.625, 8.125, 4.125}, 0.5, 2, 1, work);
  EXPECT_EQ(wanted.count, 9) << "each voxel once";
  EXPECT_DOUBLE_EQ(wanted.middle(true).y, 8.125);
}

/// The first part is dense, the rest is thin, and there are never more than there is room for.
TEST(LookoutWanted, IsThinFurtherOn) {
  LookoutMap room;
  Wanted wanted{};
  wanted.clear();
  Work work;
  for (int k = 0; k < 60; ++k) wanted.add_around(room.map(), {2.125 + 0.5 * k, 8.125, 4.125}, 0.5, k, 2, work);
  EXPECT_EQ(wanted.count, kMaxWanted);
  EXPECT_EQ(wanted.dense, kDenseWanted);
  for (std::int32_t k = 1; k < wanted.count; ++k) EXPECT_GE(wanted.voxel[k].at, wanted.voxel[k - 1].at);
  EXPECT_GE(wanted.voxel[kMaxWanted - 1].at - wanted.voxel[kDenseWanted].at, 20);
}

/// A line at 8.125, 8.125: a radius of 0.3 m meets 3 x 3 columns, 0.125 m and 0.177 m away. Ground up to 2.9 m: the
/// voxels from 3 m up are above it, and those from 2.75 m up are the highest that hold ground.
TEST(LookoutWanted, IsAllBelowAPlaceToLand) {
  LookoutMap room;
  const Vec3 place{8.125, 8.125, 4.125};
  const auto wanted_in = [&] {
    Wanted wanted{};
    wanted.clear();
    Work work;
    wanted.add_site(room.map(), place, 0.3, 2.9, 7, work);
    EXPECT_EQ(wanted.dense, wanted.count < kDenseWanted ? wanted.count : kDenseWanted);
    for (std::int32_t k = 0; k < wanted.count; ++k) EXPECT_EQ(wanted.voxel[k].at, 7);
    return wanted.count;
  };
  EXPECT_EQ(wanted_in(), 9 * 6) << "from 2.75 m to the voxel that holds the place";
  room.see_free({6.0, 6.0, 3.25}, {10.0, 10.0, 6.0});
  EXPECT_EQ(wanted_in(), 9 * 2);
  room.see_free({6.0, 6.0, 3.0}, {10.0, 10.0, 6.0});
  EXPECT_EQ(wanted_in(), 9);
  room.mark({{8.01, 8.01, 2.8}, {8.24, 8.24, 2.9}});
  EXPECT_EQ(wanted_in(), 8) << "ground was hit there";
  room.mark({{8.26, 8.01, 2.6}, {8.49, 8.24, 2.7}});
  EXPECT_EQ(wanted_in(), 7) << "and here, a voxel deeper";
  room.see_free({6.0, 6.0, 2.75}, {10.0, 10.0, 6.0});
  EXPECT_EQ(wanted_in(), 7) << "where the upper one is free, the lower one is wanted";
  room.see_free({6.0, 6.0, 2.5}, {10.0, 10.0, 6.0});
  EXPECT_EQ(wanted_in(), 0) << "there is no ground";
}

TEST(LookoutWanted, OnlyWhatIsInTheWindowCanBeUnseen) {
  LookoutMap room;
  EXPECT_TRUE(is_unseen_at(room.map(), {1.0, 1.0, 1.0}));
  EXPECT_FALSE(is_unseen_at(room.map(), {-1.0, 1.0, 1.0}));
  room.mark({{1.0, 1.0, 1.0}, {1.25, 1.25, 1.25}});
  EXPECT_FALSE(is_unseen_at(room.map(), {1.125, 1.125, 1.125}));
}

/// 20 degrees to the side count as another direction; three directions make a voxel hopeless.
TEST(LookoutTried, RemembersDirections) {
  Tried tried{};
  tried.clear();
  const Vec3 voxel{5.0, 0.0, 1.0};
  EXPECT_LT(tried.find(voxel, 0.2), 0);
  tried.note_voxel(voxel, {0.0, 0.0, 1.0}, 0.2);
  const std::int32_t entry = tried.find(voxel, 0.2);
  ASSERT_GE(entry, 0);
  EXPECT_TRUE(tried.voxel[entry].was_tried_from({-3.0, 0.0, 1.0}));
  EXPECT_TRUE(tried.voxel[entry].was_tried_from({0.0, 1.5, 1.0}));
  EXPECT_FALSE(tried.voxel[entry].was_tried_from({0.0, 2.0, 1.0}));
  tried.note_voxel(voxel, {5.0, 5.0, 1.0}, 0.2);
  EXPECT_FALSE(tried.voxel[entry].is_hopeless());
  tried.note_voxel(voxel, {5.0, 0.0, 4.0}, 0.2);
  EXPECT_TRUE(tried.voxel[entry].is_hopeless());
  EXPECT_EQ(tried.kept_voxels(), 1);
}

/// The oldest entries make room for new ones.
TEST(LookoutTried, ForgetsTheOldest) {
  Tried tried{};
  tried.clear();
  for (int k = 0; k <= kTriedVoxels; ++k) tried.note_voxel({0.2 * k, 0.0, 0.0}, {0.0, -3.0, 0.0}, 0.2);
  EXPECT_EQ(tried.kept_voxels(), kTriedVoxels);
  EXPECT_LT(tried.find({0.0, 0.0, 0.0}, 0.2), 0);
  EXPECT_GE(tried.find({0.2 * kTriedVoxels, 0.0, 0.0}, 0.2), 0);
  for (int k = 0; k <= kFailedLookouts; ++k) tried.note_failure({2.0 * k, 0.0, 0.0}, {0.0, 0.0, 0.0});
  EXPECT_FALSE(tried.has_failed({0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, 0.2));
  EXPECT_TRUE(tried.has_failed({2.0, 0.4, 0.0}, {0.0, 0.4, 0.0}, 0.2));
  EXPECT_FALSE(tried.has_failed({2.0, 0.4, 0.0}, {0.0, 0.6, 0.0}, 0.2));
}

}  // namespace
