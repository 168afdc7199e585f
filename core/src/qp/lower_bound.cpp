// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "qp/solver.hpp"

namespace tern {

double qp_lower_bound(const QpSolver& solver) noexcept {
  if (solver.phase != QpPhase::kPrice && solver.phase != QpPhase::kStep) return -kQpNoBound;
  // z minimises the Lagrangian of the current multipliers. Active rows hold with equality and the entering row is
  // violated, so the dual objective is at least the cost at z. That cost is a distance from the target.
  double distance_squared = 0.0;
  double target_squared = 0.0;
  for (int i = 0; i < solver.dimension; ++i) {
    const double off = solver.z[i] - solver.target[i];
    distance_squared += off * off;
    target_squared += solver.target[i] * solver.target[i];
  }
  return 0.5 * (distance_squared - target_squared);
}

}  // namespace tern
