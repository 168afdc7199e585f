// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Proofs of curves whose first instant too near to something, or too fast, is known by hand.
#include "tern/proof.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/math.hpp"
#include "support/grid_storage.hpp"

namespace {

using namespace tern;
using tern_test::OwnedGrid;
using tern_test::whole_grid;

/// Later than the earliest end of a proof by this, in seconds: a piece of a segment of 8 s, and rounding.
constexpr double kLate = 8.0 / (1 << kProofDepth) + 1e-9;
constexpr double kDuration = 8.0;

/// One segment whose position is the sum of c[k] t^k: Bernstein coefficients by the usual change of basis.
Trajectory polynomial(const Vec3& origin, const Vec3 (&c)[4]) {
  Trajectory plan{};
  plan.count = 1;
  plan.origin = origin;
  plan.segments[0].duration = kDuration;
  for (int i = 0; i < kControlPoints; ++i) {
    const double choose[4] = {1.0, i / 7.0, i * (i - 1) / 42.0, i * (i - 1) * (i - 2) / 210.0};
    Vec3& p = plan.segments[0].points[i];
    for (int k = 0; k < 4; ++k) {
      const double weight = choose[k] * std::pow(kDuration, k);
      p = {p.x + weight * c[k].x, p.y + weight * c[k].y, p.z + weight * c[k].z};
    }
  }
  return plan;
}

/// At constant velocity.
Trajectory line(const Vec3& from, const Vec3& velocity) {
  return polynomial(from, {{}, velocity, {}, {}});
}

/// 10 x 10 x 4 m with cells of 0.1 m and radius 0.3 m, away from the world's origin.
struct Room : OwnedGrid {
  Room() : OwnedGrid(whole_grid({100, 100, 40}, 0.1, 0.3, {-5.0, 2.0, 1.0})) {}
  /// In the room's own frame.
  Vec3 at(double x, double y, double z) const { return {x - 5.0, y + 2.0, z + 1.0}; }
  void mark(const Vec3& lower, const Vec3& upper) {
    grid.mark_box({at(lower.x, lower.y, lower.z), at(upper.x, upper.y, upper.z)});
  }
};

TEST(Proof, FlightToAWallIsProvenUntilTheRadiusIsLeft) {
  Room room;
  room.mark({6.0, 0.0, 0.0}, {7.0, 10.0, 4.0});
  const Trajectory plan = line(room.at(1.0, 5.0, 2.0), {1.0, 0.0, 0.0});
  ProofReport report;
  const double until = clear_until(room.grid, plan, 0.0, nullptr, Beyond::kEmpty, &report);
  EXPECT_LE(until, 4.7 + 1e-8);
  EXPECT_GE(until, 4.7 - kLate);
  EXPECT_EQ(report.finding, Finding::kObstacle);
  EXPECT_EQ(report.voxel.x, 60);
  EXPECT_DOUBLE_EQ(report.until, until);
}

TEST(Proof, FlightAlongAWallMayKeepExactlyTheRadius) {
  Room room;
  room.mark({2.0, 6.0, 0.0}, {9.0, 7.0, 4.0});
  for (const double gap : {0.3, 0.3 - 1e-9}) {
    const Trajectory plan = line(room.at(1.0, 6.0 - gap, 2.0), {1.0, 0.0, 0.0});
    EXPECT_DOUBLE_EQ(clear_until(room.grid, plan, 0.0), kDuration);
  }
  const Trajectory near = line(room.at(1.0, 5.7 + 1e-7, 2.0), {1.0, 0.0, 0.0});
  // The wall's edge is 0.3 m away where 1 m - dx is flown, dx^2 = 0.3^2 - (0.3 - 1e-7)^2.
  const double until = clear_until(room.grid, near, 0.0);
  EXPECT_NEAR(until, 1.0 - std::sqrt(0.09 - 0.2999999 * 0.2999999), 1e-4);
}

TEST(Proof, FlightPastACornerMayKeepExactlyTheRadius) {
  Room room;
  room.mark({5.0, 5.0, 0.0}, {5.1, 5.1, 4.0});
  // Along y = -x, at right angles to the diagonal through the corner (5, 5).
  const double away = 0.3 / std::sqrt(2.0);
  for (const double less : {0.0, 1e-9}) {
    const Trajectory plan = line(room.at(5.0 - away + less - 2.0, 5.0 - away + 2.0, 2.0), {0.5, -0.5, 0.0});
    EXPECT_DOUBLE_EQ(clear_until(room.grid, plan, 0.0), kDuration);
  }
  const Trajectory near = line(room.at(5.0 - away + 1e-7 - 2.0, 5.0 - away + 2.0, 2.0), {0.5, -0.5, 0.0});
  EXPECT_NEAR(clear_until(room.grid, near, 0.0), 4.0, 1e-2);
  EXPECT_LT(clear_until(room.grid, near, 0.0), 4.0);
}

TEST(Proof, CurveThatTouchesItsLimitAtOneInstantIsProven) {
  Room room;
  room.mark({0.0, 6.0, 0.0}, {10.0, 7.0, 4.0});
  // y = 5.7 - (t - 4)^2 / 8: 0.3 m from the wall at t = 4.
  const Trajectory plan = polynomial(room.at(1.0, 3.7, 2.0), {{}, {1.0, 1.0, 0.0}, {0.0, -0.125, 0.0}, {}});
  EXPECT_DOUBLE_EQ(clear_until(room.grid, plan, 0.0), kDuration);
}

/// From the room's centre through each of its six faces, which are walls or not.
TEST(Proof, BoundaryIsAFaceOrAWall) {
  Room room;
  for (int a = 0; a < 3; ++a) {
    for (const double speed : {-1.0, 1.0}) {
      Vec3 velocity{};
      axis(velocity, a) = speed;
      const Trajectory plan = line(room.at(5.0, 5.0, 2.0), velocity);
      const double way = a == 2 ? 2.0 : 5.0;
      ProofReport report;
      const double empty = clear_until(room.grid, plan, 0.0, nullptr, Beyond::kEmpty, &report);
      EXPECT_LE(empty, way + 1e-8) << a << ", " << speed;
      EXPECT_GE(empty, way - kLate) << a << ", " << speed;
      EXPECT_EQ(report.finding, Finding::kOutside);
      const double solid = clear_until(room.grid, plan, 0.0, nullptr, Beyond::kSolid);
      EXPECT_LE(solid, way - 0.3 + 1e-8) << a << ", " << speed;
      EXPECT_GE(solid, way - 0.3 - kLate) << a << ", " << speed;
    }
  }
}

TEST(Proof, LimitsEndItWhereTheyAreReached) {
  Room room;
  Limits limits{{2.0, 2.0, 2.0}, {3.0, 3.0, 3.0}};
  ProofReport report;
  // v = 0.25 t + ... reaches 1 m/s at t = 4.
  limits.v_max.x = 1.0;
  const Trajectory faster = polynomial(room.at(1.0, 5.0, 2.0), {{}, {}, {0.125, 0.0, 0.0}, {}});
  const double speed = clear_until(room.grid, faster, 0.0, &limits, Beyond::kEmpty, &report);
  EXPECT_NEAR(speed, 4.0, kLate + 1e-6);
  EXPECT_EQ(report.finding, Finding::kVelocity);
  // a = 0.06 t reaches 0.3 m/s^2 at t = 5, and 0.4 along both axes at 0.06 sqrt(2) t = 0.4.
  limits = {{5.0, 5.0, 2.0}, {0.3, 1.0, 3.0}};
  const Trajectory jerked = polynomial(room.at(1.0, 1.0, 2.0), {{}, {}, {}, {0.01, 0.01, 0.0}});
  EXPECT_NEAR(clear_until(room.grid, jerked, 0.0, &limits, Beyond::kEmpty, &report), 5.0, kLate + 1e-6);
  EXPECT_EQ(report.finding, Finding::kAcceleration);
  limits.a_horizontal = 0.4;
  EXPECT_NEAR(clear_until(room.grid, jerked, 0.0, &limits), 0.4 / 0.06 / std::sqrt(2.0), kLate + 1e-6);
  EXPECT_DOUBLE_EQ(clear_until(room.grid, jerked, 0.0), kDuration);
}

TEST(Proof, JerkEndsItWhereItsLimitIsReached) {
  Room room;
  // x = 1.5 u^4 over u = t / 8: jerk 36 t / 8^4 = 0.03515625 at t = 4.
  Trajectory plan = line(room.at(1.0, 5.0, 2.0), {});
  for (int i = 4; i < kControlPoints; ++i) plan.segments[0].points[i].x = 1.5 * i * (i - 1) * (i - 2) * (i - 3) / 840.0;
  Limits limits{{5.0, 5.0, 5.0}, {5.0, 5.0, 5.0}};
  limits.j_max.x = 0.03515625;
  ProofReport report;
  EXPECT_NEAR(clear_until(room.grid, plan, 0.0, &limits, Beyond::kEmpty, &report), 4.0, kLate + 1e-5);
  EXPECT_EQ(report.finding, Finding::kJerk);
  limits.j_max.x = 0.0;
  EXPECT_DOUBLE_EQ(clear_until(room.grid, plan, 0.0, &limits), kDuration);
  limits.j_horizontal = 0.5 * 0.03515625;
  EXPECT_NEAR(clear_until(room.grid, plan, 0.0, &limits), 2.0, kLate + 1e-5);
}

TEST(Proof, NothingBeforeItsBeginningCounts) {
  Room room;
  room.mark({0.0, 0.0, 0.0}, {1.5, 10.0, 4.0});
  const Trajectory plan = line(room.at(1.0, 5.0, 2.0), {1.0, 0.0, 0.0});
  EXPECT_DOUBLE_EQ(clear_until(room.grid, plan, 0.0), 0.0);
  EXPECT_DOUBLE_EQ(clear_until(room.grid, plan, NAN), 0.0);
  EXPECT_DOUBLE_EQ(clear_until(room.grid, plan, 0.9), kDuration);
  EXPECT_DOUBLE_EQ(clear_until(room.grid, plan, 100.0), 100.0);
  ProofReport report;
  clear_until(room.grid, plan, 100.0, nullptr, Beyond::kEmpty, &report);
  EXPECT_EQ(report.finding, Finding::kNone);
  room.mark({9.0, 5.0, 2.0}, {9.1, 5.1, 2.1});
  clear_until(room.grid, plan, 100.0, nullptr, Beyond::kEmpty, &report);
  EXPECT_EQ(report.finding, Finding::kObstacle);
}

TEST(Proof, RefusesWhatCannotBeProven) {
  Room room;
  Trajectory plan = line(room.at(1.0, 5.0, 2.0), {1.0, 0.0, 0.0});
  Proof proof;
  EXPECT_EQ(proof.step(1), Status::kInvalidArgument);
  Grid unbound;
  EXPECT_EQ(proof.begin(unbound, plan, 0.0, nullptr, Beyond::kEmpty), Status::kInvalidArgument);
  OwnedGrid point(whole_grid({10, 10, 10}, 1.0, 0.0));
  EXPECT_EQ(proof.begin(point.grid, plan, 0.0, nullptr, Beyond::kEmpty), Status::kInvalidArgument);
  plan.count = 0;
  EXPECT_EQ(proof.begin(room.grid, plan, 0.0, nullptr, Beyond::kEmpty), Status::kInvalidArgument);
  plan.count = kMaxSegments + 1;
  EXPECT_EQ(proof.begin(room.grid, plan, 0.0, nullptr, Beyond::kEmpty), Status::kInvalidArgument);
  ProofReport report;
  EXPECT_EQ(clear_until(unbound, plan, 3.0, nullptr, Beyond::kEmpty, &report), 3.0);
  EXPECT_EQ(report.finding, Finding::kMalformed);
}

/// The whole length of a long map once a segment: 256 pieces of 8 voxels, and the 255 that they are halves of.
TEST(Proof, LongTrajectoriesTakeManySteps) {
  OwnedGrid room(whole_grid({kMaxDimension, 3, 3}, 1.0, 0.5));
  constexpr double kLength = kMaxDimension - 1.0;
  Trajectory plan{};
  plan.count = kMaxSegments;
  plan.origin = {0.5, 1.5, 1.5};
  for (int s = 0; s < kMaxSegments; ++s) {
    plan.segments[s].duration = 1.0;
    for (int i = 0; i < kControlPoints; ++i) {
      const double part = i / 7.0;
      plan.segments[s].points[i].x = kLength * (s % 2 == 0 ? part : 1.0 - part);
    }
  }
  ProofReport report;
  EXPECT_DOUBLE_EQ(clear_until(room.grid, plan, 0.0, nullptr, Beyond::kEmpty, &report), kMaxSegments);
  EXPECT_EQ(report.finding, Finding::kNone);
  EXPECT_GT(report.work, static_cast<std::uint32_t>(kMaxSegments * (2 * kMaxDimension / kProofSpan - 1)));
  Proof proof;
  ASSERT_EQ(proof.begin(room.grid, plan, kMaxSegments - 0.001, nullptr, Beyond::kEmpty), Status::kRunning);
  EXPECT_EQ(proof.step(100), Status::kOk);
  const std::uint32_t work = proof.report().work;
  EXPECT_EQ(proof.step(100), Status::kOk);
  EXPECT_EQ(proof.report().work, work);
}

TEST(Proof, MalformedTrajectoriesAreNotProven) {
  Room room;
  const Trajectory good = line(room.at(1.0, 5.0, 2.0), {0.5, 0.0, 0.0});
  const Limits limits{{2.0, 2.0, 2.0}, {2.0, 2.0, 2.0}};
  const auto end_of = [&](const Trajectory& plan) {
    ProofReport report;
    ProofReport limited;
    clear_until(room.grid, plan, 0.0, nullptr, Beyond::kEmpty, &report);
    clear_until(room.grid, plan, 0.0, &limits, Beyond::kEmpty, &limited);
    EXPECT_EQ(report.finding, limited.finding);
    return report.finding;
  };
  Trajectory plan = good;
  plan.segments[0].points[3].y = NAN;
  EXPECT_EQ(end_of(plan), Finding::kMalformed);
  plan = good;
  plan.segments[0].duration = 0.0;
  EXPECT_EQ(end_of(plan), Finding::kMalformed);
  plan = good;
  plan.segments[0].duration = INFINITY;
  EXPECT_EQ(end_of(plan), Finding::kMalformed);
  plan = good;
  plan.origin.z = NAN;
  EXPECT_EQ(end_of(plan), Finding::kMalformed);
  plan = good;
  plan.count = 2;
  plan.segments[1] = plan.segments[0];  // begins 4 m back
  ProofReport report;
  EXPECT_DOUBLE_EQ(clear_until(room.grid, plan, 0.0, nullptr, Beyond::kEmpty, &report), kDuration);
  EXPECT_EQ(report.finding, Finding::kJoint);
  EXPECT_EQ(report.segment, 1);
  EXPECT_EQ(report.derivative, 0);
  EXPECT_NEAR(report.excess, 4.0, 1e-6);
  plan.segments[0].points[kDegree].y = NAN;
  clear_until(room.grid, plan, kDuration, nullptr, Beyond::kEmpty, &report);
  EXPECT_EQ(report.finding, Finding::kJoint);
}

TEST(Proof, SlicesChangeNothing) {
  Room room;
  room.mark({6.0, 5.5, 0.0}, {7.0, 10.0, 4.0});
  const Trajectory plan = polynomial(room.at(1.0, 3.7, 2.0), {{}, {1.0, 1.0, 0.0}, {0.0, -0.125, 0.0}, {}});
  const Limits limits{{2.0, 2.0, 2.0}, {2.0, 2.0, 2.0}};
  ProofReport whole;
  const double until = clear_until(room.grid, plan, 0.3, &limits, Beyond::kSolid, &whole);
  for (const std::uint32_t slice : {1u, 2u, 3u, 7u, 50u}) {
    Proof proof;
    ASSERT_EQ(proof.begin(room.grid, plan, 0.3, &limits, Beyond::kSolid), Status::kRunning);
    EXPECT_EQ(proof.step(0), Status::kRunning);
    constexpr std::uint32_t kLongestPiece = 50;
    std::uint32_t given = slice;
    Status status = Status::kRunning;
    while ((status = proof.step(slice)) == Status::kRunning) {
      EXPECT_GE(proof.report().work, given);
      EXPECT_LE(proof.report().work, given + kLongestPiece);
      given += slice;
    }
    EXPECT_EQ(status, Status::kOk);
    EXPECT_EQ(proof.report().until, until);
    EXPECT_EQ(proof.report().finding, whole.finding);
    EXPECT_EQ(proof.report().work, whole.work);
  }
}

/// The Chebyshev polynomial of degree 7 flies the whole length of a long map seven times: more pieces of kProofSpan
/// voxels than a segment may have.
TEST(Proof, SegmentThatNeedsTooManyPiecesIsNotProven) {
  OwnedGrid room(whole_grid({kMaxDimension, 3, 3}, 1.0, 0.5));
  const double choose[kControlPoints] = {1.0, 7.0, 21.0, 35.0, 35.0, 21.0, 7.0, 1.0};
  const double even[kControlPoints] = {1.0, 91.0, 1001.0, 3003.0, 3003.0, 1001.0, 91.0, 1.0};
  Trajectory plan{};
  plan.count = 1;
  plan.origin = {0.5 * kMaxDimension, 1.5, 1.5};
  plan.segments[0].duration = 1.0;
  for (int i = 0; i < kControlPoints; ++i) {
    plan.segments[0].points[i].x = 0.45 * kMaxDimension * (i % 2 == 0 ? -1.0 : 1.0) * even[i] / choose[i];
  }
  ProofReport report;
  const double until = clear_until(room.grid, plan, 0.0, nullptr, Beyond::kEmpty, &report);
  EXPECT_EQ(report.finding, Finding::kPieces);
  EXPECT_GT(until, 0.1);
  EXPECT_LT(until, 1.0);
  EXPECT_GT(report.work, static_cast<std::uint32_t>(kProofPieces));
}

}  // namespace
