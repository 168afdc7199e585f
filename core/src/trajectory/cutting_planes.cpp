// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/cutting_planes.hpp"

#include "base/math.hpp"

namespace tern {
namespace {

/// At the step's end, a plane may exceed the snap at the base by this part of its excess at its own durations: less
/// time is worth some snap.
constexpr double kAllowedRise = 0.5;
/// How often the weights of all planes are adjusted.
constexpr int kSweeps = 100;

int kept(const CuttingPlanes& planes) {
  return planes.found < kMaxCuttingPlanes ? planes.found : kMaxCuttingPlanes;
}

/// The least product of the step with the plane's prices; never more than 0, the product of no step.
double least_fall(const CuttingPlane& plane, double base_snap) {
  const double allowed = base_snap + kAllowedRise * larger(0.0, plane.snap - base_snap);
  return smaller(0.0, plane.at_base - allowed);
}

/// The dual of the step's problem, solved one coordinate after the other: each plane has a weight, 0 .. 1.
struct Weights {
  double of[kMaxCuttingPlanes];
  double gram[kMaxCuttingPlanes][kMaxCuttingPlanes];  ///< product of the step that one plane asks for with the prices
                                                      ///< of another
  double missing[kMaxCuttingPlanes];                  ///< by how much the step falls short on each plane
};

void take_weight(Weights& weights, int k, int planes) {
  if (!(weights.gram[k][k] > 0.0)) return;
  const double wish = weights.of[k] + weights.missing[k] / weights.gram[k][k];
  const double weight = smaller(1.0, larger(0.0, wish));
  const double change = weight - weights.of[k];
  weights.of[k] = weight;
  for (int j = 0; j < planes; ++j) weights.missing[j] -= change * weights.gram[k][j];
}

}  // namespace

void add_plane(CuttingPlanes& planes, double snap, const double* prices, const double* step, int count) noexcept {
  CuttingPlane& plane = planes.list[planes.found % kMaxCuttingPlanes];
  for (int i = 0; i < count; ++i) plane.prices[i] = prices[i];
  plane.snap = snap;
  plane.at_base = snap + sum_of_products(plane.prices, step, count);
  ++planes.found;
}

void move_base(CuttingPlanes& planes, const double* step, int count) noexcept {
  for (int k = 0; k < kept(planes); ++k) {
    planes.list[k].at_base -= sum_of_products(planes.list[k].prices, step, count);
  }
}

void bend_step(const CuttingPlanes& planes, const Curvature& curvature, double base_snap, int count,
               double* step) noexcept {
  const int last = kept(planes);
  Weights weights;
  double push[kMaxSegments];
  for (int k = 0; k < last; ++k) {
    const CuttingPlane& plane = planes.list[k];
    solve_curvature(curvature, plane.prices, count, push);
    weights.of[k] = 0.0;
    weights.missing[k] = least_fall(plane, base_snap) - sum_of_products(plane.prices, step, count);
    for (int j = 0; j < last; ++j) weights.gram[k][j] = sum_of_products(planes.list[j].prices, push, count);
  }
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    for (int k = 0; k < last; ++k) take_weight(weights, k, last);
  }
  double prices[kMaxSegments] = {};
  for (int k = 0; k < last; ++k) {
    for (int i = 0; i < count; ++i) prices[i] += weights.of[k] * planes.list[k].prices[i];
  }
  solve_curvature(curvature, prices, count, push);
  for (int i = 0; i < count; ++i) step[i] += push[i];
}

}  // namespace tern
