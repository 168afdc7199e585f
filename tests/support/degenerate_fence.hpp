// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Keep-outs that are hard on arithmetic: needles, blades, plates, planes that are equal, nearly equal or nearly
// opposite; and their corners by trying every three planes, in long double.
#ifndef TERN_TESTS_SUPPORT_DEGENERATE_FENCE_HPP
#define TERN_TESTS_SUPPORT_DEGENERATE_FENCE_HPP

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "support/random.hpp"
#include "tern/fence.hpp"

namespace tern_test {

using Real = long double;
using Point = std::array<Real, 3>;

inline Real dot_of(const Point& a, const Point& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Point cross_of(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline Point point_of(const tern::Vec3& v) {
  return {v.x, v.y, v.z};
}

/// Half-spaces of a keep-out about `center`; `size` is how far its planes may lie from there.
class DegenerateFence {
 public:
  DegenerateFence(Random& random, const tern::Vec3& center, double size)
      : random_(random), center_(center), size_(size) {
    if (random.chance(0.25)) add_needle();
    if (random.chance(0.25)) add_bundle();
    for (int k = random.integer(1, 6); k > 0; --k) add_with_twins();
  }

  std::vector<tern::Halfspace> planes;

 private:
  void add(const tern::Vec3& n, double offset) {
    const double norm = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
    if (norm < 1e-2 || planes.size() == 40) return;
    const double k = random_.chance(0.5) ? 1.0 / norm : std::pow(10.0, random_.real(-3.0, 3.0));
    planes.push_back(
        {{n.x * k, n.y * k, n.z * k}, (n.x * center_.x + n.y * center_.y + n.z * center_.z) * k + offset * norm * k});
  }

  tern::Vec3 near(const tern::Vec3& n, double by) {
    return {n.x + by * random_.real(-1.0, 1.0), n.y + by * random_.real(-1.0, 1.0), n.z + by * random_.real(-1.0, 1.0)};
  }

  void add_with_twins() {
    const tern::Vec3 n{random_.real(-1.0, 1.0), random_.real(-1.0, 1.0),
                       random_.chance(0.4) ? 0.0 : random_.real(-1.0, 1.0)};
    const double offset = random_.real(0.05, 1.2) * size_;
    add(n, offset);
    for (int k = random_.integer(0, 3); k > 0; --k) {
      const double by = std::pow(10.0, -random_.real(1.0, 14.0));
      const int kind = random_.integer(0, 2);
      if (kind == 0) add(near(n, by), offset + by * random_.real(-1.0, 1.0));
      if (kind == 1) add(near({-n.x, -n.y, -n.z}, by), random_.chance(0.5) ? by - offset : random_.real(0.0, 0.5));
      if (kind == 2) add(n, offset + random_.real(0.0, 1e-9));
    }
  }

  void add_needle() {
    const double thin = std::pow(10.0, -random_.real(1.0, 8.0));
    add({0.0, 1.0, thin}, 0.05 * size_);
    add({0.0, -1.0, thin}, 0.05 * size_);
    add({thin, thin, 1.0}, 0.3 * size_);
    add({1.0, thin, 0.0}, 0.4 * size_);
    add({-1.0, 0.0, thin}, 0.4 * size_);
  }

  void add_bundle() {
    const tern::Vec3 n{random_.real(-1.0, 1.0), random_.real(-1.0, 1.0), random_.real(-1.0, 1.0)};
    const double by = std::pow(10.0, -random_.real(1.0, 14.0));
    const double offset = random_.real(0.05, 1.0) * size_;
    for (int k = random_.integer(3, 8); k > 0; --k) add(near(n, by), offset + 0.1 * by * random_.real(-1.0, 1.0));
  }

  Random& random_;
  tern::Vec3 center_;
  double size_;
};

/// Unit normals in long double: the fence's half-spaces, then the box's faces.
struct Planes {
  std::vector<Point> normal;
  std::vector<Real> offset;

  void add(const Point& n, Real o) {
    const Real norm = std::sqrt(dot_of(n, n));
    normal.push_back({n[0] / norm, n[1] / norm, n[2] / norm});
    offset.push_back(o / norm);
  }
  Real beyond(std::size_t k, const Point& p) const { return dot_of(normal[k], p) - offset[k]; }
  /// How far the point is beyond the half-space that it is furthest beyond.
  Real worst(const Point& p) const {
    Real most = beyond(0, p);
    for (std::size_t k = 1; k < normal.size(); ++k) most = std::max(most, beyond(k, p));
    return most;
  }
};

inline Planes planes_of(const std::vector<tern::Halfspace>& fence, const tern::Box& box, double grown) {
  Planes planes;
  for (const tern::Halfspace& h : fence) planes.add(point_of(h.normal), h.offset);
  const Point lower = point_of(box.lower);
  const Point upper = point_of(box.upper);
  for (std::size_t a = 0; a < 3; ++a) {
    Point n{0.0L, 0.0L, 0.0L};
    n[a] = 1.0L;
    planes.add(n, upper[a] + grown);
    n[a] = -1.0L;
    planes.add(n, grown - lower[a]);
  }
  return planes;
}

/// The points where three planes meet that are outside none by more than `tolerance`.
inline std::vector<Point> corners_of(const Planes& planes, Real tolerance) {
  std::vector<Point> corners;
  const std::size_t count = planes.normal.size();
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 1; j < count; ++j) {
      for (std::size_t k = j + 1; k < count; ++k) {
        const Point a = cross_of(planes.normal[j], planes.normal[k]);
        const Point b = cross_of(planes.normal[k], planes.normal[i]);
        const Point c = cross_of(planes.normal[i], planes.normal[j]);
        const Real determinant = dot_of(planes.normal[i], a);
        if (std::fabs(determinant) < 1e-16L) continue;
        Point p;
        for (std::size_t e = 0; e < 3; ++e) {
          p[e] = (planes.offset[i] * a[e] + planes.offset[j] * b[e] + planes.offset[k] * c[e]) / determinant;
        }
        if (planes.worst(p) <= tolerance) corners.push_back(p);
      }
    }
  }
  return corners;
}

/// The nearest of the hull's points, but for 1e-9: steps towards the corner that is furthest along the way.
inline Point nearest_of_hull(const std::vector<Point>& corners, const Point& p) {
  Point at = corners[0];
  for (int step = 0; step < 300; ++step) {
    const Point d{at[0] - p[0], at[1] - p[1], at[2] - p[2]};
    const Point* best = &corners[0];
    for (const Point& c : corners) best = dot_of(d, c) < dot_of(d, *best) ? &c : best;
    const Point way{(*best)[0] - at[0], (*best)[1] - at[1], (*best)[2] - at[2]};
    const Real square = dot_of(way, way);
    const Real gain = -dot_of(d, way);
    if (!(gain > 1e-14L) || !(square > 0.0L)) break;
    const Real share = std::min(1.0L, gain / square);
    for (std::size_t e = 0; e < 3; ++e) at[e] += share * way[e];
  }
  return at;
}

}  // namespace tern_test

#endif
