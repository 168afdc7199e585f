// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Proofs that rely on earlier ones, or begin where something is too near; and what a map says has become solid.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "prove/chamber.hpp"
#include "support/grid_storage.hpp"
#include "support/owned_map.hpp"
#include "support/random.hpp"
#include "tern/fence.hpp"
#include "tern/proof.hpp"

namespace {

using namespace tern;
using tern_test::Chamber;
using tern_test::move;
using tern_test::OwnedMap;
using tern_test::prove;
using tern_test::Proven;
using tern_test::Random;

/// The vehicle rests 0.3 m from a wall, where 0.4 m are asked for.
TEST(ProofGrounds, LeavingAPlaceMayNotLeadNearer) {
  Chamber room;
  ASSERT_EQ(room.grid.mark_box({{2.0, -3.0, 0.0}, {4.0, 3.0, 4.0}}), Status::kOk);
  const Vec3 place{4.3, 0.0, 2.0};
  const ProofGrounds leaving{nullptr, &place};
  EXPECT_EQ(prove(room.grid, move(place, {1.0, 0.0, 0.0}), {}).finding, Finding::kObstacle);
  EXPECT_EQ(prove(room.grid, move(place, {1.0, 0.0, 0.0}), leaving).finding, Finding::kNone);
  EXPECT_EQ(prove(room.grid, move(place, {1.0, 0.5, 0.2}), leaving).finding, Finding::kNone);
  EXPECT_EQ(prove(room.grid, move(place, {-0.01, 0.5, 0.0}), leaving).finding, Finding::kObstacle);
  // Along the wall it comes to voxels that were not nearer than the radius: they keep all of it.
  const Proven along = prove(room.grid, move(place, {0.0, 1.0, 0.0}), leaving);
  EXPECT_EQ(along.finding, Finding::kObstacle);
  EXPECT_LT(along.until, 1.0);
}

TEST(ProofGrounds, LeavingAPlaceKeepsTheRadiusFromAllElse) {
  Chamber room;
  ASSERT_EQ(room.grid.mark_voxel({22, 30, 20}), Status::kOk);  // 4.2 .. 4.3
  ASSERT_EQ(room.grid.mark_voxel({40, 30, 20}), Status::kOk);  // 6.0 .. 6.1
  const Vec3 place{4.5, 0.05, 2.05};
  const ProofGrounds leaving{nullptr, &place};
  EXPECT_EQ(prove(room.grid, move(place, {1.0, 0.0, 0.0}), leaving).finding, Finding::kNone);
  EXPECT_EQ(prove(room.grid, move(place, {1.2, 0.0, 0.0}), leaving).finding, Finding::kObstacle);
}

/// The vehicle stands 0.2 m above a floor whose voxels reach up to 1.0 m; 0.4 m are asked for.
TEST(ProofGrounds, OnTheGroundOnlyTheGroundMayBeNear) {
  const Vec3 place{5.0, 0.0, 1.2};
  const double ground = 0.95;
  ProofGrounds standing{nullptr, &place};
  standing.ground = &ground;
  const Trajectory up = move(place, {0.0, 0.0, 1.0});
  const Trajectory down = move({5.0, 0.0, 2.2}, {0.0, 0.0, -1.0});
  const auto floor_and = [&](const Box& thing) {
    Chamber room;
    EXPECT_EQ(room.grid.mark_box({{2.0, -3.0, 0.0}, {8.0, 3.0, 1.0}}), Status::kOk);
    EXPECT_EQ(room.grid.mark_box(thing), Status::kOk);
    return room;
  };
  const Box nothing{{2.0, -3.0, 0.0}, {2.1, -2.9, 0.1}};
  EXPECT_EQ(prove(floor_and(nothing).grid, up, {}).finding, Finding::kObstacle);
  EXPECT_EQ(prove(floor_and(nothing).grid, up, standing).finding, Finding::kNone);
  EXPECT_EQ(prove(floor_and(nothing).grid, down, standing).finding, Finding::kNone);
  // A stone on the floor is not the ground, though it is no nearer than the place is. Beyond the radius it matters not.
  const Box stone{{5.3, 0.0, 1.0}, {5.4, 0.1, 1.1}};
  EXPECT_EQ(prove(floor_and(stone).grid, up, {nullptr, &place}).finding, Finding::kNone);
  EXPECT_EQ(prove(floor_and(stone).grid, up, standing).finding, Finding::kObstacle);
  EXPECT_EQ(prove(floor_and(stone).grid, down, standing).finding, Finding::kObstacle);
  EXPECT_EQ(prove(floor_and({{5.4, 0.0, 1.0}, {5.5, 0.1, 1.1}}).grid, down, standing).finding, Finding::kNone);
  // Never lower than it stands, even where nothing is below.
  const Proven deeper = prove(Chamber().grid, move({5.0, 0.0, 2.2}, {0.0, 0.0, -1.01}), standing);
  EXPECT_EQ(deeper.finding, Finding::kOutside);
  // And not along the ground.
  EXPECT_EQ(prove(floor_and(nothing).grid, move(place, {0.5, 0.0, 0.0}), standing).finding, Finding::kObstacle);
}

/// By how much the points of a vertical line keep off all voxels, by the rule in words. Lines and cubes are convex: the
/// nearest point of the line to a cube is at the clamped height.
double spare_on_line(const Grid& grid, const Vec3& place, double ground, double rise) {
  const GridSpec& spec = grid.spec();
  double spare = 1e9;
  for (int z = 0; z < spec.dims.z; ++z) {
    for (int y = 0; y < spec.dims.y; ++y) {
      for (int x = 0; x < spec.dims.x; ++x) {
        if (!grid.obstacle({x, y, z})) continue;
        const Vec3 low{spec.origin.x + x * spec.cell, spec.origin.y + y * spec.cell, spec.origin.z + z * spec.cell};
        const auto gap = [&](double at, double from) { return std::max({0.0, from - at, at - from - spec.cell}); };
        const double aside = std::hypot(gap(place.x, low.x), gap(place.y, low.y));
        const double height = std::min(std::max(place.z, low.z), place.z + rise);
        const double nearest = std::hypot(aside, gap(height, low.z));
        const double standing = std::hypot(aside, gap(place.z, low.z));
        const double kept = low.z < ground ? std::min(spec.clearance(), standing) : spec.clearance();
        spare = std::min(spare, nearest - kept);
      }
    }
  }
  return spare;
}

/// Up and down, among random voxels, held against that rule.
TEST(ProofGrounds, LiftsKeepWhatTheRuleSays) {
  Random random(77);
  int clear = 0;
  int met = 0;
  for (int k = 0; k < tern_test::scaled(400); ++k) {
    Chamber room;
    const Vec3 place{random.real(3.0, 7.0), random.real(-2.0, 2.0), random.real(0.6, 2.0)};
    const double ground = place.z - random.real(-0.1, 0.3);
    for (int b = 0; b < 6; ++b) {
      const Voxel voxel{static_cast<int>((place.x - 2.0 + random.real(-0.6, 0.6)) / 0.1),
                        static_cast<int>((place.y + 3.0 + random.real(-0.6, 0.6)) / 0.1),
                        static_cast<int>((place.z + random.real(-0.5, b < 4 ? 0.0 : 1.5)) / 0.1)};
      EXPECT_EQ(room.grid.mark_voxel(voxel), Status::kOk);
    }
    const double rise = random.real(0.5, 1.2);
    const double spare = spare_on_line(room.grid, place, ground, rise);
    if (std::abs(spare) < 1e-6 && spare != 0.0) continue;
    ProofGrounds standing{nullptr, &place};
    standing.ground = &ground;
    const Finding expected = spare < 0.0 ? Finding::kObstacle : Finding::kNone;
    EXPECT_EQ(prove(room.grid, move(place, {0.0, 0.0, rise}), standing).finding, expected) << k;
    EXPECT_EQ(prove(room.grid, move({place.x, place.y, place.z + rise}, {0.0, 0.0, -rise}), standing).finding, expected)
        << k;
    ++(spare < 0.0 ? met : clear);
  }
  EXPECT_GT(clear, 0);
  EXPECT_GT(met, 0);
}

/// A wall along x is one run of voxels: those near the place are each held against their own distance.
TEST(ProofGrounds, LeavingAPlaceLooksAtVoxelsOneByOne) {
  Chamber room;
  ASSERT_EQ(room.grid.mark_box({{2.0, 0.35, 2.0}, {8.0, 0.4, 2.1}}), Status::kOk);
  const Vec3 place{4.45, 0.0, 2.05};
  const ProofGrounds leaving{nullptr, &place};
  EXPECT_EQ(prove(room.grid, move(place, {0.0, -0.5, 0.0}), leaving).finding, Finding::kNone);
  EXPECT_EQ(prove(room.grid, move(place, {1.0, 0.0, 0.0}), leaving).finding, Finding::kObstacle);
}

/// What was proven, and what was added: the rest need not be looked at.
TEST(ProofGrounds, OnlyWhatWasAddedIsLookedAt) {
  Random random(41);
  int lost = 0;
  for (int k = 0; k < 300; ++k) {  // quick enough for every build
    Chamber room;
    const auto mark = [&] {
      const Vec3 at{random.real(2.0, 8.0), random.real(-3.0, 3.0), random.real(0.0, 4.0)};
      const Box box{at, {at.x + 0.4, at.y + 0.4, at.z + 0.4}};
      EXPECT_EQ(room.grid.mark_box(box), Status::kOk);
      return box;
    };
    for (int b = 0; b < 10; ++b) mark();
    const auto between = [&](double a, double b) { return random.real(a, b); };
    const Vec3 from{between(2.5, 7.5), between(-2.5, 2.5), between(0.5, 3.5)};
    const Vec3 to{between(2.5, 7.5), between(-2.5, 2.5), between(0.5, 3.5)};
    const Trajectory plan = move(from, {to.x - from.x, to.y - from.y, to.z - from.z}, {between(-0.3, 0.3), 0.0, 0.0});
    if (prove(room.grid, plan, {}).finding != Finding::kNone) continue;
    Box added = mark();
    added.lower = {added.lower.x - 0.1, added.lower.y - 0.1, added.lower.z - 0.1};  // whole voxels
    added.upper = {added.upper.x + 0.1, added.upper.y + 0.1, added.upper.z + 0.1};
    const Proven all = prove(room.grid, plan, {});
    const Proven again = prove(room.grid, plan, {&added, nullptr});
    EXPECT_EQ(again.finding, all.finding) << k;
    EXPECT_EQ(again.until, all.until) << k;
    EXPECT_LE(again.work, all.work) << k;
    lost += all.finding == Finding::kNone ? 0 : 1;
  }
  EXPECT_GE(lost, 4);
  // It is the caller's word.
  Chamber room;
  ASSERT_EQ(room.grid.mark_voxel({30, 30, 20}), Status::kOk);
  const Box elsewhere{{2.0, -3.0, 0.0}, {2.1, -2.9, 0.1}};
  EXPECT_EQ(prove(room.grid, move({4.0, 0.0, 2.0}, {2.0, 0.0, 0.0}), {&elsewhere, nullptr}).finding, Finding::kNone);
}

/// Obstacles in the alarm's box do not count where they had been seen free; all others do.
TEST(ProofGrounds, AnAlarmPardonsWhatWasSeenFree) {
  Chamber room;
  for (const int x : {30, 40}) ASSERT_EQ(room.grid.mark_voxel({x, 30, 20}), Status::kOk);  // 5.0 and 6.0 m
  std::vector<std::uint64_t> seen(static_cast<std::size_t>(room.grid.row_words()) * 60 * 40);
  const auto see = [&](int x) { seen[static_cast<std::size_t>((20 * 60 + 30) * room.grid.row_words())] |= 1ull << x; };
  const Trajectory way = move({4.0, 0.05, 2.05}, {3.0, 0.0, 0.0});
  const auto end = [&](const Box& box) {
    const Alarm alarm{box, seen.data()};
    return prove(room.grid, way, {nullptr, nullptr, &alarm}).finding;
  };
  const Box around_both{{4.9, -0.1, 1.9}, {6.2, 0.2, 2.2}};
  EXPECT_EQ(prove(room.grid, way, {}).finding, Finding::kObstacle);
  EXPECT_EQ(end(around_both), Finding::kObstacle);  // never seen
  see(30);
  EXPECT_EQ(end(around_both), Finding::kObstacle);
  see(40);
  EXPECT_EQ(end(around_both), Finding::kNone);
  EXPECT_EQ(end({{5.0, 0.0, 2.0}, {6.1, 0.1, 2.1}}), Finding::kNone);       // just these voxels
  EXPECT_EQ(end({{5.06, 0.0, 2.0}, {6.1, 0.1, 2.1}}), Finding::kObstacle);  // without the first one's centre
  EXPECT_EQ(end({{4.9, 0.1, 1.9}, {6.2, 0.2, 2.2}}), Finding::kObstacle);
  EXPECT_EQ(end({{4.9, -0.1, 2.1}, {6.2, 0.2, 2.2}}), Finding::kObstacle);
  EXPECT_EQ(end({{-1e9, -1e9, -1e9}, {1e9, 1e9, 1e9}}), Finding::kNone);
}

TEST(MapAdded, SaysWhatBecameSolid) {
  MapSpec spec = tern::map_spec({0.0, 0.0, 0.0}, 0.1, {128, 20, 20}, 0.0);
  spec.depth_margin = spec.pose_margin = 0.0;
  spec.pixels = 4096;
  OwnedMap owned(spec);
  Box added{};
  ASSERT_TRUE(owned.map.take_added(added));
  EXPECT_DOUBLE_EQ(added.lower.x, 0.0);
  EXPECT_DOUBLE_EQ(added.upper.x, 12.8);
  EXPECT_DOUBLE_EQ(added.upper.z, 2.0);
  EXPECT_FALSE(owned.map.take_added(added));
  tern_test::Image image(41, 41, 20.0);
  const auto frame = [&](double depth) {
    for (float& z : image.z) z = static_cast<float>(depth);
    ASSERT_EQ(owned.map.begin_frame(image.view, {{1.0, 1.0, 1.0}, {0.5, -0.5, 0.5, -0.5}}, 0), Status::kRunning);
    EXPECT_FALSE(owned.map.take_added(added));
    ASSERT_EQ(tern_test::finish(owned.map), Status::kOk);
  };
  // What was unknown was solid: a hit there adds nothing, and what is seen only becomes free.
  frame(4.05);
  EXPECT_FALSE(owned.map.take_added(added));
  // Something stands in what was seen.
  image.at(20, 20) = 1.05f;
  frame(1.05);
  ASSERT_TRUE(owned.map.take_added(added));
  EXPECT_NEAR(added.lower.z, 0.0, 0.11);
  EXPECT_DOUBLE_EQ(added.lower.x, 0.0);  // whole words
  EXPECT_DOUBLE_EQ(added.upper.x, 6.4);
  EXPECT_FALSE(owned.map.take_added(added));
  ASSERT_EQ(owned.map.mark_box({{8.01, 1.01, 1.01}, {8.09, 1.09, 1.09}}), Status::kOk);
  EXPECT_FALSE(owned.map.take_added(added));  // unknown before
  ASSERT_EQ(owned.map.follow({12.0, 1.0, 1.0}), Status::kRunning);
  EXPECT_FALSE(owned.map.take_added(added));
  ASSERT_EQ(tern_test::finish(owned.map), Status::kOk);
  ASSERT_TRUE(owned.map.take_added(added));
  EXPECT_DOUBLE_EQ(added.lower.x, 6.4);
  EXPECT_DOUBLE_EQ(added.upper.x, 19.2);
}

}  // namespace
