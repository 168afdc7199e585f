// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What is said of a plan beyond a limit, and where a proof is given up.
#include <gtest/gtest.h>

#include <memory>

#include "prove/check_stage.hpp"
#include "prove/grants.hpp"
#include "prove/joints.hpp"
#include "support/arc_curve.hpp"
#include "support/world.hpp"

namespace tern_test {
namespace {

using tern::Finding;
using tern::Limits;
using tern::ProofReport;
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

tern::State state_of(const Segment& segment, bool at_end, const Vec3& origin) {
  const tern::Jet jet = tern::jet_of(segment, at_end);
  return {jet.d[0] + origin, jet.d[1], jet.d[2], jet.d[3]};
}

/// Judges a plan of this segment alone, in an empty map.
ProofReport judge(const Segment& segment, const Limits& limits) {
  World world({10, 10, 10}, 4.0, 0.5);
  const auto stage = std::make_unique<tern::CheckStage>();
  const auto corridor = std::make_unique<tern::Corridor>();
  const auto plan = std::make_unique<tern::Trajectory>();
  plan->count = 1;
  plan->origin = {20.0, 20.0, 20.0};
  plan->segments[0] = segment;
  tern::CheckQuery query{state_of(segment, false, plan->origin), state_of(segment, true, plan->origin), limits};
  check_begin(*stage);
  tern::Work work{tern::kCheckBound};
  EXPECT_NE(check_advance(*stage, world.grid, *corridor, *plan, query, work), tern::Progress::kMore);
  return stage->found;
}

/// The limit that lets values up to `most` pass, and none beyond: without the grant.
double exact_limit(const Segment& segment, double most, double roundings) {
  return (most - roundings * tern::hodograph_rounding(segment, 1)) / (1.0 + tern::kCheckRelative);
}

TEST(ProveLimits, NamesTheEndThatIsBeyond) {
  Limits limits = kWide;
  limits.v_max.x = 1.0;
  for (const bool from_fast : {true, false}) {
    // 2 m/s at one end, none at the other.
    const Segment segment = with_velocity([&](int i) { return Vec3{(from_fast ? 6 - i : i) / 3.0, 0.0, 0.0}; });
    const ProofReport found = judge(segment, limits);
    EXPECT_EQ(found.finding, Finding::kVelocity);
    EXPECT_EQ(found.derivative, 1);
    EXPECT_EQ(found.axis, 0);
    EXPECT_NEAR(found.excess, 1.0, 1e-7);
  }
}

// The hull of a piece of the hill with its peak exceeds the peak by 0.044 times the piece's square, 6e-13 after 18
// halvings; the ends of the piece are below the peak.
TEST(ProveLimits, APeakWithinAHairOfTheLimitIsRefused) {
  const Segment segment = with_velocity(hill_point);
  Limits limits = kWide;
  limits.v_max.x = exact_limit(segment, 1.0 + 1e-10, 1.0);
  EXPECT_EQ(judge(segment, limits).finding, Finding::kNone);
  limits.v_max.x = exact_limit(segment, 1.0 + 1e-13, 1.0);
  const ProofReport found = judge(segment, limits);
  EXPECT_EQ(found.finding, Finding::kVelocity);
  EXPECT_EQ(found.axis, -1) << "nothing that is known is beyond the limit";
  EXPECT_EQ(found.excess, 0.0);
}

// The velocity turns by an eighth of a radian at 1 m/s. The hull of its part over 2^-n exceeds the norm by 0.025 times
// the square of the part's angle: 3.7e-10 after 10 halvings, 0.9e-10 after 11. Between them the proof would take 4095
// pieces.
TEST(ProveLimits, AProofThatTakesTooManyPiecesIsGivenUp) {
  const Segment segment = with_velocity([](int i) { return arc_point(0.125, i); });
  Limits limits = kWide;
  limits.v_horizontal = exact_limit(segment, 1.0 + 1e-9, 2.0);
  EXPECT_EQ(judge(segment, limits).finding, Finding::kNone);
  limits.v_horizontal = exact_limit(segment, 1.0 + 1.5e-10, 2.0);
  const ProofReport found = judge(segment, limits);
  EXPECT_EQ(found.finding, Finding::kPieces);
  EXPECT_EQ(found.derivative, 1);
  EXPECT_EQ(found.excess, 0.0);
}

}  // namespace
}  // namespace tern_test
