// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The copy of the route grid against one composed voxel by voxel, wherever the vehicle was before.
#include "flight/route_copy.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/flight_room.hpp"
#include "support/random.hpp"

namespace {

using namespace tern;
using tern_test::FlightRoom;
using tern_test::Random;

struct Around {
  Vec3 centre;
  double near;
  double hole;
  double emptied;
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

bool is_solid(RollingMap& map, const Voxel& v, const Around& around) {
  const double cell = FlightRoom::kCell;
  const Vec3 low = map.route().spec().origin + cell * Vec3{1.0 * v.x, 1.0 * v.y, 1.0 * v.z};
  const bool is_hidden = map.safe().obstacle(v) && meets_box(low, cell, around.centre, around.near) &&
                         !meets_box(low, cell, around.centre, around.hole);
  return (map.route().obstacle(v) || is_hidden) && !meets_ball(low, cell, around.centre, around.emptied);
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
    const Around around{at, k % 5 == 4 ? 0.0 : random.real(0.5, 3.0), hole, k % 4 == 3 ? 0.5 : 0.0};
    copy.begin(map, around.centre, around.near, around.hole, around.emptied);
    Work work;
    while (!copy.done()) copy.advance(map, work);
    expect_composed(map, copy, around);
  }
}

}  // namespace
