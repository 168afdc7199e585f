// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Coarse grids to test far ways on.
#ifndef TERN_TESTS_SUPPORT_FAR_WORLD_HPP
#define TERN_TESTS_SUPPORT_FAR_WORLD_HPP

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <vector>

#include "support/grid_storage.hpp"
#include "support/owned_map.hpp"
#include "support/random.hpp"
#include "tern/far_way.hpp"
#include "tern/workspace.hpp"

namespace tern_test {

constexpr double kCoarse = 4.0;
constexpr std::int64_t kTick = 10000000;
constexpr std::uint32_t kMuch = 1000000000;

/// A coarse grid with its planner, and a rolling map of 0.5 m that has its middle at `middle`.
struct FarWorld {
  explicit FarWorld(const tern::Voxel& dims, const tern::Vec3& middle = {64.0, 64.0, 8.0})
      : coarse(whole_grid(dims, kCoarse, 0.0)),
        seen(tern::map_spec({middle.x - 32.0, middle.y - 32.0, middle.z - 8.0}, 0.5, {128, 128, 32}, 0.5)),
        memory(new tern::Workspace),
        planner(memory.get(), sizeof *memory) {}

  void block(const tern::Box& box) { EXPECT_EQ(coarse.grid.mark_box(box), tern::Status::kOk); }
  void begin(const tern::Vec3& goal, const tern::FarWaySpec& spec = {40.0}) {
    coarse.grid.inflate();
    ASSERT_EQ(far.start(spec, coarse.grid, planner), tern::Status::kOk);
    ASSERT_EQ(far.set_goal(goal), tern::Status::kOk);
  }
  bool tick(const tern::Vec3& at, bool gave_up = false, std::uint32_t work = kMuch) {
    return tick(at, gave_up ? tern::FlightReason::kNoProgress : tern::FlightReason::kNone, work);
  }
  /// With a flight that rests for a reason.
  bool tick(const tern::Vec3& at, tern::FlightReason reason, std::uint32_t work = kMuch) {
    tern::FlightReport report{};
    report.mode = tern::FlightMode::kRest;
    report.reason = reason;
    return far.tick(at, report, seen.map, time += kTick, work);
  }
  void find_way(const tern::Vec3& from) {
    for (int k = 0; k < 100000 && far.state() == tern::FarState::kSearching; ++k) tick(from);
  }
  /// The near goals of a vehicle that is at each as soon as it is told.
  std::vector<tern::Vec3> near_goals(tern::Vec3 at) {
    std::vector<tern::Vec3> all;
    for (int k = 0; k < 1000 && (all.empty() || !far.is_last()); ++k) {
      if (!tick(at)) continue;
      all.push_back(far.near_goal());
      at = far.near_goal();
    }
    return all;
  }
  /// The grid's origin is the world's.
  tern::Vec3 centre(const tern::Voxel& v) const { return coarse.grid.center(v); }

  OwnedGrid coarse;
  OwnedMap seen;
  std::unique_ptr<tern::Workspace> memory;
  tern::Planner planner;
  tern::FarWay far;
  std::int64_t time = 0;
};

inline tern::Voxel random_free(const tern::Grid& grid, Random& random) {
  const tern::Voxel& dims = grid.spec().dims;
  for (;;) {
    const tern::Voxel v{random.integer(0, dims.x - 1), random.integer(0, dims.y - 1), random.integer(0, dims.z - 1)};
    if (grid.free(v)) return v;
  }
}

/// Blocks in a coarse grid of 24 x 20 x 6 cells.
inline void build_blocks(Random& random, FarWorld& world) {
  const int count = random.integer(0, 60);
  for (int k = 0; k < count; ++k) {
    const tern::Vec3 low{random.real(0.0, 90.0), random.real(0.0, 75.0), 0.0};
    world.block({low, {low.x + random.real(1.0, 20.0), low.y + random.real(1.0, 20.0), random.real(2.0, 24.0)}});
  }
  if (random.chance(0.3)) world.block({{48.0, 0.0, 0.0}, {49.0, 80.0, 24.0}});  // a wall from end to end
  world.coarse.grid.inflate();
}

/// Two streets around a block of 8 x 24 cells. The rolling map shows a wall across the one that is shorter.
inline FarWorld& build_streets(FarWorld& world) {
  world.block({{40.0, 24.0, 0.0}, {88.0, 116.0, 16.0}});
  world.begin({116.0, 40.0, 6.0});
  EXPECT_EQ(world.seen.map.mark_box({{60.0, 0.0, 0.0}, {60.5, 24.0, 16.0}}), tern::Status::kOk);
  return world;
}

}  // namespace tern_test

#endif
