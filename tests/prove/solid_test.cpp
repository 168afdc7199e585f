// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The proof that a keep-out lies beyond a plane, where nearly parallel half-spaces lead the simplex method astray: what
// it says is proven is so, whatever the way there.
#include "prove/solid.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/random.hpp"

namespace tern_test {
namespace {

using tern::DoubleDouble;
using tern::Plane;
using tern::Solid;
using tern::Vec3;

Vec3 in_cube(Random& random, double half) {
  return {random.real(-half, half), random.real(-half, half), random.real(-half, half)};
}

Vec3 unit(const Vec3& v) {
  return (1.0 / length(v)) * v;
}

template <class Real>
Plane<Real> plane(const Vec3& normal, double offset) {
  return {{Real(normal.x), Real(normal.y), Real(normal.z)}, Real(offset)};
}

/// Half-spaces that all hold some points of one plane, and whose normals are that plane's but for `tilt`.
class Blade {
 public:
  Blade(Random& random, double tilt) : tilt_(tilt), normal_(unit(in_cube(random, 1.0))) {
    const Vec3 u = tern::perpendicular(normal_);
    const Vec3 v = cross(normal_, u);
    for (Vec3& point : points_) {
      point = 0.1 * normal_ + random.real(-0.5, 0.5) * u + random.real(-0.5, 0.5) * v;
    }
    begin(exact);
    begin(quick);
    for (int p = random.integer(3, 20); p > 0; --p) {
      const Vec3 tilted = unit((random.chance(0.5) ? 1.0 : -1.0) * normal_ + in_cube(random, tilt));
      const double offset = -least(-1.0 * tilted) + 1e-15;  // more than its rounding
      exact.planes[exact.count++] = plane<DoubleDouble>(tilted, offset);
      quick.planes[quick.count++] = plane<double>(tilted, offset);
    }
    add_box(exact);
    add_box(quick);
  }
  /// The least that normal . p is among the points.
  double least(const Vec3& normal) const {
    double result = dot(normal, points_[0]);
    for (const Vec3& point : points_) result = std::fmin(result, dot(normal, point));
    return result;
  }
  Vec3 direction(Random& random) const {
    return unit(random.chance(0.5) ? in_cube(random, 1.0) : normal_ + in_cube(random, tilt_));
  }

  Solid<DoubleDouble> exact;
  Solid<double> quick;

 private:
  template <class Real>
  static void begin(Solid<Real>& solid) {
    solid.count = 0;
    solid.empty = false;
    for (double& half : solid.half) half = 1.0;
    solid.reach = std::sqrt(3.0) * (1.0 + 1e-15);
  }
  template <class Real>
  static void add_box(Solid<Real>& solid) {
    for (int k = 0; k < tern::kSolidFaces; ++k) {
      Vec3 face{};
      axis(face, k / 2) = k % 2 == 0 ? 1.0 : -1.0;
      solid.planes[solid.count + k] = plane<Real>(face, 1.0);
    }
  }

  double tilt_;
  Vec3 normal_;
  Vec3 points_[6];
};

TEST(CheckSolid, ProvesNothingFalseOfNearlyParallelHalfspaces) {
  Random random(1);
  int proven = 0;
  for (int i = 0; i < 8000; ++i) {
    const Blade blade(random, std::pow(10.0, random.real(-14.5, -12.5)));
    const Vec3 normal = blade.direction(random);
    const double least = blade.least(normal);
    const double offset = least + random.real(-0.1, 0.3);
    const double missing[] = {shortfall(blade.exact, plane<DoubleDouble>(normal, offset)),
                              shortfall(blade.quick, plane<double>(normal, offset))};
    for (const double by : missing) {
      ASSERT_GE(by, 0.0);
      ASSERT_LE(offset - by, least + 1e-15) << "case " << i;
      proven += by > 0.0 ? 0 : 1;
    }
  }
  EXPECT_GT(proven, 500);
}

}  // namespace
}  // namespace tern_test
