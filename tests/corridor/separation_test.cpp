// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "corridor/separation.hpp"

#include <gtest/gtest.h>

#include "support/corridor_reference.hpp"
#include "support/random.hpp"

namespace tern_test {
namespace {

using tern::Box;
using tern::Halfspace;
using tern::LocalBox;
using tern::SegmentMargin;
using tern::Status;
using tern::Vec3;

constexpr Vec3 kNoTangent{0.0, 0.0, 0.0};
const LocalBox kUnit{{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}};

TEST(CorridorSeparation, KeepsATangentThatLeavesRoom) {
  const SegmentMargin segment{{-2.0, 0.5, 0.5}, {-1.0, 0.5, 0.5}, 0.01};
  Halfspace plane;
  ASSERT_EQ(separate(segment, kUnit, 0.25, {0.8, 0.6, 0.0}, plane), Status::kOk);
  EXPECT_DOUBLE_EQ(plane.normal.x, 0.8);
  EXPECT_DOUBLE_EQ(plane.normal.y, 0.6);
  EXPECT_NEAR(plane.offset, -0.25, 1e-9);  // the corner at the origin, less the radius
}

TEST(CorridorSeparation, TurnsATangentThatCutsTheSegment) {
  const SegmentMargin segment{{-1.0, 0.5, 0.5}, {-1.0, 3.0, 0.5}, 0.01};
  Halfspace plane;
  ASSERT_EQ(separate(segment, kUnit, 0.0, {0.0, 1.0, 0.0}, plane), Status::kOk);
  const double excess = std::max(signed_excess(plane, segment.from), signed_excess(plane, segment.to));
  EXPECT_LE(excess, -tern::kMostMargin + 1e-12);
  EXPECT_GT(plane.normal.y, 0.0) << "as near to the tangent as the margin lets it";
}

TEST(CorridorSeparation, WithoutATangentTakesTheClosestPair) {
  const SegmentMargin segment{{-1.0, 0.5, 0.5}, {-3.0, 0.5, 0.5}, 0.01};
  Halfspace plane;
  ASSERT_EQ(separate(segment, kUnit, 0.5, kNoTangent, plane), Status::kOk);
  EXPECT_DOUBLE_EQ(plane.normal.x, 1.0);
  EXPECT_NEAR(plane.offset, -0.5, 1e-9);
}

TEST(CorridorSeparation, ExactlyAtTheRadiusStillHolds) {
  const SegmentMargin segment{{-0.3, 0.5, 0.5}, {-3.0, 0.5, 0.5}, 0.01};
  Halfspace plane;
  ASSERT_EQ(separate(segment, kUnit, 0.3, {0.0, 0.0, 1.0}, plane), Status::kOk);
  EXPECT_NEAR(plane.offset, -0.3, 1e-12);
  EXPECT_LE(signed_excess(plane, segment.from), 0.0);
}

TEST(CorridorSeparation, NearerThanTheRadiusIsBlocked) {
  const SegmentMargin segment{{-0.29, 0.5, 0.5}, {-3.0, 0.5, 0.5}, 0.01};
  Halfspace plane;
  EXPECT_EQ(separate(segment, kUnit, 0.3, {1.0, 0.0, 0.0}, plane), Status::kCorridorBlocked);
}

/// No axis of the box separates a point beside its corner as well as the direction from the corner does, and a point
/// has no direction of its own.
TEST(CorridorSeparation, APointJustBesideACornerKeepsItsGap) {
  const double aside = 0.3e-7;
  const SegmentMargin segment{{-aside, -aside, -aside}, {-aside, -aside, -aside}, 1e-9};
  ASSERT_LT(std::sqrt(3.0) * aside, segment.direction) << "too near for the closest pair alone";
  Halfspace plane;
  ASSERT_EQ(separate(segment, kUnit, 0.0, kNoTangent, plane), Status::kOk);
  for (const double part : {plane.normal.x, plane.normal.y, plane.normal.z}) {
    EXPECT_NEAR(part, std::sqrt(1.0 / 3.0), 1e-9);
  }
  EXPECT_NEAR(plane.offset, 0.0, 1e-12);
  EXPECT_NEAR(signed_excess(plane, segment.from), -std::sqrt(3.0) * aside, 1e-12);
}

TEST(CorridorSeparation, AStartOnAFaceTakesTheFace) {
  const SegmentMargin segment{{1.0, 0.5, 0.5}, {2.0, 0.7, 0.5}, 0.01};
  Halfspace plane;
  ASSERT_EQ(separate(segment, kUnit, 0.0, kNoTangent, plane), Status::kOk);
  EXPECT_EQ(plane.normal.x, -1.0);
  EXPECT_EQ(plane.offset, -1.0);
}

TEST(CorridorSeparation, ASegmentAlongAFaceTakesTheFace) {
  const SegmentMargin segment{{-1.0, 0.5, 1.0}, {2.0, 0.7, 1.0}, 0.01};
  Halfspace plane;
  ASSERT_EQ(separate(segment, kUnit, 0.0, kNoTangent, plane), Status::kOk);
  EXPECT_EQ(plane.normal.z, -1.0);
  EXPECT_EQ(plane.offset, -1.0);
}

TEST(CorridorSeparation, ASegmentAcrossAnEdgeTakesItsNormal) {
  // Touches the edge x = 1, z = 1 at its middle, at 45 degrees to both faces: no face separates, the edge's normal
  // does.
  const SegmentMargin segment{{0.0, 0.5, 2.0}, {2.0, 0.5, 0.0}, 0.01};
  Halfspace plane;
  ASSERT_EQ(separate(segment, kUnit, 0.0, kNoTangent, plane), Status::kOk);
  EXPECT_NEAR(plane.normal.x, -std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(plane.normal.z, -std::sqrt(0.5), 1e-12);
}

TEST(CorridorSeparation, APointOnACornerHasAPlane) {
  const SegmentMargin segment{{1.0, 1.0, 1.0}, {1.0, 1.0, 1.0}, 0.01};
  Halfspace plane;
  ASSERT_EQ(separate(segment, kUnit, 0.0, kNoTangent, plane), Status::kOk);
  EXPECT_NEAR(signed_excess(plane, segment.from), 0.0, 1e-12);
}

TEST(CorridorSeparation, APointBesideAnEdgeByATinyRadiusHasAPlane) {
  // 30 nm from the edge x = 0, y = 0, at 45 degrees to both faces: no face leaves the whole radius.
  const double radius = 3e-8;
  const double away = -radius * std::sqrt(0.5);
  const SegmentMargin segment{{away, away, 0.5}, {-0.5, -0.6, 0.5}, 0.01};
  Halfspace plane;
  ASSERT_EQ(separate(segment, kUnit, radius, kNoTangent, plane), Status::kOk);
  EXPECT_NEAR(plane.normal.x, std::sqrt(0.5), 1e-7);
  EXPECT_NEAR(plane.normal.y, std::sqrt(0.5), 1e-7);
  const SegmentMargin nearer{{0.9 * away, 0.9 * away, 0.5}, {-0.5, -0.6, 0.5}, 0.01};
  EXPECT_EQ(separate(nearer, kUnit, radius, kNoTangent, plane), Status::kCorridorBlocked);
}

TEST(CorridorSeparation, ALongSegmentPastACornerByATinyRadiusHasAPlane) {
  // The corner (1, 1, 1) lies beside the segment's middle. Rounding turns the direction of so close a pair by more
  // than the tolerance over the length of the segment.
  Random random(22);
  for (int i = 0; i < scaled(2000); ++i) {
    Vec3 outward{random.real(0.1, 1.0), random.real(0.1, 1.0), random.real(0.1, 1.0)};
    const double size = norm3(outward);
    outward = {outward.x / size, outward.y / size, outward.z / size};
    const Vec3 other{random.real(-1.0, 1.0), random.real(-1.0, 1.0), random.real(-1.0, 1.0)};
    const Vec3 along{outward.y * other.z - outward.z * other.y, outward.z * other.x - outward.x * other.z,
                     outward.x * other.y - outward.y * other.x};
    const double radius = std::pow(10.0, random.real(-8.5, -3.0));
    const double back = random.real(20.0, 90.0);
    const double on = random.real(20.0, 90.0);
    const Vec3 beside{1.0 + radius * outward.x, 1.0 + radius * outward.y, 1.0 + radius * outward.z};
    const SegmentMargin segment{{beside.x - back * along.x, beside.y - back * along.y, beside.z - back * along.z},
                                {beside.x + on * along.x, beside.y + on * along.y, beside.z + on * along.z},
                                0.01};
    Halfspace plane;
    ASSERT_EQ(separate(segment, kUnit, radius, kNoTangent, plane), Status::kOk) << "case " << i << ' ' << radius;
  }
}

TEST(CorridorSeparation, ThroughTheBoxIsBlocked) {
  const SegmentMargin segment{{-1.0, 0.5, 0.5}, {2.0, 0.6, 0.5}, 0.01};
  Halfspace plane;
  EXPECT_EQ(separate(segment, kUnit, 0.0, {1.0, 0.0, 0.0}, plane), Status::kCorridorBlocked);
  EXPECT_EQ(separate(segment, kUnit, 0.0, kNoTangent, plane), Status::kCorridorBlocked);
}

TEST(CorridorSeparation, KeepsTheStatedMarginWhateverTheTangent) {
  Random random(21);
  for (int i = 0; i < scaled(20000); ++i) {
    LocalBox box;
    for (int a = 0; a < 3; ++a) {
      box.lower[a] = random.real(-1.0, 1.0);
      box.upper[a] = box.lower[a] + random.real(0.05, 1.5);
    }
    const Vec3 from{random.real(-3.0, 3.0), random.real(-3.0, 3.0), random.real(-3.0, 3.0)};
    const Vec3 to{random.real(-3.0, 3.0), random.real(-3.0, 3.0), random.real(-3.0, 3.0)};
    const Box cube{{box.lower[0], box.lower[1], box.lower[2]}, {box.upper[0], box.upper[1], box.upper[2]}};
    const double gap = segment_cube_distance(from, to, cube);
    const double radius = random.chance(0.3) ? 0.0 : random.real(0.0, 0.5);
    const double room = gap - radius;
    if (std::fabs(room) < 1e-6 || gap < 1e-6) continue;
    Vec3 tangent{random.real(-1.0, 1.0), random.real(-1.0, 1.0), random.real(-1.0, 1.0)};
    const double size = norm3(tangent);
    tangent = size < 0.1 ? kNoTangent : Vec3{tangent.x / size, tangent.y / size, tangent.z / size};
    Halfspace plane;
    const Status status = separate({from, to, 0.005}, box, radius, tangent, plane);
    ASSERT_EQ(status, room < 0.0 ? Status::kCorridorBlocked : Status::kOk) << "case " << i;
    if (status != Status::kOk) continue;
    const double promised = std::min(room, std::max(0.005, std::min(tern::kMarginShare * room, tern::kMostMargin)));
    ASSERT_LE(std::max(signed_excess(plane, from), signed_excess(plane, to)), -promised + 1e-9) << "case " << i;
    ASSERT_GE(cube_support(plane.normal, cube), plane.offset + radius - 1e-12) << "case " << i;
    ASSERT_NEAR(norm3(plane.normal), 1.0, 1e-12);
  }
}

}  // namespace
}  // namespace tern_test
