// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the check says of a segment beyond a limit, and where it gives up a proof.
#include <gtest/gtest.h>

#include "check/check_stage.hpp"
#include "support/arc_curve.hpp"

namespace tern_test {
namespace {

using tern::CheckReport;
using tern::Finding;
using tern::Limits;
using tern::Segment;
using tern::Vec3;

constexpr Limits kWide{{100.0, 100.0, 100.0}, {1e4, 1e4, 1e4}};

/// A segment of one second from the origin whose velocity has these control points.
template <class VelocityPoint>
Segment with_velocity(const VelocityPoint& point) {
  Segment segment{};
  segment.duration = 1.0;
  for (int i = 0; i < tern::kDegree; ++i) segment.points[i + 1] = segment.points[i] + (1.0 / tern::kDegree) * point(i);
  return segment;
}

/// The limit that lets values up to `most` pass, and none beyond: without the check's tolerances.
double exact_limit(const Segment& segment, double most, double roundings) {
  return (most - roundings * tern::hodograph_rounding(segment, 1)) / (1.0 + tern::kCheckRelative);
}

TEST(CheckLimits, NamesTheEndThatIsBeyond) {
  Limits limits = kWide;
  limits.v_max.x = 1.0;
  for (const bool from_fast : {true, false}) {
    // 2 m/s at one end, none at the other.
    const Segment segment = with_velocity([&](int i) { return Vec3{(from_fast ? 6 - i : i) / 3.0, 0.0, 0.0}; });
    CheckReport found{};
    EXPECT_FALSE(limits_hold(segment, limits, found));
    EXPECT_EQ(found.finding, Finding::kVelocity);
    EXPECT_EQ(found.derivative, 1);
    EXPECT_EQ(found.axis, 0);
    EXPECT_NEAR(found.excess, 1.0, 1e-7);
  }
}

// The hull of a piece of the hill with its peak exceeds the peak by 0.044 times the piece's square, 1e-11 after 16
// halvings; the ends of the piece are below the peak.
TEST(CheckLimits, APeakWithinAHairOfTheLimitIsRefused) {
  const Segment segment = with_velocity(hill_point);
  Limits limits = kWide;
  CheckReport found{};
  limits.v_max.x = exact_limit(segment, 1.0 + 1e-10, 1.0);
  EXPECT_TRUE(limits_hold(segment, limits, found));
  limits.v_max.x = exact_limit(segment, 1.0 + 2e-12, 1.0);
  EXPECT_FALSE(limits_hold(segment, limits, found));
  EXPECT_EQ(found.finding, Finding::kVelocity);
  EXPECT_EQ(found.axis, 0);
  EXPECT_NEAR(found.excess, 2.0 / 45.0 / 65536.0 / 65536.0 - 2e-12, 1e-13);
}

// The velocity turns by an eighth of a radian at 1 m/s. The hull of its part over 2^-n exceeds the norm by 0.025 times
// the square of the part's angle: 2.3e-11 after 12 halvings, 0.6e-11 after 13. Between them the proof would take
// 16383 pieces.
TEST(CheckLimits, AProofThatTakesTooManyPiecesIsGivenUp) {
  const Segment segment = with_velocity([](int i) { return arc_point(0.125, i); });
  Limits limits = kWide;
  CheckReport found{};
  limits.v_horizontal = exact_limit(segment, 1.0 + 1e-9, 2.0);
  EXPECT_TRUE(limits_hold(segment, limits, found));
  limits.v_horizontal = exact_limit(segment, 1.0 + 1.2e-11, 2.0);
  EXPECT_FALSE(limits_hold(segment, limits, found));
  EXPECT_EQ(found.finding, Finding::kVelocity);
  EXPECT_EQ(found.derivative, 1);
  EXPECT_EQ(found.axis, CheckReport{}.axis) << "nothing that is known is beyond the limit";
  EXPECT_EQ(found.excess, 0.0);
}

}  // namespace
}  // namespace tern_test
