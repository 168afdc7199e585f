// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tern/record.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <vector>

#include "support/random.hpp"
#include "support/world.hpp"

namespace {

using namespace tern;
using Bytes = std::vector<std::uint8_t>;

// Where the words of the format are, docs/record.md.
constexpr std::size_t kVersionWord = 1;
constexpr std::size_t kFenceCountWord = 5 + 15 + 12 + 12 + 22 + 10;

Bytes record(const tern_test::World& world) {
  Bytes bytes(plan_record_bytes(world.spec.dims));
  std::size_t used = 0;
  EXPECT_EQ(
      record_plan(world.grid, world.request, world.report.status, world.trajectory, bytes.data(), bytes.size(), &used),
      Status::kOk);
  bytes.resize(used);
  return bytes;
}

Status read(const Bytes& bytes) {
  PlanRecord record;
  return read_plan_record(bytes.data(), bytes.size(), record);
}

void put(Bytes& bytes, std::size_t word, std::uint64_t value) {
  for (std::size_t k = 0; k < 8; ++k) bytes.at(8 * word + k) = static_cast<std::uint8_t>(value >> (8 * k));
}

/// Replaces a word, and the checksum, as FNV-1a gives it.
Bytes altered(Bytes bytes, std::size_t word, std::uint64_t value) {
  put(bytes, word, value);
  std::uint64_t hash = 0xCBF29CE484222325u;
  for (std::size_t k = 0; k + 8 < bytes.size(); ++k) hash = (hash ^ bytes[k]) * 0x100000001B3u;
  put(bytes, bytes.size() / 8 - 1, hash);
  return bytes;
}

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

TEST(Record, RefusesWhatIsTruncatedOrAltered) {
  tern_test::World world = tern_test::open_world();
  ASSERT_EQ(world.plan(), Status::kOk);
  const Bytes bytes = record(world);
  for (std::size_t count = 1; count < bytes.size(); ++count) {
    const Bytes part(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(count));
    ASSERT_EQ(read(part), Status::kRecordDamaged) << count;
  }
  for (std::size_t k = 0; k < bytes.size(); ++k) {
    Bytes wrong = bytes;
    wrong[k] = static_cast<std::uint8_t>(wrong[k] ^ 0x10u);
    const bool version = k / 8 == kVersionWord;
    ASSERT_EQ(read(wrong), version ? Status::kRecordVersion : Status::kRecordDamaged) << k;
  }
  Bytes longer = bytes;
  longer.resize(bytes.size() + 8);
  EXPECT_EQ(read(longer), Status::kRecordDamaged);
  PlanRecord out;
  EXPECT_EQ(read_plan_record(nullptr, 800, out), Status::kInvalidArgument);
}

// Whoever alters a record can also make its checksum.
TEST(Record, TrustsNoCount) {
  tern_test::World world = tern_test::open_world();
  ASSERT_EQ(world.plan(), Status::kOk);
  const Bytes bytes = record(world);
  ASSERT_EQ(read(altered(bytes, kFenceCountWord, 0)), Status::kOk) << "the word's place is wrong";
  EXPECT_EQ(read(altered(bytes, kFenceCountWord, kMaxFences + 1)), Status::kFencesFull);
  EXPECT_EQ(read(altered(bytes, kFenceCountWord, ~std::uint64_t{0})), Status::kRecordDamaged);
  EXPECT_EQ(read(altered(bytes, kFenceCountWord + 1, kMaxVias + 1)), Status::kViasFull);
  // The plan's segments stand behind the previous plan, which is not there, and the status.
  EXPECT_EQ(read(altered(bytes, kFenceCountWord + 4, kMaxSegments + 1)), Status::kSegmentsFull);
  // One fence with too many planes.
  EXPECT_EQ(read(altered(altered(bytes, kFenceCountWord, 1), kFenceCountWord + 5, kMaxFencePlanes + 1)),
            Status::kFencePlanesFull);
  // Any single word may be anything: an answer, and nothing read or written out of bounds.
  tern_test::Random random(9);
  PlanRecord out;
  std::vector<std::uint64_t> words(grid_words(world.spec.dims));
  for (std::size_t k = 5; k + 1 < bytes.size() / 8; ++k) {
    const Bytes wrong = altered(bytes, k, random.chance(0.5) ? random.next() : random.next() >> 56);
    Grid grid;
    read_plan_record(wrong.data(), wrong.size(), out, grid, words.data(), words.size());
  }
}

TEST(Record, SaysWhenTheRoomDoesNotSuffice) {
  tern_test::World world = tern_test::open_world();
  ASSERT_EQ(world.plan(), Status::kOk);
  const Bytes bytes = record(world);
  EXPECT_LE(bytes.size(), plan_record_bytes(world.spec.dims));
  for (std::size_t room = 0; room < bytes.size(); room += 8) {
    Bytes small(bytes.size(), 0xAA);
    std::size_t used = 77;
    ASSERT_EQ(record_plan(world.grid, world.request, Status::kOk, world.trajectory, small.data(), room, &used),
              Status::kRecordFull);
    ASSERT_EQ(used, 77u);
    for (std::size_t k = room; k < small.size(); ++k) ASSERT_EQ(small[k], 0xAA) << room;
  }
  EXPECT_EQ(plan_record_bytes({0, 1, 1}), 0u);
}

TEST(Record, RefusesWhatIsNoQuery) {
  tern_test::World world = tern_test::open_world();
  ASSERT_EQ(world.plan(), Status::kOk);
  Bytes bytes(plan_record_bytes(world.spec.dims));
  std::size_t used = 0;
  const auto write = [&](const Grid& grid, std::size_t* to) {
    return record_plan(grid, world.request, Status::kOk, world.trajectory, bytes.data(), bytes.size(), to);
  };
  EXPECT_EQ(write(Grid(), &used), Status::kInvalidArgument);
  EXPECT_EQ(write(world.grid, nullptr), Status::kInvalidArgument);
  world.request.fence_count = 1;
  EXPECT_EQ(write(world.grid, &used), Status::kInvalidArgument);
  world.request.fence_count = 0;
  world.request.via_count = -1;
  EXPECT_EQ(write(world.grid, &used), Status::kInvalidArgument);
  world.request.via_count = 0;
  Trajectory none{};
  none.count = kMaxSegments + 1;
  world.request.previous = &none;
  EXPECT_EQ(write(world.grid, &used), Status::kInvalidArgument);
}

/// Reads a record with its obstacles.
Status read_whole(const Bytes& bytes) {
  PlanRecord record;
  Grid grid;
  std::vector<std::uint64_t> words(grid_words({20, 20, 10}));
  return read_plan_record(bytes.data(), bytes.size(), record, grid, words.data(), words.size());
}

TEST(Record, RunsOfObstaclesThatAreNoneAreDamage) {
  tern_test::World world({20, 20, 10}, 0.1, 0.1);
  world.from({0.55, 0.55, 0.55}).to({1.45, 1.45, 0.55});
  world.plan();
  // No obstacle: one run of free words is the last thing before the checksum.
  const Bytes free = record(world);
  const std::size_t last = free.size() / 8 - 2;
  constexpr std::uint64_t kWords = 20 * 10;
  EXPECT_EQ(read_whole(altered(free, last, 4 * kWords)), Status::kOk);
  EXPECT_EQ(read_whole(altered(free, last, 0)), Status::kRecordDamaged);                 // no words
  EXPECT_EQ(read_whole(altered(free, last, 4 * (kWords + 1))), Status::kRecordDamaged);  // too many
  EXPECT_EQ(read_whole(altered(free, last, 4 * (kWords - 1))), Status::kRecordDamaged);  // too few
  EXPECT_EQ(read_whole(altered(free, last, 4 * kWords + 1)), Status::kRecordDamaged);    // the equal word is missing
  EXPECT_EQ(read_whole(altered(free, last, 4 * kWords + 2)), Status::kRecordDamaged);    // all of them are missing
  EXPECT_EQ(read_whole(altered(free, last, 4 * kWords + 3)), Status::kRecordDamaged);    // no kind of run
  Bytes longer = free;
  longer.insert(longer.end() - 8, 8, 0);
  constexpr std::size_t kLengthWord = 3;
  EXPECT_EQ(read_whole(altered(longer, kLengthWord, longer.size() / 8)), Status::kRecordDamaged);  // a word too many
  // All solid: a run of equal words. A voxel beyond the grid is none.
  world.block({0.0, 0.0, 0.0}, {2.0, 2.0, 1.0});
  world.plan();
  const Bytes solid = record(world);
  EXPECT_EQ(read_whole(solid), Status::kOk);
  EXPECT_EQ(read_whole(altered(solid, solid.size() / 8 - 2, ~std::uint64_t{0})), Status::kRecordDamaged);
}

TEST(Record, RequestsThatCannotBeWrittenAreRefused) {
  tern_test::World world({20, 20, 10}, 0.1, 0.1);
  world.from({0.55, 0.55, 0.55}).to({1.45, 1.45, 0.55});
  ASSERT_EQ(world.plan(), Status::kOk);
  Bytes bytes(plan_record_bytes(world.spec.dims));
  std::size_t used = 0;
  const auto write = [&](std::uint8_t* to, std::size_t* size) {
    return record_plan(world.grid, world.request, world.report.status, world.trajectory, to, bytes.size(), size);
  };
  EXPECT_EQ(write(nullptr, &used), Status::kInvalidArgument);
  EXPECT_EQ(write(bytes.data(), nullptr), Status::kInvalidArgument);
  for (const int count : {-1, kMaxSegments + 1}) {
    const int right = world.trajectory.count;
    world.trajectory.count = count;
    EXPECT_EQ(write(bytes.data(), &used), Status::kInvalidArgument) << count;
    world.trajectory.count = right;
  }
  world.request.via_count = 1;
  EXPECT_EQ(write(bytes.data(), &used), Status::kInvalidArgument);
  world.request.via_count = -1;
  EXPECT_EQ(write(bytes.data(), &used), Status::kInvalidArgument);
  const std::vector<Via> many(kMaxVias + 1);
  world.request.vias = many.data();
  world.request.via_count = kMaxVias + 1;
  EXPECT_EQ(write(bytes.data(), &used), Status::kInvalidArgument);
  world.request.via_count = 0;
  Fence fence{nullptr, 3, FenceKind::kKeepIn};
  world.request.fences = &fence;
  world.request.fence_count = 1;
  EXPECT_EQ(write(bytes.data(), &used), Status::kInvalidArgument);
}

}  // namespace
