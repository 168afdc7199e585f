// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/work.hpp"

#include <gtest/gtest.h>

#include "support/random.hpp"

namespace tern_test {
namespace {

using tern::kUnit;
using tern::Operations;
using tern::Work;

TEST(Work, APieceMayBeginWhileAnythingIsLeft) {
  Work work{2};
  EXPECT_EQ(work.units(), 2u);
  work.spend(2 * kUnit - 1);
  EXPECT_TRUE(work.left());
  EXPECT_EQ(work.units(), 1u) << "a part of one";
  work.spend(1);
  EXPECT_FALSE(work.left());
  EXPECT_EQ(work.units(), 0u);
}

TEST(Work, UnitsPayADebtFirst) {
  Work work{1};
  work.spend(5 * kUnit);
  EXPECT_EQ(work.operations(), -4 * kUnit);
  EXPECT_EQ(work.units(), 0u);
  work.add(4);
  EXPECT_FALSE(work.left());
  work.add(1);
  EXPECT_EQ(work.units(), 1u);
}

TEST(Work, ADebtCanBeForgivenAndWhatIsLeftStays) {
  Work work{3};
  work.forgive();
  EXPECT_EQ(work.units(), 3u);
  work.spend(7 * kUnit);
  work.forgive();
  EXPECT_EQ(work.operations(), 0);
}

TEST(Work, APartKeepsWithinItsLimit) {
  const Work work{3};
  EXPECT_EQ(work.within(5).operations(), 5);
  EXPECT_EQ(work.within(5 * kUnit).operations(), 3 * kUnit);
}

TEST(Work, EveryTurnTakesItsUnitsInTheMean) {
  Random random(1);
  for (const std::uint32_t slice : {1u, 7u, 1000u}) {
    Work work;
    Operations spent = 0;
    constexpr int kLongest = 20000;
    for (int turn = 1; turn <= 1000; ++turn) {
      work.add(slice);
      while (work.left()) {
        const Operations piece = random.integer(1, kLongest);
        work.spend(piece);
        spent += piece;
      }
      ASSERT_GE(spent, kUnit * slice * turn);
      ASSERT_LT(spent, kUnit * slice * turn + kLongest);
    }
  }
}

}  // namespace
}  // namespace tern_test
