// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "inflation/plane_steps.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "support/grid_storage.hpp"

namespace {

using tern::bits_met;
using tern::kAllBits;
using tern::PlaneSteps;
using tern::Stencil;
using tern_test::OwnedGrid;
using tern_test::whole_grid;

/// Marks voxels lower <= v < upper.
void mark(OwnedGrid& owned, const tern::Voxel& lower, const tern::Voxel& upper) {
  for (int z = lower.z; z < upper.z; ++z) {
    for (int y = lower.y; y < upper.y; ++y) {
      for (int x = lower.x; x < upper.x; ++x) owned.grid.mark_voxel({x, y, z});
    }
  }
}

/// The planes from 1 on that are marked in word k of the window.
std::vector<int> marked_planes(PlaneSteps& steps, const tern::StripWindow& window, int k, int planes) {
  std::vector<int> marked;
  steps.begin(window, 0);
  for (int z = 1; z < planes; ++z) {
    steps.advance();
    if (steps.mark(k).rows != 0) marked.push_back(z);
  }
  return marked;
}

/// A radius of two cells: the ball reaches two voxels along each axis.
TEST(InflationPlaneSteps, ABoxIsMarkedBelowItsFloorAndAboveItsTop) {
  OwnedGrid owned(whole_grid({100, 40, 20}, 0.1, 0.2));
  mark(owned, {10, 20, 5}, {14, 23, 10});
  const Stencil stencil(owned.grid.spec());
  PlaneSteps steps(owned.grid, stencil);
  EXPECT_EQ(marked_planes(steps, {0, {0, 64}, {0, 2}}, 0, 20), (std::vector<int>{3, 4, 11, 12}));
  EXPECT_EQ(marked_planes(steps, {0, {0, 64}, {0, 2}}, 1, 20), std::vector<int>{});
}

TEST(InflationPlaneSteps, MarksHoldTheRowsAndVoxelsWithinReach) {
  OwnedGrid owned(whole_grid({100, 40, 20}, 0.1, 0.2));
  mark(owned, {10, 20, 5}, {14, 23, 10});
  const Stencil stencil(owned.grid.spec());
  PlaneSteps steps(owned.grid, stencil);
  steps.begin({0, {0, 64}, {0, 2}}, 2);
  EXPECT_FALSE(steps.known());
  EXPECT_EQ(steps.mark(0).rows, kAllBits);
  steps.advance();
  EXPECT_TRUE(steps.known());
  EXPECT_EQ(steps.mark(0).rows, bits_met({18, 25}, 0));
  EXPECT_EQ(steps.mark(0).bits, bits_met({8, 16}, 0));
  EXPECT_EQ(steps.voxels({0, 1}).begin, 8);
  EXPECT_EQ(steps.voxels({0, 1}).end, 16);
}

TEST(InflationPlaneSteps, ADifferenceNearAWordsEndMarksTheWordBesideIt) {
  OwnedGrid owned(whole_grid({200, 40, 20}, 0.1, 0.2));
  mark(owned, {62, 20, 5}, {63, 21, 10});
  mark(owned, {129, 30, 5}, {130, 31, 10});
  const Stencil stencil(owned.grid.spec());
  PlaneSteps steps(owned.grid, stencil);
  steps.begin({0, {0, 64}, {1, 2}}, 2);
  steps.advance();
  EXPECT_EQ(steps.mark(1).rows, bits_met({18, 23}, 0) | bits_met({28, 33}, 0));
  EXPECT_EQ(steps.mark(1).bits, 1u | std::uint64_t{1} << 63);
}

TEST(InflationPlaneSteps, ADifferenceInTheNextBlockReachesThisOne) {
  OwnedGrid owned(whole_grid({20, 100, 20}, 0.1, 0.2));
  mark(owned, {10, 65, 5}, {11, 66, 10});
  const Stencil stencil(owned.grid.spec());
  PlaneSteps steps(owned.grid, stencil);
  steps.begin({0, {0, 64}, {0, 1}}, 2);
  steps.advance();
  EXPECT_EQ(steps.mark(0).rows, std::uint64_t{1} << 63);
}

TEST(InflationPlaneSteps, WhatStandsOnTheGridsFloorOrReachesItsCeilingHasNoStepThere) {
  OwnedGrid owned(whole_grid({20, 20, 10}, 0.1, 0.2));
  mark(owned, {10, 10, 0}, {11, 11, 10});
  const Stencil stencil(owned.grid.spec());
  PlaneSteps steps(owned.grid, stencil);
  EXPECT_EQ(marked_planes(steps, {0, {0, 64}, {0, 1}}, 0, 10), std::vector<int>{});
}

/// Six cells reach as far as the kept planes; seven do not.
TEST(InflationPlaneSteps, ALargerBallIsNotFollowed) {
  for (const int cells : {6, 7}) {
    OwnedGrid owned(whole_grid({20, 20, 30}, 0.1, 0.1 * cells));
    const Stencil stencil(owned.grid.spec());
    PlaneSteps steps(owned.grid, stencil);
    steps.begin({0, {0, 64}, {0, 1}}, 0);
    steps.advance();
    EXPECT_EQ(steps.known(), cells == 6);
  }
}

/// In a low grid a ball may reach few planes and more than a word along x.
TEST(InflationPlaneSteps, ABallBeyondAWordIsNotFollowed) {
  for (const int cells : {63, 64}) {
    OwnedGrid owned(whole_grid({200, 20, 5}, 0.1, 0.1 * cells));
    const Stencil stencil(owned.grid.spec());
    PlaneSteps steps(owned.grid, stencil);
    steps.begin({0, {0, 64}, {0, 1}}, 0);
    steps.advance();
    EXPECT_EQ(steps.known(), cells == 63);
  }
}

TEST(InflationPlaneSteps, RestsWhereMarksAreOfNoUse) {
  OwnedGrid owned(whole_grid({20, 20, 90}, 0.1, 0.2));
  const Stencil stencil(owned.grid.spec());
  PlaneSteps steps(owned.grid, stencil);
  steps.begin({0, {0, 64}, {0, 1}}, 0);
  int useless = 0;
  for (int z = 1; z < 10; ++z) {
    steps.advance();
    useless += steps.known() ? 1 : 0;
    steps.judge(false);
  }
  EXPECT_EQ(useless, 5) << "two planes of reach to either side, and one more";
  int rested = 0;
  for (int z = 10; z < 80; ++z) {
    steps.advance();
    rested += steps.known() ? 0 : 1;
    steps.judge(true);
  }
  // Four of the planes before, and the one that it begins anew at.
  EXPECT_EQ(rested + 4, tern::kRestPlanes);
}

/// Changes far from the rows of the window are not looked at.
TEST(InflationPlaneSteps, OnlyDifferencesNearTheRowsAreMarked) {
  OwnedGrid owned(whole_grid({100, 40, 20}, 0.1, 0.2));
  mark(owned, {10, 20, 5}, {14, 23, 10});
  const Stencil stencil(owned.grid.spec());
  PlaneSteps steps(owned.grid, stencil);
  EXPECT_EQ(marked_planes(steps, {0, {0, 18}, {0, 2}}, 0, 20), std::vector<int>{});
  EXPECT_EQ(marked_planes(steps, {0, {0, 19}, {0, 2}}, 0, 20), (std::vector<int>{3, 4, 11, 12}));
}

}  // namespace
