// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_TESTS_ATTACK_STRAIGHT_PLAN_HPP
#define TERN_TESTS_ATTACK_STRAIGHT_PLAN_HPP

#include "tern/tern.hpp"

namespace tern_attack {

/// 4 m along x in 2 s, for tests of the checkers.
inline tern::Trajectory straight_plan() {
  tern::Trajectory plan{};
  plan.count = 1;
  plan.segments[0].duration = 2.0;
  for (int k = 0; k < tern::kControlPoints; ++k) plan.segments[0].points[k] = {4.0 * k / 7.0, 0.0, 0.0};
  return plan;
}

}  // namespace tern_attack

#endif
