// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How a point joins the grid, against a plain second version: a list of all candidates, sorted, and sets of voxels. The
// sequence of voxels that are joined one after the other, as if no search from them found a path, must be the same.
#include "path/join.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <tuple>
#include <vector>

#include "grid/distance.hpp"
#include "support/random.hpp"
#include "world/fences.hpp"

namespace {

using tern::Grid;
using tern::Vec3;
using tern::Voxel;
using tern_test::Random;

constexpr int kReach = 2;

using Key = std::tuple<int, int, int>;

Key key(const Voxel& v) {
  return {v.z, v.y, v.x};
}

/// A small grid of voxels of any size, strewn with obstacles, and a point in it: anywhere, or on faces and edges.
struct Place {
  std::vector<std::uint64_t> words;
  Grid grid;
  Vec3 point{};
  std::unique_ptr<tern::Solids> solids;

  tern::World world() const { return solids ? tern::World(grid, *solids) : tern::World(grid); }

  explicit Place(Random& random) {
    constexpr double kCells[] = {0.1, 0.25, 1.0, 3.0};
    tern::GridSpec spec{};
    spec.cell = kCells[random.integer(0, 3)];
    spec.dims = {random.integer(2, 8), random.integer(2, 8), random.integer(2, 8)};
    spec.boundary = {{0.0, 0.0, 0.0}, {spec.dims.x * spec.cell, spec.dims.y * spec.cell, spec.dims.z * spec.cell}};
    if (random.chance(0.4)) spec.radius = spec.cell * random.real(0.01, 0.5);
    words.resize(tern::grid_words(spec.dims));
    EXPECT_EQ(grid.bind(spec, words.data(), words.size()), tern::Status::kOk);
    const double density = random.real(0.2, 0.8);
    for (int z = 0; z < spec.dims.z; ++z) {
      for (int y = 0; y < spec.dims.y; ++y) {
        for (int x = 0; x < spec.dims.x; ++x) {
          if (random.chance(density)) grid.mark_voxel({x, y, z});
        }
      }
    }
    grid.inflate();
    point = {coordinate(random, spec.dims.x), coordinate(random, spec.dims.y), coordinate(random, spec.dims.z)};
    if (random.chance(0.2)) add_fence(random);
  }
  /// In the middle of a voxel, on a face, or anywhere.
  double coordinate(Random& random, int count) const {
    const double cell = grid.spec().cell;
    const int kind = random.integer(0, 9);
    const double at = random.integer(0, count - 1) + (kind == 0 ? 0.5 : kind < 8 ? 0.0 : random.unit());
    return at * cell;
  }
  void add_fence(Random& random) {
    const double size = grid.spec().cell * grid.spec().dims.x;
    const tern::Halfspace plane{{random.real(-1.0, 1.0), random.real(-1.0, 1.0), 1.1}, random.real(0.3, 1.5) * size};
    const tern::Fence fence{&plane, 1, tern::FenceKind::kKeepIn};
    solids = std::make_unique<tern::Solids>();
    EXPECT_EQ(load_fences(grid, &fence, 1, *solids).status, tern::Status::kOk);
  }
};

/// The second version.
class Reference {
 public:
  Reference(const Place& place, bool moves) : place_(place), moves_(moves), home_(place.grid.voxel_of(place.point)) {}

  std::vector<Key> joined() {
    const double radius = place_.grid.spec().clearance();
    if (place_.grid.free(home_)) {
      take(home_);
      collect(!moves_ && !(radius > 0.0));
    } else if (tern::point_clear(place_.grid, place_.point, radius)) {
      collect(false);
    }
    for (const Voxel& voxel : candidates_) {
      const Vec3 center = place_.grid.center(voxel);
      if (searched_.count(key(voxel)) != 0) continue;
      if (!place_.world().solids_clear(place_.point, center)) continue;
      if (tern::segment_clear(place_.grid, place_.point, center, radius)) take(voxel);
    }
    return joined_;
  }

 private:
  bool is_near(const Voxel& v) const {
    return std::abs(v.x - home_.x) <= kReach && std::abs(v.y - home_.y) <= kReach && std::abs(v.z - home_.z) <= kReach;
  }
  bool touches(const Voxel& v) const {
    const double cell = place_.grid.spec().cell;
    const auto within = [cell](double p, int k) { return p >= (k - 1e-9) * cell && p <= (k + 1 + 1e-9) * cell; };
    return within(place_.point.x, v.x) && within(place_.point.y, v.y) && within(place_.point.z, v.z);
  }
  double square(const Voxel& v) const {
    const Vec3 center = place_.grid.center(v);
    const Vec3 d{center.x - place_.point.x, center.y - place_.point.y, center.z - place_.point.z};
    return (d.x * d.x + d.y * d.y) + d.z * d.z;
  }
  void collect(bool touching) {
    const Voxel& dims = place_.grid.spec().dims;
    for (int z = 0; z < dims.z; ++z) {
      for (int y = 0; y < dims.y; ++y) {
        for (int x = 0; x < dims.x; ++x) {
          const Voxel v{x, y, z};
          const bool other = x != home_.x || y != home_.y || z != home_.z;
          if (other && is_near(v) && place_.grid.free(v) && (!touching || touches(v))) candidates_.push_back(v);
        }
      }
    }
    std::stable_sort(candidates_.begin(), candidates_.end(),
                     [this](const Voxel& a, const Voxel& b) { return square(a) < square(b); });
  }
  /// Whatever is connected with it through faces, within reach, has been searched.
  void take(const Voxel& first) {
    joined_.push_back(key(first));
    std::vector<Voxel> waiting{first};
    while (!waiting.empty()) {
      const Voxel v = waiting.back();
      waiting.pop_back();
      if (!is_near(v) || !place_.grid.free(v) || !searched_.insert(key(v)).second) continue;
      for (const int d : {-1, 1}) {
        waiting.push_back({v.x + d, v.y, v.z});
        waiting.push_back({v.x, v.y + d, v.z});
        waiting.push_back({v.x, v.y, v.z + d});
      }
    }
  }

  const Place& place_;
  bool moves_;
  Voxel home_;
  std::vector<Voxel> candidates_;
  std::set<Key> searched_;
  std::vector<Key> joined_;
};

std::vector<Key> joined(const Place& place, bool moves) {
  const auto join = std::make_unique<tern::Join>();
  tern::Work work;
  tern::join_begin(*join, place.world(), place.point);
  std::vector<Key> found;
  for (int turn = 0; turn <= 2 * tern::kJoinCells && join->state != tern::JoinState::kRefused; ++turn) {
    if (join->state == tern::JoinState::kTrying) {
      tern::join_try(*join, place.world(), place.point, work);
    } else {
      found.push_back(key(join->voxel));
      const bool more = tern::join_others(*join, place.grid, place.point, moves);
      EXPECT_EQ(more, join->state == tern::JoinState::kTrying);
    }
  }
  EXPECT_EQ(join->state, tern::JoinState::kRefused) << "it comes to an end";
  return found;
}

TEST(PathJoin, TheSameVoxelsInTheSameOrder) {
  Random random(41);
  int several = 0;
  int many = 0;
  for (int k = 0; k < tern_test::scaled(40000); ++k) {
    const Place place(random);
    const bool moves = random.chance(0.5);
    const std::vector<Key> found = joined(place, moves);
    ASSERT_EQ(found, Reference(place, moves).joined()) << "case " << k;
    several += found.size() > 1 ? 1 : 0;
    many += found.size() > 2 ? 1 : 0;
  }
  EXPECT_GT(several, tern_test::scaled(1000));
  EXPECT_GT(many, tern_test::scaled(100));
}

/// How a point at height `z` joins, where voxels with index 4 are obstacles: from 2 m to 2.5 m.
tern::Join joined_beside(double z, const tern::Halfspace& wall) {
  tern::GridSpec spec{};
  spec.cell = 0.5;
  spec.dims = {8, 8, 8};
  spec.boundary = {{0.0, 0.0, 0.0}, {4.0, 4.0, 4.0}};
  std::vector<std::uint64_t> words(tern::grid_words(spec.dims));
  Grid grid;
  EXPECT_EQ(grid.bind(spec, words.data(), words.size()), tern::Status::kOk);
  grid.mark_box({{0.0, 0.0, 2.1}, {4.0, 4.0, 2.4}});
  grid.inflate();
  const tern::Fence fence{&wall, 1, tern::FenceKind::kKeepIn};
  const auto solids = std::make_unique<tern::Solids>();
  EXPECT_EQ(load_fences(grid, &fence, 1, *solids).status, tern::Status::kOk);
  tern::Join join{};
  tern::join_begin(join, tern::World(grid, *solids), {0.6, 0.6, z});
  return join;
}

TEST(PathJoin, APointOnAWallBelongsToTheVoxelInside) {
  const tern::Join below = joined_beside(2.0, {{0.0, 0.0, 2.0}, 4.0});
  EXPECT_EQ(below.state, tern::JoinState::kJoined);
  EXPECT_EQ(key(below.voxel), Key(3, 1, 1));
  const tern::Join above = joined_beside(2.5 - 1e-12, {{0.0, 0.0, -1.0}, -2.5});
  EXPECT_EQ(above.state, tern::JoinState::kJoined);
  EXPECT_EQ(key(above.voxel), Key(5, 1, 1));
  // A wall that the voxel does not lie beyond changes nothing.
  const tern::Join far = joined_beside(2.0, {{0.0, 0.0, 1.0}, 3.0});
  EXPECT_EQ(far.state, tern::JoinState::kTrying);
  EXPECT_EQ(key(far.home), Key(4, 1, 1));
}

}  // namespace
