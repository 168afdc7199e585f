// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Random quadratic programmes with everything that makes them hard: redundant, duplicate, near-parallel and zero rows,
// constant points, vertices with more rows than unknowns, badly scaled Hessians, contradictions.
#ifndef TERN_TESTS_SUPPORT_QP_RANDOM_HPP
#define TERN_TESTS_SUPPORT_QP_RANDOM_HPP

#include <algorithm>
#include <cmath>

#include "support/qp_dense.hpp"
#include "support/random.hpp"

namespace tern_test {

/// What a random programme is made of.
struct QpRecipe {
  int unknowns = 4;  ///< per axis
  int groups = 2;
  int points = 4;      ///< a group, at most
  int planes = 6;      ///< a group, at most
  double scale = 1.0;  ///< ratio between the largest and the smallest unit of an unknown
  double room = 1.0;   ///< bounds keep an inner point by up to this; negative contradicts
};

inline tern::Vec3 random_unit(Random& random) {
  for (int attempt = 0; attempt < 100; ++attempt) {
    const tern::Vec3 v{random.real(-1, 1), random.real(-1, 1), random.real(-1, 1)};
    const double squared = v.x * v.x + v.y * v.y + v.z * v.z;
    if (squared > 1.0 || squared < 0.01) continue;
    const double length = std::sqrt(squared);
    return {v.x / length, v.y / length, v.z / length};
  }
  return {1.0, 0.0, 0.0};
}

/// H = S G G' S with a random banded G and random scales S.
inline void random_hessian(Random& random, const QpRecipe& recipe, QpBench& bench, Column& unit) {
  const int n = recipe.unknowns;
  bench.start(Column(static_cast<std::size_t>(n), 0.0));
  std::vector<Column> g(static_cast<std::size_t>(n), Column(static_cast<std::size_t>(n), 0.0));
  unit.clear();
  for (int i = 0; i < n; ++i) {
    const auto row = static_cast<std::size_t>(i);
    for (int j = std::max(0, i - tern::kQpBand); j < i; ++j) g[row][static_cast<std::size_t>(j)] = random.real(-1, 1);
    g[row][row] = random.real(0.5, 2.0);
    unit.push_back(std::pow(recipe.scale, random.real(-0.5, 0.5)));
    for (int c = 0; c < 3; ++c) bench.pull(c, i, random.real(-5, 5) * unit[row]);
  }
  for (int i = 0; i < n; ++i) {
    for (int d = 0; d <= std::min(i, tern::kQpBand); ++d) {
      const auto r = static_cast<std::size_t>(i);
      const auto s = static_cast<std::size_t>(i - d);
      bench.problem->hessian[i][d] = dense_dot(g[r], g[s]) * unit[r] * unit[s];
    }
  }
}

inline void random_point(Random& random, const QpRecipe& recipe, const Column& unit, QpBench& bench) {
  const tern::Vec3 offset{random.real(-2, 2), random.real(-2, 2), random.real(-2, 2)};
  if (bench.problem->point_count > 0 && random.chance(0.1)) {
    bench.problem->points[bench.problem->point_count] = bench.problem->points[bench.problem->point_count - 1];
    ++bench.problem->point_count;
    return;
  }
  if (random.chance(0.05)) {
    bench.add_point(offset, 0, {});
    return;
  }
  const int terms = random.integer(1, std::min(recipe.unknowns, tern::kQpPointTerms));
  const int first = random.integer(0, recipe.unknowns - terms);
  Column coefficients;
  for (int t = 0; t < terms; ++t) {
    coefficients.push_back(random.real(-1, 1) * unit[static_cast<std::size_t>(first + t)]);
  }
  bench.add_point(offset, first, coefficients);
}

/// A new normal, or one that nearly repeats an earlier one of the group, or zero.
inline tern::Vec3 random_normal(Random& random, int begin, QpBench& bench) {
  const int count = bench.problem->plane_count;
  if (count > begin && random.chance(0.2)) {
    tern::Vec3 normal = bench.problem->planes[random.integer(begin, count - 1)].normal;
    const double tilt = random.chance(0.5) ? 0.0 : std::pow(10.0, random.real(-13, -2));
    const double factor = random.chance(0.5) ? 1.0 : random.real(0.1, 10.0);
    return {factor * (normal.x + tilt), factor * (normal.y - tilt), factor * normal.z};
  }
  if (random.chance(0.03)) return {0.0, 0.0, 0.0};
  if (random.chance(0.7)) return random_unit(random);
  const int axis = random.integer(0, 2);
  const double side = random.chance(0.5) ? 1.0 : -1.0;
  return {axis == 0 ? side : 0.0, axis == 1 ? side : 0.0, axis == 2 ? side : 0.0};
}

/// Planes that keep `inside` of every point of the group, by the room given.
inline void random_planes(Random& random, const QpRecipe& recipe, const std::vector<tern::Vec3>& inside,
                          QpBench& bench) {
  const int begin = bench.problem->plane_count;
  const int count = random.integer(1, recipe.planes);
  for (int p = 0; p < count; ++p) {
    const tern::Vec3 normal = random_normal(random, begin, bench);
    double most = -1e300;
    for (const tern::Vec3& q : inside) most = std::max(most, normal.x * q.x + normal.y * q.y + normal.z * q.z);
    bench.add_plane(normal, most + (random.chance(0.1) ? 0.0 : random.real(0.0, 1.0) * recipe.room));
  }
}

/// A programme with a feasible point where recipe.room >= 0.
inline void random_programme(Random& random, const QpRecipe& recipe, QpBench& bench) {
  Column unit;
  random_hessian(random, recipe, bench, unit);
  std::vector<tern::Vec3> inner;
  for (const double u : unit) inner.push_back({random.real(-1, 1) / u, random.real(-1, 1) / u, random.real(-1, 1) / u});
  for (int g = 0; g < recipe.groups; ++g) {
    const int point_begin = bench.problem->point_count;
    const int plane_begin = bench.problem->plane_count;
    const int count = random.integer(1, recipe.points);
    std::vector<tern::Vec3> inside;
    for (int k = 0; k < count; ++k) {
      random_point(random, recipe, unit, bench);
      const tern::QpPoint& point = bench.problem->points[bench.problem->point_count - 1];
      tern::Vec3 value = point.offset;
      for (int t = 0; t < point.terms; ++t) {
        const tern::Vec3& x = inner[static_cast<std::size_t>(point.first + t)];
        value.x += point.coefficient[t] * x.x;
        value.y += point.coefficient[t] * x.y;
        value.z += point.coefficient[t] * x.z;
      }
      inside.push_back(value);
    }
    random_planes(random, recipe, inside, bench);
    bench.add_group(point_begin, bench.problem->point_count, plane_begin, bench.problem->plane_count);
  }
}

}  // namespace tern_test

#endif
