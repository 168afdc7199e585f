// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Clusters: by hand, beside a flood through a map of cells, and with full capacities.
#include "tern_tracker/clusters.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "support/random.hpp"

namespace {

using tern::Vec3;
using tern_tracker::Cluster;
using tern_tracker::Clusters;
using tern_tracker::ClusterSettings;
using tern_tracker::ClusterStatus;

std::unique_ptr<Clusters> joined(const std::vector<Vec3>& points, const ClusterSettings& settings) {
  auto clusters = std::make_unique<Clusters>();
  EXPECT_EQ(clusters->begin(settings), ClusterStatus::kOk);
  for (const Vec3& point : points) EXPECT_EQ(clusters->add(point), ClusterStatus::kOk);
  EXPECT_EQ(clusters->join(), ClusterStatus::kOk);
  return clusters;
}

/// Numbers that order and compare a cluster.
std::array<double, 7> numbers_of(const Cluster& c) {
  return {-1.0 * c.points,       c.center.x - c.half.x, c.center.y - c.half.y, c.center.z - c.half.z,
          c.center.x + c.half.x, c.center.y + c.half.y, c.center.z + c.half.z};
}

/// What a flood from cell to cell gives.
std::vector<std::array<double, 7>> flooded(const std::vector<Vec3>& points, const ClusterSettings& settings) {
  std::map<std::array<int, 3>, std::vector<Vec3>> cells;
  for (const Vec3& p : points) {
    const auto number = [&](double at) { return static_cast<int>(std::floor(at / settings.cell)); };
    cells[{number(p.x), number(p.y), number(p.z)}].push_back(p);
  }
  std::vector<std::array<double, 7>> found;
  while (!cells.empty()) {
    std::vector<std::array<int, 3>> open{cells.begin()->first};
    std::vector<Vec3> all;
    for (std::size_t k = 0; k < open.size(); ++k) {
      const auto cell = cells.find(open[k]);
      if (cell == cells.end()) continue;
      all.insert(all.end(), cell->second.begin(), cell->second.end());
      cells.erase(cell);
      for (int n = 0; n < 27; ++n) {
        open.push_back({open[k][0] + n / 9 - 1, open[k][1] + n / 3 % 3 - 1, open[k][2] + n % 3 - 1});
      }
    }
    if (static_cast<int>(all.size()) < settings.points) continue;
    Vec3 low = all[0], high = all[0];
    for (const Vec3& p : all) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    found.push_back({-1.0 * static_cast<double>(all.size()), low.x, low.y, low.z, high.x, high.y, high.z});
  }
  std::sort(found.begin(), found.end());
  return found;
}

TEST(Clusters, AreComputedByHand) {
  // Cells of a metre: two that touch at a corner, with three points, and one that is a cell away.
  const auto clusters = joined({{0.5, 0.5, 0.5}, {-0.25, -0.5, -0.25}, {0.75, 0.5, 0.5}, {2.5, 0.5, 0.5}}, {1.0, 1});
  ASSERT_EQ(clusters->size(), 2);
  const Cluster& pair = (*clusters)[0];
  EXPECT_EQ(pair.points, 3);
  EXPECT_EQ(pair.center.x, 0.25);
  EXPECT_EQ(pair.center.y, 0.0);
  EXPECT_EQ(pair.center.z, 0.125);
  EXPECT_EQ(pair.half.x, 0.5);
  EXPECT_EQ(pair.half.y, 0.5);
  EXPECT_EQ(pair.half.z, 0.375);
  EXPECT_EQ((*clusters)[1].points, 1);
  EXPECT_EQ((*clusters)[1].center.x, 2.5);
  EXPECT_EQ((*clusters)[1].half.x, 0.0);
  EXPECT_EQ(joined({{0.5, 0.5, 0.5}, {2.5, 0.5, 0.5}}, {1.0, 2})->size(), 0) << "one point each";
  EXPECT_EQ(joined({}, {1.0, 1})->size(), 0);
}

TEST(Clusters, AreThoseOfAFloodInWhateverOrderPointsCome) {
  tern_test::Random random(7);
  for (int k = 0; k < tern_test::scaled(400); ++k) {
    std::vector<Vec3> points;
    const double wide = random.real(0.5, 4.0);
    const int count = random.integer(1, 60);
    for (int n = 0; n < count; ++n) {
      points.push_back({random.real(-wide, wide), random.real(-wide, wide), random.real(-wide, wide)});
    }
    const ClusterSettings settings{random.real(0.1, 1.0), random.integer(1, 4)};
    const auto expected = flooded(points, settings);
    const auto clusters = joined(points, settings);
    ASSERT_EQ(static_cast<std::size_t>(clusters->size()), expected.size());
    for (std::size_t c = 0; c < expected.size(); ++c) {
      const auto numbers = numbers_of((*clusters)[static_cast<std::int32_t>(c)]);
      for (std::size_t n = 0; n < numbers.size(); ++n) EXPECT_NEAR(numbers[n], expected[c][n], 1e-12);
    }
    for (std::size_t n = points.size(); n > 1; --n) {
      std::swap(points[n - 1], points[static_cast<std::size_t>(random.integer(0, static_cast<int>(n) - 1))]);
    }
    const auto again = joined(points, settings);
    for (std::int32_t c = 0; c < clusters->size(); ++c) EXPECT_EQ(numbers_of((*again)[c]), numbers_of((*clusters)[c]));
  }
}

TEST(Clusters, RefuseWhatTheyCannotTake) {
  Clusters& clusters = *std::make_unique<Clusters>().release();
  const std::unique_ptr<Clusters> owner(&clusters);
  EXPECT_EQ(clusters.add({0.0, 0.0, 0.0}), ClusterStatus::kInvalidArgument) << "not begun";
  EXPECT_EQ(clusters.join(), ClusterStatus::kInvalidArgument);
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  for (const ClusterSettings& wrong : {ClusterSettings{0.009, 1}, {10.1, 1}, {kNan, 1}, {1.0, 0}}) {
    EXPECT_EQ(clusters.begin(wrong), ClusterStatus::kInvalidArgument);
  }
  ASSERT_EQ(clusters.begin({1.0, 1}), ClusterStatus::kOk);
  const double last = tern_tracker::kClusterReach - 2.5;
  EXPECT_EQ(clusters.add({last, -last - 2.0, 0.0}), ClusterStatus::kOk);
  for (const double far : {last + 1.0, -last - 3.0, kNan, std::numeric_limits<double>::infinity()}) {
    EXPECT_EQ(clusters.add({0.0, far, 0.0}), ClusterStatus::kOutOfReach) << far;
  }
  EXPECT_EQ(clusters.join(), ClusterStatus::kOk);
  EXPECT_EQ(clusters.size(), 1);
  EXPECT_EQ(clusters.join(), ClusterStatus::kInvalidArgument) << "joined already";
}

TEST(Clusters, CellsFull) {
  const auto clusters = std::make_unique<Clusters>();
  ASSERT_EQ(clusters->begin({1.0, 1}), ClusterStatus::kOk);
  for (int k = 0; k < tern_tracker::kMaxClusterCells; ++k) {
    ASSERT_EQ(clusters->add({k % 64 + 0.5, k / 64 + 0.5, 0.5}), ClusterStatus::kOk);
  }
  EXPECT_EQ(clusters->add({0.5, 0.5, 1.5}), ClusterStatus::kCellsFull);
  EXPECT_EQ(clusters->add({0.25, 0.5, 0.5}), ClusterStatus::kOk) << "in a cell that is there";
  EXPECT_EQ(clusters->join(), ClusterStatus::kOk);
  ASSERT_EQ(clusters->size(), 1);
  EXPECT_EQ((*clusters)[0].points, tern_tracker::kMaxClusterCells + 1);
}

TEST(Clusters, ClustersFullLeavesOutTheSmallest) {
  const auto clusters = std::make_unique<Clusters>();
  ASSERT_EQ(clusters->begin({1.0, 1}), ClusterStatus::kOk);
  // 66 clusters, of which one has a single point, and one of the others comes last.
  for (int k = 0; k < tern_tracker::kMaxClusters + 2; ++k) {
    for (int n = 0; n < (k == 5 ? 1 : 2); ++n) EXPECT_EQ(clusters->add({3.0 * k + 0.5, 0.5, 0.5}), ClusterStatus::kOk);
  }
  EXPECT_EQ(clusters->join(), ClusterStatus::kClustersFull);
  ASSERT_EQ(clusters->size(), tern_tracker::kMaxClusters);
  for (std::int32_t k = 0; k < clusters->size(); ++k) {
    EXPECT_EQ((*clusters)[k].points, 2);
    EXPECT_EQ((*clusters)[k].center.x, 3.0 * (k < 5 ? k : k + 1) + 0.5);
  }
}

}  // namespace
