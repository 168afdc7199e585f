// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What changed in a map: by hand, and beside each voxel's own answer. Flights in worlds that stand still are in
// tests/host/cluster_detector_test.cpp.
#include "tern_tracker/changes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

#include "support/camera_map.hpp"
#include "support/owned_map.hpp"
#include "support/random.hpp"
#include "tern_tracker/detection.hpp"

namespace {

using tern::Vec3;
using tern_tracker::Clusters;
using tern_tracker::ClusterStatus;

constexpr double kCell = 0.1;

/// A ball of a metre in it is seen.
struct SeenBall {
  explicit SeenBall(const tern::MapSpec& spec = tern_test::camera_spec()) : owned(spec) {
    EXPECT_EQ(owned.map.assume_free({3.0, 1.0, 1.0}, 1.0), tern::Status::kOk);
    EXPECT_EQ(clusters->begin({0.25, 1}), ClusterStatus::kOk);
  }
  tern::RollingMap& map() { return owned.map; }

  tern_test::OwnedMap owned;
  std::unique_ptr<Clusters> clusters = std::make_unique<Clusters>();
};

/// Looks along x from (1.05, 1.05, 1.05).
constexpr tern::Pose kAlongX = {{1.05, 1.05, 1.05}, {0.5, -0.5, 0.5, -0.5}};

TEST(Changes, EachVoxelWithinTheErrorMustBeSeen) {
  SeenBall ball;
  tern_test::Random random(11);
  int changes = 0;
  for (int k = 0; k < tern_test::scaled(4000); ++k) {
    const Vec3 p{random.real(1.5, 4.5), random.real(-0.2, 2.2), random.real(-0.2, 2.2)};
    const double error = random.real(0.0, 0.35);
    bool expected = true;
    for (int x = 0; x < 64; ++x) {
      for (int y = -2; y < 23; ++y) {
        for (int z = -2; z < 23; ++z) {
          const auto beyond = [&](double at, int n) { return std::abs(at - kCell * (n + 0.5)) - 0.5 * kCell; };
          const double far = std::fmax(beyond(p.x, x), std::fmax(beyond(p.y, y), beyond(p.z, z)));
          if (far < error && !ball.map().seen({x, y, z})) expected = false;
        }
      }
    }
    EXPECT_EQ(tern_tracker::is_change(ball.map(), p, error), expected) << p.x << " " << p.y << " " << p.z;
    changes += expected ? 1 : 0;
  }
  EXPECT_GT(changes, 0);
  EXPECT_TRUE(tern_tracker::is_change(ball.map(), {3.0, 1.0, 1.0}, 0.4));
  EXPECT_FALSE(tern_tracker::is_change(ball.map(), {3.0, 1.0, 1.0}, 0.41)) << "more than four voxels";
  EXPECT_FALSE(tern_tracker::is_change(ball.map(), {std::numeric_limits<double>::quiet_NaN(), 1.0, 1.0}, 0.1));
  EXPECT_FALSE(tern_tracker::is_change(tern::RollingMap(), {3.0, 1.0, 1.0}, 0.1)) << "not bound";
}

TEST(Changes, AnImageAddsWhatItHitsInSeenSpace) {
  SeenBall ball;
  tern_test::Image image(3, 3, 100.0);
  for (float& z : image.z) z = 5.0f;  // not seen there
  image.at(1, 1) = 2.0f;              // straight ahead
  image.at(2, 0) = 1.5f;              // to the right and above
  image.at(0, 2) = 50.0f;             // nothing measured
  ASSERT_EQ(tern_tracker::add_changes(ball.map(), image.view, kAlongX, *ball.clusters), ClusterStatus::kOk);
  ASSERT_EQ(ball.clusters->join(), ClusterStatus::kOk);
  ASSERT_EQ(ball.clusters->size(), 2);
  const tern_tracker::Cluster& near = (*ball.clusters)[0];
  EXPECT_NEAR(near.center.x, 2.55, 1e-12);
  EXPECT_NEAR(near.center.y, 1.05 - 0.015, 1e-12);
  EXPECT_NEAR(near.center.z, 1.05 + 0.015, 1e-12);
  EXPECT_NEAR((*ball.clusters)[1].center.x, 3.05, 1e-12);
  image.view.z32 = nullptr;
  EXPECT_EQ(tern_tracker::add_changes(ball.map(), image.view, kAlongX, *ball.clusters),
            ClusterStatus::kInvalidArgument);
}

// With an error of 0.3 m at a depth of 2 m, only what is that far inside the ball is a change.
TEST(Changes, ErrorsOfDepthAndPoseCount) {
  for (const double margin : {0.1, 0.3}) {
    tern::MapSpec spec = tern_test::camera_spec();
    spec.pose_margin = 0.5 * margin;
    spec.depth_margin_square = 0.125 * margin;
    SeenBall ball(spec);
    tern_test::Image image(1, 1, 1000.0);
    image.at(0, 0) = 2.65f;  // at x = 3.7: 0.3 m inside
    const double error = 0.5 * margin + 0.125 * margin * 2.65 * 2.65;
    ASSERT_EQ(tern_tracker::add_changes(ball.map(), image.view, kAlongX, *ball.clusters), ClusterStatus::kOk);
    ball.clusters->join();
    EXPECT_EQ(ball.clusters->size(), error < 0.2 ? 1 : 0) << error;
  }
}

TEST(Changes, AScanAddsWhatItHitsInSeenSpace) {
  tern::MapSpec spec = tern_test::camera_spec();
  spec.scan_pixel = 0.1;
  SeenBall ball(spec);
  const Vec3 directions[] = {{2.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 0.0, 0.0}};
  const float ranges[] = {2.0f, 5.5f, std::numeric_limits<float>::infinity(), 2.0f};
  const tern::Beams beams{directions, ranges, 4, 0.1, 100.0};
  ASSERT_EQ(tern_tracker::add_changes(ball.map(), beams, kAlongX.position, *ball.clusters), ClusterStatus::kOk);
  ball.clusters->join();
  ASSERT_EQ(ball.clusters->size(), 1);
  EXPECT_EQ((*ball.clusters)[0].points, 1);
  EXPECT_NEAR((*ball.clusters)[0].center.x, 3.05, 1e-12);
  const tern::Beams none{nullptr, ranges, 4, 0.1, 100.0};
  EXPECT_EQ(tern_tracker::add_changes(ball.map(), none, kAlongX.position, *ball.clusters),
            ClusterStatus::kInvalidArgument);
}

TEST(Changes, ACapacityThatIsFullIsTold) {
  tern::MapSpec spec = tern_test::camera_spec();
  SeenBall ball(spec);
  ASSERT_EQ(ball.clusters->begin({0.25, 1}), ClusterStatus::kOk);
  for (int k = 0; k < tern_tracker::kMaxClusterCells; ++k) {
    ASSERT_EQ(ball.clusters->add({0.25 * (k % 64) + 0.1, 0.25 * (k / 64) + 0.1, 10.1}), ClusterStatus::kOk);
  }
  tern_test::Image image(1, 1, 1000.0);
  image.at(0, 0) = 2.0f;
  EXPECT_EQ(tern_tracker::add_changes(ball.map(), image.view, kAlongX, *ball.clusters), ClusterStatus::kCellsFull);
}

// A man who is seen from (0, 0): 0.5 m of his width, 0.2 m of his depth, and all but his feet.
TEST(Detection, IsPlacedBehindWhatIsSeenOfIt) {
  const tern_tracker::Cluster cluster{{0.0, 4.0, 1.2}, {0.25, 0.1, 0.6}, 100};
  const auto man = tern_tracker::detection_of(cluster, {0.0, 0.0, 5.0}, tern::TrackClass::kPerson);
  EXPECT_EQ(man.kind, tern::TrackClass::kPerson);
  EXPECT_DOUBLE_EQ(man.position.x, 0.0);
  EXPECT_DOUBLE_EQ(man.position.y, 4.3);  // 0.4 m behind the nearest point, at 3.9
  EXPECT_DOUBLE_EQ(man.position.z, 1.2);
  EXPECT_DOUBLE_EQ(man.error, 0.15);  // he may be 0.15 m wider to either side
  EXPECT_DOUBLE_EQ(man.radius, 0.4);
  EXPECT_DOUBLE_EQ(man.half_height, 1.4);  // 2 m below the upper end, or above the lower one
  EXPECT_EQ(man.deviation, 0.05);
  // Who stands on the ground is no taller than 2 m above it.
  const auto standing = tern_tracker::detection_of(cluster, {0.0, 0.0, 5.0}, tern::TrackClass::kPerson, {0.1, 0.25});
  EXPECT_DOUBLE_EQ(standing.position.z, 1.25);
  EXPECT_DOUBLE_EQ(standing.half_height, 1.0);
  EXPECT_EQ(standing.deviation, 0.1);
  // What is larger than its class is as large as it is.
  const auto wide =
      tern_tracker::detection_of({{3.0, 0.0, 1.2}, {0.6, 0.8, 1.5}, 9}, {0.0, 0.0, 0.0}, tern::TrackClass::kPerson);
  EXPECT_DOUBLE_EQ(wide.position.x, 3.0);
  EXPECT_EQ(wide.error, 0.0);
  EXPECT_DOUBLE_EQ(wide.radius, 1.0);
  EXPECT_DOUBLE_EQ(wide.half_height, 1.5);
}

}  // namespace
