// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where the beams of scanners look, and which beam shows what lies between them.
#ifndef TERN_TESTS_SUPPORT_SCAN_PATTERNS_HPP
#define TERN_TESTS_SUPPORT_SCAN_PATTERNS_HPP

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/random.hpp"
#include "tern/vec3.hpp"

namespace tern_test {

/// A range that says that nothing is there.
constexpr double kNothing = 1e9;
constexpr double kTurn = 6.283185307179586;

inline tern::Vec3 random_direction(Random& random) {
  const double z = random.real(-1, 1), turn = random.real(0, kTurn), flat = std::sqrt(1 - z * z);
  return {flat * std::cos(turn), flat * std::sin(turn), z};
}

inline double cosine_of(const tern::Vec3& a, const tern::Vec3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// How a sensor shows what lies between its beams.
enum class Parts {
  kCells,    ///< a beam shows its cell of the rows and columns
  kNearest,  ///< the nearest beam shows a direction, unless it is too far away
  kFarthest  ///< the farthest of those that are not too far away
};

/// Unit vectors in the sensor's frame. The view is a band of elevations, less a cone without beams.
struct Pattern {
  std::vector<tern::Vec3> beams;
  Parts parts = Parts::kNearest;
  double lowest = 0.0, highest = 0.0;  ///< the view's elevations, radians
  tern::Vec3 hole{0, 0, 1};
  double hole_cosine = 2.0;  ///< 2: no hole
  double reach = 0.0;        ///< the furthest that a beam answers for, radians
  double unknown = 0.0;      ///< share of the beams that know nothing
  int columns = 0, rows = 0;
  std::vector<int> cells;  ///< the beam of each cell, or -1

  bool in_view(const tern::Vec3& unit) const {
    const double elevation = std::asin(std::clamp(unit.z, -1.0, 1.0));
    return elevation >= lowest && elevation <= highest && cosine_of(unit, hole) < hole_cosine;
  }
  int cell_of(const tern::Vec3& unit) const {
    const double turn = std::atan2(unit.y, unit.x);
    const int c = static_cast<int>((turn < 0 ? turn + kTurn : turn) / kTurn * columns);
    const int r = static_cast<int>((std::asin(unit.z) - lowest) / (highest - lowest) * rows);
    return std::min(c, columns - 1) * rows + std::min(r, rows - 1);
  }
  /// The beam that shows what lies in this direction, or -1.
  int owner(const tern::Vec3& unit) const {
    if (!in_view(unit)) return -1;
    if (parts == Parts::kCells) return cells[static_cast<std::size_t>(cell_of(unit))];
    const double least = std::cos(reach);
    int best = -1;
    double best_cosine = parts == Parts::kNearest ? -2.0 : 2.0;
    for (std::size_t k = 0; k < beams.size(); ++k) {
      const double cosine = cosine_of(unit, beams[k]);
      const bool better = parts == Parts::kNearest ? cosine > best_cosine : cosine < best_cosine;
      if (cosine < least || !better) continue;
      best = static_cast<int>(k);
      best_cosine = cosine;
    }
    return best;
  }
  void add(const tern::Vec3& unit) {
    const bool shines = cosine_of(unit, hole) < hole_cosine;
    if (parts == Parts::kCells) cells.push_back(shines ? static_cast<int>(beams.size()) : -1);
    if (shines) beams.push_back(unit);
  }
};

inline tern::Vec3 direction(double turn, double elevation) {
  return {std::cos(elevation) * std::cos(turn), std::cos(elevation) * std::sin(turn), std::sin(elevation)};
}

/// Rows and columns, so far apart at most; `loose`: a beam is anywhere in its cell.
inline void add_grid(Random& random, Pattern& pattern, double column, double row, bool loose) {
  pattern.parts = Parts::kCells;
  pattern.columns = static_cast<int>(std::ceil(kTurn / column));
  pattern.rows = static_cast<int>(std::ceil((pattern.highest - pattern.lowest) / row));
  const double high = (pattern.highest - pattern.lowest) / pattern.rows;
  for (int c = 0; c < pattern.columns; ++c) {
    for (int r = 0; r < pattern.rows; ++r) {
      const double u = loose ? random.unit() : 0.5, v = loose ? random.unit() : 0.5;
      pattern.add(direction((c + u) * kTurn / pattern.columns, pattern.lowest + (r + v) * high));
    }
  }
}

/// A pattern that never repeats itself: evenly spread, or all by chance, which leaves holes.
inline void add_rosette(Random& random, Pattern& pattern, int count, bool even) {
  const double bottom = std::sin(pattern.lowest), top = std::sin(pattern.highest);
  double turn = random.unit(), height = random.unit();
  for (int k = 0; k < count; ++k) {
    turn += even ? 0.7548776662466927 : random.unit();
    height += even ? 0.5698402909980532 : random.unit();
    turn -= std::floor(turn);
    height -= std::floor(height);
    pattern.add(direction(kTurn * turn, std::asin(bottom + (top - bottom) * height)));
  }
}

/// A sensor that keeps its promise for this scan_pixel. Wide beams: rows and columns half a pixel apart, 16 rings, or a
/// rosette with holes. Thin beams: rows and columns, 16 rings, or an even rosette, no direction too far from a beam.
inline Pattern random_pattern(Random& random, double pixel, bool thin) {
  Pattern pattern;
  pattern.reach = 1.25 * pixel;
  pattern.lowest = random.chance(0.5) ? -kTurn / 4 : random.real(-1.2, -0.2);
  pattern.highest = random.chance(0.5) ? kTurn / 4 : random.real(0.2, 1.2);
  const int kind = random.integer(0, 2);
  if (kind == 1) {
    pattern.highest = 8 * pixel / 2;
    pattern.lowest = -pattern.highest;
  }
  if (random.chance(0.3)) {
    pattern.hole = random_direction(random);
    pattern.hole_cosine = std::cos(random.real(1.5, 4.0) * pixel);
  }
  if (!thin && random.chance(0.3)) pattern.unknown = 0.02;
  if (kind == 0) add_grid(random, pattern, pixel / 2, pixel / 2, !thin && random.chance(0.5));
  if (kind == 1) add_grid(random, pattern, pixel / (thin ? 8 : 2), pixel / 2, false);
  const double area = kTurn * (std::sin(pattern.highest) - std::sin(pattern.lowest)) / (pixel * pixel);
  if (kind == 2) add_rosette(random, pattern, static_cast<int>((thin ? 10.0 : random.real(0.5, 6.0)) * area), thin);
  if (!thin && random.chance(0.5)) pattern.parts = random.chance(0.5) ? Parts::kNearest : Parts::kFarthest;
  return pattern;
}

}  // namespace tern_test

#endif
