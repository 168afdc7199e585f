// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <vector>

#include "base/linear.hpp"
#include "ellipsoid/barrier_ellipsoid.hpp"
#include "ellipsoid/ellipsoid_fit.hpp"
#include "ellipsoid/ellipsoid_metric.hpp"
#include "grid/touching.hpp"
#include "support/at_once.hpp"
#include "support/corridor_reference.hpp"
#include "support/random.hpp"

namespace tern_test {
namespace {

using tern::box_of;
using tern::BoxContact;
using tern::EllipsoidFrame;
using tern::EllipsoidMetric;
using tern::LocalBox;
using tern::Obstacles;
using tern::Polyhedron;
using tern::support;
using tern::to_vec3;
using tern::Vec3;
using tern::Vector;

Vec3 cross3(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

Vec3 scaled3(double s, const Vec3& v) {
  return {s * v.x, s * v.y, s * v.z};
}

EllipsoidFrame random_frame(Random& random) {
  EllipsoidFrame frame;
  frame.center = {random.real(-1.0, 1.0), random.real(-1.0, 1.0), random.real(-1.0, 1.0)};
  Vec3 u{random.real(-1.0, 1.0), random.real(-1.0, 1.0), random.real(0.1, 1.0)};
  u = scaled3(1.0 / norm3(u), u);
  Vec3 v = cross3(u, {0.3, 0.8, -0.2});
  v = scaled3(1.0 / norm3(v), v);
  frame.direction.col(0) = tern::to_vector(u);
  frame.direction.col(1) = tern::to_vector(v);
  frame.direction.col(2) = tern::to_vector(cross3(u, v));
  for (double& s : frame.semi_axis) s = random.real(0.05, 2.0);
  return frame;
}

LocalBox random_box(Random& random) {
  LocalBox box;
  for (int a = 0; a < 3; ++a) {
    box.lower[a] = random.real(-3.0, 3.0);
    box.upper[a] = box.lower[a] + random.real(0.01, 2.0);
  }
  return box;
}

double norm_in(const EllipsoidFrame& frame, const Vec3& offset) {
  double sum = 0.0;
  for (int k = 0; k < 3; ++k) {
    const double q = dot3(offset, to_vec3(frame.direction.col(k))) / frame.semi_axis[k];
    sum += q * q;
  }
  return std::sqrt(sum);
}

/// Cyclic coordinate descent on a strictly convex function over a box: slow, and certain to arrive.
double reference_norm(const EllipsoidFrame& frame, const EllipsoidMetric& metric, const LocalBox& box) {
  const double c[3] = {frame.center[0], frame.center[1], frame.center[2]};
  double d[3];
  for (int a = 0; a < 3; ++a) d[a] = std::clamp(0.0, box.lower[a] - c[a], box.upper[a] - c[a]);
  for (int sweep = 0; sweep < 20000; ++sweep) {
    double change = 0.0;
    for (int a = 0; a < 3; ++a) {
      double pull = 0.0;
      for (int b = 0; b < 3; ++b) pull += b == a ? 0.0 : metric.matrix(a, b) * d[b];
      const double next = std::clamp(-pull / metric.matrix(a, a), box.lower[a] - c[a], box.upper[a] - c[a]);
      change = std::max(change, std::fabs(next - d[a]));
      d[a] = next;
    }
    if (change < 1e-14) break;
  }
  return norm_in(frame, {d[0], d[1], d[2]});
}

TEST(CorridorEllipsoid, NearestPointOfABoxIsExact) {
  Random random(11);
  for (int i = 0; i < scaled(20000); ++i) {
    const EllipsoidFrame frame = random_frame(random);
    const EllipsoidMetric metric = metric_of(frame);
    const LocalBox box = random_box(random);
    const Vec3 offset = to_vec3(nearest_offset(metric, frame.center, box));
    const double coordinates[3] = {frame.center[0] + offset.x, frame.center[1] + offset.y, frame.center[2] + offset.z};
    bool holds_center = true;
    for (int a = 0; a < 3; ++a) {
      const double c = frame.center[a];
      holds_center = holds_center && c >= box.lower[a] && c <= box.upper[a];
      ASSERT_GE(coordinates[a], box.lower[a] - 1e-9);
      ASSERT_LE(coordinates[a], box.upper[a] + 1e-9);
    }
    if (holds_center) {
      ASSERT_EQ(norm3(offset), 0.0);
      continue;
    }
    ASSERT_NEAR(norm_in(frame, offset), reference_norm(frame, metric, box), 1e-6) << "case " << i;
  }
}

TEST(CorridorEllipsoid, ContactPlaneKeepsTheScaledEllipsoidFromTheGrownBox) {
  Random random(12);
  for (int i = 0; i < scaled(20000); ++i) {
    const EllipsoidFrame frame = random_frame(random);
    const EllipsoidMetric metric = metric_of(frame);
    const LocalBox box = random_box(random);
    const double radius = random.chance(0.5) ? 0.0 : random.real(0.0, 0.5);
    const BoxContact contact = contact_of(metric, box, radius);
    const Vec3 normal = to_vec3(contact.normal);
    if (norm3(normal) < 0.5) continue;
    ASSERT_NEAR(norm3(normal), 1.0, 1e-12);
    const double plane = support(normal, box_of(box)) - radius;
    const double ellipsoid = dot3(normal, to_vec3(frame.center)) + contact.scale * reach_along(metric, contact.normal);
    ASSERT_NEAR(plane, ellipsoid, 1e-9);
    if (radius <= 0.0) {
      ASSERT_NEAR(contact.scale, norm_in(frame, to_vec3(contact.point)), 1e-6 * (1.0 + contact.scale));
    }
  }
}

TEST(CorridorEllipsoid, TheLeastScaleIsABoundAndMostlyANearOne) {
  Random random(13);
  int cases = 0;
  int near = 0;
  for (int i = 0; i < scaled(20000); ++i) {
    const EllipsoidMetric metric = metric_of(random_frame(random));
    const LocalBox box = random_box(random);
    const double scale = contact_of(metric, box, 0.0).scale;  // without a radius it is exact
    ASSERT_LE(least_scale(metric, box, 0.0), scale) << "case " << i;
    const double radius = random.real(0.0, 0.5);
    ASSERT_LE(least_scale(metric, box, radius), scale) << "case " << i;
    if (!(scale > 0.0)) continue;
    ++cases;
    near += least_scale(metric, box, 0.0) > 0.9 * scale ? 1 : 0;
  }
  EXPECT_GT(4 * near, 3 * cases);
}

TEST(CorridorEllipsoid, AFreeSegmentGetsASphere) {
  const Obstacles none{nullptr, 0, 0.25};
  const EllipsoidFrame frame = tern_test::fit_ellipsoid({0.0, 0.0, 0.0}, {4.0, 0.0, 0.0}, none, 0.1, nullptr);
  EXPECT_EQ(frame.center[0], 2.0);
  for (const double semi_axis : frame.semi_axis) EXPECT_EQ(semi_axis, 2.0);
}

TEST(CorridorEllipsoid, AWallBesideShrinksYAndLeavesZ) {
  // A wall at y = 1, wide in x and z: the ellipsoid touches it at its middle, one metre away.
  const LocalBox wall{{-10.0, 1.0, -10.0}, {10.0, 2.0, 10.0}};
  std::int32_t inside[1];
  const EllipsoidFrame frame =
      tern_test::fit_ellipsoid({-3.0, 0.0, 0.0}, {3.0, 0.0, 0.0}, {&wall, 1, 0.0}, 0.1, inside);
  EXPECT_DOUBLE_EQ(frame.semi_axis[0], 3.0);
  EXPECT_NEAR(frame.semi_axis[1], 1.0, 5e-3);
  EXPECT_NEAR(frame.semi_axis[2], 3.0, 1e-12);
  EXPECT_NEAR(std::fabs(frame.direction(1, 1)), 1.0, 1e-12);
}

/// A wall 1 m to the side and a ceiling 1.2 m above: y shrinks to the wall, round about the segment, so that the
/// ceiling is not met before z stretches. With the ceiling nearer, y points up. Obstacles come in either order.
TEST(CorridorEllipsoid, YPointsToTheNearestOfTwo) {
  const LocalBox wall{{-5.0, 1.0, -5.0}, {5.0, 2.0, 5.0}};
  for (const double height : {1.2, 0.8}) {
    const LocalBox ceiling{{-5.0, -5.0, height}, {5.0, 5.0, 2.0}};
    for (const bool wall_first : {true, false}) {
      const LocalBox boxes[] = {wall_first ? wall : ceiling, wall_first ? ceiling : wall};
      std::int32_t inside[2];
      const EllipsoidFrame frame =
          tern_test::fit_ellipsoid({-3.0, 0.0, 0.0}, {3.0, 0.0, 0.0}, {boxes, 2, 0.0}, 0.1, inside);
      const bool wall_is_nearer = height > 1.0;
      EXPECT_NEAR(frame.semi_axis[1], wall_is_nearer ? 1.0 : height, 2e-3);
      EXPECT_NEAR(frame.semi_axis[2], wall_is_nearer ? height : 1.0, 2e-3);
      EXPECT_NEAR(std::abs(frame.direction(wall_is_nearer ? 1 : 2, 1)), 1.0, 1e-9);
    }
  }
}

TEST(CorridorEllipsoid, TheRadiusCountsAsObstacle) {
  const LocalBox wall{{-10.0, 1.0, -10.0}, {10.0, 2.0, 10.0}};
  std::int32_t inside[1];
  const EllipsoidFrame frame =
      tern_test::fit_ellipsoid({-3.0, 0.0, 0.0}, {3.0, 0.0, 0.0}, {&wall, 1, 0.4}, 0.1, inside);
  EXPECT_NEAR(frame.semi_axis[1], 0.6, 5e-3);
}

TEST(CorridorEllipsoid, AGrazedObstacleLeavesAtLeastTheThinnestAxis) {
  const LocalBox wall{{-10.0, 0.0, -10.0}, {10.0, 2.0, 10.0}};
  std::int32_t inside[1];
  const EllipsoidFrame frame =
      tern_test::fit_ellipsoid({-3.0, 0.0, 0.0}, {3.0, 0.0, 0.0}, {&wall, 1, 0.0}, 0.1, inside);
  EXPECT_GE(frame.semi_axis[1], 0.01);
  EXPECT_GE(frame.semi_axis[2], frame.semi_axis[1]);
}

TEST(CorridorEllipsoid, APointGetsABall) {
  const Obstacles none{nullptr, 0, 0.0};
  const EllipsoidFrame frame = tern_test::fit_ellipsoid({1.0, 2.0, 3.0}, {1.0, 2.0, 3.0}, none, 0.2, nullptr);
  for (const double semi_axis : frame.semi_axis) EXPECT_DOUBLE_EQ(semi_axis, 0.1);
  EXPECT_EQ(frame.center[1], 2.0);
}

/// The box 0 <= x <= a, 0 <= y <= b, 0 <= z <= c.
Polyhedron box_polyhedron(double a, double b, double c) {
  Polyhedron p{};
  p.count = 6;
  p.planes[0] = {{1.0, 0.0, 0.0}, a};
  p.planes[1] = {{-1.0, 0.0, 0.0}, 0.0};
  p.planes[2] = {{0.0, 1.0, 0.0}, b};
  p.planes[3] = {{0.0, -1.0, 0.0}, 0.0};
  p.planes[4] = {{0.0, 0.0, 1.0}, c};
  p.planes[5] = {{0.0, 0.0, -1.0}, 0.0};
  return p;
}

TEST(CorridorEllipsoid, TheBarrierCentresOnABox) {
  // Two slacks of a / 2 each: the Hessian is 8 / a^2 along x, so that E^2 is a^2 / 8.
  tern::Work work;
  const tern::BarrierEllipsoid inner =
      barrier_ellipsoid(box_polyhedron(4.0, 2.0, 1.0), Vector(0.3, 1.9, 0.1), 1e-3, work);
  EXPECT_NEAR(inner.metric.center[0], 2.0, 2e-2);
  EXPECT_NEAR(inner.metric.center[1], 1.0, 1e-2);
  EXPECT_NEAR(inner.metric.center[2], 0.5, 5e-3);
  EXPECT_NEAR(inner.metric.shape(0, 0), 2.0, 1e-2);
  EXPECT_NEAR(inner.metric.shape(1, 1), 0.5, 1e-2);
  EXPECT_NEAR(inner.metric.shape(2, 2), 0.125, 1e-3);
  EXPECT_NEAR(inner.size, 2.0 * 0.5 * 0.125 * 216.0, 0.5);
}

TEST(CorridorEllipsoid, TheBarrierBeginsOnAPlaneToo) {
  tern::Work work;
  const tern::BarrierEllipsoid inner =
      barrier_ellipsoid(box_polyhedron(4.0, 2.0, 1.0), Vector(0.0, 2.0, 0.5), 0.05, work);
  EXPECT_NEAR(inner.metric.center[0], 2.0, 0.1);
  EXPECT_NEAR(inner.metric.center[1], 1.0, 0.1);
}

}  // namespace
}  // namespace tern_test
