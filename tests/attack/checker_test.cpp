// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The attack's own checker: silent on plans that keep every promise exactly, and not on plans spoiled by 1e-5.
#include "attack/checker.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "attack/emptiness.hpp"

namespace tern_attack {
namespace {

constexpr double kSpoil = 1e-5;

/// 4 x 4 x 2 m, cells of 0.25 m, a radius of 0.5 m, one obstacle voxel at (8, 2, 4): [2, 2.25] x [0.5, 0.75] x
/// [1, 1.25].
void make_hand_world(World& world) {
  world.spec.origin = {100.0, -50.0, 10.0};
  world.spec.cell = 0.25;
  world.spec.dims = {16, 16, 8};
  world.spec.boundary = {{100.0, -50.0, 10.0}, {104.0, -46.0, 12.0}};
  world.spec.radius = 0.5;
  world.solid.assign(static_cast<std::size_t>(world.count()), 0);
  world.set(8, 2, 4, true);
}

/// Straight from `from` to `to` (local) from rest to rest: four equal control points at each end.
tern::Segment straight(const tern::Vec3& from, const tern::Vec3& to, double duration) {
  tern::Segment segment{duration, {}, 0};
  for (int i = 0; i < tern::kControlPoints; ++i) segment.points[i] = i < 4 ? from : to;
  return segment;
}

/// Along y = 1.25, which is the radius from the obstacle's face, and back above it at z = 1.75.
class Checker : public testing::Test {
 protected:
  void SetUp() override {
    make_hand_world(world);
    plan.origin = world.spec.origin;
    plan.count = 2;
    plan.segments[0] = straight({0.5, 1.25, 1.125}, {3.5, 1.25, 1.125}, 4.0);
    plan.segments[1] = straight({3.5, 1.25, 1.125}, {3.5, 3.0, 1.0}, 4.0);
    request.start.position = {100.5, -48.75, 11.125};
    request.goal.position = {103.5, -47.0, 11.0};
    // Peaks of the first segment: 35/16 L/T and 84 sqrt(5)/25 L/T^2.
    request.limits.v_max = {35.0 / 16.0 * 3.0 / 4.0, 10.0, 10.0};
    request.limits.a_max = {84.0 * std::sqrt(5.0) / 25.0 * 3.0 / 16.0, 10.0, 10.0};
  }

  std::vector<std::string> kinds() {
    Rng rng(1);
    Findings findings;
    check_plan(rng, world, request, plan, 0.0, findings);
    std::vector<std::string> names;
    for (const Finding& f : findings) names.push_back(f.kind);
    return names;
  }
  bool finds(const char* kind) {
    const std::vector<std::string> names = kinds();
    return std::find(names.begin(), names.end(), kind) != names.end();
  }
  void move(int segment, int first, int last, const tern::Vec3& by) {
    for (int i = first; i <= last; ++i) {
      tern::Vec3& p = plan.segments[segment].points[i];
      p = {p.x + by.x, p.y + by.y, p.z + by.z};
    }
  }
  void fence(const tern::Box& box, tern::FenceKind kind) {
    tern::box_planes(box, faces);
    one = {faces, tern::kBoxPlanes, kind};
    request.fences = &one;
    request.fence_count = 1;
  }

  World world;
  tern::Request request{};
  tern::Trajectory plan{};
  tern::Halfspace faces[tern::kBoxPlanes];
  tern::Fence one{};
};

TEST_F(Checker, IsSilentOnAPlanThatTouchesEveryLimit) {
  EXPECT_EQ(kinds(), std::vector<std::string>{});
}

TEST_F(Checker, SeesAControlPointNearerThanTheRadius) {
  move(0, 3, 3, {0.0, -kSpoil, 0.0});
  EXPECT_TRUE(finds("clearance"));
}

TEST_F(Checker, SeesTheRadiusBrokenAtAnEdge) {
  // Over the edge y = 0.75, z = 1.25 at 45 degrees: exactly the radius from it, then a little less.
  const double d = 0.5 / std::sqrt(2.0);
  plan.count = 1;
  request.goal.position = {103.5, -50.0 + 0.75 + d, 10.0 + 1.25 + d};
  request.start.position = {100.5, -50.0 + 0.75 + d, 10.0 + 1.25 + d};
  plan.segments[0] = straight({0.5, 0.75 + d, 1.25 + d}, {3.5, 0.75 + d, 1.25 + d}, 4.0);
  EXPECT_EQ(kinds(), std::vector<std::string>{});
  move(0, 4, 4, {0.0, -kSpoil, -kSpoil});
  EXPECT_TRUE(finds("clearance"));
}

TEST_F(Checker, SeesARadiusOfZeroBrokenInsideAnObstacle) {
  world.spec.radius = 0.0;
  plan.count = 1;
  request.start.position = {100.5, -49.25, 11.125};
  request.goal.position = {103.5, -49.25, 11.125};
  plan.segments[0] = straight({0.5, 0.75, 1.125}, {3.5, 0.75, 1.125}, 4.0);
  EXPECT_EQ(kinds(), std::vector<std::string>{});
  move(0, 3, 3, {0.0, -kSpoil, 0.0});
  EXPECT_TRUE(finds("clearance"));
}

TEST_F(Checker, SeesTheBoundaryBroken) {
  world.spec.boundary.lower.y = -50.0 + 1.25;
  EXPECT_EQ(kinds(), std::vector<std::string>{});
  move(0, 4, 4, {0.0, -kSpoil, 0.0});
  EXPECT_TRUE(finds("boundary"));
}

TEST_F(Checker, SeesLimitsBroken) {
  request.limits.v_max.x *= 1.0 - kSpoil;
  EXPECT_EQ(kinds(), std::vector<std::string>{"velocity"});
  request.limits.v_max.x = 10.0;
  request.limits.a_max.x *= 1.0 - kSpoil;
  EXPECT_EQ(kinds(), std::vector<std::string>{"acceleration"});
  request.limits.a_max.x = 10.0;
  request.limits.v_horizontal = 35.0 / 16.0 * 3.0 / 4.0 * (1.0 - kSpoil);
  EXPECT_EQ(kinds(), std::vector<std::string>{"velocity"});
}

TEST_F(Checker, SeesLowerLimitsBroken) {
  request.limits.v_min.z = -35.0 / 16.0 * 0.125 / 4.0;
  EXPECT_EQ(kinds(), std::vector<std::string>{});
  request.limits.v_min.z *= 1.0 - kSpoil;
  EXPECT_EQ(kinds(), std::vector<std::string>{"velocity"});
}

TEST_F(Checker, SeesJointsBroken) {
  for (int order = 0; order < 4; ++order) {
    SetUp();
    request.limits.v_max.z = request.limits.a_max.z = 100.0;
    // Control point k moves derivatives from order k on.
    move(1, order, order, {0.0, 0.0, kSpoil});
    EXPECT_TRUE(finds("joint")) << order;
  }
}

TEST_F(Checker, SeesEndsNotMet) {
  request.start.position.z += kSpoil;
  EXPECT_EQ(kinds(), std::vector<std::string>{"start_state"});
  request.start.position.z -= kSpoil;
  request.goal.velocity.y = kSpoil;
  EXPECT_EQ(kinds(), std::vector<std::string>{"goal_state"});
}

TEST_F(Checker, SeesAKeepInBroken) {
  fence({{100.0, -48.75, 10.0}, {104.0, -46.0, 12.0}}, tern::FenceKind::kKeepIn);
  EXPECT_EQ(kinds(), std::vector<std::string>{});
  fence({{100.0, -48.75 + kSpoil, 10.0}, {104.0, -46.0, 12.0}}, tern::FenceKind::kKeepIn);
  EXPECT_EQ(kinds(), std::vector<std::string>{"keep_in"});
}

TEST_F(Checker, SeesAKeepOutBroken) {
  fence({{101.0, -48.0, 10.9}, {102.0, -48.25 + 0.5, 11.1}}, tern::FenceKind::kKeepOut);
  EXPECT_EQ(kinds(), std::vector<std::string>{});
  fence({{101.0, -48.25 - kSpoil, 10.9}, {102.0, -47.0, 11.2}}, tern::FenceKind::kKeepOut);
  EXPECT_EQ(kinds(), std::vector<std::string>{"keep_out"});
}

TEST_F(Checker, SeesNumbersThatAreNone) {
  plan.segments[1].points[2].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(kinds(), std::vector<std::string>{"malformed"});
}

/// x between 1 and 2, the same the other way round, and a wall without thickness, of which nothing is said.
TEST(FencesOfTheAttack, EmptinessIsProvenOrDenied) {
  const Point x{{1, 0, 0}};
  EXPECT_EQ(emptiness_of({{x, 2}, {-1.0L * x, -1}}, 10), Emptiness::kHasPoint);
  EXPECT_EQ(emptiness_of({{x, 1}, {-1.0L * x, -2}}, 10), Emptiness::kEmpty);
  EXPECT_EQ(emptiness_of({{x, 2}, {-1.0L * x, -2 - 1e-12L}}, 10), Emptiness::kDoubt);
}

TEST_F(Checker, SeesFencesThatAreEmptyAndNotRefused) {
  const tern::Halfspace apart[] = {{{1.0, 0.0, 0.0}, 101.0}, {{-1.0, 0.0, 0.0}, -102.0}};
  const tern::Fence none{apart, 2, tern::FenceKind::kKeepOut};
  const tern::Fence some{apart, 1, tern::FenceKind::kKeepOut};
  const auto judged = [&](const tern::Fence& fence, tern::Status status) {
    Findings found;
    judge_fences(world, &fence, 1, status, 0, "plan", found);
    return found.size();
  };
  EXPECT_EQ(judged(none, tern::Status::kFenceEmpty), 0u);
  EXPECT_EQ(judged(none, tern::Status::kOk), 1u);
  EXPECT_EQ(judged(some, tern::Status::kOk), 0u);
  EXPECT_EQ(judged(some, tern::Status::kFenceEmpty), 1u);
}

/// A ball at rest, as near as it may be to the plan's middle at (2, 1.25, 1.125) and 1e-5 nearer; and one that comes.
TEST_F(Checker, Tracks) {
  tern::Track ball;
  ball.position = {102.0, -48.75 - 1.0, 11.125};
  ball.radius = 0.25;
  ball.error = 0.25;
  request.tracks = &ball;
  request.track_count = 1;
  const auto count = [&](double until) {
    Findings findings;
    check_tracks(world, request, plan, until, false, "plan", findings);
    return findings.size();
  };
  EXPECT_EQ(count(8.0), 0u);
  ball.error += kSpoil;
  EXPECT_EQ(count(8.0), 1u);
  // Half of the way takes 2 s.
  EXPECT_EQ(count(1.9), 0u);
  ball.error -= kSpoil;
  ball.position.y -= 6.0;
  ball.velocity.y = 3.0;
  ball.end = tern::TrackEnd::kStays;
  ball.until = 2000000000;
  EXPECT_EQ(count(8.0), 0u);
  ball.velocity.y = 3.0 + kSpoil;
  EXPECT_EQ(count(8.0), 1u);
  ball.end = tern::TrackEnd::kGone;
  ball.until = 1900000000;
  EXPECT_EQ(count(8.0), 0u);
}

}  // namespace
}  // namespace tern_attack
