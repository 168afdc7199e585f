// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Goals in the middle of things, goals that are walled in, and goals beyond the window: which are reached, and how near
// the vehicle comes to the others.
#include <gtest/gtest.h>

#include <cmath>

#include "support/flights.hpp"

namespace {

using namespace tern;
using tern_test::FlightSettings;
using tern_test::Flown;
using tern_test::Random;
using tern_test::Scene;
using tern_test::story;

double from_goal(const Flown& flown, const Vec3& goal) {
  const Vec3 p = flown.position();
  return std::hypot(p.x - goal.x, std::hypot(p.y - goal.y, p.z - goal.z));
}

/// A block whose middle is further from its faces than the radius: no sensor sees the goal there. The nearest place is
/// a radius before a face; the vehicle rests no further away than that, a voxel of what is seen and a hop.
TEST(FlightGoals, TheMiddleOfAThickBlockIsApproached) {
  for (const double half : {0.6, 1.0, 1.6}) {
    for (const Vec3& goal : {Vec3{6.0, 0.0, 1.5}, Vec3{10.0, 0.0, 1.5}, Vec3{9.0, 4.0, 1.5}}) {
      Scene scene;
      scene.boxes.push_back({{goal.x - half, goal.y - half, 0.0}, {goal.x + half, goal.y + half, 5.0}});
      FlightSettings settings;
      Flown flown(scene, settings);
      EXPECT_EQ(flown.flight.set_goal(goal), Status::kOk);
      EXPECT_EQ(flown.fly(90.0), FlightReason::kNearest) << half << ": " << story(flown);
      EXPECT_LT(from_goal(flown, goal), half + settings.radius + 3.0 * settings.cell) << half << ": " << story(flown);
    }
  }
}

/// Four walls around the goal. Where one of them has a gap that nobody has seen yet, the goal is reached.
TEST(FlightGoals, AGapThatIsUnseenYetIsFound) {
  for (const bool is_closed : {true, false}) {
    for (const double gap : {0.0, 1.0}) {
      const Vec3 goal{8.0, 0.0, 1.5};
      Scene scene;
      scene.boxes.push_back({{6.0, -2.0, 0.0}, {6.2, 2.0, 5.0}});
      scene.boxes.push_back({{6.0, -2.0, 0.0}, {10.0, -1.8, 5.0}});
      scene.boxes.push_back({{6.0, 1.8, 0.0}, {10.0, 2.0, 5.0}});
      // The gap is on the far side.
      scene.boxes.push_back({{9.8, -2.0, 0.0}, {10.0, is_closed ? 2.0 : gap - 0.8, 5.0}});
      if (!is_closed) scene.boxes.push_back({{9.8, gap + 0.8, 0.0}, {10.0, 2.0, 5.0}});
      Flown flown(scene, FlightSettings{});
      EXPECT_EQ(flown.flight.set_goal(goal), Status::kOk);
      const FlightReason reason = flown.fly(90.0);
      EXPECT_EQ(reason, is_closed ? FlightReason::kNearest : FlightReason::kArrived) << gap << ": " << story(flown);
      EXPECT_LT(from_goal(flown, goal), is_closed ? 3.0 : 0.01) << gap << ": " << story(flown);
    }
  }
}

/// Beyond the window, which is 51 m long, and at its faces.
TEST(FlightGoals, GoalsBeyondTheWindowAreReached) {
  for (const Vec3& goal :
       {Vec3{40.0, 0.0, 1.5}, Vec3{-40.0, 5.0, 1.0}, Vec3{10.0, 25.0, 2.0}, Vec3{25.0, -14.9, 1.5}}) {
    FlightSettings settings;
    settings.v = 5.0;
    settings.a = 8.0;
    Flown flown(Scene{}, settings);
    EXPECT_EQ(flown.flight.set_goal(goal), Status::kOk);
    EXPECT_EQ(flown.fly(60.0), FlightReason::kArrived) << story(flown);
    EXPECT_LT(from_goal(flown, goal), 0.01) << story(flown);
  }
}

/// A room of 12 x 8 x 3 m that a wall with a doorway parts.
Scene parted_room() {
  Scene scene;
  scene.boxes = {{{-3.0, -5.0, 3.0}, {11.0, 5.0, 4.0}}, {{-3.0, -5.0, 0.0}, {-2.0, 5.0, 3.0}},
                 {{10.0, -5.0, 0.0}, {11.0, 5.0, 3.0}}, {{-2.0, -5.0, 0.0}, {10.0, -4.0, 3.0}},
                 {{-2.0, 4.0, 0.0}, {10.0, 5.0, 3.0}},  {{4.0, -4.0, 0.0}, {4.4, 1.0, 3.0}},
                 {{4.0, 3.0, 0.0}, {4.4, 4.0, 3.0}}};
  return scene;
}

/// Goals anywhere in the room, from a radius and a voxel away from its faces on, many of them right above the floor or
/// below the ceiling. What is next to a face is seen whole only along flat lines of sight, since the pose may be wrong.
class FlightGoalsInARoom : public testing::TestWithParam<unsigned> {};

TEST_P(FlightGoalsInARoom, AreReached) {
  FlightSettings settings;
  settings.radius = 0.3;
  settings.pose_margin = 0.05;
  settings.assumed = 1.0;  // between that ball and the first views some voxels stay unseen
  settings.window = {128, 64, 20};
  Random random(GetParam());
  for (int k = 0; k < tern_test::scaled(9); ++k) {
    const bool is_beyond = k % 3 > 0;
    const double x = is_beyond ? random.real(4.92, 9.48) : random.real(-1.48, 3.48);
    const double heights[] = {0.52, random.real(0.52, 2.48), 2.48};
    const Vec3 goal{x, random.real(-3.48, 3.48), heights[k / 3 % 3]};
    Flown flown(parted_room(), settings);
    EXPECT_EQ(flown.flight.set_goal(goal), Status::kOk);
    EXPECT_EQ(flown.fly(90.0), FlightReason::kArrived)
        << goal.x << " " << goal.y << " " << goal.z << ": " << story(flown);
    EXPECT_LT(from_goal(flown, goal), 0.01);
  }
}

// With seeds 49 and 51, a vehicle goes to the edge of that ball, where no plan can begin. With 57 and 59, it would go
// there again and again. With 49 and 55, goals are right below the ceiling, and what is above them is seen only along
// the flattest lines.
INSTANTIATE_TEST_SUITE_P(Seeds, FlightGoalsInARoom, testing::Values(44u, 49u, 51u, 55u, 57u, 59u));

/// The bottom of a shaft of 2.4 m, 2 m deep: from inside, a camera that looks level and 29 degrees down does not see
/// the voxels below it, and from above only those beside the walls.
TEST(FlightGoals, TheBottomOfANarrowShaftIsSeenFromNowhere) {
  const Vec3 goal{7.0, 0.0, 0.7};
  Scene scene;
  scene.boxes = {{{4.0, -3.0, 0.0}, {5.8, 3.0, 2.0}},
                 {{8.2, -3.0, 0.0}, {10.0, 3.0, 2.0}},
                 {{5.8, -3.0, 0.0}, {8.2, -1.2, 2.0}},
                 {{5.8, 1.2, 0.0}, {8.2, 3.0, 2.0}}};
  Flown flown(scene, FlightSettings{});
  EXPECT_EQ(flown.flight.set_goal(goal), Status::kOk);
  EXPECT_EQ(flown.fly(90.0), FlightReason::kGoalUnseen) << story(flown);
  EXPECT_EQ(flown.report.blocked_by, BlockedBy::kUnseen);
  const Vec3 off = flown.report.blocked_at - goal;
  EXPECT_LT(std::hypot(off.x, off.y), 1.2) << "in the shaft";
  EXPECT_LT(flown.report.blocked_at.z, 2.0);
}

/// What is above a wall is presumed to be wall until it is seen, or until there is no other way.
TEST(FlightGoals, TheOnlyWayMayLeadOverAWall) {
  for (const double top : {2.4, 4.0}) {
    const Vec3 goal{8.0, 0.0, 1.3};
    Scene scene;
    scene.boxes = {{{-3.0, -5.0, 4.0}, {11.0, 5.0, 5.0}}, {{-3.0, -5.0, 0.0}, {-2.0, 5.0, 4.0}},
                   {{10.0, -5.0, 0.0}, {11.0, 5.0, 4.0}}, {{-2.0, -5.0, 0.0}, {10.0, -4.0, 4.0}},
                   {{-2.0, 4.0, 0.0}, {10.0, 5.0, 4.0}},  {{4.0, -4.0, 0.0}, {4.4, 4.0, top}}};
    Flown flown(scene, FlightSettings{});
    EXPECT_EQ(flown.flight.set_goal(goal), Status::kOk);
    EXPECT_EQ(flown.fly(90.0), top < 4.0 ? FlightReason::kArrived : FlightReason::kNearest) << story(flown);
  }
}

/// Below the floor, above the window, and further away than anything is flown: the vehicle rests with a reason and then
/// reaches a goal that it can.
TEST(FlightGoals, GoalsOutOfReachEndWithAReason) {
  for (const Vec3& goal : {Vec3{5.0, 0.0, -40.0}, Vec3{3.0, 3.0, 100.0}, Vec3{6.0, 1.0, -0.1}}) {
    FlightSettings settings;
    settings.v = 5.0;
    settings.a = 8.0;
    Flown flown(Scene{}, settings);
    EXPECT_EQ(flown.flight.set_goal(goal), Status::kOk);
    const FlightReason reason = flown.fly(60.0);
    EXPECT_TRUE(reason == FlightReason::kNoProgress || reason == FlightReason::kGoalUnseen ||
                reason == FlightReason::kNearest)
        << story(flown);
    EXPECT_EQ(flown.flight.set_goal({8.0, -3.0, 1.5}), Status::kOk);
    EXPECT_EQ(flown.fly(30.0), FlightReason::kArrived) << story(flown);
    EXPECT_LT(from_goal(flown, {8.0, -3.0, 1.5}), 0.01) << story(flown);
  }
}

}  // namespace
