// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fences as grounds of a proof.

#include <gtest/gtest.h>

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
using tern_test::prove;

Finding end_with(const Chamber& room, const Trajectory& way, const Fence& fence) {
  ProofGrounds grounds;
  grounds.fences = &fence;
  grounds.fence_count = 1;
  return prove(room.grid, way, grounds).finding;
}

/// The centre stays in; the radius plays no part.
TEST(ProofGrounds, KeepInsHoldTheCentre) {
  Chamber room;
  Halfspace planes[kBoxPlanes];
  box_planes({{3.0, -1.0, 1.0}, {6.0, 1.0, 3.0}}, planes);
  planes[0] = {{2.0, 0.0, 0.0}, 12.0};  // x <= 6, in another scale
  const Fence fence{planes, kBoxPlanes, FenceKind::kKeepIn};
  EXPECT_EQ(end_with(room, move({3.0, 0.0, 2.0}, {3.0, 0.0, 0.0}), fence), Finding::kNone);
  EXPECT_EQ(end_with(room, move({3.0, 0.0, 2.0}, {3.001, 0.0, 0.0}), fence), Finding::kFence);
  EXPECT_EQ(end_with(room, move({3.0, 0.0, 2.0}, {2.0, 0.0, 0.0}, {0.0, 3.0, 0.0}), fence), Finding::kFence);
}

/// The radius of 0.4 m is kept from faces and from edges.
TEST(ProofGrounds, KeepOutsAreKeptAtTheRadius) {
  Chamber room;
  Halfspace planes[kBoxPlanes];
  box_planes({{5.0, 0.0, -1.0}, {9.0, 9.0, 9.0}}, planes);
  const Fence fence{planes, kBoxPlanes, FenceKind::kKeepOut};
  EXPECT_EQ(end_with(room, move({3.0, 1.0, 2.0}, {1.6, 0.0, 0.0}), fence), Finding::kNone);
  EXPECT_EQ(end_with(room, move({3.0, 1.0, 2.0}, {1.601, 0.0, 0.0}), fence), Finding::kFence);
  // Past the edge at (5, 0), at right angles to the diagonal: (4.7, -0.3) is 0.424 m away from it, (4.75, -0.25) 0.354
  // m.
  EXPECT_EQ(end_with(room, move({3.7, -1.3, 2.0}, {2.0, 2.0, 0.0}, {0.0, 0.0, 0.0}), fence), Finding::kFence);
  EXPECT_EQ(end_with(room, move({3.7, 0.7, 2.0}, {2.0, -2.0, 0.0}), fence), Finding::kNone);
  EXPECT_EQ(end_with(room, move({3.75, 0.75, 2.0}, {2.0, -2.0, 0.0}), fence), Finding::kFence);
}

}  // namespace
