// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The oblique view: what stands before what, and where points are drawn.
#include "host/picture/oblique_camera.hpp"

#include <gtest/gtest.h>

#include <set>
#include <utility>
#include <vector>

#include "support/random.hpp"

namespace {

/// Boxes that do not meet, as each lies in a cell of its own.
std::vector<tern::Box> separate_boxes(tern_test::Random& random) {
  std::vector<tern::Box> boxes;
  for (int cell = 0; cell < 27; ++cell) {
    const tern::Vec3 at{1.0 * (cell % 3), 1.0 * (cell / 3 % 3), 1.0 * (cell / 9)};
    const auto low = [&] { return random.real(0.0, 0.4); };
    const auto high = [&] { return random.real(0.6, 1.0); };
    boxes.push_back({{at.x + low(), at.y + low(), at.z + low()}, {at.x + high(), at.y + high(), at.z + high()}});
  }
  for (std::size_t i = boxes.size() - 1; i > 0; --i) {
    std::swap(boxes[i], boxes[static_cast<std::size_t>(random.integer(0, static_cast<int>(i)))]);
  }
  return boxes;
}

TEST(ObliqueCamera, DrawsNoBoxAfterOneThatStandsBeforeIt) {
  tern_test::Random random(11);
  int pairs = 0;
  for (int trial = 0; trial < 20; ++trial) {
    const std::vector<tern::Box> boxes = separate_boxes(random);
    const std::vector<std::size_t> order = tern_host::back_to_front(boxes);
    ASSERT_EQ(std::set<std::size_t>(order.begin(), order.end()).size(), boxes.size());
    for (std::size_t later = 0; later < order.size(); ++later) {
      const tern::Box& box = boxes[order[later]];
      for (int point = 0; point < 50; ++point) {
        const tern::Vec3 inside{random.real(box.lower.x, box.upper.x), random.real(box.lower.y, box.upper.y),
                                random.real(box.lower.z, box.upper.z)};
        for (std::size_t k = 0; k < order.size(); ++k) {
          if (k == later || !tern_host::ObliqueCamera::hides(boxes[order[k]], inside)) continue;
          EXPECT_GT(k, later);
          ++pairs;
        }
      }
    }
  }
  EXPECT_GT(pairs, 1000);
}

TEST(ObliqueCamera, PutsHiddenPointsBehindTheBoxThatHidesThem) {
  tern_host::ObliqueCamera camera({{0, 0, 0}, {10, 4, 3}});
  camera.fit({0.0, 0.0, 1000.0, 600.0});
  const tern::Box wall{{4, 1, 0}, {6, 1.2, 3}};
  EXPECT_TRUE(tern_host::ObliqueCamera::hides(wall, {4.8, 1.5, 1}));
  EXPECT_FALSE(tern_host::ObliqueCamera::hides(wall, {4.8, 0.9, 1}));  // before it
  EXPECT_FALSE(tern_host::ObliqueCamera::hides(wall, {4.8, 1.5, 3}));  // above it
  EXPECT_FALSE(tern_host::ObliqueCamera::hides(wall, {6.5, 1.5, 1}));  // beside it
  const tern_host::Pixel left = camera.project({0, 0, 0});
  const tern_host::Pixel right = camera.project({10, 0, 0});
  EXPECT_NEAR(left.y, right.y, 1e-9);
  EXPECT_NEAR(right.x - left.x, 10.0 * camera.scale(), 1e-9);
  EXPECT_GT(left.y, camera.project({0, 0, 3}).y);  // up is up
}

}  // namespace
