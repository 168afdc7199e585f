// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "verify/emptiness.hpp"

#include <algorithm>
#include <array>

#include "verify/polyhedron.hpp"

namespace tern_verify {
namespace {

/// Rounds of projections for a common point; where they find none, four half-spaces are asked for a proof that there is
/// none.
constexpr int kRounds = 50;

Rational determinant(const Point& a, const Point& b, const Point& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/// About a point, each moved out by a nanometre.
std::vector<HalfSpace> grown_about(const Point& center, const std::vector<HalfSpace>& planes) {
  std::vector<HalfSpace> grown;
  for (const HalfSpace& plane : planes) {
    const Rational by = decimal(1, 9) * root_above(dot(plane.normal, plane.normal));
    grown.push_back({plane.normal, plane.offset - dot(plane.normal, center) + by});
  }
  return grown;
}

Rational farthest(const std::vector<HalfSpace>& planes, const Rational& size) {
  Rational most = size;
  for (const HalfSpace& plane : planes) {
    const Rational away = abs(plane.offset) / root_below(dot(plane.normal, plane.normal));
    most = std::max(most, away);
  }
  return most;
}

/// A point of all of them, found by projecting onto each that does not hold it. Doubles only guess where to.
bool finds_point(const std::vector<HalfSpace>& planes) {
  Point at{0, 0, 0};
  for (int round = 0; round < kRounds; ++round) {
    bool holds = true;
    for (const HalfSpace& plane : planes) {
      const Rational beyond = dot(plane.normal, at) - plane.offset;
      if (beyond <= 0) continue;
      holds = false;
      const Rational step = beyond / dot(plane.normal, plane.normal);
      for (std::size_t a = 0; a < 3; ++a) at[a] = (at[a] - step * plane.normal[a]).convert_to<double>();
    }
    if (holds) return true;
  }
  return false;
}

/// Multipliers >= 0 under which the normals vanish and the offsets sum to less than 0: no point can hold all four.
bool proves_empty(const std::array<const HalfSpace*, 4>& planes) {
  std::array<Rational, 4> m;
  for (std::size_t k = 0; k < 4; ++k) {
    std::array<const Point*, 3> others{};
    std::size_t count = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      if (i != k) others[count++] = &planes[i]->normal;
    }
    m[k] = determinant(*others[0], *others[1], *others[2]);
    if (k % 2 == 1) m[k] = -m[k];
  }
  const bool positive = std::all_of(m.begin(), m.end(), [](const Rational& x) { return x >= 0; });
  const bool negative = std::all_of(m.begin(), m.end(), [](const Rational& x) { return x <= 0; });
  if (positive == negative) return false;  // of both signs, or all of them 0
  Rational sum = 0;
  for (std::size_t k = 0; k < 4; ++k) sum += abs(m[k]) * planes[k]->offset;
  return sum < 0;
}

/// In the box of this half edge, there are as many half-spaces as a proof needs, whatever the normals are (Helly).
bool four_prove_it(const std::vector<HalfSpace>& planes) {
  const std::size_t n = planes.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      for (std::size_t k = j + 1; k < n; ++k) {
        for (std::size_t l = k + 1; l < n; ++l) {
          if (proves_empty({&planes[i], &planes[j], &planes[k], &planes[l]})) return true;
        }
      }
    }
  }
  return false;
}

}  // namespace

bool is_empty(const std::vector<HalfSpace>& planes, const Box& boundary) {
  const Point center = decimal(5, 1) * (boundary.lower + boundary.upper);
  const std::vector<HalfSpace> grown = grown_about(center, planes);
  if (finds_point(grown)) return false;
  const Point across = boundary.upper - boundary.lower;
  const Rational reach = 1000000 * farthest(grown, across[0] + across[1] + across[2] + 1);
  return four_prove_it(cut_to({{0, 0, 0}, {0, 0, 0}}, reach, grown));
}

std::optional<std::size_t> empty_fence(const std::vector<Fence>& fences, const Box& boundary) {
  std::vector<HalfSpace> inside;
  for (std::size_t f = 0; f < fences.size(); ++f) {
    const std::vector<HalfSpace>& planes = fences[f].planes;
    const bool joins = fences[f].keep_in && !fences[f].window;
    if (joins) inside.insert(inside.end(), planes.begin(), planes.end());
    if (is_empty(joins ? inside : planes, boundary)) return f;
  }
  return {};
}

std::string empty_text(const Fence& fence) {
  return fence.keep_in ? "no point is in this keep-in and those before it" : "the keep-out is empty: no point is in it";
}

}  // namespace tern_verify
