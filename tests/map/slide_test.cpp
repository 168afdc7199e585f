// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A window that has moved holds what it held before, elsewhere: voxel by voxel, and in both grids what a new grid with
// these obstacles would have. And no slicing of any job changes a bit.
#include <gtest/gtest.h>

#include <algorithm>

#include "grid/bit_rows.hpp"
#include "map/map_state.hpp"
#include "support/grid_storage.hpp"
#include "support/owned_map.hpp"

namespace {

using tern::Box;
using tern::Grid;
using tern::MapSpec;
using tern::MapState;
using tern::Pose;
using tern::Status;
using tern::Vec3;
using tern::Voxel;
using tern_test::finish;
using tern_test::Image;
using tern_test::OwnedGrid;
using tern_test::OwnedMap;
using tern_test::Random;
using tern_test::scaled;

/// All that is known of a voxel: seen, the count, and blocked.
int knowledge(const OwnedMap& owned, const Voxel& v) {
  const MapState& state = *reinterpret_cast<const MapState*>(owned.words.data());
  const auto bit = [&](const std::uint64_t* layer) {
    return static_cast<int>(layer[state.row(v.y, v.z) + static_cast<std::size_t>(v.x >> 6)] >> (v.x & 63) & 1);
  };
  return bit(state.seen) + 2 * bit(state.low) + 4 * bit(state.high) + (owned.map.route().obstacle(v) ? 8 : 0);
}

std::vector<int> knowledge(const OwnedMap& owned) {
  const Voxel dims = owned.map.route().spec().dims;
  std::vector<int> all;
  for (int z = 0; z < dims.z; ++z) {
    for (int y = 0; y < dims.y; ++y) {
      for (int x = 0; x < dims.x; ++x) all.push_back(knowledge(owned, {x, y, z}));
    }
  }
  return all;
}

/// Both layers equal those of a new grid with the same obstacles.
void expect_as_new(const Grid& grid) {
  OwnedGrid fresh(grid.spec());
  ASSERT_EQ(fresh.status, Status::kOk);
  tern_test::copy_obstacles(grid, fresh.grid);
  ASSERT_TRUE(grid.inflated());
  const std::size_t count = tern::GridAccess::layer_words(grid);
  const auto equal = [&](const std::uint64_t* a, const std::uint64_t* b) { return std::equal(a, a + count, b); };
  ASSERT_TRUE(equal(grid.obstacle_row(0, 0), fresh.grid.obstacle_row(0, 0)));
  ASSERT_TRUE(equal(grid.blocked_row(0, 0), fresh.grid.blocked_row(0, 0)));
}

/// The safe grid's obstacles are the route grid's and what was never seen.
void expect_safe(const OwnedMap& owned) {
  const Voxel dims = owned.map.route().spec().dims;
  for (int z = 0; z < dims.z; ++z) {
    for (int y = 0; y < dims.y; ++y) {
      for (int x = 0; x < dims.x; ++x) {
        const Voxel v{x, y, z};
        ASSERT_EQ(owned.map.safe().obstacle(v), owned.map.route().obstacle(v) || !owned.map.seen(v));
      }
    }
  }
  expect_as_new(owned.map.route());
  expect_as_new(owned.map.safe());
}

Vec3 inside(Random& random, const OwnedMap& owned) {
  const tern::GridSpec& spec = owned.map.route().spec();
  return {spec.origin.x + spec.dims.x * spec.cell * random.real(0.1, 0.9),
          spec.origin.y + spec.dims.y * spec.cell * random.real(0.1, 0.9),
          spec.origin.z + spec.dims.z * spec.cell * random.real(0.1, 0.9)};
}

/// A frame, a scan, or things told.
void learn(Random& random, OwnedMap& owned, std::uint32_t slice) {
  const Vec3 eye = inside(random, owned);
  const int what = random.integer(0, 3);
  if (what == 0) {
    Image image(24, 18, 12.0);
    tern_test::fill_randomly(random, image, owned.map.route().spec().cell * 25);
    Pose pose{eye, {}};
    tern_test::random_quaternion(random, pose.quaternion);
    ASSERT_EQ(owned.map.begin_frame(image.view, pose, 0), Status::kRunning);
    ASSERT_EQ(finish(owned.map, slice), Status::kOk);
  } else if (what == 1) {
    std::vector<Vec3> points(3000);
    const double far = random.real(0.5, 3.0);
    for (Vec3& p : points) {
      p = {eye.x + far * random.real(-1, 1), eye.y + far * random.real(-1, 1), eye.z + far * random.real(-1, 1)};
    }
    ASSERT_EQ(owned.map.begin_scan(points.data(), points.size(), eye, 0), Status::kRunning);
    ASSERT_EQ(finish(owned.map, slice), Status::kOk);
  } else if (what == 2) {
    ASSERT_EQ(owned.map.assume_free(eye, random.real(0.2, 1.0)), Status::kOk);
  } else {
    ASSERT_EQ(owned.map.mark_box({eye, {eye.x + 0.3, eye.y + 0.2, eye.z + 0.5}}), Status::kOk);
  }
}

/// Obstacles known beforehand: boxes and cylinders of which some are in the window, and some come into it later.
struct Prior {
  Box boxes[3];
  tern::Cylinder cylinders[2];

  explicit Prior(Random& random) {
    const auto place = [&] { return Vec3{random.real(-15.0, 15.0), random.real(-4.0, 8.0), random.real(-4.0, 2.0)}; };
    for (Box& box : boxes) {
      const Vec3 a = place();
      box = {a, {a.x + random.real(0.0, 5.0), a.y + random.real(0.0, 2.0), a.z + random.real(0.0, 1.0)}};
    }
    for (tern::Cylinder& cylinder : cylinders) cylinder = {place(), random.real(0.0, 2.0), random.real(0.0, 1.0)};
  }
  void add_to(MapSpec& spec, Random& random) const {
    spec.prior = boxes;
    spec.prior_count = random.integer(0, 3);
    spec.prior_cylinders = cylinders;
    spec.prior_cylinder_count = random.integer(0, 2);
  }
};

MapSpec random_window(Random& random) {
  const Voxel dims{random.chance(0.3) ? 64 * random.integer(1, 3) : random.integer(60, 260), random.integer(5, 70),
                   random.integer(5, 20)};
  MapSpec spec = tern::map_spec({random.real(-5.0, 5.0), 1.0, -2.0}, 0.1, dims, random.real(0.0, 0.35));
  spec.range = 3.0;
  spec.hits = random.integer(1, 4);
  spec.misses = random.integer(1, 4);
  spec.support = random.chance(0.5) ? 0 : random.integer(1, 8);
  spec.slack = random.integer(0, 3);
  spec.pixels = 8000;
  spec.scan_pixel = 0.07;
  spec.depth_margin = spec.pose_margin = 0.0;
  return spec;
}

/// Where the window should go: a little off its middle, or far.
Vec3 next_center(Random& random, const OwnedMap& owned) {
  const tern::GridSpec& spec = owned.map.route().spec();
  const double most = random.chance(0.7) ? 8.0 : 150.0;
  const auto on = [&](double origin, int count, double reach) {
    return origin + spec.cell * (0.5 * count + (random.chance(0.3) ? 0.0 : random.real(-reach, reach)));
  };
  return {on(spec.origin.x, spec.dims.x, 12 * most), on(spec.origin.y, spec.dims.y, most),
          on(spec.origin.z, spec.dims.z, most)};
}

/// The voxel's number in another grid with the same lattice.
Voxel moved(const tern::GridSpec& from, const tern::GridSpec& to, const Voxel& v) {
  const auto on = [&](double a, double b) { return static_cast<int>(std::lround((a - b) / from.cell)); };
  return {v.x + on(from.origin.x, to.origin.x), v.y + on(from.origin.y, to.origin.y),
          v.z + on(from.origin.z, to.origin.z)};
}

TEST(MapSlide, EqualsAMapMadeAnew) {
  Random random(321);
  for (int k = 0; k < scaled(60); ++k) {
    const Prior prior(random);
    MapSpec spec = random_window(random);
    prior.add_to(spec, random);
    OwnedMap owned(spec);
    ASSERT_EQ(owned.status, Status::kOk);
    for (int round = 0; round < 5; ++round) {
      ASSERT_NO_FATAL_FAILURE(learn(random, owned, 1u << 30));
      ASSERT_NO_FATAL_FAILURE(expect_safe(owned));
      const std::vector<int> before = knowledge(owned);
      const tern::GridSpec old = owned.map.route().spec();
      const std::uint64_t revision = owned.map.revision();
      const Grid copy = owned.map.route();
      const Vec3 center = next_center(random, owned);
      const Status status = owned.map.follow(center);
      if (status == Status::kOk) continue;
      ASSERT_EQ(status, Status::kRunning);
      ASSERT_FALSE(owned.map.route().bound());
      ASSERT_EQ(finish(owned.map, random.chance(0.5) ? 3 : 1000), Status::kOk);
      const tern::GridSpec now = owned.map.route().spec();
      EXPECT_GT(owned.map.revision(), revision);
      EXPECT_FALSE(copy.bound());
      // A new map has only the prior, in the same place.
      const MapState& state = *reinterpret_cast<const MapState*>(owned.words.data());
      MapSpec at_new_place = state.spec;
      at_new_place.origin = now.origin;
      const OwnedMap fresh(at_new_place);
      ASSERT_EQ(fresh.status, Status::kOk);
      const Voxel dims = now.dims;
      for (int z = 0; z < dims.z; ++z) {
        for (int y = 0; y < dims.y; ++y) {
          for (int x = 0; x < dims.x; ++x) {
            const Voxel was = moved(now, old, {x, y, z});
            const bool kept = owned.map.route().inside(was);
            const int expected = kept ? before[static_cast<std::size_t>((was.z * dims.y + was.y) * dims.x + was.x)]
                                      : knowledge(fresh, {x, y, z});
            ASSERT_EQ(knowledge(owned, {x, y, z}), expected) << x << ' ' << y << ' ' << z;
          }
        }
      }
      ASSERT_NO_FATAL_FAILURE(expect_safe(owned));
      // The middle is as near as the slack and whole words allow.
      const auto off = [&](double c, double origin, int count) {
        return std::abs(std::floor((c - origin) / now.cell) - count / 2);
      };
      EXPECT_LE(off(center.x, now.origin.x, dims.x), 33 + state.spec.slack);
      EXPECT_LE(off(center.y, now.origin.y, dims.y), 1 + state.spec.slack);
      EXPECT_LE(off(center.z, now.origin.z, dims.z), 1 + state.spec.slack);
    }
  }
}

TEST(MapSlide, TheSameBitsInSlicesOfAnySize) {
  for (const std::uint32_t slice : {1u, 2u, 7u, 64u, 1000u}) {
    Random random(322), same(322);
    for (int k = 0; k < scaled(6); ++k) {
      OwnedMap whole(random_window(random));
      OwnedMap sliced(random_window(same));
      for (int round = 0; round < 4; ++round) {
        ASSERT_NO_FATAL_FAILURE(learn(random, whole, 1u << 30));
        ASSERT_NO_FATAL_FAILURE(learn(same, sliced, slice));
        const Vec3 center = next_center(random, whole);
        next_center(same, sliced);
        if (whole.map.follow(center) == Status::kRunning) finish(whole.map);
        if (sliced.map.follow(center) == Status::kRunning) finish(sliced.map, slice);
        ASSERT_EQ(knowledge(whole), knowledge(sliced));
        ASSERT_EQ(tern_test::hash_of(whole.map), tern_test::hash_of(sliced.map)) << slice;
        ASSERT_EQ(whole.map.revision(), sliced.map.revision());
      }
    }
  }
}

/// Between two slices of a frame, the safe grid shows no voxel free that was solid before and is after.
TEST(MapSlide, ObstaclesBetweenSlicesAreThoseBeforeOrAfter) {
  Random random(323);
  MapSpec spec = random_window(random);
  spec.dims = {100, 20, 12};
  OwnedMap owned(spec);
  ASSERT_EQ(owned.map.assume_free(inside(random, owned), 0.8), Status::kOk);
  Image image(24, 18, 12.0);
  tern_test::fill_randomly(random, image, 2.0);
  Pose pose{inside(random, owned), {}};
  tern_test::random_quaternion(random, pose.quaternion);
  const std::size_t count = tern::GridAccess::layer_words(owned.map.safe());
  const std::uint64_t* layer = owned.map.safe().obstacle_row(0, 0);
  const std::vector<std::uint64_t> before(layer, layer + count);
  ASSERT_EQ(owned.map.begin_frame(image.view, pose, 0), Status::kRunning);
  std::vector<std::vector<std::uint64_t>> between;
  while (owned.map.step(50) == Status::kRunning) between.emplace_back(layer, layer + count);
  ASSERT_GT(between.size(), 3u);
  for (const std::vector<std::uint64_t>& words : between) {
    for (std::size_t k = 0; k < count; ++k) ASSERT_TRUE(words[k] == before[k] || words[k] == layer[k]);
  }
}

}  // namespace
