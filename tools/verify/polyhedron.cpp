// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Doubles guess which three half-spaces prove the most. They do if their corner is in the polyhedron. In exact numbers,
// all triples would take too long for each piece of each curve.
#include "verify/polyhedron.hpp"

#include <algorithm>
#include <cmath>

namespace tern_verify {
namespace {

/// Multipliers of unit normals for a direction of length 1 that are above this, negated, may be 0 or more.
constexpr double kSlack = 1e-9;

/// The point where three half-spaces end, if they prove that no point of theirs has less of n . p: their multipliers
/// are >= 0.
std::optional<Point> proven_corner(const HalfSpace& a, const HalfSpace& b, const HalfSpace& c, const Point& n) {
  const Point bc = cross(b.normal, c.normal);
  const Rational volume = dot(a.normal, bc);
  if (volume == 0) return {};
  const Rational sign = volume > 0 ? 1 : -1;
  if (sign * dot(n, bc) > 0) return {};
  const Point ca = cross(c.normal, a.normal);
  if (sign * dot(n, ca) > 0) return {};
  const Point ab = cross(a.normal, b.normal);
  if (sign * dot(n, ab) > 0) return {};
  return Rational(1 / volume) * (a.offset * bc + b.offset * ca + c.offset * ab);
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

Extent::Extent(const std::vector<HalfSpace>& planes) {
  for (const HalfSpace& plane : planes) {
    const Guess n = guess(plane.normal);
    const double length = std::sqrt(dot(n, n));
    planes_.push_back({plane, {n[0] / length, n[1] / length, n[2] / length}, guess(plane.offset) / length});
  }
  for (std::size_t i = 0; i < planes.size(); ++i) {
    for (std::size_t j = i + 1; j < planes.size(); ++j) {
      for (std::size_t k = j + 1; k < planes.size(); ++k) add(i, j, k);
    }
  }
}

void Extent::add(std::size_t i, std::size_t j, std::size_t k) {
  const Guess &a = planes_[i].normal, &b = planes_[j].normal, &c = planes_[k].normal;
  Triple triple{{i, j, k}, {cross(b, c), cross(c, a), cross(a, b)}};
  const double volume = dot(a, triple.rows[0]);
  for (Guess& row : triple.rows) {
    for (double& x : row) x /= volume;
  }
  triples_.push_back(triple);
}

Extent::Candidate Extent::candidate(const Triple& triple, const Guess& n) const {
  Candidate found{&triple, true, 0.0};
  for (std::size_t k = 0; k < 3; ++k) {
    const double multiplier = -dot(n, triple.rows[k]);
    found.is_likely = found.is_likely && multiplier > -kSlack && std::isfinite(multiplier);
    found.least -= multiplier * planes_[triple.planes[k]].offset;
  }
  found.is_likely = found.is_likely && std::isfinite(found.least);
  if (!found.is_likely) found.least = 0.0;
  return found;
}

std::optional<Rational> Extent::least_along(const Point& n) const {
  Guess along = guess(n);
  const double length = std::sqrt(dot(along, along));
  for (double& x : along) x /= length;
  std::vector<Candidate> candidates;
  for (const Triple& triple : triples_) candidates.push_back(candidate(triple, along));
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    return a.is_likely != b.is_likely ? a.is_likely : a.least > b.least;
  });
  std::optional<Rational> best;
  for (const Candidate& c : candidates) {
    const auto& [i, j, k] = c.triple->planes;
    const std::optional<Point> corner = proven_corner(planes_[i].exact, planes_[j].exact, planes_[k].exact, n);
    if (!corner) continue;
    const Rational least = dot(n, *corner);
    if (!best || least > *best) best = least;
    if (holds(*corner)) return least;
  }
  return best;
}

bool Extent::holds(const Point& point) const {
  return std::all_of(planes_.begin(), planes_.end(),
                     [&point](const Plane& plane) { return dot(plane.exact.normal, point) <= plane.exact.offset; });
}

}  // namespace tern_verify
