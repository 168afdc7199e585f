// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Carving against each voxel looked at by itself: what is passed over, in cubes or whole bricks, is not seen.
#include "view/carve.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/random.hpp"

namespace {

using tern::BrickWords;
using tern::Depth;
using tern::kBrick;
using tern::Vec3;
using tern::Voxel;

constexpr double kRange = 10.0;
constexpr double kCell = 0.2;
constexpr std::int32_t kFace = 62;

/// A view of a wall with holes, from a random place: a camera's, or one of a scan.
struct RandomView {
  RandomView(tern_test::Random& random, bool around)
      : entries(static_cast<std::size_t>(tern::DepthPyramid::entries(kFace, kFace))) {
    const double yaw = random.real(-3.0, 3.0);
    const double pitch = around ? 0.0 : random.real(-0.6, 0.6);
    const double c = std::cos(yaw);
    const double s = std::sin(yaw);
    const Vec3 ahead{c * std::cos(pitch), s * std::cos(pitch), std::sin(pitch)};
    const Vec3 right{s, -c, 0.0};
    const Vec3 down{c * std::sin(pitch), s * std::sin(pitch), -std::cos(pitch)};
    const Vec3 face[] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
    const int a = random.integer(0, 2);
    const Vec3 along_face[] = {face[(a + 1) % 3], face[(a + 2) % 3], face[a]};
    const Vec3 along_camera[] = {right, down, ahead};
    const Vec3 origin{random.real(-6.0, 18.0), random.real(0.0, 8.0), random.real(0.0, 4.0)};
    tern::place(view, around ? along_face : along_camera, origin, kCell);
    view.width = view.height = kFace;
    view.fx = view.fy = around ? kFace / (2.0 * tern::bent(tern::kFaceTangent)) : 0.6 * kFace;
    view.cx = view.cy = 0.5 * (kFace - 1);
    if (!around && random.chance(0.5)) view.cx = random.real(-50.0, 110.0);  // a part of a larger image
    view.growth = random.real(0.0, 0.1);
    view.growth_ahead = random.real(0.0, 0.02);
    view.reach = around ? 1.25 * 2.5 / kFace : 0.0;
    view.units = tern::kDepthUnits / kRange;
    view.pyramid = tern::DepthPyramid(kFace, kFace, entries.data());
    draw(random);
    projector = tern::Projector(view, 50.0);
  }

  void draw(tern_test::Random& random) {
    const double wall = random.real(1.0, 8.0);
    const std::int32_t hole = random.integer(2, 30);
    for (std::int32_t v = 0; v < kFace; ++v) {
      for (std::int32_t u = 0; u < kFace; ++u) {
        const bool open = (u / hole + v / hole) % 2 == 0;
        const double metres = random.integer(0, 400) == 0 ? 0.0 : open ? kRange : wall + 0.02 * u;
        view.pyramid.row(v)[u] = static_cast<Depth>(metres * view.units);
      }
    }
    for (std::int32_t level = 1; level < view.pyramid.levels(); ++level) {
      for (std::int32_t row = 0; row < view.pyramid.height(level); ++row) view.pyramid.make_row(level, row);
    }
  }

  /// True if a voxel of this size is seen whole.
  bool sees(const Voxel& voxel, float size) const {
    const Vec3 at = view.at(voxel.x + 0.5, voxel.y + 0.5, voxel.z + 0.5);
    const tern::Point center{static_cast<float>(at.x), static_cast<float>(at.y), static_cast<float>(at.z)};
    const tern::Footprints feet = projector.footprints(projector.row(center, 0.0f), size);
    return feet.inside[0][0] != 0 && view.pyramid.least_closely(feet.pixels.at(0)) >= feet.far[0][0];
  }

  std::vector<Depth> entries;
  tern::View view{};
  tern::Projector projector;
};

/// What is carved of a brick.
BrickWords carved(const RandomView& from, const Voxel& first, const BrickWords& wanted) {
  BrickWords free{};
  if (tern::misses(from.view, from.projector, first)) return free;
  tern::CubeBits left = 0;
  tern::Work work;
  tern::carve(from.view, from.projector, first, wanted, free, {true, 0x0f}, left, work);
  tern::carve(from.view, from.projector, first, wanted, free, {false, tern::kAllCubes}, left, work);
  return free;
}

/// Voxels of the brick that are seen. Where rounding decides, both answers are right.
int expect_each_voxel(const RandomView& from, const Voxel& first, const BrickWords& wanted, const BrickWords& free) {
  int seen = 0;
  for (std::int32_t k = 0; k < 64 * kBrick * kBrick; ++k) {
    const Voxel in{k % 64, k / 64 % kBrick, k / 64 / kBrick};
    const std::uint64_t bit = std::uint64_t{1} << in.x;
    if ((wanted.words[in.z][in.y] & bit) == 0) continue;
    const bool is_free = (free.words[in.z][in.y] & bit) != 0;
    const Voxel voxel{first.x + in.x, first.y + in.y, first.z + in.z};
    EXPECT_TRUE(is_free || !from.sees(voxel, 1.001f)) << in.x << " " << in.y << " " << in.z;
    EXPECT_TRUE(!is_free || from.sees(voxel, 0.999f)) << in.x << " " << in.y << " " << in.z;
    seen += is_free ? 1 : 0;
  }
  return seen;
}

void carve_random_bricks(bool around) {
  tern_test::Random random(around ? 51 : 52);
  int seen = 0;
  int hidden = 0;
  for (int n = 0; n < tern_test::scaled(1000); ++n) {
    const RandomView from(random, around);
    const Voxel first{0, 8 * random.integer(0, 5), 8 * random.integer(0, 3)};
    BrickWords wanted;
    for (auto& plane : wanted.words) {
      for (std::uint64_t& word : plane)
        word = random.integer(0, 3) == 0 ? 0 : ~std::uint64_t{0} << random.integer(0, 40);
    }
    const int free = expect_each_voxel(from, first, wanted, carved(from, first, wanted));
    seen += free;
    hidden += free == 0 ? 1 : 0;
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(seen, 0);
  EXPECT_GT(hidden, 0);
}

TEST(Carve, FindsEachVoxelThatACameraSees) {
  carve_random_bricks(false);
}

TEST(Carve, FindsEachVoxelThatAScanSees) {
  carve_random_bricks(true);
}

}  // namespace
