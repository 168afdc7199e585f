// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The checker of things that move finds what is too near, and nothing else.
#include <gtest/gtest.h>

#include "attack/attack_case.hpp"
#include "attack/in_time.hpp"
#include "attack/straight_plan.hpp"

namespace tern_attack {
namespace {

constexpr std::int64_t kSecond = 1000000000;

/// 4 m along x in 2 s, then at rest; the radius is 0.5 m. The thing is a ball of 0.5 m.
class Moving : public testing::Test {
 protected:
  Moving() {
    world_.spec.radius = 0.5;
    thing_.shape = tern::TrackShape::kBall;
    thing_.radius = 0.5;
    thing_.end = tern::TrackEnd::kGoesOn;
  }

  /// The kind of what is found, or nothing.
  std::string found(double until, bool may_leave = false) {
    tern::Request request;
    request.tracks = &thing_;
    request.track_count = 1;
    Findings findings;
    check_tracks(world_, request, plan_, until, may_leave, "plan", findings);
    return findings.empty() ? "" : findings[0].kind;
  }

  /// It is too near at just less than an offset from the plan's line, and not at just more.
  void expect_least_offset(double offset) {
    thing_.position.y = offset - 1e-4;
    EXPECT_EQ(found(2.0), "track") << offset;
    thing_.position.y = offset + 1e-4;
    EXPECT_EQ(found(2.0), "") << offset;
  }

  World world_;
  tern::Trajectory plan_ = straight_plan();
  tern::Track thing_{};
};

/// It rests beside the middle of the line, 2 m from where the plan begins. With an error that grows, the offset is the
/// largest of all times.
TEST_F(Moving, AtRestAndLessAndLessKnown) {
  thing_.position = {2.0, 0.0, 0.0};
  expect_least_offset(1.0);
  thing_.error = 0.25;
  expect_least_offset(1.25);
  thing_.error = 0.0;
  thing_.error_speed = 0.2;
  thing_.error_growth = 0.1;
  double most = 0.0;
  for (int k = 0; k <= 20000; ++k) {
    const double t = 1e-4 * k;
    const double needed = 1.0 + 0.2 * t + 0.05 * t * t;
    const double ahead = 2.0 - 2.0 * t;
    if (needed > std::fabs(ahead)) most = std::max(most, std::sqrt(needed * needed - ahead * ahead));
  }
  expect_least_offset(most);
}

/// Head-on, it is met after half a second; it comes into being at its measurement and is gone after its time.
TEST_F(Moving, IsThereForAWhile) {
  thing_.position = {4.0, 0.0, 0.0};
  thing_.velocity = {-2.0, 0.0, 0.0};
  EXPECT_EQ(found(0.7499), "");  // 4 m apart at first, 1 m after 0.75 s
  EXPECT_EQ(found(0.7501), "track");
  thing_.end = tern::TrackEnd::kGone;
  thing_.until = 3 * kSecond / 4 - 1000000;
  EXPECT_EQ(found(2.0), "");
  thing_.until = 3 * kSecond / 4 + 1000000;
  EXPECT_EQ(found(2.0), "track");
  thing_.position = {0.0, 0.0, 0.0};
  thing_.velocity = {0.0, 0.0, 0.0};
  thing_.until = 9 * kSecond;
  thing_.measured = kSecond / 2 + 1000000;  // the vehicle is 1.002 m away
  EXPECT_EQ(found(2.0), "");
  thing_.measured = kSecond / 2 - 1000000;
  EXPECT_EQ(found(2.0), "track");
}

/// After its time it does as it likes at up to 1 m/s: 3 m away from the goal, it is near after 2 s more.
TEST_F(Moving, DoesAsItLikesLater) {
  thing_.position = {7.0, 0.0, 0.0};
  thing_.reach = 1.0;
  thing_.end = tern::TrackEnd::kReach;
  thing_.until = 2 * kSecond;
  EXPECT_EQ(found(3.999), "");
  EXPECT_EQ(found(4.001), "track");
  thing_.end = tern::TrackEnd::kStays;
  EXPECT_EQ(found(100.0), "");
}

/// It begins 0.2 m too near. Straight ahead of a thing beside it, it leads away; towards one in front of it, nearer.
TEST_F(Moving, LeavesWhatItBeginsTooNearTo) {
  thing_.position = {0.0, 0.8, 0.0};
  EXPECT_EQ(found(2.0), "track");
  EXPECT_EQ(found(2.0, true), "");
  thing_.position = {0.8, 0.0, 0.0};
  EXPECT_EQ(found(2.0, true), "track");
}

/// Its curve leads in front of the plan, 0.1 m from where that is after a second, but it moves by 1 cm/s at most: from
/// 0.3 s on, the plan is out of its reach.
TEST_F(Moving, OutOfReachItMayComeNearerToTheCurve) {
  static constexpr double kAway[8] = {0.0, 0.3, 0.6, 0.3, 0.0, -0.3, -0.6, -0.7};
  static constexpr double kAlong[8] = {0.0, 0.0, 0.0, 0.5, 1.0, 1.5, 1.8, 2.0};
  tern::TrackPiece piece{};
  piece.duration = 1.0;
  for (int k = 0; k < 8; ++k) piece.points[k] = {kAlong[k], kAway[k], 0.0};
  thing_.position = {0.0, 0.8, 0.0};
  thing_.pieces = &piece;
  thing_.piece_count = 1;
  thing_.end = tern::TrackEnd::kStays;
  thing_.until = kSecond;
  EXPECT_EQ(found(2.0, true), "track");
  thing_.reach = 0.01;
  EXPECT_EQ(found(2.0, true), "");
}

/// A vehicle that follows, for two hours and a millimetre beside what is too near, takes few halvings.
TEST_F(Moving, FollowsForLong) {
  constexpr double kHours = 7200.0;
  plan_.segments[0].duration = kHours;
  for (int k = 0; k < tern::kControlPoints; ++k) plan_.segments[0].points[k].x = 1e6 * k / 7.0;
  tern::Trajectory other = plan_;
  tern::TrackPiece pieces[tern::kMaxSegments];
  for (tern::Vec3& p : other.segments[0].points) p.y = 1.001;
  ASSERT_EQ(tern::track_of(other, 0.5, pieces, tern::kMaxSegments, thing_), tern::Status::kOk);
  EXPECT_EQ(found(kHours), "");
  pieces[0].points[tern::kDegree].y -= 0.002;
  EXPECT_EQ(found(kHours), "track");
}

TEST(StaysAbove, SaysWhatItCouldNotDecide) {
  Real when = 0;
  const auto zero = [](Real) { return Real{0}; };
  const auto never = [](const Interval&, Real) { return false; };
  EXPECT_EQ(stays_above(0, {0, 1000}, zero, never, when), Proof::kUnproven);
  EXPECT_EQ(stays_above(1e-3L, {0, 1000}, zero, never, when), Proof::kBroken);
  const auto always = [](const Interval&, Real) { return true; };
  EXPECT_EQ(stays_above(0, {0, 1000}, zero, always, when), Proof::kProven);
}

}  // namespace
}  // namespace tern_attack
