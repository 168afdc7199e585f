// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Flights through corridors, tunnels and doors of several widths: each arrives, or says soon what is too narrow. Beside
// a wall, none calls that a threat for long.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
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
    EXPECT_NEAR(flown.result.narrow.plan, c.needed, 1e-9);
    EXPECT_NEAR(flown.result.narrow.vehicle, 0.7, 1e-9);
  }
}

/// A slot is called narrow if no voxel in it is one that a plan may pass, and only then.
TEST(NarrowPlace, IsOneWithoutAVoxelForAPlan) {
  for (const double cell : {0.1, 0.2}) {
    const int needed = cell < 0.15 ? 9 : 5;
    for (int free = 2; free <= needed + 1; ++free) {
      tern_test::OwnedGrid owned(tern_test::whole_grid({64, 24, 24}, cell, 0.35));
      ASSERT_EQ(owned.status, tern::Status::kOk);
      for (int x = 0; x < 64; ++x) {
        for (int z = 0; z < 24; ++z) {
          owned.grid.mark_voxel({x, 0, z});
          owned.grid.mark_voxel({x, 1 + free, z});
        }
      }
      owned.grid.inflate();
      tern::FlightReport report{};
      report.blocked_by = tern::BlockedBy::kObstacle;
      report.blocked_at = owned.grid.center({32, 0, 12});
      const Vec3 rest = owned.grid.center({32, 1 + free / 2, 12});
      bool fits = false;
      for (int y = 1; y < 1 + free; ++y) fits = fits || owned.grid.free({32, y, 12});
      EXPECT_EQ(fits, free >= needed);
      for (const Vec3& place : {rest, report.blocked_at}) {  // the second one is in the wall
        const tern_host::NarrowPlace narrow = tern_host::narrow_place(owned.grid, report, place);
        EXPECT_EQ(narrow.axis, fits ? 0 : 'y') << free;
        EXPECT_NEAR(narrow.free, fits ? 0.0 : free * cell, 1e-9);
      }
      report.blocked_by = tern::BlockedBy::kWindow;
      EXPECT_EQ(tern_host::narrow_place(owned.grid, report, rest).axis, 0);
    }
  }
}

}  // namespace
