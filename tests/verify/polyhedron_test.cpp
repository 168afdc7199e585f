// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How far a polyhedron reaches, beside the corners of its half-spaces: all of them, in exact numbers.
#include "verify/polyhedron.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/random.hpp"

namespace {

using namespace tern_verify;

/// Where three half-spaces end, if that is one point of the polyhedron.
std::optional<Point> corner(const HalfSpace& a, const HalfSpace& b, const HalfSpace& c,
                            const std::vector<HalfSpace>& planes) {
  const Rational volume = dot(a.normal, cross(b.normal, c.normal));
  if (volume == 0) return {};
  const Point sum = a.offset * cross(b.normal, c.normal) + b.offset * cross(c.normal, a.normal) +
                    c.offset * cross(a.normal, b.normal);
  const Point at = Rational(1 / volume) * sum;
  const bool holds = std::all_of(planes.begin(), planes.end(),
                                 [&at](const HalfSpace& plane) { return dot(plane.normal, at) <= plane.offset; });
  return holds ? std::optional<Point>(at) : std::nullopt;
}

std::vector<Point> corners_of(const std::vector<HalfSpace>& planes) {
  std::vector<Point> corners;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    for (std::size_t j = i + 1; j < planes.size(); ++j) {
      for (std::size_t k = j + 1; k < planes.size(); ++k) {
        const std::optional<Point> found = corner(planes[i], planes[j], planes[k], planes);
        if (found) corners.push_back(*found);
      }
    }
  }
  return corners;
}

/// Planes that hold a point, cut to a box: upright ones, leaning ones, and some again, nearly.
std::vector<HalfSpace> random_planes(tern_test::Random& random) {
  std::vector<HalfSpace> planes;
  const double x = random.real(2.0, 8.0), y = random.real(2.0, 8.0), z = random.real(0.5, 2.5);
  while (planes.size() < 6) {
    const double a = random.real(-1.0, 1.0), b = random.real(-1.0, 1.0);
    const double c = random.chance(0.5) ? 0.0 : random.real(-1.0, 1.0);
    planes.push_back({{a, b, c}, Rational(a * x + b * y + c * z + random.real(0.0, 2.0))});
    if (!random.chance(0.1)) continue;
    planes.push_back(planes.back());
    planes.back().normal[0] += decimal(1, 16);
  }
  return cut_to({{0, 0, 0}, {10, 10, 3}}, 1, planes);
}

TEST(Polyhedron, ExtendsToItsCorners) {
  tern_test::Random random(4417);
  for (int i = 0; i < tern_test::scaled(60); ++i) {
    const std::vector<HalfSpace> planes = random_planes(random);
    const std::vector<Point> corners = corners_of(planes);
    const Extent extent(planes);
    for (int k = 0; k < 20; ++k) {
      Point n{random.real(-1.0, 1.0), random.real(-1.0, 1.0), random.real(-1.0, 1.0)};
      // At right angles to an edge, many triples prove the same.
      if (random.chance(0.5)) n = cross(n, cross(planes[0].normal, planes[1].normal));
      Rational least = dot(n, corners.front());
      for (const Point& at : corners) least = std::min<Rational>(least, dot(n, at));
      const std::optional<Rational> proven = extent.least_along(n);
      ASSERT_TRUE(proven.has_value());
      EXPECT_EQ(*proven, least) << i;
    }
  }
}

}  // namespace
