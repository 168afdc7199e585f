// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/figures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tern_host {
namespace {

using tern::Vec3;

constexpr double kSampleStep = 1e-3;
constexpr double kMaxSamples = 2e6;

double norm(const Vec3& v) {
  return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
}

Vec3 difference(const Vec3& a, const Vec3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

void raise(Vec3& peak, const Vec3& v) {
  peak = {std::max(peak.x, std::fabs(v.x)), std::max(peak.y, std::fabs(v.y)), std::max(peak.z, std::fabs(v.z))};
}

double part(double value, double lower, double upper) {
  return value < 0.0 ? value / lower : value / upper;
}

/// How far a value is towards its limits: 1 where it reaches one of them.
double use(const Vec3& v, const LimitRange& limit) {
  const double most = std::max({part(v.x, limit.lower.x, limit.upper.x), part(v.y, limit.lower.y, limit.upper.y),
                                part(v.z, limit.lower.z, limit.upper.z)});
  return limit.horizontal > 0.0 ? std::max(most, std::hypot(v.x, v.y) / limit.horizontal) : most;
}

double outside(double value, double lower, double upper) {
  return std::max({lower - value, value - upper, 0.0});
}

}  // namespace

double distance_to_blocks(const Vec3& p, const Scenario& scenario) {
  double least = std::numeric_limits<double>::infinity();
  for (const Block& block : scenario.blocks) {
    const Vec3& lo = block.box.lower;
    const Vec3& hi = block.box.upper;
    least = std::min(least, norm({outside(p.x, lo.x, hi.x), outside(p.y, lo.y, hi.y), outside(p.z, lo.z, hi.z)}));
  }
  return least;
}

Figures measure(const tern::Trajectory& trajectory, const Scenario& scenario) {
  Figures figures;
  figures.duration = tern::duration(trajectory);
  figures.snap = tern::snap_cost(trajectory);
  figures.clearance = std::numeric_limits<double>::infinity();
  const double wanted = std::ceil(figures.duration / kSampleStep);
  const int samples = static_cast<int>(std::max(1.0, std::min(wanted, kMaxSamples)));
  const LimitRange velocity = velocity_range(scenario.limits);
  const LimitRange acceleration = acceleration_range(scenario.limits);
  Vec3 last = tern::evaluate(trajectory, 0.0).position;
  for (int i = 0; i <= samples; ++i) {
    const tern::Sample sample = tern::evaluate(trajectory, figures.duration * i / samples);
    figures.length += norm(difference(sample.position, last));
    last = sample.position;
    raise(figures.v_peak, sample.velocity);
    raise(figures.a_peak, sample.acceleration);
    figures.speed = std::max(figures.speed, norm(sample.velocity));
    figures.acceleration = std::max(figures.acceleration, norm(sample.acceleration));
    figures.v_use = std::max(figures.v_use, use(sample.velocity, velocity));
    figures.a_use = std::max(figures.a_use, use(sample.acceleration, acceleration));
    figures.clearance = std::min(figures.clearance, distance_to_blocks(sample.position, scenario));
  }
  return figures;
}

}  // namespace tern_host
