// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "volume.hpp"

#include <cmath>

namespace tern_bench {
namespace {

using tern::Halfspace;
using tern::Vec3;
using Polygon = std::vector<Vec3>;

constexpr double kFar = 1e4;

double dot(const Vec3& a, const Vec3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
/// a + s b
Vec3 along(const Vec3& a, double s, const Vec3& b) {
  return {a.x + s * b.x, a.y + s * b.y, a.z + s * b.z};
}
Vec3 minus(const Vec3& a, const Vec3& b) {
  return along(a, -1.0, b);
}

/// Sutherland and Hodgman's cut of a convex polygon.
Polygon cut(const Polygon& polygon, const Halfspace& by) {
  Polygon left;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec3& a = polygon[k];
    const Vec3& b = polygon[(k + 1) % polygon.size()];
    const double at_a = dot(by.normal, a) - by.offset;
    const double at_b = dot(by.normal, b) - by.offset;
    if (at_a <= 0.0) left.push_back(a);
    if ((at_a <= 0.0) != (at_b <= 0.0)) left.push_back(along(a, at_a / (at_a - at_b), minus(b, a)));
  }
  return left;
}

Polygon square_on(const Halfspace& plane) {
  const Vec3& n = plane.normal;
  const bool steep = std::fabs(n.x) > 0.7;
  Vec3 u = cross(n, steep ? Vec3{0.0, 1.0, 0.0} : Vec3{1.0, 0.0, 0.0});
  const double scale = kFar / std::sqrt(dot(u, u));
  u = {scale * u.x, scale * u.y, scale * u.z};
  const Vec3 v = cross(n, u);
  const Vec3 foot = along({0.0, 0.0, 0.0}, plane.offset, n);
  return {along(along(foot, -1.0, u), -1.0, v), along(along(foot, 1.0, u), -1.0, v), along(along(foot, 1.0, u), 1.0, v),
          along(along(foot, -1.0, u), 1.0, v)};
}

/// Twice the vector area, along the plane's normal.
double double_area(const Polygon& polygon, const Vec3& normal) {
  double sum = 0.0;
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
    sum += dot(normal, cross(minus(polygon[k], polygon[0]), minus(polygon[k + 1], polygon[0])));
  }
  return std::fabs(sum);
}

}  // namespace

std::vector<Halfspace> bounding_planes(const tern::Polyhedron& polyhedron) {
  return {polyhedron.planes, polyhedron.planes + polyhedron.count};
}

std::vector<Halfspace> planes_of(const tern::Box& box) {
  return {{{1.0, 0.0, 0.0}, box.upper.x},   {{-1.0, 0.0, 0.0}, -box.lower.x}, {{0.0, 1.0, 0.0}, box.upper.y},
          {{0.0, -1.0, 0.0}, -box.lower.y}, {{0.0, 0.0, 1.0}, box.upper.z},   {{0.0, 0.0, -1.0}, -box.lower.z}};
}

double volume(const std::vector<Halfspace>& planes) {
  double sum = 0.0;
  Vec3 apex{0.0, 0.0, 0.0};  // a corner of the first facet: pyramids from there keep cancellation small
  bool has_apex = false;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    Polygon facet = square_on(planes[i]);
    for (std::size_t j = 0; j < planes.size() && !facet.empty(); ++j) {
      if (j != i) facet = cut(facet, planes[j]);
    }
    if (facet.empty()) continue;
    if (!has_apex) apex = facet[0];
    has_apex = true;
    sum += (planes[i].offset - dot(planes[i].normal, apex)) * double_area(facet, planes[i].normal) / 6.0;
  }
  return sum;
}

}  // namespace tern_bench
