// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Hits and misses on words of voxels, against a voxel with plain numbers.
#include "map/evidence.hpp"

#include <gtest/gtest.h>

#include "support/random.hpp"

namespace {

using tern::Evidence;
using tern::Threshold;

/// One voxel.
struct Plain {
  bool seen;
  int count;
  bool blocked;

  void enter(bool hit, bool miss, int hits, int misses) {
    if (hit) {
      if (blocked) {
        count = 0;
      } else if (++count == hits) {
        blocked = true;
        count = 0;
      }
    } else if (miss) {
      seen = true;
      if (!blocked) {
        count -= count > 0 ? 1 : 0;
      } else if (++count == misses) {
        blocked = false;
        count = 0;
      }
    }
  }
};

Plain voxel(const Evidence& e, int k) {
  const auto bit = [k](std::uint64_t word) { return static_cast<int>(word >> k & 1); };
  return {bit(e.seen) != 0, bit(e.low) + 2 * bit(e.high), bit(e.blocked) != 0};
}

TEST(MapEvidence, EqualsPlainNumbersForAnySequence) {
  tern_test::Random random(311);
  for (int hits = 1; hits <= 4; ++hits) {
    for (int misses = 1; misses <= 4; ++misses) {
      Evidence words{};
      Plain plain[64] = {};
      for (int frame = 0; frame < 200; ++frame) {
        const std::uint64_t hit = random.next() & random.next();
        const std::uint64_t miss = random.next();
        const std::uint64_t open = tern::open_to_misses(words);
        const Evidence missed = tern::after(words, 0, ~std::uint64_t{0}, Threshold(hits), Threshold(misses));
        const std::uint64_t changed = (missed.seen ^ words.seen) | (missed.low ^ words.low) |
                                      (missed.high ^ words.high) | (missed.blocked ^ words.blocked);
        ASSERT_EQ(open, changed);
        words = tern::after(words, hit, miss, Threshold(hits), Threshold(misses));
        for (int k = 0; k < 64; ++k) {
          plain[k].enter((hit >> k & 1) != 0, (miss >> k & 1) != 0, hits, misses);
          const Plain got = voxel(words, k);
          ASSERT_EQ(got.seen, plain[k].seen);
          ASSERT_EQ(got.count, plain[k].count);
          ASSERT_EQ(got.blocked, plain[k].blocked) << hits << ' ' << misses << ' ' << frame << ' ' << k;
        }
      }
    }
  }
}

}  // namespace
