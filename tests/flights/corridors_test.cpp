// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Flights through corridors, tunnels and doors of several widths: each arrives, or says soon what is too narrow. Beside
// a wall, none calls that a threat for long.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "host/flight/simulated_flight.hpp"
#include "support/grid_storage.hpp"
#include "support/random.hpp"

namespace {

using tern::Vec3;
using tern_host::FlightResult;
using tern_host::FlightWorld;

enum class Shape { kAlongX, kAlongY, kTunnel, kSquare, kBlocks, kDoor, kDiagonal };

/// A wall of upright poles to both sides of the diagonal.
void add_poles(double half, FlightWorld& world) {
  constexpr double kPole = 0.15;
  const double aside = (half + kPole) / std::sqrt(2.0);
  for (double at = 0.3; at < 15.0; at += kPole) {
    world.cylinders.push_back({at - aside, at + aside, 0.0, 4.0, kPole});
    world.cylinders.push_back({at + aside, at - aside, 0.0, 4.0, kPole});
  }
}

FlightWorld corridor(Shape shape, double width, double cell, const std::vector<std::string>& settings = {}) {
  const double half = 0.5 * width;
  FlightWorld world;
  world.settings = tern_host::flight_settings(settings);
  world.settings.cell = cell;
  world.settings.window = cell < 0.15 ? Vec3{25.6, 20.0, 8.0} : Vec3{51.2, 30.0, 8.0};
  world.settings.hits = 1;
  world.settings.support = world.settings.speckle_filter = 0;
  world.boundary = {{0.0, 0.0, 0.0}, {14.0, width, 4.0}};
  world.start = {2.0, half, 1.5};
  world.goal = {12.0, half, 1.5};
  const double side = 2.0 + width;
  switch (shape) {
    case Shape::kAlongX:
      break;
    case Shape::kAlongY:
      world.boundary.upper = {width, 14.0, 4.0};
      world.start = {half, 2.0, 1.5};
      world.goal = {half, 12.0, 1.5};
      break;
    case Shape::kTunnel:
      world.boundary.upper = {14.0, 6.0, width};
      world.start = {2.0, 3.0, half};
      world.goal = {12.0, 3.0, half};
      break;
    case Shape::kSquare:
      world.boundary.upper = {14.0, width, width};
      world.start.z = world.goal.z = half;
      break;
    case Shape::kBlocks:
    case Shape::kDoor: {
      const bool is_door = shape == Shape::kDoor;
      world.boundary.upper.y = side + 2.0;
      world.blocks = {{{is_door ? 7.0 : 0.0, 0.0, 0.0}, {is_door ? 7.5 : 14.0, 2.0, 4.0}},
                      {{is_door ? 7.0 : 0.0, side, 0.0}, {is_door ? 7.5 : 14.0, side + 2.0, 4.0}}};
      world.start.y = world.goal.y = 2.0 + half;
      break;
    }
    case Shape::kDiagonal:
      world.boundary.upper = {15.0, 15.0, 4.0};
      add_poles(half, world);
      world.start = {2.5, 2.5, 1.5};
      world.goal = {11.0, 11.0, 1.5};
      break;
  }
  return world;
}

struct FlownCorridor {
  FlightResult result;
  double threat = 0.0;  ///< the longest time that the vehicle rested under a threat, seconds
};

FlownCorridor fly(const FlightWorld& world) {
  FlownCorridor flown;
  double now = 0.0;
  flown.result = tern_host::simulate_flight(world, [&](const tern_host::FlightMoment& moment) {
    const Vec3& v = moment.command.sample.velocity;
    const bool rests = !(std::abs(v.x) + std::abs(v.y) + std::abs(v.z) > 0.0);
    now = rests && moment.report.mode == tern::FlightMode::kThreat ? now + 1.0 / world.settings.tick_hz : 0.0;
    flown.threat = std::max(flown.threat, now);
  });
  return flown;
}

std::string name_of(Shape shape, double width, double cell) {
  char text[80];
  std::snprintf(text, sizeof text, "shape %d, %.2f m wide, cells of %.1f m", static_cast<int>(shape), width, cell);
  return text;
}

void expect_arrival(Shape shape, double width, double cell, const std::vector<std::string>& settings = {}) {
  SCOPED_TRACE(name_of(shape, width, cell));
  const FlightWorld world = corridor(shape, width, cell, settings);
  const FlownCorridor flown = fly(world);
  EXPECT_EQ(flown.result.status, "reached") << flown.result.reason << ", " << flown.result.blocked();
  EXPECT_LE(flown.threat, 1.0);
  EXPECT_GT(flown.result.min_clearance, world.settings.body_radius);
}

/// As wide as the voxels need, and about a tenth of a metre to each side, in which the sensor sees no voxel whole.
TEST(Corridors, AreFlownThroughWhereVoxelsFit) {
  struct Case {
    Shape shape;
    double width, cell;
  };
  const std::vector<Case> cases = {{Shape::kAlongX, 1.2, 0.1}, {Shape::kAlongX, 1.4, 0.2},  {Shape::kAlongY, 1.2, 0.1},
                                   {Shape::kAlongY, 1.5, 0.2}, {Shape::kTunnel, 1.2, 0.1},  {Shape::kTunnel, 1.4, 0.2},
                                   {Shape::kSquare, 1.3, 0.1}, {Shape::kBlocks, 1.6, 0.2},  {Shape::kDoor, 1.2, 0.1},
                                   {Shape::kDoor, 1.4, 0.2},   {Shape::kDiagonal, 1.3, 0.1}};
  for (int k = 0; k < tern_test::scaled(static_cast<int>(cases.size())); ++k) {
    const Case& c = cases[static_cast<std::size_t>(k)];
    expect_arrival(c.shape, c.width, c.cell);
  }
  expect_arrival(Shape::kAlongX, 1.2, 0.1, {"v_max=1"});
  expect_arrival(Shape::kAlongX, 1.0, 0.1, {"body_radius=0.15"});
}

/// What is too narrow for the voxels ends soon, with the width that there is and the one that would do.
TEST(Corridors, ThatAreTooNarrowAreSaidToBe) {
  struct Case {
    Shape shape;
    double width, cell;
    char axis;
    double needed;
  };
  for (const Case& c : std::vector<Case>{{Shape::kAlongX, 1.2, 0.2, 'y', 1.0},
                                         {Shape::kAlongY, 1.2, 0.2, 'x', 1.0},
                                         {Shape::kAlongX, 1.0, 0.1, 'y', 0.9},
                                         {Shape::kAlongX, 1.1, 0.2, 'y', 1.0},
                                         {Shape::kBlocks, 1.2, 0.2, 'y', 1.0}}) {
    SCOPED_TRACE(name_of(c.shape, c.width, c.cell));
    const FlownCorridor flown = fly(corridor(c.shape, c.width, c.cell));
    EXPECT_EQ(flown.result.status, "stuck") << flown.result.reason;
    EXPECT_LE(flown.threat, 1.0);
    EXPECT_LT(flown.result.time, 14.0);  // a look around takes 8 s, and the way there up to 5 s
    EXPECT_NE(flown.result.blocked_by, tern::BlockedBy::kNothing);
    EXPECT_EQ(flown.result.narrow.axis, c.axis) << flown.result.narrow.text();
    EXPECT_LT(flown.result.narrow.free, c.needed - 0.05);
    EXPECT_NEAR(flown.result.narrow.width, c.needed, 1e-9);
    EXPECT_NEAR(flown.result.narrow.vehicle, 0.7, 1e-9);
  }
}

/// Two rooms with a wall of two voxels between them, from x = 30 on, and the voxels of that wall in which a gap is.
template <typename IsGap>
void build_wall(tern_test::OwnedGrid& owned, IsGap is_gap) {
  ASSERT_EQ(owned.status, tern::Status::kOk);
  for (int y = 0; y < 24; ++y) {
    for (int z = 0; z < 24; ++z) {
      if (is_gap(y, z)) continue;
      owned.grid.mark_voxel({30, y, z});
      owned.grid.mark_voxel({31, y, z});
    }
  }
}

/// A gap is called narrow if a plan may pass no voxel in it, and only then.
TEST(NarrowPlace, IsAGapWithoutAVoxelForAPlan) {
  for (const double cell : {0.1, 0.2}) {
    const int needed = cell < 0.15 ? 9 : 5;
    for (int free = 1; free <= needed + 1; ++free) {
      tern_test::OwnedGrid owned(tern_test::whole_grid({64, 24, 24}, cell, 0.35));
      build_wall(owned, [free](int y, int) { return y >= 3 && y < 3 + free; });
      owned.grid.inflate();
      bool fits = false;
      for (int y = 3; y < 3 + free; ++y) fits = fits || (owned.grid.free({30, y, 12}) && owned.grid.free({31, y, 12}));
      EXPECT_EQ(fits, free >= needed);
      const Vec3 rest = owned.grid.center({10, 12, 12});
      const Vec3 goal = owned.grid.center({55, 12, 12});
      const tern_host::NarrowPlace narrow = tern_host::narrow_place(owned.grid, rest, goal);
      EXPECT_EQ(narrow.found, !fits) << free;
      if (fits) continue;
      EXPECT_EQ(narrow.axis, 'y');
      EXPECT_NEAR(narrow.free, free * cell, 1e-9);
      EXPECT_NEAR(narrow.width, needed * cell, 1e-9);
      EXPECT_NEAR(narrow.at.x, 31.0 * cell, 0.51 * cell);  // the wall's middle
      EXPECT_FALSE(tern_host::narrow_place(owned.grid, goal, goal).found);
    }
  }
}

// Of two gaps, the wider one is named. Without one, or from within the wall, nothing is.
TEST(NarrowPlace, IsOnTheWidestWay) {
  tern_test::OwnedGrid two(tern_test::whole_grid({64, 24, 24}, 0.2, 0.35));
  build_wall(two, [](int y, int) { return (y >= 3 && y < 5) || (y >= 17 && y < 21); });
  const Vec3 rest = two.grid.center({10, 4, 12});
  const Vec3 goal = two.grid.center({55, 4, 12});
  const tern_host::NarrowPlace wider = tern_host::narrow_place(two.grid, rest, goal);
  EXPECT_NEAR(wider.free, 0.8, 1e-9);
  EXPECT_GT(wider.at.y, 3.4);
  EXPECT_FALSE(tern_host::narrow_place(two.grid, two.grid.center({30, 12, 12}), goal).found);
  tern_test::OwnedGrid closed(tern_test::whole_grid({64, 24, 24}, 0.2, 0.35));
  build_wall(closed, [](int, int) { return false; });
  EXPECT_FALSE(tern_host::narrow_place(closed.grid, rest, goal).found);
}

// A square of five voxels is wide enough, but not without its corners: those are within the radius of its middle.
TEST(NarrowPlace, MayBeWideEnoughAlongEachAxis) {
  tern_test::OwnedGrid owned(tern_test::whole_grid({64, 24, 24}, 0.2, 0.35));
  build_wall(owned, [](int y, int z) {
    const int off_y = std::abs(y - 12);
    const int off_z = std::abs(z - 12);
    return off_y <= 2 && off_z <= 2 && off_y + off_z < 4;
  });
  const tern_host::NarrowPlace narrow =
      tern_host::narrow_place(owned.grid, owned.grid.center({10, 12, 12}), owned.grid.center({55, 12, 12}));
  EXPECT_TRUE(narrow.found);
  EXPECT_EQ(narrow.axis, 0);
  EXPECT_NEAR(narrow.gap, 0.2 * std::sqrt(2.0), 1e-9);
  EXPECT_NEAR(narrow.at.y, 2.5, 1e-9);
  EXPECT_NE(narrow.text().find("the widest way passes 0.28 m"), std::string::npos) << narrow.text();
}

}  // namespace
