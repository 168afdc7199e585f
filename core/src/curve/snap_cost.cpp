// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "curve/bezier.hpp"
#include "tern/trajectory.hpp"

namespace tern {

double snap_cost(const Trajectory& trajectory) noexcept {
  double cost = 0.0;
  const int count = trajectory.count < kMaxSegments ? trajectory.count : kMaxSegments;
  for (int i = 0; i < count; ++i) {
    const Curve snap = snap_of(trajectory.segments[i]);
    cost += integral_of_product(snap, snap, trajectory.segments[i].duration);
  }
  return cost;
}

}  // namespace tern
