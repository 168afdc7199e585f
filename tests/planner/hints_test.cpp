// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Stops and rests of plans beside a plate whose faces are parallel but for 1e-6 rad: no face, edge or corner of it cuts
// a curve off that passes the edge in doubles, so that the proof needs a hint.
#include "planner/hints.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>

#include "planner/end_stop.hpp"
#include "support/random.hpp"
#include "support/world.hpp"
#include "world/fences.hpp"

namespace tern_test {
namespace {

using tern::Halfspace;
using tern::Progress;
using tern::Status;
using tern::Trajectory;
using tern::Vec3;

/// The plate x = 5, z >= 2: sharp at the edge, and 2e-6 m thick at the top of the map.
constexpr Halfspace kPlate[] = {{{-1.0, 0.0, 0.0}, -5.0}, {{1.0, 0.0, -1e-6}, 5.0 - 2e-6}};
/// The same, y >= 2.
constexpr Halfspace kOther[] = {{{-1.0, 0.0, 0.0}, -5.0}, {{1.0, -1e-6, 0.0}, 5.0 - 2e-6}};

class BesideAPlate : public testing::Test {
 protected:
  BesideAPlate() : world_({100, 40, 40}, 0.1, 0.0) {
    world_.grid.inflate();
    curve_->origin = {0.0, 0.0, 0.0};
    curve_->count = 1;
    curve_->segments[0].duration = 4.0;
    curve_->segments[0].polyhedron = tern::kNoPolyhedron;
    load(1);
  }

  void load(int count) {
    world_.request.fences = fences_;
    world_.request.fence_count = count;
    ASSERT_EQ(load_fences(world_.grid, fences_, count, *solids_).status, Status::kOk);
    ASSERT_TRUE(copy_asked(fences_, count, *asked_));
  }

  /// Control points whose x goes evenly from 4.3 to 6.
  void fly(const double (&z)[tern::kControlPoints]) {
    for (int k = 0; k <= tern::kDegree; ++k) {
      curve_->segments[0].points[k] = {4.3 + 1.7 * k / tern::kDegree, 1.0, z[k]};
    }
  }

  tern::World solid_world() const { return {world_.grid, *solids_}; }
  tern::RoomProof room(const tern::World& around) { return {world_.grid, asked_.get(), *stage_, *curve_, around}; }

  /// True if the curve is proven with the hints for this world.
  bool proven(const tern::World& around) {
    tern::Work work{0xFFFFFFFFu};
    check_begin(*stage_);
    return prove_room(room(around), 0.0, work) == Progress::kDone;
  }

  const tern::FenceHints& own(int segment) const { return stage_->hints.fences[segment]; }

  World world_;
  tern::Fence fences_[2] = {{kPlate, 2, tern::FenceKind::kKeepOut}, {kOther, 2, tern::FenceKind::kKeepOut}};
  std::unique_ptr<tern::Solids> solids_ = std::make_unique<tern::Solids>();
  std::unique_ptr<tern::AskedWorld> asked_ = std::make_unique<tern::AskedWorld>();
  std::unique_ptr<tern::CheckStage> stage_ = std::make_unique<tern::CheckStage>();
  std::unique_ptr<Trajectory> curve_ = std::make_unique<Trajectory>();
};

constexpr double kStraight[] = {1.5, 1.5, 1.5, 1.5, 1.5, 1.5, 1.5, 1.5};

TEST_F(BesideAPlate, AHintPartsTheCurveFromTheEdge) {
  fly(kStraight);
  EXPECT_FALSE(proven(tern::World(world_.grid))) << "a proof without hints";
  EXPECT_EQ(stage_->found.finding, tern::Finding::kFence);
  EXPECT_TRUE(proven(solid_world()));
  ASSERT_EQ(own(0).count, 1);
  EXPECT_NEAR(own(0).planes[0].normal.z, 1.0, 1e-3);
}

/// The hull of the whole curve meets the plate, those of its halves do not.
TEST_F(BesideAPlate, AHalfHasAHintOfItsOwn) {
  fly({2.9, 2.9, 1.0, 0.2, 0.2, 1.0, 2.9, 2.9});
  EXPECT_FALSE(proven(tern::World(world_.grid)));
  EXPECT_TRUE(proven(solid_world()));
  ASSERT_EQ(own(0).count, 1);
  const Vec3& normal = own(0).planes[0].normal;
  EXPECT_GT(hull_reach(normal, {curve_->segments[0].points, tern::kControlPoints}),
            solid_support(normal, solid_world().solid(0)));
}

/// Turns around the edges of both plates, tight and wide: hints are never more than eighths and plates.
TEST_F(BesideAPlate, EachEighthHasOneHintForEachSolidAtMost) {
  load(2);
  Random random(5);
  std::int32_t most = 0;
  for (int i = 0; i < scaled(400); ++i) {
    const double depth = random.real(1.0, 2.5);
    for (int k = 0; k <= tern::kDegree; ++k) {
      const double angle = 3.14159265 * k / tern::kDegree;
      const double x = 5.0 - random.real(0.02, 0.7) * std::cos(angle);
      curve_->segments[0].points[k] = {x, 2.8 - depth * std::sin(angle), 3.0 - depth * std::sin(angle)};
    }
    proven(solid_world());
    ASSERT_LE(own(0).count, 2 * 8);
    most = std::max(most, own(0).count);
  }
  EXPECT_GE(most, 2);
}

TEST_F(BesideAPlate, EachSegmentAndEachSolidHasItsHints) {
  load(2);
  fly(kStraight);
  curve_->count = 2;
  curve_->segments[1] = curve_->segments[0];
  for (int k = 0; k <= tern::kDegree; ++k) {
    curve_->segments[1].points[k] = {6.0 - 2.0 * k / tern::kDegree, 1.0 + 0.05 * k, 1.5};
  }
  EXPECT_TRUE(proven(solid_world()));
  EXPECT_EQ(stage_->hints.hinted, 2);
  for (const int segment : {0, 1}) {
    ASSERT_EQ(own(segment).count, 2);
    EXPECT_NEAR(own(segment).planes[0].normal.z, 1.0, 1e-3);
    EXPECT_GT(own(segment).planes[1].normal.y, 0.9);
  }
}

/// A unit at a time: the same hints, and a solid for each piece of work.
TEST_F(BesideAPlate, SlicesFindTheSameHints) {
  load(2);
  fly(kStraight);
  ASSERT_TRUE(proven(solid_world()));
  const tern::FenceHints whole = own(0);
  check_begin(*stage_);
  Progress progress = Progress::kMore;
  int slices = 0;
  for (; progress == Progress::kMore; ++slices) {
    tern::Work one = tern::Work{1}.within(1);
    progress = hints_advance(solid_world(), nullptr, *curve_, stage_->hints, one);
  }
  EXPECT_EQ(progress, Progress::kDone);
  EXPECT_EQ(slices, 2);
  ASSERT_EQ(own(0).count, whole.count);
  for (int k = 0; k < whole.count; ++k) {
    for (int a = 0; a < 3; ++a)
      EXPECT_EQ(tern::axis(own(0).planes[k].normal, a), tern::axis(whole.planes[k].normal, a));
  }
}

TEST_F(BesideAPlate, NoWorkWithoutSolids) {
  fly(kStraight);
  check_begin(*stage_);
  tern::Work none{0};
  EXPECT_EQ(hints_advance(tern::World(world_.grid), nullptr, *curve_, stage_->hints, none), Progress::kDone);
  EXPECT_EQ(hints_advance(solid_world(), nullptr, *curve_, stage_->hints, none), Progress::kMore);
}

/// What a half-space of the polyhedron cuts off needs no hint. What only several do does: here none alone does.
TEST_F(BesideAPlate, APolyhedronMayTellEnough) {
  fly(kStraight);
  curve_->segments[0].polyhedron = 0;
  const auto corridor = std::make_unique<tern::Corridor>();
  corridor->count = 1;
  corridor->polyhedra[0].count = 1;
  for (const double top : {1.9, 2.1}) {
    corridor->polyhedra[0].planes[0] = {{0.0, 0.0, 1.0}, top};
    check_begin(*stage_);
    tern::Work work{0xFFFFFFFFu};
    ASSERT_EQ(hints_advance(solid_world(), corridor.get(), *curve_, stage_->hints, work), Progress::kDone);
    EXPECT_EQ(own(0).count, top < 2.0 ? 0 : 1);
  }
}

/// A curve through the plate is not proven, whatever the hints say.
TEST_F(BesideAPlate, HintsNeedNoTrust) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  fly({2.5, 2.5, 2.5, 2.5, 2.5, 2.5, 2.5, 2.5});
  EXPECT_FALSE(proven(solid_world()));
  for (const Vec3& normal : {Vec3{0, 0, 1}, Vec3{0, 0, -1}, Vec3{1, 0, 0}, Vec3{0, 0, 0}, Vec3{kNan, 0, 1}}) {
    check_begin(*stage_);
    stage_->hints.hinted = 1;
    stage_->hints.fences[0].count = 1;
    stage_->hints.fences[0].planes[0] = {normal, 0.0};
    tern::Work work{0xFFFFFFFFu};
    EXPECT_EQ(room_advance(*stage_, world_.grid, *curve_, asked_.get(), 0.0, work), Progress::kFailed);
    EXPECT_EQ(stage_->found.finding, tern::Finding::kFence);
  }
}

/// Braking from 1.5 m/s takes the vehicle under the edge.
TEST_F(BesideAPlate, AStopPassesTheEdge) {
  const auto stop = std::make_unique<tern::EndStop>();
  const auto stops = [&](const tern::World& around) {
    reset(*stop);
    curve_->origin = {4.7, 1.0, 1.5};
    tern::Work work{0xFFFFFFFFu};
    const tern::State state{{0, 0, 0}, {1.5, 0, 0}, {0, 0, 0}};
    return stop_advance(room(around), state, false, world_.request.limits, *stop, work) == Progress::kDone;
  };
  EXPECT_FALSE(stops(tern::World(world_.grid))) << "a proof without hints";
  ASSERT_TRUE(stops(solid_world()));
  EXPECT_GT(stop->place.x, 0.5);
}

/// The rest of a plan that is promised to be found, where no search may help.
TEST_F(BesideAPlate, TheRestOfAPlanIsProven) {
  world_.from({1.0, 1.0, 1.5}).to({9.0, 1.0, 1.5});
  ASSERT_EQ(world_.plan(), Status::kOk);
  const Trajectory first = world_.trajectory;
  world_.request.previous = &first;
  world_.request.budget.search = 0;
  for (const double part : {0.0, 0.25, 0.4}) {
    const double time = part * duration(first);
    const tern::Sample now = evaluate(first, time);
    world_.request.start = {now.position, now.velocity, now.acceleration, now.jerk};
    world_.request.previous_time = time;
    ASSERT_EQ(world_.replan(), Status::kOk) << part;
    EXPECT_EQ(world_.report.quality, tern::Quality::kPrevious);
    EXPECT_EQ(world_.report.entered, time);
    EXPECT_EQ(duration(world_.trajectory), duration(first));
  }
}

}  // namespace
}  // namespace tern_test
