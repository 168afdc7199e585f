// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Records that are damaged or too large, and queries that cannot be written.

#include <gtest/gtest.h>

#include <vector>

#include "record/records.hpp"
#include "support/random.hpp"
#include "support/world.hpp"
#include "tern/record.hpp"

namespace {

using namespace tern;
using tern_test::Bytes;
using tern_test::record;

// Where the words of the format are, docs/record.md.
constexpr std::size_t kVersionWord = 1;
constexpr std::size_t kFenceCountWord = 5 + 15 + 12 + 12 + 22 + 10;

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
