// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tern/record.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <vector>

#include "record/records.hpp"
#include "support/random.hpp"
#include "support/world.hpp"

namespace {

using namespace tern;
using tern_test::Bytes;
using tern_test::record;

/// Plans what a record asks for, from nothing but its bytes.
struct Replayed {
  explicit Replayed(const Bytes& bytes) : planner(memory.get(), sizeof *memory) {
    EXPECT_EQ(read_plan_record(bytes.data(), bytes.size(), record), Status::kOk);
    words.resize(grid_words(record.grid.dims));
    EXPECT_EQ(read_plan_record(bytes.data(), bytes.size(), record, grid, words.data(), words.size()), Status::kOk);
    status = planner.plan(grid, record.request, plan, report);
  }
  PlanRecord record;
  std::vector<std::uint64_t> words;
  Grid grid;
  std::unique_ptr<Workspace> memory = std::make_unique<Workspace>();
  Planner planner;
  Trajectory plan{};
  Report report{};
  Status status = Status::kRunning;
};

void expect_same(const Trajectory& a, const Trajectory& b) {
  ASSERT_EQ(a.count, b.count);
  EXPECT_EQ(a.begin, b.begin);
  EXPECT_EQ(std::memcmp(&a.origin, &b.origin, sizeof a.origin), 0);
  for (int i = 0; i < a.count; ++i) {
    EXPECT_EQ(std::memcmp(&a.segments[i].points, &b.segments[i].points, sizeof a.segments[i].points), 0);
    EXPECT_EQ(std::memcmp(&a.segments[i].duration, &b.segments[i].duration, sizeof(double)), 0);
    EXPECT_EQ(a.segments[i].polyhedron, b.segments[i].polyhedron);
  }
}

void scatter(tern_test::World& world, std::uint64_t seed) {
  tern_test::Random random(seed);
  const Voxel dims = world.spec.dims;
  for (int k = 0; k < 60; ++k) {
    world.grid.mark_voxel(
        {random.integer(10, dims.x - 11), random.integer(0, dims.y - 1), random.integer(0, dims.z - 1)});
  }
}

/// A query with all that a request can hold.
void ask_for_everything(tern_test::World& world, std::vector<Halfspace>& planes, Fence (&fences)[2], Via (&vias)[2]) {
  planes.resize(2 * kBoxPlanes);
  Halfspace box[kBoxPlanes];
  box_planes({{0.1, 0.1, 0.1}, {6.9, 3.9, 1.9}}, box);
  std::copy(std::begin(box), std::end(box), planes.begin());
  box_planes({{3.0, 0.0, 0.0}, {3.3, 0.4, 2.0}}, box);
  std::copy(std::begin(box), std::end(box), planes.begin() + kBoxPlanes);
  fences[0] = {planes.data(), kBoxPlanes, FenceKind::kKeepIn, -1234567900123456789, 1234567890123456789, 0.25};
  fences[1] = {planes.data() + kBoxPlanes, kBoxPlanes, FenceKind::kKeepOut};
  vias[0].position = {0.65, 3.05, 1.05};
  vias[0].tolerance = 0.1;
  vias[1].position = {0.85, 1.05, 1.35};
  vias[1].stop = true;
  world.request.fences = fences;
  world.request.fence_count = 2;
  world.request.vias = vias;
  world.request.via_count = 2;
  world.request.limits.j_max = {50.0, 50.0, 50.0};
  world.request.limits.v_horizontal = 1.75;
  world.request.time_weight = 200.0;
  world.request.search = SearchMode::kOptimal;
  world.request.begin = -1234567890123456789;
}

TEST(Record, HoldsAllOfAQuery) {
  tern_test::World world({70, 40, 20}, 0.1, 0.15);
  world.from({0.55, 0.55, 1.05}).to({6.45, 3.45, 1.05});
  std::vector<Halfspace> planes;
  Fence fences[2];
  Via vias[2];
  ask_for_everything(world, planes, fences, vias);
  scatter(world, 3);
  ASSERT_EQ(world.plan(), Status::kOk);
  const Bytes bytes = record(world);
  Replayed again(bytes);
  EXPECT_EQ(again.record.configuration, kConfigurationHash);
  EXPECT_EQ(again.record.request.fences[0].from, fences[0].from);
  EXPECT_EQ(again.record.request.fences[0].until, fences[0].until);
  EXPECT_EQ(again.record.request.fences[0].clock_error, fences[0].clock_error);
  EXPECT_EQ(again.record.status, Status::kOk);
  expect_same(again.record.plan, world.trajectory);
  EXPECT_EQ(again.status, Status::kOk);
  expect_same(again.plan, world.trajectory);
  EXPECT_EQ(again.report.vias[1].time, world.report.vias[1].time);
  // Reading and writing again gives the same bytes.
  Bytes twice(bytes.size());
  std::size_t used = 0;
  ASSERT_EQ(record_plan(again.grid, again.record.request, again.status, again.plan, twice.data(), twice.size(), &used),
            Status::kOk);
  EXPECT_EQ(used, bytes.size());
  EXPECT_EQ(twice, bytes);
}

TEST(Record, HoldsThePreviousPlan) {
  tern_test::World world({70, 40, 20}, 0.1, 0.15);
  world.from({0.55, 0.55, 1.05}).to({6.45, 3.45, 1.05});
  scatter(world, 4);
  ASSERT_EQ(world.plan(), Status::kOk);
  const Trajectory previous = world.trajectory;
  const Sample sample = evaluate(previous, 1.0);
  world.request.start = {sample.position, sample.velocity, sample.acceleration, sample.jerk};
  world.request.previous = &previous;
  world.request.previous_time = 1.0;
  ASSERT_EQ(world.replan(), Status::kOk);
  Replayed again(record(world));
  EXPECT_EQ(again.status, Status::kOk);
  expect_same(again.plan, world.trajectory);
}

TEST(Record, HoldsTracks) {
  tern_test::World world({70, 40, 20}, 0.1, 0.15);
  world.from({0.55, 0.55, 1.05}).to({6.45, 3.45, 1.05});
  const std::size_t without = record(world).size();
  std::vector<TrackPiece> pieces(2, TrackPiece{2.0, {}});
  for (Vec3& point : pieces[1].points) point = {0.5, 0.25, 0.0};
  std::vector<Track> tracks(2);
  tracks[0].position = {6.45, 3.45, 1.0};
  tracks[0].radius = 0.25;
  tracks[0].end = TrackEnd::kGone;
  tracks[0].until = 9000000000;
  tracks[1].position = {1.0, 3.5, 1.0};
  tracks[1].pieces = pieces.data();
  tracks[1].piece_count = 2;
  tracks[1].shape = TrackShape::kBox;
  tracks[1].half = {0.1, 0.2, 0.3};
  tracks[1].reach = 0.01;
  tracks[1].id = 4000000000u;
  world.request.tracks = tracks.data();
  world.request.track_count = 2;
  world.request.rest_clear = 1.5;
  ASSERT_EQ(world.plan(), Status::kOk);
  EXPECT_GT(duration(world.trajectory), 9.0);
  const Bytes bytes = record(world);
  EXPECT_GT(bytes.size(), without);
  Replayed again(bytes);
  EXPECT_EQ(again.status, Status::kOk);
  expect_same(again.plan, world.trajectory);
  EXPECT_EQ(again.record.request.rest_clear, 1.5);
  EXPECT_EQ(again.record.request.tracks[1].id, 4000000000u);
  EXPECT_EQ(again.record.request.tracks[1].pieces[1].points[3].y, 0.25);
  Bytes twice(bytes.size());
  std::size_t used = 0;
  ASSERT_EQ(record_plan(again.grid, again.record.request, again.status, again.plan, twice.data(), twice.size(), &used),
            Status::kOk);
  EXPECT_EQ(twice, bytes);
}

TEST(Record, HoldsAnAnswerWithoutAPlan) {
  tern_test::World world = tern_test::open_world();
  world.block({2.0, 0.0, 0.0}, {2.3, 4.0, 2.0});
  ASSERT_EQ(world.plan(), Status::kNoPath);
  Replayed again(record(world));
  EXPECT_EQ(again.record.status, Status::kNoPath);
  EXPECT_EQ(again.record.plan.count, 0);
  EXPECT_EQ(again.status, Status::kNoPath);
}

TEST(Record, GivesBackEveryVoxel) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    tern_test::Random random(seed);
    const Voxel dims{random.integer(1, 200), random.integer(1, 20), random.integer(1, 6)};
    tern_test::World world(dims, 0.1, 0.0);
    const int chance = random.integer(0, 4);  // of 4: from empty to full, and half of the rows alike
    for (int z = 0; z < dims.z; ++z) {
      for (int y = 0; y < dims.y; ++y) {
        const bool full = random.chance(0.5);
        for (int x = 0; x < dims.x; ++x) {
          if (full ? chance > 1 : random.integer(1, 4) <= chance) world.grid.mark_voxel({x, y, z});
        }
      }
    }
    const Bytes bytes = record(world);
    PlanRecord out;
    std::vector<std::uint64_t> words(grid_words(dims));
    Grid grid;
    ASSERT_EQ(read_plan_record(bytes.data(), bytes.size(), out, grid, words.data(), words.size()), Status::kOk);
    for (int z = 0; z < dims.z; ++z) {
      for (int y = 0; y < dims.y; ++y) {
        for (int x = 0; x < dims.x; ++x) {
          ASSERT_EQ(grid.obstacle({x, y, z}), world.grid.obstacle({x, y, z}))
              << seed << ": " << x << " " << y << " " << z;
        }
      }
    }
  }
}

}  // namespace
