// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the report says is in the way of a flight that does not arrive.
#include "flight/blocked.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "base/math.hpp"
#include "support/flight_room.hpp"
#include "support/grid_storage.hpp"
#include "support/random.hpp"
#include "support/yaw_case.hpp"

namespace {

using namespace tern;
using tern_test::FlightRoom;
using tern_test::OwnedMap;

double distance_to_cube(const Vec3& p, const Vec3& center, double cell) {
  const auto gap = [cell](double at, double middle) { return std::max(0.0, std::abs(at - middle) - 0.5 * cell); };
  return std::hypot(gap(p.x, center.x), gap(p.y, center.y), gap(p.z, center.z));
}

TEST(NearestSolid, IsTheNearestOfAll) {
  tern_test::Random random(36);
  for (int k = 0; k < tern_test::scaled(300); ++k) {
    const double cell = random.real(0.05, 0.3);
    tern_test::OwnedGrid owned(tern_test::whole_grid({150, 12, 9}, cell, 0.3));
    ASSERT_EQ(owned.status, Status::kOk);
    Grid& grid = owned.grid;
    const int marked = random.integer(0, 40);
    for (int n = 0; n < marked; ++n) {
      grid.mark_voxel({random.integer(0, 149), random.integer(0, 11), random.integer(0, 8)});
    }
    const Vec3 p{cell * random.real(-3.0, 153.0), cell * random.real(-3.0, 15.0), cell * random.real(-3.0, 12.0)};
    const double reach = cell * random.real(0.5, 40.0);
    double least = reach;
    for (int z = 0; z < 9; ++z) {
      for (int y = 0; y < 12; ++y) {
        for (int x = 0; x < 150; ++x) {
          if (grid.obstacle({x, y, z})) least = std::min(least, distance_to_cube(p, grid.center({x, y, z}), cell));
        }
      }
    }
    const NearestSolid found = nearest_solid(grid, p, reach);
    ASSERT_EQ(found.found, least < reach);
    EXPECT_NEAR(found.distance, least, 1e-9);
    if (!found.found) continue;
    EXPECT_TRUE(grid.obstacle(found.voxel));
    EXPECT_NEAR(distance_to_cube(p, grid.center(found.voxel), cell), least, 1e-9);
  }
}

/// The goal is in a block: the voxel of the block that is nearest to it.
TEST(FlightBlocked, GoalInABlock) {
  FlightRoom room(FlightRoom::flight_spec(), {{{4.0, -2.0, -2.0}, {6.0, 2.0, 4.0}}});
  ASSERT_EQ(room.flight.set_goal({3.7, 0.125, 1.125}), Status::kOk);
  EXPECT_EQ(room.fly(), FlightReason::kNearest);
  EXPECT_EQ(room.report.blocked_by, BlockedBy::kObstacle);
  EXPECT_DOUBLE_EQ(room.report.blocked_at.x, 4.125);
  EXPECT_LT(std::abs(room.report.blocked_at.y - 0.125), 0.3);
  ASSERT_EQ(room.flight.set_goal({0.125, 4.125, 1.125}), Status::kOk);
  room.tick();
  EXPECT_EQ(room.report.blocked_by, BlockedBy::kNothing);
  EXPECT_EQ(room.fly(), FlightReason::kArrived);
  EXPECT_EQ(room.report.blocked_by, BlockedBy::kNothing);
  EXPECT_EQ(room.report.blocked_at.x, 0.0);
  EXPECT_EQ(room.report.blocked_fence, kNoFence);
}

/// Around the vehicle: the wall on the way from where the vehicle ends towards the goal.
TEST(FlightBlocked, GoalBeyondClosedWalls) {
  const std::vector<Box> walls = {{{3.0, -3.0, -2.0}, {3.25, 3.25, 4.0}},
                                  {{-3.0, -3.0, -2.0}, {-2.75, 3.25, 4.0}},
                                  {{-3.0, -3.0, -2.0}, {3.25, -2.75, 4.0}},
                                  {{-3.0, 3.0, -2.0}, {3.25, 3.25, 4.0}}};
  FlightRoom room(FlightRoom::flight_spec(), walls);
  ASSERT_EQ(room.flight.set_goal({14.125, 0.125, 1.125}), Status::kOk);
  EXPECT_EQ(room.fly(6000), FlightReason::kNearest);
  EXPECT_EQ(room.report.blocked_by, BlockedBy::kObstacle);
  EXPECT_DOUBLE_EQ(room.report.blocked_at.x, 3.125);
}

TEST(FlightBlocked, HemmedIn) {
  FlightRoom room;
  const Vec3& p = room.start;
  for (int a = 0; a < 3; ++a) {
    for (const double sign : {-1.0, 1.0}) {
      Box wall{{p.x - 2.0, p.y - 2.0, p.z - 2.0}, {p.x + 2.0, p.y + 2.0, p.z + 2.0}};
      axis(sign < 0.0 ? wall.upper : wall.lower, a) = axis(p, a) + sign * 0.4;
      room.mark(wall);
    }
  }
  ASSERT_EQ(room.flight.set_goal({8.0, 0.0, 1.125}), Status::kOk);
  EXPECT_EQ(room.fly(1000), FlightReason::kHemmedIn);
  EXPECT_EQ(room.report.blocked_by, BlockedBy::kObstacle);
  EXPECT_LT(distance_to_cube(p, room.report.blocked_at, FlightRoom::kCell), FlightRoom::kRadius);
}

/// Something appears beside a vehicle that rests, and stays there: a threat for 0.3 s, and again if it comes
/// nearer. After that the report only says what it is.
TEST(FlightBlocked, WhatStaysBesideTheVehicleIsAThreatForAWhile) {
  FlightRoom room;
  const Vec3& p = room.start;
  room.tick();
  EXPECT_EQ(room.report.mode, FlightMode::kRest);
  const auto ticks_of_threat = [&](double gap) {
    room.mark({{p.x + gap, p.y - 0.1, p.z - 0.1}, {p.x + 1.0, p.y + 0.1, p.z + 0.1}});
    int ticks = 0;
    for (int k = 0; k < 200; ++k) {
      room.tick();
      ticks += room.report.mode == FlightMode::kThreat ? 1 : 0;
      EXPECT_EQ(room.report.contact_speed, 0.0);
    }
    EXPECT_EQ(room.report.mode, FlightMode::kRest);
    EXPECT_EQ(room.report.reason, FlightReason::kNoGoal);
    EXPECT_EQ(room.report.contact_time, 0);
    return ticks;
  };
  EXPECT_EQ(ticks_of_threat(0.7), 0);  // further than the radius
  EXPECT_EQ(room.report.blocked_by, BlockedBy::kNothing);
  EXPECT_EQ(ticks_of_threat(0.4), 31);
  EXPECT_EQ(room.report.blocked_by, BlockedBy::kObstacle);
  EXPECT_DOUBLE_EQ(room.report.blocked_at.x, 0.625);
  EXPECT_EQ(ticks_of_threat(0.4), 0);
  EXPECT_EQ(ticks_of_threat(0.2), 31);
  EXPECT_DOUBLE_EQ(room.report.blocked_at.x, 0.375);
}

/// No way leads out: it looks around, says all the while what is too near, and gives up.
TEST(FlightBlocked, HemmedInItLooksAround) {
  FlightRoom room;
  const Vec3& p = room.start;
  room.mark({{p.x - 0.6, p.y - 0.6, p.z - 0.6}, {p.x + 0.6, p.y + 0.6, p.z - 0.4}});
  room.mark({{p.x - 0.6, p.y - 0.6, p.z + 0.4}, {p.x + 0.6, p.y + 0.6, p.z + 0.6}});
  for (const double side : {-0.6, 0.4}) {
    room.mark({{p.x + side, p.y - 0.6, p.z - 0.6}, {p.x + side + 0.2, p.y + 0.6, p.z + 0.6}});
    room.mark({{p.x - 0.6, p.y + side, p.z - 0.6}, {p.x + 0.6, p.y + side + 0.2, p.z + 0.6}});
  }
  ASSERT_EQ(room.flight.set_goal({8.0, 0.0, 1.125}), Status::kOk);
  int threats = 0;
  int looks = 0;
  while (room.time < 20000000000 && room.report.reason != FlightReason::kHemmedIn) {
    room.tick();
    threats += room.report.mode == FlightMode::kThreat ? 1 : 0;
    looks += room.report.mode == FlightMode::kLook ? 1 : 0;
    if (room.report.mode != FlightMode::kLook) continue;
    ASSERT_EQ(room.report.blocked_by, BlockedBy::kObstacle);
    ASSERT_LT(distance_to_cube(p, room.report.blocked_at, FlightRoom::kCell), FlightRoom::kRadius);
  }
  EXPECT_EQ(room.report.mode, FlightMode::kRest);
  EXPECT_LE(threats, 40);
  EXPECT_GT(looks, 600);  // four directions of 0.928 s, and 3 s
}

TEST(FlightBlocked, GoalInAKeepOut) {
  Halfspace planes[kBoxPlanes];
  box_planes({{4.0, -2.0, -3.0}, {6.0, 2.0, 5.0}}, planes);
  const Fence fence{planes, kBoxPlanes, FenceKind::kKeepOut};
  FlightSpec spec = FlightRoom::flight_spec();
  spec.fences = &fence;
  spec.fence_count = 1;
  FlightRoom room(spec);
  ASSERT_EQ(room.flight.set_goal({5.0, 0.125, 1.125}), Status::kOk);
  EXPECT_EQ(room.fly(), FlightReason::kNoProgress);
  EXPECT_LT(room.time, 1000000000);  // a fence does not go away: nothing to look for
  EXPECT_EQ(room.report.plan, Status::kGoalFenced);
  EXPECT_EQ(room.report.blocked_by, BlockedBy::kFence);
  EXPECT_DOUBLE_EQ(room.report.blocked_at.x, 5.0);
  EXPECT_EQ(room.report.blocked_fence, 0);
}

/// The second fence is a wall from end to end: no way leads on, though nothing unseen or solid is near.
TEST(FlightBlocked, GoalBeyondAFence) {
  Halfspace planes[2][kBoxPlanes];
  box_planes({{-30.0, -30.0, -30.0}, {30.0, 30.0, 30.0}}, planes[0]);
  box_planes({{4.0, -30.0, -30.0}, {4.5, 30.0, 30.0}}, planes[1]);
  const Fence fences[2] = {{planes[0], kBoxPlanes, FenceKind::kKeepIn}, {planes[1], kBoxPlanes, FenceKind::kKeepOut}};
  FlightSpec spec = FlightRoom::flight_spec();
  spec.fences = fences;
  spec.fence_count = 2;
  FlightRoom room(spec);
  ASSERT_EQ(room.flight.set_goal({8.125, 0.125, 1.125}), Status::kOk);
  EXPECT_EQ(room.fly(6000), FlightReason::kNearest);
  EXPECT_EQ(room.report.blocked_by, BlockedBy::kFence);
  EXPECT_EQ(room.report.blocked_fence, 1);
  EXPECT_GT(room.report.blocked_at.x, 4.0 - FlightRoom::kRadius);
  EXPECT_LT(room.report.blocked_at.x, 4.5);
}

/// A ball is known, and no sensor shows more: the first unseen voxel beside the way, just outside the ball.
TEST(FlightBlocked, SpaceThatNobodySaw) {
  const Vec3 start{0.125, 0.125, 1.125};
  constexpr double kKnown = 1.9;
  OwnedMap owned(FlightRoom::map_spec());
  ASSERT_EQ(owned.map.assume_free(start, kKnown), Status::kOk);
  const auto memory = std::make_unique<Workspace>();
  Planner planner(memory.get(), sizeof *memory);
  std::vector<std::uint64_t> words(flight_words(FlightRoom::map_spec().dims));
  Flight flight;
  const FlightSpec spec = FlightRoom::flight_spec();
  ASSERT_EQ(flight.start(spec, owned.map, planner, words.data(), words.size(), start, 0), Status::kOk);
  ASSERT_EQ(flight.set_goal({8.125, 0.125, 1.125}), Status::kOk);
  FlightReport report{};
  for (int k = 0; k < 500 && report.blocked_by == BlockedBy::kNothing; ++k) flight.tick(k * spec.tick, report);
  EXPECT_EQ(report.blocked_by, BlockedBy::kUnseen);
  const Grid& safe = owned.map.safe();
  EXPECT_TRUE(safe.obstacle(safe.voxel_of(safe.to_local(report.blocked_at))));
  const Vec3 away = report.blocked_at - start;
  const double far = std::hypot(away.x, away.y, away.z);
  EXPECT_GT(far, kKnown - 2.0 * FlightRoom::kCell);
  EXPECT_LT(far, kKnown + 2.0 * FlightRoom::kCell);
}

/// A plan straight through a fence at 2 m/s: its proof ends a radius before it.
TEST(FlightBlocked, ProofThatEndsAtAFence) {
  Halfspace planes[kBoxPlanes];
  box_planes({{4.0, -30.0, -30.0}, {4.5, 30.0, 30.0}}, planes);
  const Fence fence{planes, kBoxPlanes, FenceKind::kKeepOut};
  FlightSpec spec = FlightRoom::flight_spec();
  spec.fences = &fence;
  spec.fence_count = 1;
  FlightRoom room(spec);
  FlightState& state = room.state();
  state.draft.plan.planned = tern_test::polyline({room.start, {8.125, 0.125, 1.125}}, 4.0);
  ASSERT_EQ(state.draft.begin_proof(state.facts, state.draft.plan.planned, 0.0), Status::kRunning);
  Work work{100000};
  ASSERT_EQ(state.draft.proof.step(work), Status::kOk);
  state.block.note_unproven(state.facts.map, state.draft);
  EXPECT_EQ(state.block.fence, 0);
  EXPECT_NEAR(state.block.at.x, 3.4, 0.1);
}

/// A goal that is reached, and a plan of which nobody knows how near it could come.
TEST(FlightBlocked, NothingIsBeyond) {
  FlightRoom room;
  FlightState& state = room.state();
  state.block = {BlockedBy::kWindow, state.cycle.aim.target_place, kNoFence};
  state.block.note_beyond(state.facts, state.cycle.aim, state.cycle.aim.target_place, state.tick_work);
  EXPECT_EQ(state.block.by, BlockedBy::kWindow);
  Report found{};
  found.status = Status::kNoPath;
  state.block.note_no_plan(state.facts, state.cycle.aim, found, state.tick_work);
  EXPECT_EQ(state.block.by, BlockedBy::kNothing);
}

/// Where the vehicle may not begin: in a ball of 1.5 m, beside a block and below the window's face.
TEST(FlightBlocked, StartsThatAreRefused) {
  const auto refusal_at = [](const Vec3& start, const std::vector<Box>& solid) {
    OwnedMap owned(FlightRoom::map_spec());
    EXPECT_EQ(owned.map.assume_free({0.0, 0.0, 1.0}, 1.5), Status::kOk);
    for (const Box& box : solid) EXPECT_EQ(owned.map.mark_box(box), Status::kOk);
    const auto memory = std::make_unique<Workspace>();
    Planner planner(memory.get(), sizeof *memory);
    std::vector<std::uint64_t> words(flight_words(FlightRoom::map_spec().dims));
    Flight flight;
    FlightRefusal refusal;
    const Status status =
        flight.start(FlightRoom::flight_spec(), owned.map, planner, words.data(), words.size(), start, 0, &refusal);
    EXPECT_EQ(status, refusal.blocked_by == BlockedBy::kNothing ? Status::kOk : Status::kStartOccupied);
    return refusal;
  };
  EXPECT_EQ(refusal_at({0.0, 0.0, 1.0}, {}).blocked_by, BlockedBy::kNothing);
  const FlightRefusal beside = refusal_at({0.0, 0.0, 1.0}, {{{0.3, -0.2, 0.8}, {0.5, 0.2, 1.2}}});
  EXPECT_EQ(beside.blocked_by, BlockedBy::kObstacle);
  EXPECT_DOUBLE_EQ(beside.distance, 0.25);
  EXPECT_DOUBLE_EQ(beside.needed, 0.5);
  EXPECT_DOUBLE_EQ(beside.blocked_at.x, 0.375);
  const FlightRefusal unseen = refusal_at({1.2, 0.0, 1.0}, {});
  EXPECT_EQ(unseen.blocked_by, BlockedBy::kUnseen);
  EXPECT_LT(unseen.distance, 0.3);
  const FlightRefusal low = refusal_at({0.0, 0.0, -1.9}, {});
  EXPECT_EQ(low.blocked_by, BlockedBy::kUnseen);  // its own voxel
  EXPECT_EQ(low.distance, 0.0);
  FlightRoom room;
  FlightRefusal face;
  EXPECT_EQ(room.flight.start(room.spec, room.map(), room.planner, room.words.data(), room.words.size(),
                              {0.125, 0.125, -1.8}, 0, &face),
            Status::kStartOccupied);
  EXPECT_EQ(face.blocked_by, BlockedBy::kWindow);
  EXPECT_NEAR(face.distance, 0.2, 1e-12);
  EXPECT_DOUBLE_EQ(face.blocked_at.z, -2.0);
}

TEST(FlightBlocked, EveryKindHasAText) {
  for (const BlockedBy by :
       {BlockedBy::kNothing, BlockedBy::kUnseen, BlockedBy::kObstacle, BlockedBy::kWindow, BlockedBy::kFence}) {
    EXPECT_STRNE(blocked_by_text(by), "unknown");
  }
  EXPECT_STREQ(blocked_by_text(static_cast<BlockedBy>(77)), "unknown");
}

/// A fence is worth waiting for if it will end, or if a link of the chain will begin; by the clock of each.
TEST(FlightBlocked, FencesForAWhileAreWaitedFor) {
  struct Case {
    FenceKind kind;
    double from, until, error;
    bool is_temporary;
  };
  for (const Case& c :
       {Case{FenceKind::kKeepOut, -9.0, -0.3, 0.1, false}, Case{FenceKind::kKeepOut, -9.0, -0.3, 0.4, true},
        Case{FenceKind::kKeepOut, 0.0, 0.0, 0.4, false}, Case{FenceKind::kKeepIn, -0.3, 9.0, 0.4, true},
        Case{FenceKind::kKeepIn, -0.3, 9.0, 0.1, false}, Case{FenceKind::kKeepIn, 5.0, 9.0, 2.5, false},
        Case{FenceKind::kKeepIn, 0.0, 0.0, 0.4, false}}) {
    FlightRoom room;
    FlightFacts& facts = room.state().facts;
    facts.fences[0] = {
        nullptr, 0, c.kind, static_cast<std::int64_t>(c.from * 1e9), static_cast<std::int64_t>(c.until * 1e9), c.error};
    facts.spec.fence_count = 1;
    Work work{1000};
    const Blockage block{BlockedBy::kFence, room.start, 0};
    EXPECT_EQ(block.is_temporary(facts, work), c.is_temporary) << c.from << " " << c.until << " " << c.error;
  }
}

}  // namespace
