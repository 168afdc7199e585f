// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/polyhedron.hpp"

#include <gtest/gtest.h>

namespace tern {
namespace {

/// 0 <= x <= 4, y <= 1; behind them a half-space x <= -9 that does not count.
Polyhedron strip() {
  Polyhedron p{};
  p.count = 3;
  p.planes[0] = {{1.0, 0.0, 0.0}, 4.0};
  p.planes[1] = {{-1.0, 0.0, 0.0}, 0.0};
  p.planes[2] = {{0.0, 1.0, 0.0}, 1.0};
  p.planes[3] = {{1.0, 0.0, 0.0}, -9.0};
  return p;
}

TEST(Polyhedron, HoldsAPointWithItsMargin) {
  const Polyhedron p = strip();
  EXPECT_TRUE(holds(p, {3.5, 0.0, 7.0}, 0.5));
  EXPECT_FALSE(holds(p, {3.5, 0.0, 7.0}, 0.75));
  EXPECT_TRUE(holds(p, {4.0, 1.0, 0.0}, 0.0));
  EXPECT_FALSE(holds(p, {4.25, 0.0, 0.0}, 0.0));
  EXPECT_TRUE(holds(p, {4.25, 0.0, 0.0}, -0.25));
}

TEST(Polyhedron, RoomIsThatToTheNearestPlane) {
  const Polyhedron p = strip();
  EXPECT_EQ(room_at(p, {3.5, 0.75, 7.0}), 0.25);
  EXPECT_EQ(room_at(p, {3.5, 0.0, 7.0}), 0.5);
  EXPECT_EQ(room_at(p, {-2.0, 0.0, 0.0}), -2.0);
}

}  // namespace
}  // namespace tern
