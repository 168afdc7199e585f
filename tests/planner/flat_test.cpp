// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Flights inside a boundary, or a keep-in, that holds no whole voxel on an axis: at one height, along a wall, in a
// slab. What a flood over the layers that it meets connects has a plan: between random points, through vias and in
// flight. By dense sampling, every plan stays inside and keeps the radius.
#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "support/slab.hpp"
#include "tern/tern.hpp"
#include "world/fences.hpp"

namespace tern_test {
namespace {

using tern::Status;
using tern::Vec3;
using tern::Voxel;

class FlatPlans : public testing::TestWithParam<ThinBy> {
 protected:
  FlatPlans() : memory_(new unsigned char[tern::kWorkspaceBytes]), planner_(memory_.get(), tern::kWorkspaceBytes) {}

  Status plan(const Slab& slab) {
    fence_ = slab.fence();
    request_.fences = &fence_;
    request_.fence_count = GetParam() == ThinBy::kKeepIn ? 1 : 0;
    const Status status = planner_.plan(slab.grid(), request_, plan_, report_);
    if (status == Status::kOk) expect_inside(slab);
    return status;
  }
  void expect_inside(const Slab& slab) const {
    constexpr double kTolerance = 3e-9;
    const double end = tern::duration(plan_);
    for (int k = 0; k <= 200; ++k) {
      const Vec3 p = tern::evaluate(plan_, end * k / 200).position;
      for (int a = 0; a < 3; ++a) {
        ASSERT_GE(tern::axis(p, a), tern::axis(slab.box().lower, a) - kTolerance);
        ASSERT_LE(tern::axis(p, a), tern::axis(slab.box().upper, a) + kTolerance);
      }
      ASSERT_GE(slab.clearance(p), slab.spec().radius - kTolerance);
    }
  }
  const Voxel& pick(Random& random, const Slab& slab) const { return slab.free()[random.next() % slab.free().size()]; }
  /// Chooses a request. True if free voxels connect all its points.
  bool ask(Random& random, const Slab& slab) {
    const Voxel& from = pick(random, slab);
    const Voxel& to = pick(random, slab);
    request_ = {};
    request_.limits = {{2.0, 2.0, 1.0}, {4.0, 4.0, 2.0}};
    request_.start.position = slab.point(random, from);
    request_.goal.position = slab.point(random, to);
    request_.search = random.chance(0.5) ? tern::SearchMode::kFast : tern::SearchMode::kOptimal;
    bool connected = slab.part(from) == slab.part(to);
    vias_.clear();
    for (int k = random.chance(0.3) ? random.integer(1, 3) : 0; k > 0; --k) {
      const Voxel& by = pick(random, slab);
      connected = connected && slab.part(by) == slab.part(from);
      tern::Via via{};
      via.position = slab.point(random, by);
      via.tolerance = random.chance(0.5) ? 0.0 : random.real(0.0, 0.5);
      via.stop = random.chance(0.3);
      vias_.push_back(via);
    }
    request_.vias = vias_.data();
    request_.via_count = static_cast<int>(vias_.size());
    return connected;
  }
  /// From somewhere along the plan at hand, with and without it.
  void expect_replans(Random& random, const Slab& slab) {
    const tern::Trajectory flown = plan_;
    const double time = tern::duration(flown) * random.unit();
    const tern::Sample at = tern::evaluate(flown, time);
    request_.start = {at.position, at.velocity, at.acceleration, at.jerk};
    request_.previous = &flown;
    request_.previous_time = time;
    EXPECT_EQ(plan(slab), Status::kOk) << tern::status_name(report_.status);
    request_.previous = nullptr;
    EXPECT_EQ(plan(slab), Status::kOk) << tern::status_name(report_.status);
  }

  std::unique_ptr<unsigned char[]> memory_;
  tern::Planner planner_;
  tern::Request request_{};
  tern::Fence fence_{};
  std::vector<tern::Via> vias_;
  tern::Trajectory plan_{};
  tern::Report report_{};
};

TEST_P(FlatPlans, WhatTheLayersOfTheBoundaryConnectHasAPlan) {
  Random random(4021);
  int planned = 0;
  int optimised = 0;
  int apart = 0;
  int bridged = 0;
  for (int i = 0; i < scaled(200); ++i) {
    const Slab slab(random, GetParam());
    if (slab.free().empty()) continue;
    const bool connected = ask(random, slab);
    const Status status = plan(slab);
    if (!connected) {
      // A point may join a voxel of another part nearby, along a line that the parts do not show. Few do.
      EXPECT_TRUE(status == Status::kNoPath || status == Status::kOk) << tern::status_name(status);
      bridged += status == Status::kOk ? 1 : 0;
      ++apart;
      continue;
    }
    ASSERT_EQ(status, Status::kOk) << "case " << i << ": " << tern::status_name(status);
    ++planned;
    optimised += report_.quality == tern::Quality::kOptimised ? 1 : 0;
    if (vias_.empty()) expect_replans(random, slab);
    if (HasFailure()) FAIL() << "case " << i;
  }
  EXPECT_EQ(optimised, planned);
  EXPECT_GE(planned, scaled(100) / 2);
  EXPECT_GE(apart, scaled(20) / 4);
  EXPECT_LE(10 * bridged, apart);
}

/// The nearest point that a path leads to lies inside the boundary, too, and is flown to.
TEST_P(FlatPlans, AGoalThatIsCutOffIsApproachedInsideTheBoundary) {
  Random random(4022);
  int missed = 0;
  for (int i = 0; i < scaled(80); ++i) {
    const Slab slab(random, GetParam());
    if (slab.free().empty()) continue;
    ask(random, slab);
    request_.via_count = 0;
    request_.goal_mode = tern::GoalMode::kNearest;
    ASSERT_EQ(plan(slab), Status::kOk) << "case " << i << ": " << tern::status_name(report_.status);
    missed += report_.goal_missed != Status::kOk ? 1 : 0;
    if (HasFailure()) FAIL() << "case " << i;
  }
  EXPECT_GE(missed, scaled(10) / 4);
}

/// Half-spaces about a point near the slab, at any angle.
std::vector<tern::Halfspace> oblique(Random& random, const Slab& slab) {
  Vec3 middle{};
  for (int a = 0; a < 3; ++a) {
    tern::axis(middle, a) = random.real(tern::axis(slab.box().lower, a), tern::axis(slab.box().upper, a));
  }
  std::vector<tern::Halfspace> planes;
  for (int k = random.integer(1, 6); k > 0; --k) {
    const Vec3 n{random.real(-1.0, 1.0), random.real(-1.0, 1.0), random.real(-1.0, 1.0)};
    planes.push_back({n, tern::dot(n, middle) + random.real(0.0, 0.4)});
  }
  return planes;
}

/// The blocked layer of a grid with fences.
class FencedLayer {
 public:
  void make(const tern::Grid& grid, const std::vector<tern::Fence>& list) {
    const auto count = static_cast<std::int32_t>(list.size());
    world_begin(*memory_, grid);
    ASSERT_EQ(world_add(*memory_, list.data(), count).status, Status::kOk);
    ASSERT_EQ(world_prepare(*memory_), Status::kOk);
    tern::Work work{0xFFFFFFFFu};
    ASSERT_EQ(world_advance(*memory_, work), tern::Progress::kDone);
    view = memory_->view;
  }
  bool narrowed() const { return memory_->layer.narrowed; }

  tern::Grid view;

 private:
  std::unique_ptr<tern::WorldMemory> memory_ = std::make_unique<tern::WorldMemory>();
};

/// Bit for bit, also where the boundary cuts the voxels of the keep-in, and where a keep-out is near.
TEST(FlatKeepIn, BlocksWhatABoundaryOfItsSizeDoes) {
  Random random(4023);
  FencedLayer layer;
  FencedLayer expected;
  int freed = 0;
  for (int i = 0; i < scaled(200); ++i) {
    const Slab slab(random, ThinBy::kKeepIn);
    tern::GridSpec spec = slab.spec();
    spec.boundary = slab.box();
    OwnedGrid thin(spec);
    copy_obstacles(slab.grid(), thin.grid);
    const std::vector<tern::Halfspace> planes = oblique(random, slab);
    std::vector<tern::Fence> fences;
    if (i % 2 != 0) fences.push_back({planes.data(), static_cast<int>(planes.size()), tern::FenceKind::kKeepOut});
    expected.make(thin.grid, fences);
    fences.push_back(slab.fence());
    layer.make(slab.grid(), fences);
    if (HasFatalFailure()) return;
    EXPECT_TRUE(layer.narrowed());
    for (int z = 0; z < spec.dims.z; ++z) {
      for (int y = 0; y < spec.dims.y; ++y) {
        for (int x = 0; x < spec.dims.x; ++x) {
          const bool free = layer.view.free({x, y, z});
          ASSERT_EQ(free, expected.view.free({x, y, z})) << i << ": " << x << " " << y << " " << z;
          freed += free && i % 2 != 0 ? 1 : 0;
        }
      }
    }
  }
  EXPECT_GE(freed, scaled(200) * 20);
}

/// World coordinates there are rounded by more than kLatticeTolerance of a voxel. A keep-in of a whole number of voxels
/// has them all; one of no height has the layers on both sides.
TEST(FlatKeepIn, IsOnTheLatticeFarFromTheOriginToo) {
  Random random(4024);
  FencedLayer layer;
  for (int i = 0; i < scaled(400); ++i) {
    const auto any = [&] { return random.real(-1e7, 1e7); };
    OwnedGrid owned(whole_grid({6, 6, 6}, 0.05, 0.0, {any(), any(), any()}));
    owned.grid.inflate();
    const int thin = random.integer(0, 2);
    const int height = i % 4;
    const int from = random.integer(1, 5 - height);
    Vec3 normal{0.0, 0.0, 0.0};
    tern::axis(normal, thin) = 1.0;
    const double lower = tern::axis(owned.grid.spec().origin, thin) + from * 0.05;
    const double upper = tern::axis(owned.grid.spec().origin, thin) + (from + height) * 0.05;
    const tern::Halfspace planes[] = {{normal, upper}, {-1.0 * normal, -lower}};
    layer.make(owned.grid, {{planes, 2, tern::FenceKind::kKeepIn}});
    if (HasFatalFailure()) return;
    int free = 0;
    for_each_voxel({6, 6, 6}, [&](const Voxel& v) { free += layer.view.free(v) ? 1 : 0; });
    ASSERT_EQ(free, 36 * (height == 0 ? 2 : height)) << i;
  }
}

/// The plane that the flight keeps to is on the lattice but for rounding. The way is on one side of it.
TEST_P(FlatPlans, FarFromTheOriginThereIsAWayOnBothSidesOfTheLattice) {
  constexpr double kPlane = -9099245.5490231272;
  for (const double beyond : {-0.05, 0.05}) {
    tern::GridSpec spec = whole_grid({8, 31, 9}, 0.1, 0.0, {-9099245.8490231279, 0.0, 0.0});
    if (GetParam() == ThinBy::kBoundary) spec.boundary.lower.x = spec.boundary.upper.x = kPlane;
    OwnedGrid owned(spec);
    owned.grid.mark_box({{kPlane + beyond, 0.0, 0.0}, {kPlane + beyond, 3.1, 0.9}});
    owned.grid.inflate();
    const tern::Halfspace planes[] = {{{64.0, 0.0, 0.0}, 64.0 * kPlane}, {{-128.0, 0.0, 0.0}, -128.0 * kPlane}};
    const tern::Fence keep_in{planes, 2, tern::FenceKind::kKeepIn};
    request_ = {};
    request_.limits = {{2.0, 2.0, 1.0}, {4.0, 4.0, 2.0}};
    request_.fences = &keep_in;
    request_.fence_count = GetParam() == ThinBy::kKeepIn ? 1 : 0;
    request_.start.position = {kPlane, 1.25, 0.25};
    request_.goal.position = {kPlane, 0.75, 0.35};
    EXPECT_EQ(planner_.plan(owned.grid, request_, plan_, report_), Status::kOk) << tern::status_name(report_.status);
  }
}

/// A keep-out slants across a flat boundary, or a flat keep-in, with a gap at one end or none.
TEST_P(FlatPlans, AKeepOutIsNoWayThroughWithoutARadius) {
  for (const double height : {0.0, 1e-10, 0.03}) {
    tern::GridSpec spec = whole_grid({40, 40, 10}, 0.1, 0.0, {0.0, 0.0, 0.0});
    const tern::Box thin{{0.0, 0.0, 0.5}, {4.0, 4.0, 0.5 + height}};
    if (GetParam() == ThinBy::kBoundary) spec.boundary = thin;
    OwnedGrid owned(spec);
    owned.grid.inflate();
    tern::Halfspace faces[tern::kBoxPlanes];
    tern::box_planes(thin, faces);
    tern::Halfspace across[] = {{{1.0, 0.1, 0.0}, 2.5}, {{-1.0, -0.1, 0.0}, -1.5}, {{0.0, 1.0, 0.0}, 9.0}};
    const tern::Fence list[] = {{across, 3, tern::FenceKind::kKeepOut}, {faces, 6, tern::FenceKind::kKeepIn}};
    request_ = {};
    request_.limits = {{2.0, 2.0, 1.0}, {4.0, 4.0, 2.0}};
    request_.fences = list;
    request_.fence_count = GetParam() == ThinBy::kKeepIn ? 2 : 1;
    request_.start.position = {0.55, 1.05, 0.5};
    request_.goal.position = {3.55, 1.05, 0.5};
    const auto answer = [&] { return planner_.plan(owned.grid, request_, plan_, report_); };
    EXPECT_EQ(answer(), Status::kNoPath) << height;
    across[2].offset = 3.0;
    ASSERT_EQ(answer(), Status::kOk) << height;
    EXPECT_EQ(report_.quality, tern::Quality::kOptimised);
    for (int k = 0; k <= 200; ++k) {
      const Vec3 p = tern::evaluate(plan_, tern::duration(plan_) * k / 200).position;
      const double along = p.x + 0.1 * p.y;
      EXPECT_TRUE(along < 1.5 + 1e-8 || along > 2.5 - 1e-8 || p.y > 3.0 - 1e-8) << height;
    }
    request_.start.position = {2.05, 1.05, 0.5};
    EXPECT_EQ(answer(), Status::kStartFenced) << height;
  }
}

INSTANTIATE_TEST_SUITE_P(By, FlatPlans, testing::Values(ThinBy::kBoundary, ThinBy::kKeepIn));

}  // namespace
}  // namespace tern_test
