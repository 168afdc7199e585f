// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A planner with soft constraints, written for the comparison: a uniform cubic B-spline whose control points are moved
// by L-BFGS (NLopt's) to lessen a sum of smoothness and penalties for collision, speed and acceleration. One of that
// kind of planner; it is not anybody's published one.
#ifndef TERN_BENCH_SOFT_BSPLINE_HPP
#define TERN_BENCH_SOFT_BSPLINE_HPP

#include <vector>

#include "host/scenario.hpp"
#include "tern/trajectory.hpp"

namespace tern_bench {

/// A uniform cubic B-spline from rest to rest: the first and the last three control points coincide. World frame.
struct BSpline {
  double interval = 0.0;  ///< seconds between knots
  std::vector<tern::Vec3> points;

  double duration() const { return interval * static_cast<double>(points.size() - 3); }
  /// Position, velocity, acceleration and jerk at t, clamped to [0, duration]; snap is 0 within an interval.
  tern::Sample evaluate(double t) const;
};

struct SoftWeights {
  double smoothness = 1.0;  ///< of the squared third differences of control points, 1/m^2
  double collision = 40.0;  ///< of the squared depth below the clearance wanted, 1/m^2
  double limits = 1.0;      ///< of the squared excess over speed (s^2/m^2) and acceleration (s^4/m^2)
  double margin = 0.15;     ///< clearance wanted beyond the radius, metres: the curve cuts corners between its points
  double spacing = 0.4;     ///< between control points at first, metres
  double pace = 1.5;        ///< interval, as a multiple of spacing over v_max
  int evaluations = 300;    ///< of the cost, a round
  int rounds = 4;           ///< while the curve hits something, each with five times the weight on collision
};

struct SoftResult {
  BSpline curve;
  int rounds = 0;
  int evaluations = 0;
  bool clear = false;  ///< keeps the radius at every sample
};

/// Optimises from a collision-free chain of points, start and goal included (two at least). Distances to the blocks are
/// exact, not those of a field on a grid. Limits: v_max and a_max of the scenario, an axis at a time.
SoftResult soft_bspline(const std::vector<tern::Vec3>& chain, const tern_host::Scenario& scenario,
                        const SoftWeights& weights = {});

/// Distance of a point to the nearest block, negative inside, and its gradient. Infinite without blocks.
double signed_distance(const tern::Vec3& point, const tern_host::Scenario& scenario, tern::Vec3& gradient);

/// The cost and its gradient at control points 3 .. n - 4 of `curve` (three values each), for tests.
double soft_cost(const BSpline& curve, const tern_host::Scenario& scenario, const SoftWeights& weights,
                 std::vector<double>& gradient);

}  // namespace tern_bench

#endif
