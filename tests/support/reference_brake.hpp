// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Brakes in closed form that share nothing with the core's: what a flight's answer to a threat is held against.
#ifndef TERN_TESTS_SUPPORT_REFERENCE_BRAKE_HPP
#define TERN_TESTS_SUPPORT_REFERENCE_BRAKE_HPP

#include <algorithm>
#include <cmath>
#include <vector>

#include "tern/request.hpp"
#include "tern/trajectory.hpp"
#include "tern/vec3.hpp"

namespace tern_test {

/// Straight ahead to rest: the jerk falls to zero in `settle`, then the acceleration goes over to a steady one in
/// `ramp`, stays, and goes back to none in `ramp`. The acceleration of each phase is a cubic in time, so speed and
/// place are polynomials too.
class ReferenceBrake {
 public:
  ReferenceBrake(const tern::Sample& from, double settle, double ramp, const tern::Limits& limits) {
    const double p[3] = {from.position.x, from.position.y, from.position.z};
    const double v[3] = {from.velocity.x, from.velocity.y, from.velocity.z};
    const double a[3] = {from.acceleration.x, from.acceleration.y, from.acceleration.z};
    const double j[3] = {from.jerk.x, from.jerk.y, from.jerk.z};
    double settled[3];
    double excess[3];  // the speed that is left once the first ramp has undone the acceleration
    for (int k = 0; k < 3; ++k) {
      settled[k] = a[k] + 0.5 * settle * j[k];
      excess[k] = v[k] + settle * (a[k] + settle * j[k] / 3.0) + 0.5 * ramp * settled[k];
    }
    const double level = limits.a_horizontal > 0.0 ? limits.a_horizontal : std::min(limits.a_max.x, limits.a_max.y);
    const double needed = std::max(std::hypot(excess[0], excess[1]) / level, std::abs(excess[2]) / limits.a_max.z);
    const double steady = std::max(ramp, needed);
    time_[0] = settle;
    time_[1] = time_[3] = ramp;
    time_[2] = steady - ramp;
    for (int k = 0; k < 3; ++k) {
      const double d = -excess[k] / steady;
      const double cubic[4][4] = {
          {a[k], j[k], settle > 0.0 ? -0.5 * j[k] / settle : 0.0, 0.0},
          {settled[k], 0.0, 3.0 * (d - settled[k]) / (ramp * ramp), -2.0 * (d - settled[k]) / (ramp * ramp * ramp)},
          {d, 0.0, 0.0, 0.0},
          {d, 0.0, -3.0 * d / (ramp * ramp), 2.0 * d / (ramp * ramp * ramp)}};
      double place = p[k];
      double speed = v[k];
      for (int phase = 0; phase < 4; ++phase) {
        Axis& axis = axes_[phase][k];
        axis.p = place;
        axis.v = speed;
        std::copy(cubic[phase], cubic[phase] + 4, axis.a);
        place = axis.place(time_[phase]);
        speed = axis.speed(time_[phase]);
      }
    }
  }

  double duration() const { return time_[0] + time_[1] + time_[2] + time_[3]; }

  /// Position to jerk after t seconds of it.
  tern::Sample at(double t) const {
    int phase = 0;
    while (phase < 3 && t > time_[phase]) t -= time_[phase++];
    t = std::min(t, time_[phase]);
    const Axis* const k = axes_[phase];
    tern::Sample sample{};
    sample.position = {k[0].place(t), k[1].place(t), k[2].place(t)};
    sample.velocity = {k[0].speed(t), k[1].speed(t), k[2].speed(t)};
    sample.acceleration = {k[0].pull(t), k[1].pull(t), k[2].pull(t)};
    sample.jerk = {k[0].jerk(t), k[1].jerk(t), k[2].jerk(t)};
    return sample;
  }

  /// As sampled.
  bool keeps(const tern::Limits& limits) const {
    constexpr double kWider = 1.0 + 1e-7;
    const auto holds = [](const tern::Vec3& x, const tern::Vec3& most, double level) {
      return std::abs(x.x) <= kWider * most.x && std::abs(x.y) <= kWider * most.y && std::abs(x.z) <= kWider * most.z &&
             (!(level > 0.0) || std::hypot(x.x, x.y) <= kWider * level);
    };
    for (double t = 0.0; t < duration(); t += 0.001) {
      const tern::Sample s = at(t);
      if (!holds(s.velocity, limits.v_max, limits.v_horizontal)) return false;
      if (!holds(s.acceleration, limits.a_max, limits.a_horizontal)) return false;
      if (limits.j_max.x > 0.0 && !holds(s.jerk, limits.j_max, limits.j_horizontal)) return false;
    }
    return true;
  }

 private:
  /// Place, speed and acceleration of one axis in one phase.
  struct Axis {
    double p, v, a[4];
    double place(double t) const {
      return p + t * (v + t * (a[0] / 2.0 + t * (a[1] / 6.0 + t * (a[2] / 12.0 + t * a[3] / 20.0))));
    }
    double speed(double t) const { return v + t * (a[0] + t * (a[1] / 2.0 + t * (a[2] / 3.0 + t * a[3] / 4.0))); }
    double pull(double t) const { return a[0] + t * (a[1] + t * (a[2] + t * a[3])); }
    double jerk(double t) const { return a[1] + t * (2.0 * a[2] + t * 3.0 * a[3]); }
  };

  double time_[4];
  Axis axes_[4][3];
};

/// Brakes from sharp to gentle that keep the limits.
inline std::vector<ReferenceBrake> reference_brakes(const tern::Sample& from, const tern::Limits& limits) {
  std::vector<ReferenceBrake> brakes;
  for (double ramp = 0.05; ramp < 2.0; ramp *= 1.1) {
    for (double settle = 0.05; settle > 0.001; settle *= 0.5) {
      const ReferenceBrake brake(from, settle, ramp, limits);
      if (!brake.keeps(limits)) continue;
      brakes.push_back(brake);
      break;
    }
  }
  return brakes;
}

}  // namespace tern_test

#endif
