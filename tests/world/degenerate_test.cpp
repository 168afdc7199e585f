// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Keep-outs with planes that are equal, nearly equal or nearly opposite: the hull of the corners found holds the whole
// keep-out, the check proves what the hull says and refuses what is nearer, and every plan has an answer.
#include <gtest/gtest.h>

#include <limits>
#include <memory>

#include "base/math.hpp"
#include "prove/fences.hpp"
#include "support/degenerate_fence.hpp"
#include "support/world.hpp"
#include "world/fences.hpp"

namespace tern_test {
namespace {

using tern::Fence;
using tern::FenceKind;
using tern::Status;
using tern::Vec3;

Vec3 unit(const Point& p) {
  const Real norm = std::sqrt(dot_of(p, p));
  return {static_cast<double>(p[0] / norm), static_cast<double>(p[1] / norm), static_cast<double>(p[2] / norm)};
}

/// Any direction, one near a plane's, or along an edge.
Vec3 random_direction(Random& random, const Planes& planes) {
  const int last = static_cast<int>(planes.normal.size()) - 1;
  const Point& n = planes.normal[static_cast<std::size_t>(random.integer(0, last))];
  const Point& m = planes.normal[static_cast<std::size_t>(random.integer(0, last))];
  const Point any{random.real(-1.0, 1.0), random.real(-1.0, 1.0), random.real(-1.0, 1.0)};
  const Point edge = cross_of(n, m);
  const int kind = random.integer(0, 2);
  if (kind == 1 && dot_of(edge, edge) > 1e-20L) return unit(edge);
  const Real by = kind == 2 && random.chance(0.3) ? 0.0L : std::pow(10.0L, -static_cast<Real>(random.real(0.0, 14.0)));
  return unit({by * any[0] - n[0], by * any[1] - n[1], by * any[2] - n[2]});
}

Real least_along(const Vec3& normal, const std::vector<Point>& points) {
  Real least = dot_of(point_of(normal), points[0]);
  for (const Point& p : points) least = std::min(least, dot_of(point_of(normal), p));
  return least;
}

/// Points well inside the keep-out, as near to its corners as that lets them be.
std::vector<Point> points_inside(const Planes& planes, const std::vector<Point>& corners) {
  Point middle{0.0L, 0.0L, 0.0L};
  for (const Point& p : corners) {
    for (std::size_t e = 0; e < 3; ++e) middle[e] += p[e] / static_cast<Real>(corners.size());
  }
  std::vector<Point> points;
  for (Point p : corners) {
    for (std::size_t e = 0; e < 3; ++e) p[e] += 1e-9L * (middle[e] - p[e]);
    if (planes.worst(p) <= -1e-15L) points.push_back(p);
  }
  return points;
}

/// Metres by which a keep-out may be too near, times the scale.
constexpr double kGranted = 1e-9;

bool long_double_is_longer() {
  return std::numeric_limits<Real>::digits >= 64;
}

/// A grid of its own origin with one keep-out, as the stages read it and as the check does.
struct Case {
  explicit Case(Random& random)
      : scale(random.chance(0.3) ? 10.0 : 1.0),
        world({30, 20, 10}, 0.2 * scale, random.chance(0.2) ? 0.0 : random.real(0.0, 0.4) * scale,
              {random.chance(0.5) ? 0.0 : random.real(-50.0, 50.0), 0.0, 0.0}) {
    const Vec3& origin = world.spec.origin;
    const Vec3 center{origin.x + random.real(1.2, 4.8) * scale, random.real(0.8, 3.2) * scale,
                      random.real(0.4, 1.6) * scale};
    planes = DegenerateFence(random, center, scale).planes;
    fence = {planes.data(), static_cast<std::int32_t>(planes.size()), FenceKind::kKeepOut};
    exact = planes_of(planes, world.spec.boundary, world.spec.radius);
    corners = corners_of(exact, 1e-15L * scale);
  }

  double scale;
  World world;
  std::vector<tern::Halfspace> planes;
  Fence fence{};
  Planes exact;
  std::vector<Point> corners;  ///< world frame
};

/// True if the keep-out is proven to lie beyond the plane normal . x = offset, by `distance`: the hull is a square in
/// that plane, so wide that no other plane cuts it off.
bool proven_beyond(const tern::Grid& grid, const tern::AskedWorld& asked, const Vec3& normal, double offset,
                   double distance, tern::FenceScratch& scratch) {
  constexpr double kWide = 1e3;
  const Vec3 side = tern::perpendicular(normal);
  const Vec3 across = tern::cross(normal, side);
  Vec3 square[4];
  for (int k = 0; k < 4; ++k) {
    square[k] = offset * normal + (k % 2 == 0 ? kWide : -kWide) * side + (k < 2 ? kWide : -kWide) * across;
  }
  const tern::Halfspace hint{normal, 0.0};
  tern::Work work;
  return keep_out_cut_off(grid, asked.fence, asked.count, 0, {&hint, 1}, {square, 4, distance}, scratch, work);
}

TEST(FencesDegenerate, TheHullHoldsTheKeepOutAndTheCheckAgrees) {
  if (!long_double_is_longer()) GTEST_SKIP() << "the reference needs a long double that is longer than a double";
  Random random(41);
  const auto solids = std::make_unique<tern::Solids>();
  const auto asked = std::make_unique<tern::AskedWorld>();
  const auto scratch = std::make_unique<tern::FenceScratch>();
  int refused = 0;
  for (int i = 0; i < scaled(1500); ++i) {
    Case c(random);
    const tern::Grid& grid = c.world.grid;
    const double radius = c.world.spec.radius;
    const Status status = load_fences(grid, &c.fence, 1, *solids).status;
    if (status == Status::kFenceEmpty) {
      ASSERT_TRUE(c.corners.empty()) << "case " << i;
      continue;
    }
    ASSERT_EQ(status, Status::kOk);
    ASSERT_TRUE(copy_asked(&c.fence, 1, *asked));
    if (solids->solid_count == 0) {
      ASSERT_TRUE(c.corners.empty()) << "case " << i;
      ASSERT_TRUE(proven_beyond(grid, *asked, {1.0, 0.0, 0.0}, 1e3, radius, *scratch)) << "case " << i;
      continue;
    }
    const std::vector<Point> inside = points_inside(c.exact, c.corners);
    for (int k = 0; k < 12; ++k) {
      const Vec3 normal = random_direction(random, c.exact);
      const Real shift = dot_of(point_of(normal), point_of(c.world.spec.origin));
      const double support = solid_support(normal, solid_of(*solids, solids->parts[0]));
      if (!c.corners.empty()) {
        ASSERT_LE(support, least_along(normal, c.corners) - shift) << "case " << i << ", " << k;
      }
      // A hundredth of the tolerance is left: the hull is larger than the keep-out by more than a proof loses.
      const double distance = radius - kGranted * c.scale;
      const double wanted = support - radius + 0.99 * kGranted * c.scale;
      ASSERT_TRUE(proven_beyond(grid, *asked, normal, wanted, distance, *scratch)) << "case " << i << ", " << k;
      if (inside.empty()) continue;
      const auto too_near = static_cast<double>(least_along(normal, inside) - shift) - radius;
      ASSERT_FALSE(proven_beyond(grid, *asked, normal, too_near + 1.02 * kGranted * c.scale, distance, *scratch))
          << "case " << i << ", " << k;
      ++refused;
    }
  }
  EXPECT_GT(refused, scaled(1500) * 5);
}

void expect_kept(const Case& c) {
  const double end = tern::duration(c.world.trajectory);
  const double radius = c.world.spec.radius;
  for (int k = 0; k <= 60; ++k) {
    const Point p = point_of(tern::evaluate(c.world.trajectory, end * k / 60.0).position);
    ASSERT_GE(c.exact.worst(p), -1e-6L);
    const Point near = nearest_of_hull(c.corners, p);
    const Point d{near[0] - p[0], near[1] - p[1], near[2] - p[2]};
    ASSERT_GE(std::sqrt(dot_of(d, d)), radius - 1e-6L);
  }
}

bool is_answer(Status status) {
  return status == Status::kOk || status == Status::kNoPath || status == Status::kStartFenced ||
         status == Status::kGoalFenced || status == Status::kFenceEmpty || status == Status::kStartOccupied ||
         status == Status::kGoalOccupied || status == Status::kStartTooNarrow || status == Status::kGoalTooNarrow;
}

/// A point that a face of the keep-out leaves just the radius, where there is one in the boundary.
void touch(Random& random, const Case& c, Vec3& position) {
  const auto face = static_cast<std::size_t>(random.integer(0, static_cast<int>(c.planes.size()) - 1));
  std::vector<Point> on;
  for (const Point& p : c.corners) {
    if (std::fabs(c.exact.beyond(face, p)) < 1e-9L) on.push_back(p);
  }
  if (on.empty()) return;
  Point at{0.0L, 0.0L, 0.0L};
  const std::size_t take = random.chance(0.3) ? 1 : on.size();
  for (std::size_t k = 0; k < take; ++k) {
    for (std::size_t e = 0; e < 3; ++e) at[e] += on[k][e] / static_cast<Real>(take);
  }
  for (std::size_t e = 0; e < 3; ++e) at[e] += c.world.spec.radius * c.exact.normal[face][e];
  const Vec3 there{static_cast<double>(at[0]), static_cast<double>(at[1]), static_cast<double>(at[2])};
  const tern::Box& box = c.world.spec.boundary;
  if (there.x >= box.lower.x && there.y >= box.lower.y && there.z >= box.lower.z && there.x <= box.upper.x &&
      there.y <= box.upper.y && there.z <= box.upper.z) {
    position = there;
  }
}

TEST(FencesDegenerate, EveryPlanFromRestToRestHasAnAnswer) {
  if (!long_double_is_longer()) GTEST_SKIP() << "the reference needs a long double that is longer than a double";
  Random random(43);
  int flown = 0;
  for (int i = 0; i < scaled(600); ++i) {
    Case c(random);
    c.world.request.fences = &c.fence;
    c.world.request.fence_count = 1;
    for (int k = 0; k < 3; ++k) {
      c.world.request.budget.trajectory = random.chance(0.5) ? tern::Budget{}.trajectory : 10;
      c.world.from({random.real(0.1, 5.9) * c.scale, random.real(0.1, 3.9) * c.scale, random.real(0.1, 1.9) * c.scale});
      c.world.to({random.real(0.1, 5.9) * c.scale, random.real(0.1, 3.9) * c.scale, random.real(0.1, 1.9) * c.scale});
      if (random.chance(0.3)) touch(random, c, c.world.request.start.position);
      if (random.chance(0.3)) touch(random, c, c.world.request.goal.position);
      const Status status = c.world.plan();
      ASSERT_TRUE(is_answer(status)) << tern::status_name(status) << " in case " << i;
      if (status != Status::kOk) continue;
      ++flown;
      if (c.corners.empty()) continue;
      ASSERT_NO_FATAL_FAILURE(expect_kept(c)) << "case " << i;
    }
  }
  EXPECT_GT(flown, scaled(600));
}

}  // namespace
}  // namespace tern_test
