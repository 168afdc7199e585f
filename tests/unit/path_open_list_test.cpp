// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The open list and the node store against the standard library.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <memory>
#include <vector>

#include "path/open_list.hpp"
#include "support/random.hpp"

namespace {

using tern::NodeStore;
using tern::OpenKey;
using tern::OpenList;
using tern_test::Random;

/// Both structures, in memory that starts as garbage.
struct Fixture {
  Fixture() : store(new NodeStore), open(new OpenList) {
    std::memset(static_cast<void*>(store.get()), 0xA5, sizeof *store);
    std::memset(static_cast<void*>(open.get()), 0xA5, sizeof *open);
    tern::store_reset(*store, 1 << 20);
    tern::open_reset(*open);
  }
  std::unique_ptr<NodeStore> store;
  std::unique_ptr<OpenList> open;
};

TEST(PathOpenList, TakesInTotalOrderWithKeysThatImprove) {
  Fixture f;
  Random random(21);
  std::map<std::uint32_t, OpenKey> reference;
  for (int round = 0; round < 20000; ++round) {
    if (reference.empty() || random.chance(0.6)) {
      const auto voxel = static_cast<std::uint32_t>(random.integer(0, 3000));
      // Few distinct values, so that ties are common.
      const OpenKey key = tern::open_key(static_cast<tern::Cost>(random.integer(0, 9)) << tern::kCostFraction,
                                         static_cast<tern::Cost>(random.integer(0, 9)) << tern::kCostFraction, voxel);
      const auto known = reference.find(voxel);
      if (known != reference.end() && !tern::before(key, known->second)) continue;
      reference[voxel] = key;
      ASSERT_TRUE(tern::open_put(*f.open, *f.store, tern::store_find_or_add(*f.store, voxel), key));
    } else {
      const auto least = std::min_element(reference.begin(), reference.end(), [](const auto& a, const auto& b) {
        return tern::before(a.second, b.second);
      });
      const std::uint32_t node = tern::open_take(*f.open, *f.store);
      ASSERT_EQ(f.store->nodes[node].voxel, least->first);
      ASSERT_EQ(f.store->nodes[node].open_slot, tern::kNotOpen);
      reference.erase(least);
    }
    ASSERT_EQ(f.open->count, static_cast<int>(reference.size()));
  }
}

TEST(PathOpenList, OrderIsCostThenHeuristicThenVoxel) {
  const tern::Cost one = tern::kStraightCost;
  EXPECT_TRUE(tern::before(tern::open_key(one, one, 9), tern::open_key(2 * one, one, 1)));
  EXPECT_TRUE(tern::before(tern::open_key(2 * one, one, 9), tern::open_key(one, 2 * one, 1)));
  EXPECT_TRUE(tern::before(tern::open_key(one, one, 1), tern::open_key(one, one, 2)));
  EXPECT_FALSE(tern::before(tern::open_key(one, one, 1), tern::open_key(one, one, 1)));
}

TEST(PathNodeStore, FindsWhatItHolds) {
  Fixture f;
  Random random(22);
  std::map<std::uint32_t, std::uint32_t> reference;
  for (int round = 0; round < 50000; ++round) {
    const auto voxel = static_cast<std::uint32_t>(random.integer(0, (1 << 20) - 1));
    const std::uint32_t index = tern::store_find_or_add(*f.store, voxel);
    const auto [known, added] = reference.emplace(voxel, static_cast<std::uint32_t>(reference.size()));
    ASSERT_EQ(index, known->second);
    ASSERT_EQ(f.store->nodes[index].voxel, voxel);
    if (added) {
      ASSERT_EQ(f.store->nodes[index].arrivals, 0u);
    }
  }
  EXPECT_EQ(f.store->count, reference.size());
}

TEST(PathNodeStore, ForgetsOnReset) {
  Fixture f;
  for (std::uint32_t v = 0; v < 1000; ++v) tern::store_find_or_add(*f.store, v);
  tern::store_reset(*f.store, 1 << 20);
  EXPECT_EQ(tern::store_find_or_add(*f.store, 999), 0u);
  EXPECT_EQ(tern::store_find_or_add(*f.store, 5), 1u);
  EXPECT_EQ(f.store->count, 2u);
}

TEST(PathCost, OctileIsConsistentAndExact) {
  EXPECT_NEAR(static_cast<double>(tern::kPlaneDiagonalCost) / static_cast<double>(tern::kStraightCost), std::sqrt(2.0),
              2e-11);
  EXPECT_NEAR(static_cast<double>(tern::kSpaceDiagonalCost) / static_cast<double>(tern::kStraightCost), std::sqrt(3.0),
              2e-11);
  Random random(23);
  for (int k = 0; k < 20000; ++k) {
    const tern::Voxel a{random.integer(0, 99), random.integer(0, 99), random.integer(0, 99)};
    const tern::Voxel goal{random.integer(0, 99), random.integer(0, 99), random.integer(0, 99)};
    for (int d = 0; d < tern::kDirections; ++d) {
      if (d == tern::kHere) continue;
      EXPECT_LE(tern::octile(a, goal), tern::move_cost(d) + tern::octile(a + tern::offset(d), goal));
    }
  }
}

}  // namespace
