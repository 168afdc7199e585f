// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "verify/polyhedron.hpp"

namespace tern_verify {
namespace {

/// What three half-spaces prove of n . p, if their multipliers are >= 0.
std::optional<Rational> proven_by(const HalfSpace& a, const HalfSpace& b, const HalfSpace& c, const Point& n) {
  const Point bc = cross(b.normal, c.normal);
  const Rational volume = dot(a.normal, bc);
  if (volume == 0) return {};
  const Rational x = -dot(n, bc) / volume;
  const Rational y = -dot(n, cross(c.normal, a.normal)) / volume;
  const Rational z = -dot(n, cross(a.normal, b.normal)) / volume;
  if (x < 0 || y < 0 || z < 0) return {};
  return -(x * a.offset + y * b.offset + z * c.offset);
}

}  // namespace

Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

std::vector<HalfSpace> cut_to(const Box& boundary, const Rational& reach, std::vector<HalfSpace> planes) {
  for (std::size_t a = 0; a < 3; ++a) {
    Point axis{0, 0, 0};
    axis[a] = 1;
    planes.push_back({axis, boundary.upper[a] + reach});
    axis[a] = -1;
    planes.push_back({axis, -(boundary.lower[a] - reach)});
  }
  return planes;
}

std::optional<Rational> least_along(const Point& n, const std::vector<HalfSpace>& planes) {
  std::optional<Rational> best;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    for (std::size_t j = i + 1; j < planes.size(); ++j) {
      for (std::size_t k = j + 1; k < planes.size(); ++k) {
        const std::optional<Rational> proven = proven_by(planes[i], planes[j], planes[k], n);
        if (proven && (!best || *proven > *best)) best = proven;
      }
    }
  }
  return best;
}

}  // namespace tern_verify
