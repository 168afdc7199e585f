// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The checker of fences for a while finds what is broken, and nothing else.
#include "attack/windows.hpp"

#include <gtest/gtest.h>

#include "attack/in_time.hpp"
#include "attack/straight_plan.hpp"

namespace tern_attack {
namespace {

/// 4 m along x in 2 s, beside a wall at x = 2 .. 2.5 for a while; the radius is 0.5 m.
class Windows : public testing::Test {
 protected:
  Windows() {
    world_.spec.radius = 0.5;
    tern::box_planes({{2.0, -1.0, -1.0}, {2.5, 1.0, 1.0}}, wall_);
    tern::box_planes({{-1.0, -1.0, -1.0}, {3.0, 1.0, 1.0}}, room_);
  }

  bool broken(tern::FenceKind kind, double from, double until, double clock_error = 0.0) {
    tern::Fence fence{kind == tern::FenceKind::kKeepIn ? room_ : wall_, tern::kBoxPlanes, kind};
    fence.from = static_cast<std::int64_t>(from * 1e9);
    fence.until = static_cast<std::int64_t>(until * 1e9);
    fence.clock_error = clock_error;
    tern::Request request;
    request.fences = &fence;
    request.fence_count = 1;
    Findings findings;
    check_windows(world_, request, plan_, until_, "plan", findings);
    return !findings.empty();
  }

  World world_;
  tern::Trajectory plan_ = straight_plan();
  double until_ = 2.0;
  tern::Halfspace wall_[tern::kBoxPlanes];
  tern::Halfspace room_[tern::kBoxPlanes];
};

/// A plan that turns round is slower than its control points say, but for its ends.
TEST(Chains, TheMostIsThatOfTheTimeAskedFor) {
  tern::Trajectory plan = straight_plan();
  for (int k = 0; k < tern::kControlPoints; ++k) plan.segments[0].points[k].x = k == 0 || k == 7 ? 0.0 : 1.0;
  const Chain<tern::Segment> chain = chain_of(plan);
  EXPECT_NEAR(static_cast<double>(chain.most(1, 0.0L, 2.0L)), 3.5, 1e-12);
  for (const Real t : {0.0L, 0.3L, 1.0L, 1.9L, 2.0L}) {
    const double most = static_cast<double>(chain.most(1, t, std::min<Real>(2.0L, t + 1e-6L)));
    EXPECT_NEAR(most, static_cast<double>(length(chain.velocity(std::min<Real>(t, 2.0L - 1e-12L)))), 2e-5) << most;
  }
}

/// The plan is too near to the wall from 0.75 s to 1.5 s.
TEST_F(Windows, KeepOut) {
  EXPECT_TRUE(broken(tern::FenceKind::kKeepOut, 0.0, 2.0));
  EXPECT_TRUE(broken(tern::FenceKind::kKeepOut, 0.0, 0.7501));
  EXPECT_TRUE(broken(tern::FenceKind::kKeepOut, 1.4999, 2.0));
  EXPECT_FALSE(broken(tern::FenceKind::kKeepOut, 0.0, 0.75));
  EXPECT_FALSE(broken(tern::FenceKind::kKeepOut, 1.5, 2.0));
  EXPECT_TRUE(broken(tern::FenceKind::kKeepOut, 1.51, 2.0, 0.02));
}

/// Thirty nanometres decide between a plan that slides along a wall and one that is too near, at any speed.
TEST_F(Windows, AlongAWall) {
  for (const double y : {0.5, 0.5 - 3e-8, 0.5 + 1e-8}) {
    tern::box_planes({{-1.0, y, -1.0}, {5.0, 2.0, 1.0}}, wall_);
    EXPECT_EQ(broken(tern::FenceKind::kKeepOut, -1.0, 3.0), y < 0.5) << y;
  }
  for (const double y : {0.0, 1e-9, -3e-8}) {
    tern::box_planes({{-1.0, -1.0, -1.0}, {5.0, y, 1.0}}, room_);
    EXPECT_EQ(broken(tern::FenceKind::kKeepIn, -1.0, 3.0), y < 0.0) << y;
  }
}

/// A kink into a wall, between straight ways beside it.
TEST_F(Windows, JointsAreLookedAt) {
  plan_.count = 2;
  plan_.segments[0].duration = 0.3;
  plan_.segments[1].duration = 1.7;
  for (int k = 0; k < tern::kControlPoints; ++k) {
    plan_.segments[0].points[k] = {0.3 * k / 7.0, 0.6 * k / 7.0, 0.0};
    plan_.segments[1].points[k] = {0.3 + 1.7 * k / 7.0, 0.6 - 0.6 * k / 7.0, 0.0};
  }
  world_.spec.radius = 0.0;
  tern::box_planes({{-1.0, 0.5, -1.0}, {5.0, 2.0, 1.0}}, wall_);
  EXPECT_TRUE(broken(tern::FenceKind::kKeepOut, -1.0, 3.0));
  tern::box_planes({{-1.0, 0.61, -1.0}, {5.0, 2.0, 1.0}}, wall_);
  EXPECT_FALSE(broken(tern::FenceKind::kKeepOut, -1.0, 3.0));
}

/// The plan leaves the room after 2 s; it is 1 m too far then.
TEST_F(Windows, KeepIn) {
  EXPECT_TRUE(broken(tern::FenceKind::kKeepIn, -1.0, 3.0));
  until_ = 1.5;
  EXPECT_FALSE(broken(tern::FenceKind::kKeepIn, -1.0, 3.0));
  EXPECT_TRUE(broken(tern::FenceKind::kKeepIn, 0.001, 3.0));
  EXPECT_TRUE(broken(tern::FenceKind::kKeepIn, -1.0, 1.4));
  EXPECT_TRUE(broken(tern::FenceKind::kKeepIn, -1.0, 3.0, 1.001));
}

}  // namespace
}  // namespace tern_attack
