// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_TESTS_SUPPORT_WALKED_PATH_HPP
#define TERN_TESTS_SUPPORT_WALKED_PATH_HPP

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "support/reference_search.hpp"
#include "tern/path.hpp"

namespace tern_test {

/// Walks a raw path move by move. Every leg goes straight along one of the 26 directions and cuts no corner; returns
/// the path's cost, -1 where a move is not allowed.
inline double walked_cost(const tern::Grid& grid, const ReferenceSearch& reference, const tern::Path& path) {
  const auto sign = [](int v) { return (v > 0) - (v < 0); };
  double cost = 0.0;
  for (int k = 1; k < path.raw_count; ++k) {
    tern::Voxel at = grid.voxel_of(path.raw[k - 1]);
    const tern::Voxel to = grid.voxel_of(path.raw[k]);
    const tern::Voxel step{sign(to.x - at.x), sign(to.y - at.y), sign(to.z - at.z)};
    while (at.x != to.x || at.y != to.y || at.z != to.z) {
      if (!reference.allowed(at, step)) return -1.0;
      at = {at.x + step.x, at.y + step.y, at.z + step.z};
      cost += std::sqrt(step.x * step.x + step.y * step.y + step.z * step.z);
    }
  }
  return cost;
}

inline void expect_same_raw(const tern::Path& a, const tern::Path& b) {
  ASSERT_EQ(a.raw_count, b.raw_count);
  EXPECT_EQ(std::memcmp(a.raw, b.raw, sizeof(tern::Vec3) * static_cast<std::size_t>(a.raw_count)), 0);
}

}  // namespace tern_test

#endif
