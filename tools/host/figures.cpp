// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/figures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tern/flatness.hpp"

namespace tern_host {
namespace {

using tern::Vec3;

constexpr double kSampleStep = 1e-3;
constexpr double kMaxSamples = 2e6;
constexpr double kLengthSlack = 1e-9;  // m, above the rounding of a summed length

double norm(const Vec3& v) {
  return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
}

Vec3 difference(const Vec3& a, const Vec3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

void raise(Vec3& peak, const Vec3& v) {
  peak = {std::max(peak.x, std::fabs(v.x)), std::max(peak.y, std::fabs(v.y)), std::max(peak.z, std::fabs(v.z))};
}

void widen(PeakRange& range, const Vec3& v) {
  range.least = {std::min(range.least.x, v.x), std::min(range.least.y, v.y), std::min(range.least.z, v.z)};
  range.most = {std::max(range.most.x, v.x), std::max(range.most.y, v.y), std::max(range.most.z, v.z)};
  range.horizontal = std::max(range.horizontal, std::hypot(v.x, v.y));
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

void widen_thrust(Figures& figures, const tern::Sample& sample) {
  const Vec3& j = sample.jerk;
  const Vec3 f{sample.acceleration.x, sample.acceleration.y, sample.acceleration.z + tern::kGravity};
  const double thrust = norm(f);
  figures.thrust_least = std::min(figures.thrust_least, thrust);
  figures.thrust_most = std::max(figures.thrust_most, thrust);
  figures.tilt = std::max(figures.tilt, std::atan2(std::hypot(f.x, f.y), f.z));
  const double turn = norm({j.y * f.z - j.z * f.y, j.z * f.x - j.x * f.z, j.x * f.y - j.y * f.x});
  figures.rate = std::max(figures.rate, turn / (thrust * thrust));
}

double outside(double value, double lower, double upper) {
  return std::max({lower - value, value - upper, 0.0});
}

}  // namespace

double distance_to_blocks(const Vec3& p, const Scenario& scenario) {
  double least = std::numeric_limits<double>::infinity();  // squared
  for (const Block& block : scenario.blocks) {
    const Vec3& lo = block.box.lower;
    const Vec3& hi = block.box.upper;
    const Vec3 d{outside(p.x, lo.x, hi.x), outside(p.y, lo.y, hi.y), outside(p.z, lo.z, hi.z)};
    least = std::min(least, d.x * d.x + d.y * d.y + d.z * d.z);
  }
  return std::sqrt(least);
}

Figures measure(const tern::Trajectory& trajectory, const Scenario& scenario) {
  Figures figures;
  figures.duration = tern::duration(trajectory);
  figures.snap = tern::snap_cost(trajectory);
  figures.clearance = std::numeric_limits<double>::infinity();
  figures.thrust_least = figures.clearance;
  const double wanted = std::ceil(figures.duration / kSampleStep);
  const int samples = static_cast<int>(std::max(1.0, std::min(wanted, kMaxSamples)));
  const LimitRange velocity = velocity_range(scenario.limits);
  const LimitRange acceleration = acceleration_range(scenario.limits);
  const LimitRange jerk = jerk_range(scenario.limits);
  Vec3 last = tern::evaluate(trajectory, 0.0).position;
  // A distance shrinks by no more than the way flown: until then no sample is closer than the closest so far.
  double look_again = 0.0;
  for (int i = 0; i <= samples; ++i) {
    const tern::Sample sample = tern::evaluate(trajectory, figures.duration * i / samples);
    figures.length += norm(difference(sample.position, last));
    last = sample.position;
    raise(figures.v_peak, sample.velocity);
    raise(figures.a_peak, sample.acceleration);
    widen(figures.v_range, sample.velocity);
    widen(figures.a_range, sample.acceleration);
    widen(figures.j_range, sample.jerk);
    widen_thrust(figures, sample);
    figures.speed = std::max(figures.speed, norm(sample.velocity));
    figures.acceleration = std::max(figures.acceleration, norm(sample.acceleration));
    figures.v_use = std::max(figures.v_use, use(sample.velocity, velocity));
    figures.a_use = std::max(figures.a_use, use(sample.acceleration, acceleration));
    figures.j_use = std::max(figures.j_use, use(sample.jerk, jerk));
    if (figures.length < look_again) continue;
    const double distance = distance_to_blocks(sample.position, scenario);
    figures.clearance = std::min(figures.clearance, distance);
    look_again = figures.length + (distance - figures.clearance) - kLengthSlack;
  }
  return figures;
}

}  // namespace tern_host
