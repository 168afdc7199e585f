// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The copy of the route grid against one composed voxel by voxel, wherever the vehicle was before.
#include "flight/route_copy.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "support/flight_room.hpp"
#include "support/random.hpp"

namespace {

using namespace tern;
using tern_test::FlightRoom;
using tern_test::Random;

struct Around {
  Vec3 centre;
  CopyRule rule;
};

/// True if a voxel's cube and the box within `radius` of the centre along each axis have a point in common.
bool meets_box(const Vec3& low, double cell, const Vec3& centre, double radius) {
  if (!(radius > 0.0)) return false;
  for (int a = 0; a < 3; ++a) {
    if (axis(low, a) >= axis(centre, a) + radius || axis(low, a) + cell <= axis(centre, a) - radius) return false;
  }
  return true;
}

bool meets_ball(const Vec3& low, double cell, const Vec3& centre, double radius) {
  double square = 0.0;
  for (int a = 0; a < 3; ++a) {
    const double off = axis(centre, a) - std::clamp(axis(centre, a), axis(low, a), axis(low, a) + cell);
    square += off * off;
  }
  return square < radius * radius;
}

/// True if the first voxel from this one up or down that was seen, and the three beyond it, are obstacles.
bool follows_wall(RollingMap& map, Voxel v, int up) {
  while (map.safe().inside(v) && map.safe().obstacle(v) && !map.route().obstacle(v)) v.z += up;
  for (int n = 0; n < 4; ++n, v.z += up) {
    if (!map.route().inside(v) || !map.route().obstacle(v)) return false;
  }
  return true;
}

bool is_solid(RollingMap& map, const Voxel& v, const Around& around) {
  const double cell = FlightRoom::kCell;
  const Vec3 low = map.route().spec().origin + cell * Vec3{1.0 * v.x, 1.0 * v.y, 1.0 * v.z};
  const bool is_near =
      meets_box(low, cell, around.centre, around.rule.near) && !meets_box(low, cell, around.centre, around.rule.hole);
  const bool is_walled = around.rule.has_walls && (follows_wall(map, v, 1) || follows_wall(map, v, -1));
  const bool is_hidden = map.safe().obstacle(v) && (is_near || is_walled);
  return (map.route().obstacle(v) || is_hidden) && !meets_ball(low, cell, around.centre, around.rule.emptied);
}

void expect_composed(RollingMap& map, const RouteCopy& copy, const Around& around) {
  const Voxel dims = map.route().spec().dims;
  std::vector<std::uint64_t> words(grid_words(dims));
  Grid composed;
  ASSERT_EQ(composed.bind(map.route().spec(), words.data(), words.size()), Status::kOk);
  std::vector<Vec3> solids;
  int different = 0;
  for (std::int32_t z = 0; z < dims.z; ++z) {
    for (std::int32_t y = 0; y < dims.y; ++y) {
      for (std::int32_t x = 0; x < dims.x; ++x) {
        const bool solid = is_solid(map, {x, y, z}, around);
        if (solid) solids.push_back(composed.spec().origin + composed.center({x, y, z}));
        different += copy.grid().obstacle({x, y, z}) != solid;
      }
    }
  }
  EXPECT_EQ(different, 0);
  composed.mark_points(solids.data(), solids.size());
  composed.inflate();
  for (std::int32_t z = 0; z < dims.z; ++z) {
    for (std::int32_t y = 0; y < dims.y; ++y) {
      const std::uint64_t* const row = composed.blocked_row(y, z);
      ASSERT_TRUE(std::equal(row, row + composed.row_words(), copy.grid().blocked_row(y, z))) << y << ' ' << z;
    }
  }
}

/// Boxes come, the window slides, and the vehicle moves: each copy begins with what the one before left.
TEST(RouteCopy, IsTheSameAsComposedAnew) {
  Random random(81);
  FlightRoom room;
  RollingMap& map = room.map();
  std::vector<std::uint64_t> words(grid_words(FlightRoom::map_spec().dims));
  RouteCopy copy;
  ASSERT_EQ(copy.bind(map, words.data(), words.size()), Status::kOk);
  Vec3 at = room.start;
  for (int k = 0; k < std::max(4, tern_test::scaled(20)); ++k) {
    const Vec3 low{at.x + random.real(-6.0, 6.0), at.y + random.real(-6.0, 6.0), random.real(-1.5, 2.0)};
    if (k % 2 == 0) room.mark({low, low + Vec3{random.real(0.1, 2.0), random.real(0.1, 2.0), random.real(0.1, 2.0)}});
    if (k % 3 == 2) {
      at.x += random.real(0.0, 40.0);
      at.y += random.real(-3.0, 3.0);
      ASSERT_EQ(map.follow(at), Status::kRunning);
    }
    while (map.busy()) map.step(std::uint32_t{100000});
    const double hole = k % 4 == 1 ? 1.0 : 0.0;
    const double near = k % 5 == 4 ? 0.0 : random.real(0.5, 3.0);
    const Around around{at, {near, hole, k % 4 == 3 ? 0.5 : 0.0, k % 3 != 1}};
    copy.begin(map, around.centre, around.rule);
    Work work;
    while (!copy.done()) copy.advance(map, work);
    expect_composed(map, copy, around);
  }
}

/// Of 24 voxels a column, 0 .. 23, those of 8 .. 11 and, elsewhere, of 8 .. 10 were hit. Above the third column's wall
/// there are voxels that were seen free.
TEST(RouteCopy, WhatFollowsAWallOfFourVoxelsIsSolid) {
  tern_test::OwnedMap owned(FlightRoom::map_spec());
  RollingMap& map = owned.map;
  const auto mark = [&map](int x, int count) {
    const Vec3 low = map.route().spec().origin + FlightRoom::kCell * Vec3{1.0 * x, 64.0, 8.0};
    EXPECT_EQ(map.mark_box({low + Vec3{0.01, 0.01, 0.01}, low + Vec3{0.24, 0.24, 0.25 * count - 0.01}}), Status::kOk);
  };
  mark(20, 4);
  mark(40, 3);
  mark(100, 4);
  const Vec3 above = map.route().spec().origin + FlightRoom::kCell * Vec3{100.5, 64.5, 15.5};
  ASSERT_EQ(map.assume_free(above, 0.5), Status::kOk);
  std::vector<std::uint64_t> words(grid_words(FlightRoom::map_spec().dims));
  RouteCopy copy;
  ASSERT_EQ(copy.bind(map, words.data(), words.size()), Status::kOk);
  copy.begin(map, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0, true});
  Work work;
  while (!copy.done()) copy.advance(map, work);
  const auto solid_in = [&copy](int x) {
    std::string found;
    for (std::int32_t z = 0; z < 24; ++z) found += copy.grid().obstacle({x, 64, z}) ? '#' : '.';
    return found;
  };
  EXPECT_EQ(solid_in(20), "########################");
  EXPECT_EQ(solid_in(40), "........###.............");
  EXPECT_EQ(solid_in(21), "........................");
  EXPECT_EQ(solid_in(100), "##############..........");
}

}  // namespace
