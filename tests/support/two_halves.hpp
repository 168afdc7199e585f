// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_TESTS_SUPPORT_TWO_HALVES_HPP
#define TERN_TESTS_SUPPORT_TWO_HALVES_HPP

#include "tern/trajectory.hpp"

namespace tern_test {

/// x = t^3 (10 - 15 t + 6 t^2) metres over two seconds, the halves of it one segment each: from rest to rest. The
/// Bernstein coefficients of the whole, raised to degree 7, are 0, 0, 0, 2/7, 5/7, 1, 1, 1.
inline tern::Trajectory two_halves() {
  const double whole[] = {0.0, 0.0, 0.0, 2.0 / 7.0, 5.0 / 7.0, 1.0, 1.0, 1.0};
  tern::Trajectory t{};
  t.count = 2;
  double row[8];
  for (int i = 0; i < 8; ++i) row[i] = whole[i];
  for (int level = 0; level < 8; ++level) {
    t.segments[0].points[level].x = row[0];
    t.segments[1].points[7 - level].x = row[7 - level];
    for (int i = 0; i + 1 < 8 - level; ++i) row[i] = 0.5 * (row[i] + row[i + 1]);
  }
  t.segments[0].duration = t.segments[1].duration = 1.0;
  return t;
}

}  // namespace tern_test

#endif
