// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Plans on a snapshot of the route grid while frames and slides go on: the same bits as on a grid that was built anew
// with the same obstacles and then left alone.
#include <gtest/gtest.h>

#include <cstring>
#include <memory>

#include "base/math.hpp"
#include "grid/distance.hpp"
#include "support/at_once.hpp"
#include "support/grid_storage.hpp"
#include "support/owned_map.hpp"
#include "tern/planner.hpp"

namespace {

using tern::Grid;
using tern::Status;
using tern::Vec3;
using tern_test::finish;
using tern_test::OwnedMap;
using tern_test::Random;

struct Planning {
  std::unique_ptr<unsigned char[]> memory{new unsigned char[tern::kWorkspaceBytes]};
  tern::Planner planner{memory.get(), tern::kWorkspaceBytes};
  tern::Trajectory trajectory{};
  tern::Report report{};
};

/// A map with frames coming in.
class Flight {
 public:
  explicit Flight(Random& random) : owned_(spec()), image_(32, 24, 16.0), random_(random) {}

  tern::RollingMap& map() { return owned_.map; }
  Vec3 eye() const { return eye_; }

  void begin_frame() {
    tern_test::fill_randomly(random_, image_, 4.0);
    tern::Pose pose{eye_, {}};
    tern_test::random_quaternion(random_, pose.quaternion);
    ASSERT_EQ(owned_.map.begin_frame(image_.view, pose, ++time_), Status::kRunning);
  }
  void slide() {
    eye_ = {eye_.x + random_.real(-3.0, 6.0), eye_.y + random_.real(-1.0, 1.0), eye_.z + random_.real(-0.2, 0.2)};
    owned_.map.follow(eye_);
    finish(owned_.map);
  }

 private:
  static tern::MapSpec spec() {
    tern::MapSpec spec = tern::map_spec({-6.4, -3.0, 0.0}, 0.2, {128, 40, 20}, 0.25);
    spec.range = 4.0;
    return spec;
  }

  OwnedMap owned_;
  tern_test::Image image_;
  Random& random_;
  Vec3 eye_{6.4, 1.0, 2.0};
  std::int64_t time_ = 0;
};

void expect_same_voxels(const Grid& a, const Grid& b) {
  const tern::Voxel dims = a.spec().dims;
  for (int z = 0; z < dims.z; ++z) {
    for (int y = 0; y < dims.y; ++y) {
      for (int k = 0; k < a.row_words(); ++k) {
        ASSERT_EQ(a.obstacle_row(y, z)[k], b.obstacle_row(y, z)[k]);
        ASSERT_EQ(a.blocked_row(y, z)[k], b.blocked_row(y, z)[k]);
      }
    }
  }
}

TEST(MapSnapshot, PlansOnItWhileFramesAndSlidesGoOn) {
  Random random(41);
  Flight flight(random);
  tern::RollingMap& map = flight.map();
  Grid snapshot;
  std::vector<std::uint64_t> words(tern::grid_words({128, 40, 20}));
  Planning sliced;
  Planning whole;
  tern_test::OwnedGrid anew(map.route().spec());
  int plans = 0;
  std::uint64_t revision = 0;
  for (int k = 0; k < tern_test::scaled(60); ++k) {
    if (k % 5 == 4) flight.slide();
    flight.begin_frame();
    EXPECT_EQ(map.snapshot(snapshot, words.data(), words.size()), Status::kInvalidArgument);
    finish(map);
    ASSERT_EQ(map.snapshot(snapshot, words.data(), words.size()), Status::kOk);
    ASSERT_TRUE(snapshot.inflated());
    EXPECT_GT(snapshot.revision(), revision);
    revision = snapshot.revision();
    ASSERT_EQ(anew.grid.bind(map.route().spec(), anew.words.data(), anew.words.size()), Status::kOk);
    tern_test::copy_obstacles(map.route(), anew.grid);
    anew.grid.inflate();
    expect_same_voxels(snapshot, anew.grid);

    tern::Request request{};
    request.limits = {{2.0, 2.0, 2.0}, {2.0, 2.0, 2.0}};
    const Vec3 eye = flight.eye();
    tern::Voxel free{};
    ASSERT_TRUE(tern_test::nearest_free_voxel(snapshot, snapshot.to_local(eye), free));
    request.start.position = snapshot.center(free) + snapshot.spec().origin;
    request.goal.position = {eye.x + random.real(-5.0, 5.0), eye.y + random.real(-2.0, 2.0), eye.z};
    request.goal_mode = tern::GoalMode::kNearest;
    request.search = random.chance(0.5) ? tern::SearchMode::kOptimal : tern::SearchMode::kFast;
    Status status = sliced.planner.begin(snapshot, request);
    flight.begin_frame();
    while (status == Status::kRunning) {
      status = sliced.planner.step(20);
      if (map.step(200) == Status::kOk) flight.begin_frame();
    }
    finish(map);
    sliced.planner.finish(sliced.trajectory, sliced.report);
    ASSERT_EQ(whole.planner.plan(anew.grid, request, whole.trajectory, whole.report), status);
    if (status != Status::kOk) continue;
    ++plans;
    ASSERT_EQ(std::memcmp(&sliced.trajectory, &whole.trajectory, sizeof whole.trajectory), 0) << k;
  }
  EXPECT_GT(plans, tern_test::scaled(60) / 2);
}

TEST(MapSnapshot, TheSameBitsInSlicesOfAnySize) {
  Random random(44);
  Flight flight(random);
  tern::RollingMap& map = flight.map();
  Grid whole, sliced;
  std::vector<std::uint64_t> whole_words(tern::grid_words({128, 40, 20}));
  std::vector<std::uint64_t> sliced_words(whole_words.size());
  const std::vector<std::uint32_t> slices{1, 2, 7, 64, 1000};
  for (int k = 0; k < tern_test::scaled(30); ++k) {
    if (k % 4 == 3) flight.slide();
    flight.begin_frame();
    finish(map);
    const std::uint64_t revision = sliced.revision();
    ASSERT_EQ(map.begin_snapshot(sliced, sliced_words.data(), sliced_words.size()), Status::kRunning);
    EXPECT_TRUE(map.busy());
    EXPECT_FALSE(sliced.bound());
    EXPECT_EQ(map.follow({100.0, 0.0, 0.0}), Status::kInvalidArgument);
    std::uint32_t units = 1;
    while (map.step(slices[static_cast<std::size_t>(k) % slices.size()]) == Status::kRunning) ++units;
    EXPECT_LE(units, map.scan_work(0));
    ASSERT_TRUE(sliced.inflated());
    EXPECT_GT(sliced.revision(), revision);
    ASSERT_EQ(map.snapshot(whole, whole_words.data(), whole_words.size()), Status::kOk);
    expect_same_voxels(whole, sliced);
    expect_same_voxels(map.route(), sliced);
    EXPECT_TRUE(tern::same(map.route().spec().origin, sliced.spec().origin));
  }
}

TEST(MapSnapshot, BeginningAnotherOneEndsAPlan) {
  Random random(45);
  Flight flight(random);
  Grid snapshot;
  std::vector<std::uint64_t> words(tern::grid_words({128, 40, 20}));
  ASSERT_EQ(flight.map().snapshot(snapshot, words.data(), words.size()), Status::kOk);
  Planning planning;
  tern::Request request{};
  request.limits = {{2.0, 2.0, 2.0}, {2.0, 2.0, 2.0}};
  request.start.position = flight.eye();
  request.goal.position = {flight.eye().x + 3.0, flight.eye().y, flight.eye().z};
  ASSERT_EQ(planning.planner.begin(snapshot, request), Status::kRunning);
  ASSERT_EQ(flight.map().begin_snapshot(snapshot, words.data(), words.size()), Status::kRunning);
  EXPECT_EQ(planning.planner.step(1), Status::kMapChanged);
}

TEST(MapSnapshot, TakingAnotherOneEndsAPlan) {
  Random random(42);
  Flight flight(random);
  Grid snapshot;
  std::vector<std::uint64_t> words(tern::grid_words({128, 40, 20}));
  ASSERT_EQ(flight.map().snapshot(snapshot, words.data(), words.size()), Status::kOk);
  Planning planning;
  tern::Request request{};
  request.limits = {{2.0, 2.0, 2.0}, {2.0, 2.0, 2.0}};
  request.start.position = flight.eye();
  request.goal.position = {flight.eye().x + 3.0, flight.eye().y, flight.eye().z};
  ASSERT_EQ(planning.planner.begin(snapshot, request), Status::kRunning);
  ASSERT_EQ(flight.map().snapshot(snapshot, words.data(), words.size()), Status::kOk);
  EXPECT_EQ(planning.planner.step(1), Status::kMapChanged);
}

TEST(MapSnapshot, IsRefusedWithoutAMapOrWords) {
  tern::RollingMap none;
  Grid snapshot;
  std::vector<std::uint64_t> words(tern::grid_words({128, 40, 20}));
  EXPECT_EQ(none.snapshot(snapshot, words.data(), words.size()), Status::kInvalidArgument);
  EXPECT_EQ(none.begin_snapshot(snapshot, words.data(), words.size()), Status::kInvalidArgument);
  Random random(43);
  Flight flight(random);
  EXPECT_EQ(flight.map().snapshot(snapshot, words.data(), words.size() - 1), Status::kInvalidArgument);
  EXPECT_EQ(flight.map().snapshot(snapshot, nullptr, words.size()), Status::kInvalidArgument);
  EXPECT_FALSE(flight.map().busy());
  EXPECT_FALSE(snapshot.bound());
}

}  // namespace
