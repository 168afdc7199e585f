// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Cases that are too much for the tiny profile.
#ifndef TERN_TESTS_SUPPORT_TINY_CASES_HPP
#define TERN_TESTS_SUPPORT_TINY_CASES_HPP

#include <vector>

#include "support/qp_random.hpp"
#include "support/world.hpp"

namespace tern_test {

/// Walls across y with doors at alternating ends: a path of many turns. One voxel high, so that the turns run out
/// before the nodes do.
inline World slalom(int walls) {
  World world({4 * walls + 4, 12, 1}, 0.25, 0.0);
  for (int i = 0; i < walls; ++i) {
    const double x = 1.0 * (i + 1);
    world.block({x, i % 2 == 0 ? 0.0 : 0.5, 0.0}, {x + 0.25, i % 2 == 0 ? 2.5 : 3.0, 0.25});
  }
  world.from({0.375, 0.375, 0.125}).to({walls + 0.625, 0.375, 0.125});
  return world;
}

/// A random programme of many tight rows, solved from a warm start that does not help: it takes many iterations.
/// Twelve dimensions leave room for every working set.
inline tern::Status solve_tight_programme(Random& random, QpBench& bench) {
  QpRecipe recipe;
  recipe.unknowns = 4;
  recipe.groups = 4;
  recipe.points = 9;
  recipe.planes = 10;
  recipe.room = 0.02;
  random_programme(random, recipe, bench);
  std::vector<tern::QpConstraint> rows;
  for (int j = 0; j < tern::kMaxActive; ++j) {
    const int point = random.integer(0, bench.problem->point_count - 1);
    rows.push_back({point, random.integer(0, bench.problem->plane_count - 1)});
  }
  return bench.solve_from(rows);
}

}  // namespace tern_test

#endif
