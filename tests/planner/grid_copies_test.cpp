// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Any sequence of binds, marks, clears, inflations, copies and plans over a few grids that share storages: a planner
// that has planned before answers as a new one, and notices a change of its grid.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <vector>

#include "support/grid_storage.hpp"
#include "support/random.hpp"
#include "tern/tern.hpp"

namespace {

using tern::Grid;
using tern::GridSpec;
using tern::Status;
using tern::Vec3;
using tern::Voxel;
using tern_test::Random;
using tern_test::scaled;

constexpr int kGrids = 4;
constexpr int kStorages = 2;
constexpr int kBoxes = 16;
constexpr int kHeight = 8;

/// A storage, and how often it was bound and its obstacles changed.
struct Storage {
  std::vector<std::uint64_t> words;
  int bound = 0;
  int changes = 0;
  int kind = 0;          ///< of the last bind's spec
  bool cleared = false;  ///< since the world began, by other hands than a grid's
};

/// Which bind of which storage a grid should see; none where storage is negative.
struct View {
  int storage = -1;
  int bound = 0;
  int kind = 0;
};

struct Moment {
  int storage;
  int bound;
  int changes;

  bool operator==(const Moment& other) const {
    return storage == other.storage && bound == other.bound && changes == other.changes;
  }
};

struct PlannerMemory {
  PlannerMemory() : memory(new unsigned char[tern::kWorkspaceBytes]), planner(memory.get(), tern::kWorkspaceBytes) {}

  std::unique_ptr<unsigned char[]> memory;
  tern::Planner planner;
  tern::Trajectory trajectory{};
  tern::Report report{};
};

class GridCopiesPlan : public ::testing::Test {
 protected:
  static GridSpec spec_of(int kind) {
    const GridSpec specs[] = {tern_test::whole_grid({100, 80, kHeight}, 0.1, 0.0),
                              tern_test::whole_grid({100, 80, kHeight}, 0.1, 0.1),
                              tern_test::whole_grid({70, 60, kHeight}, 0.1, 0.0, {0.5, 0.3, 0.0})};
    return specs[kind];
  }

  void begin_world() {
    for (Storage& storage : storages) {
      storage.words.assign(tern::grid_words({100, 80, kHeight}), random.next());
      ++storage.bound;
      storage.cleared = false;
    }
    for (int k = 0; k < kGrids; ++k) {
      grids[k] = Grid();
      views[k] = View();
    }
    // Few walls, so that histories repeat in part; long ones, so that searches scan.
    for (int k = 0; k < kBoxes; ++k) {
      const double x = 0.1 * random.integer(0, 99);
      const double y = 0.1 * random.integer(0, 79);
      const double along = 0.1 * random.integer(5, 50);
      const double across = 0.1 * random.integer(1, 4);
      boxes[k] = {{x, y, 0.0}, {x + (k % 2 == 0 ? along : across), y + (k % 2 == 0 ? across : along), 0.1 * kHeight}};
    }
  }

  bool bound(int k) const { return views[k].storage >= 0 && storages[views[k].storage].bound == views[k].bound; }

  Moment moment(int k) const {
    if (!bound(k)) return {-1, 0, 0};
    return {views[k].storage, views[k].bound, storages[views[k].storage].changes};
  }

  void bind(int k) {
    const int s = random.integer(0, kStorages - 1);
    Storage& storage = storages[s];
    storage.kind = random.integer(0, 2);
    ASSERT_EQ(grids[k].bind(spec_of(storage.kind), storage.words.data(), storage.words.size()), Status::kOk);
    views[k] = {s, ++storage.bound, storage.kind};
  }

  Status mark(Grid& grid) {
    const tern::Box& box = boxes[random.integer(0, kBoxes - 1)];
    const Voxel voxel{random.integer(0, 69), random.integer(0, 59), random.integer(0, kHeight - 1)};
    const Vec3 points[] = {box.lower, {0.05 + 0.1 * voxel.x, 1.05, 0.25}, {0.05, 0.1 * voxel.y, 0.35}};
    switch (random.integer(0, 9)) {
      case 0:
        return grid.mark_voxel(voxel);
      case 1:
        return grid.clear_voxel(voxel);
      case 2:
        return grid.mark_points(points, 3);
      case 3:
      case 4:
      case 5:
        return grid.clear_box(box);
      default:
        return grid.mark_box(box);
    }
  }

  /// One random call, and what the model of it says.
  void act() {
    const int k = random.integer(0, kGrids - 1);
    const int action = random.integer(0, 99);
    if (action < 3) {
      bind(k);
    } else if (action == 3 && random.chance(0.5)) {
      Storage& storage = storages[random.integer(0, kStorages - 1)];
      std::fill(storage.words.begin(), storage.words.end(), 0);
      ++storage.bound;
      storage.cleared = true;
    } else if (action < 15) {
      const int from = random.integer(0, kGrids - 1);
      grids[k] = grids[from];
      views[k] = views[from];
    } else if (action < 75) {
      ASSERT_EQ(mark(grids[k]), bound(k) ? Status::kOk : Status::kInvalidArgument);
      if (bound(k)) ++storages[views[k].storage].changes;
    } else {
      grids[k].inflate();
    }
    for (int g = 0; g < kGrids; ++g) expect_bound_as_modelled(g);
  }

  /// Where a storage was cleared and bound again, a view from before may be told to be the same: then it is.
  void expect_bound_as_modelled(int k) {
    if (grids[k].bound() && !bound(k) && views[k].storage >= 0) {
      const Storage& storage = storages[views[k].storage];
      ASSERT_TRUE(storage.cleared);
      ASSERT_EQ(views[k].kind, storage.kind);
      views[k].bound = storage.bound;
    }
    ASSERT_EQ(grids[k].bound(), bound(k));
  }

  Vec3 free_point(const Grid& grid) {
    const GridSpec& spec = grid.spec();
    Voxel voxel{-1, -1, -1};
    for (int k = 0; k < 200 && !grid.free(voxel); ++k) {
      voxel = {random.integer(0, spec.dims.x - 1), random.integer(0, spec.dims.y - 1), random.integer(0, kHeight - 1)};
    }
    const Vec3 local = grid.center(voxel);
    return {spec.origin.x + local.x, spec.origin.y + local.y, spec.origin.z + local.z};
  }

  tern::Request request_on(const Grid& grid) {
    tern::Request request{};
    request.limits = {{2.0, 2.0, 2.0}, {2.0, 2.0, 2.0}};
    request.start.position = free_point(grid);
    request.goal.position = free_point(grid);
    return request;
  }

  void expect_as_fresh(Status status, const Grid& grid, const tern::Request& request) {
    fresh.planner = tern::Planner(fresh.memory.get(), tern::kWorkspaceBytes);
    ASSERT_EQ(status, fresh.planner.plan(grid, request, fresh.trajectory, fresh.report));
    if (status != Status::kOk) return;
    ++planned;
    ASSERT_EQ(used.trajectory.count, fresh.trajectory.count);
    for (int i = 0; i < used.trajectory.count; ++i) {
      const tern::Segment& segment = used.trajectory.segments[i];
      const tern::Segment& expected = fresh.trajectory.segments[i];
      ASSERT_EQ(std::memcmp(&segment.duration, &expected.duration, sizeof segment.duration), 0);
      ASSERT_EQ(std::memcmp(segment.points, expected.points, sizeof segment.points), 0);
    }
  }

  void plan_whole(int k) {
    const tern::Request request = request_on(grids[k]);
    expect_as_fresh(used.planner.plan(grids[k], request, used.trajectory, used.report), grids[k], request);
  }

  /// A plan in slices with random calls between: it notices them, or is as it would have been.
  void plan_slices(int k) {
    const tern::Request request = request_on(grids[k]);
    const Moment before = moment(k);
    Status status = used.planner.begin(grids[k], request);
    if (status != Status::kRunning) return;  // nothing was free
    for (int slice = random.integer(0, 3); slice > 0 && status == Status::kRunning; --slice)
      status = used.planner.step(static_cast<std::uint32_t>(random.integer(0, 40)));
    for (int calls = random.integer(0, 2); calls > 0; --calls) act();
    const bool ended = status != Status::kRunning;
    for (int slice = 0; slice < 1000 && status == Status::kRunning; ++slice) status = used.planner.step(1000);
    ASSERT_EQ(status, used.planner.finish(used.trajectory, used.report));
    if (status == Status::kMapChanged) {
      ++noticed;
      ASSERT_FALSE(moment(k) == before);
    } else if (!ended || moment(k) == before) {
      ASSERT_TRUE(moment(k) == before || storages[before.storage].cleared);
      expect_as_fresh(status, grids[k], request);
    }
  }

  void plan(int k) {
    if (random.chance(0.8)) grids[k].inflate();
    if (!grids[k].inflated()) {
      ASSERT_EQ(used.planner.plan(grids[k], {}, used.trajectory, used.report), Status::kInvalidArgument);
      ASSERT_EQ(used.report.field, grids[k].bound() ? tern::Field::kNotInflated : tern::Field::kStorage);
    } else if (random.chance(0.3)) {
      plan_slices(k);
    } else {
      plan_whole(k);
    }
  }

  Random random{20251};
  Storage storages[kStorages];
  Grid grids[kGrids];
  View views[kGrids];
  tern::Box boxes[kBoxes];
  PlannerMemory used;
  PlannerMemory fresh;
  int planned = 0;
  int noticed = 0;
};

TEST_F(GridCopiesPlan, APlannerThatHasPlannedAnswersAsANewOne) {
  const int worlds = scaled(60);
  for (int world = 0; world < worlds; ++world) {
    begin_world();
    for (int call = 0; call < 400; ++call) {
      act();
      if (random.chance(0.5)) plan(random.integer(0, kGrids - 1));
      if (HasFatalFailure()) FAIL() << "world " << world << ", call " << call;
    }
  }
  EXPECT_GT(planned, 10 * worlds);
  EXPECT_GT(noticed, worlds);
}

}  // namespace
