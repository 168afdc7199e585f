// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Pixels that no pixel around them agrees with: by hand, and against images that were filtered pixel by pixel.
#include "map/support.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/owned_map.hpp"

namespace {

using tern::MapSpec;
using tern::Pose;
using tern::Status;
using tern::Voxel;
using tern_test::Image;
using tern_test::OwnedMap;
using tern_test::Random;

tern::Judged judge(const float (&rows)[3][3], int least) {
  return tern::judge_pixel<false>({0.25f, 0.125f, 0.0f, least}, rows[0], rows[1], rows[2]);
}

TEST(MapSupport, PixelsAgreeWithinAVoxelAndBothErrors) {
  const float wall[3][3] = {{9, 9, 9}, {9, 4, 9}, {4.5f, 9, 9}};
  EXPECT_EQ(judge(wall, 1).hits, 4.0f);
  EXPECT_EQ(judge(wall, 1).sees, 4.0f);
  EXPECT_EQ(judge(wall, 2).hits, 0.0f);
  EXPECT_EQ(judge(wall, 2).sees, 4.0f);
  const float apart[3][3] = {{9, 9, 9}, {9, 4, 9}, {4.51f, 9, 9}};
  EXPECT_EQ(judge(apart, 1).hits, 0.0f);
}

TEST(MapSupport, ADeepPixelSeesNoFurtherThanTheOnesAroundIt) {
  const float hole[3][3] = {{NAN, NAN, NAN}, {3, 8, 2}, {3, 3, 3}};
  EXPECT_EQ(judge(hole, 1).sees, 2.0f);
  EXPECT_EQ(judge(hole, 1).hits, 0.0f);
  const float silent[3][3] = {{3, 3, 3}, {3, 8, 3}, {3, 0, 3}};
  EXPECT_EQ(judge(silent, 1).sees, 0.0f);
}

/// The image's pixels, as a plain loop judges them. False for what is not supported.
bool supported(Image& image, const MapSpec& spec, int u, int v, float& nearest) {
  const auto depth = [&](int a, int b) {
    const float z = image.at(a, b);
    if (image.view.no_return > 0.0 && (z == 0.0f || z == INFINITY)) return INFINITY;
    return z >= static_cast<float>(image.view.min) && z < static_cast<float>(image.view.max) ? z : 0.0f;
  };
  const float z = depth(u, v);
  const float tolerance = static_cast<float>(spec.cell) + 2.0f * (static_cast<float>(spec.depth_margin) +
                                                                  static_cast<float>(spec.depth_margin_square) * z * z);
  int agreeing = 0;
  nearest = z;
  for (int b = v - 1; b <= v + 1; ++b) {
    for (int a = u - 1; a <= u + 1; ++a) {
      const bool inside = a >= 0 && b >= 0 && a < image.view.width && b < image.view.height;
      if (!inside || (a == u && b == v)) continue;
      agreeing += depth(a, b) == z || (z < INFINITY && std::abs(depth(a, b) - z) <= tolerance) ? 1 : 0;
      nearest = std::min(nearest, depth(a, b));
    }
  }
  return agreeing >= spec.support;
}

/// The map of one image.
struct Seen {
  Seen(const MapSpec& spec, const Image& image, const Pose& pose) : owned(spec) {
    EXPECT_EQ(owned.map.begin_frame(image.view, pose, 0), Status::kRunning);
    EXPECT_EQ(tern_test::finish(owned.map), Status::kOk);
  }
  OwnedMap owned;
};

TEST(MapSupport, LoneImagesAreFilteredAsByAPlainLoop) {
  Random random(320);
  int lone = 0;
  for (int k = 0; k < tern_test::scaled(200) && !::testing::Test::HasFailure(); ++k) {
    MapSpec spec = tern::map_spec({-3.0, -3.0, -3.0}, random.real(0.1, 0.3), {64, 30, 30}, 0.0);
    spec.range = random.real(2.0, 6.0);
    spec.depth_margin_square = random.chance(0.5) ? 0.0 : 0.01;
    spec.support = random.integer(1, 8);
    Image image(random.integer(1, 150), random.integer(1, 40), random.real(20.0, 60.0));
    tern_test::fill_randomly(random, image, spec.range);
    if (random.chance(0.5)) image.view.no_return = random.real(0.1, spec.range);
    Pose pose{{0.0, 0.0, 0.0}, {}};
    tern_test::random_quaternion(random, pose.quaternion);
    const Seen filtered(spec, image, pose);
    Image sees(image.view.width, image.view.height, image.view.fx);
    Image hits(image.view.width, image.view.height, image.view.fx);
    for (int v = 0; v < image.view.height; ++v) {
      for (int u = 0; u < image.view.width; ++u) {
        float nearest = 0.0f;
        const bool counts = supported(image, spec, u, v, nearest);
        lone += counts ? 0 : 1;
        sees.at(u, v) = counts ? image.at(u, v) : (nearest > 0.0f ? nearest : -1.0f);
        hits.at(u, v) = counts ? image.at(u, v) : 0.0f;
      }
    }
    sees.view.no_return = image.view.no_return;
    MapSpec plain = spec;
    plain.support = 0;
    const Seen what_is_seen(plain, sees, pose);
    const Seen what_is_hit(plain, hits, pose);
    for (int n = 0; n < 64 * 30 * 30; ++n) {
      const Voxel v{n % 64, n / 64 % 30, n / 64 / 30};
      ASSERT_EQ(filtered.owned.map.seen(v), what_is_seen.owned.map.seen(v)) << k << ": " << v.x << ' ' << v.y;
      ASSERT_EQ(filtered.owned.map.route().obstacle(v), what_is_hit.owned.map.route().obstacle(v)) << k;
    }
  }
  EXPECT_GT(lone, 500);
}

}  // namespace
