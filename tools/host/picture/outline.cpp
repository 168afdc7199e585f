// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/picture/outline.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace tern_host {
namespace {

using tern::Halfspace;
using tern::Vec3;

constexpr double kParallel = 1e-9;  // of three unit normals' triple product
constexpr double kInside = 1e-7;    // m

Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

double dot(const Vec3& a, const Vec3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

bool inside(const std::vector<Halfspace>& planes, const Vec3& p) {
  return std::all_of(planes.begin(), planes.end(),
                     [&](const Halfspace& h) { return dot(h.normal, p) <= h.offset + kInside; });
}

bool intersect(const Halfspace& a, const Halfspace& b, const Halfspace& c, Vec3& point) {
  const Vec3 bc = cross(b.normal, c.normal);
  const Vec3 ca = cross(c.normal, a.normal);
  const Vec3 ab = cross(a.normal, b.normal);
  const double volume = dot(a.normal, bc);
  if (std::fabs(volume) < kParallel) return false;
  point = {(a.offset * bc.x + b.offset * ca.x + c.offset * ab.x) / volume,
           (a.offset * bc.y + b.offset * ca.y + c.offset * ab.y) / volume,
           (a.offset * bc.z + b.offset * ca.z + c.offset * ab.z) / volume};
  return true;
}

double turn(const Pixel& a, const Pixel& b, const Pixel& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// One side of the hull of sorted points (Andrew's monotone chain), without its last point.
template <typename Iterator>
void append_chain(Iterator begin, Iterator end, std::vector<Pixel>& hull) {
  const std::size_t first = hull.size();
  for (Iterator it = begin; it != end; ++it) {
    while (hull.size() >= first + 2 && turn(hull[hull.size() - 2], hull.back(), *it) <= 0.0) hull.pop_back();
    hull.push_back(*it);
  }
  hull.pop_back();
}

}  // namespace

std::vector<Vec3> vertices(const std::vector<Halfspace>& planes) {
  std::vector<Vec3> found;
  Vec3 point{};
  for (std::size_t i = 0; i < planes.size(); ++i) {
    for (std::size_t j = i + 1; j < planes.size(); ++j) {
      for (std::size_t k = j + 1; k < planes.size(); ++k) {
        if (intersect(planes[i], planes[j], planes[k], point) && inside(planes, point)) found.push_back(point);
      }
    }
  }
  return found;
}

std::vector<Pixel> convex_hull(std::vector<Pixel> points) {
  if (points.size() < 3) return {};
  std::sort(points.begin(), points.end(),
            [](const Pixel& a, const Pixel& b) { return std::tie(a.x, a.y) < std::tie(b.x, b.y); });
  std::vector<Pixel> hull;
  append_chain(points.begin(), points.end(), hull);
  append_chain(points.rbegin(), points.rend(), hull);
  return hull;
}

}  // namespace tern_host
