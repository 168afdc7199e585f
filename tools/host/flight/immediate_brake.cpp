// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/immediate_brake.hpp"

#include <algorithm>
#include <cmath>

#include "host/flight/vectors.hpp"
#include "host/nanoseconds.hpp"

namespace tern_host {
namespace {

using tern::Sample;
using tern::Vec3;

constexpr double kBrakeStep = 1e-3;        // seconds
constexpr std::int64_t kStepNs = 1000000;  // the same
constexpr std::size_t kMostSteps = 60000;  // of a way: a minute
constexpr double kShortest = 0.05;         // seconds, of a brake and of its ramps
constexpr double kBrakeSettle = 0.05;      // seconds, in which the jerk falls to zero
constexpr double kNoJerk = 1e-6;           // m/s^3
constexpr double kLonger = 1.02;           // from one that is tried to the next
constexpr int kTries = 400;

Vec3 sum(double a, const Vec3& u, double b, const Vec3& v, double c = 0.0, const Vec3& w = {}) {
  return {a * u.x + b * v.x + c * w.x, a * u.y + b * v.y + c * w.y, a * u.z + b * v.z + c * w.z};
}

/// How fast time along a way goes, from 1 to 0 for u from 0 to 1, with its derivatives by u and its integral.
struct Pace {
  explicit Pace(double u)
      : way(u - u * u * u * u * (2.5 - 3.0 * u + u * u)),
        rate(1.0 - u * u * u * (10.0 - 15.0 * u + 6.0 * u * u)),
        first(-30.0 * u * u * (1.0 - u) * (1.0 - u)),
        second(-60.0 * u * (1.0 - u) * (1.0 - 2.0 * u)) {}
  double way, rate, first, second;
};

/// A brake of so many seconds along a way.
class SlowDown {
 public:
  SlowDown(const std::vector<Sample>& way, double begin) : way_(way), begin_(begin) {}

  Sample at(double t, double duration) const {
    const Pace pace(std::min(1.0, t / duration));
    Sample s = along(begin_ + duration * pace.way);
    const double r1 = pace.rate;
    const double r2 = pace.first / duration;
    const double r3 = pace.second / (duration * duration);
    s.jerk = sum(r1 * r1 * r1, s.jerk, 3.0 * r1 * r2, s.acceleration, r3, s.velocity);
    s.acceleration = sum(r1 * r1, s.acceleration, r2, s.velocity);
    s.velocity = sum(r1, s.velocity, 0.0, {});
    return s;
  }
  bool keeps(const tern::Limits& limits, double duration) const {
    for (double t = 0.0; t <= duration; t += 0.01 * duration) {
      if (broken_limit(limits, at(t, duration)) != nullptr) return false;
    }
    return true;
  }

 private:
  Sample along(double t) const {
    const double at = std::clamp(t / kBrakeStep, 0.0, static_cast<double>(way_.size() - 1));
    const std::size_t k = std::min(static_cast<std::size_t>(at), way_.size() - 1);
    if (k + 1 == way_.size()) return way_.back();
    const double b = at - static_cast<double>(k);
    const Sample& from = way_[k];
    const Sample& to = way_[k + 1];
    return {sum(1.0 - b, from.position, b, to.position),
            sum(1.0 - b, from.velocity, b, to.velocity),
            sum(1.0 - b, from.acceleration, b, to.acceleration),
            sum(1.0 - b, from.jerk, b, to.jerk),
            {}};
  }

  const std::vector<Sample>& way_;
  double begin_;
};

/// The acceleration of a brake straight ahead: first the jerk falls to zero, if there is some, then a smooth ramp leads
/// to a steady deceleration, and another one back to zero.
class StraightBrake {
 public:
  StraightBrake(const Sample& start, double ramp, double hold)
      : start_(start), settle_(length(start.jerk) > kNoJerk ? kBrakeSettle : 0.0), ramp_(ramp), hold_(hold) {
    settled_ = sum(1.0, start.acceleration, 0.5 * settle_, start.jerk);
    const Vec3 speed = sum(1.0, start.velocity, settle_, start.acceleration, settle_ * settle_ / 3.0, start.jerk);
    slower_ = sum(-1.0 / (ramp + hold), speed, -0.5 * ramp / (ramp + hold), settled_);
  }
  double duration() const { return settle_ + 2.0 * ramp_ + hold_; }
  /// Acceleration and jerk.
  void at(double t, Vec3& acceleration, Vec3& jerk) const {
    const double after = t - settle_;
    if (after < 0.0) {
      const double u = t / settle_;
      acceleration = sum(1.0, start_.acceleration, t * (1.0 - 0.5 * u), start_.jerk);
      jerk = sum(1.0 - u, start_.jerk, 0.0, {});
    } else if (after < ramp_) {
      between(settled_, slower_, after / ramp_, acceleration, jerk);
    } else if (after < ramp_ + hold_) {
      acceleration = slower_;
      jerk = {};
    } else {
      between(slower_, {}, std::min(1.0, (after - ramp_ - hold_) / ramp_), acceleration, jerk);
    }
  }

 private:
  void between(const Vec3& from, const Vec3& to, double u, Vec3& acceleration, Vec3& jerk) const {
    const double step = u * u * (3.0 - 2.0 * u);
    const double rate = 6.0 * u * (1.0 - u) / ramp_;
    acceleration = sum(1.0 - step, from, step, to);
    jerk = sum(-rate, from, rate, to);
  }

  Sample start_;
  double settle_, ramp_, hold_;
  Vec3 settled_{}, slower_{};
};

/// Flies it in steps of a millisecond. False where a limit is broken.
bool fly(const StraightBrake& brake, const Sample& start, const tern::Limits& limits, BrakeWay& way) {
  Sample s = start;
  for (double t = 0.0; t < brake.duration(); t += kBrakeStep) {
    way.push_back({s.position, length(s.velocity)});
    brake.at(t + 0.5 * kBrakeStep, s.acceleration, s.jerk);
    s.position = sum(1.0, s.position, kBrakeStep, s.velocity, 0.5 * kBrakeStep * kBrakeStep, s.acceleration);
    s.velocity = sum(1.0, s.velocity, kBrakeStep, s.acceleration);
    if (broken_limit(limits, s) != nullptr) return false;
  }
  way.push_back({s.position, 0.0});
  return true;
}

}  // namespace

BrakeWay brake_along(const Commands& commands, std::int64_t now, std::int64_t begin, const tern::Limits& limits) {
  std::vector<Sample> flown;
  do {
    flown.push_back(commands(now + static_cast<std::int64_t>(flown.size()) * kStepNs));
  } while (flown.size() < kMostSteps && !rests(flown.back()));
  const double before = seconds_of(begin - now);
  const SlowDown brake(flown, before);
  double duration = kShortest;
  for (int k = 0; k < kTries && !brake.keeps(limits, duration); ++k) duration *= kLonger;
  BrakeWay way;
  for (std::int64_t t = now; t < begin; t += kStepNs) {
    const Sample s = commands(t);
    way.push_back({s.position, length(s.velocity)});
  }
  for (double t = 0.0; t < duration + kBrakeStep; t += kBrakeStep) {
    const Sample s = brake.at(t, duration);
    way.push_back({s.position, length(s.velocity)});
  }
  return way;
}

/// The shortest of those with ramps of some durations.
BrakeWay brake_straight(const Commands& commands, std::int64_t now, std::int64_t begin, const tern::Limits& limits) {
  BrakeWay before;
  for (std::int64_t t = now; t < begin; t += kStepNs) {
    const Sample s = commands(t);
    before.push_back({s.position, length(s.velocity)});
  }
  const Sample start = commands(begin);
  BrakeWay best;
  for (double ramp = kShortest; ramp < 2.0; ramp *= 1.05) {
    const double hold = std::max(kShortest, length(start.velocity) / limits.a_horizontal - ramp);
    for (double longer = 1.0; longer < 2.0; longer *= 1.05) {
      BrakeWay way;
      const bool kept = fly(StraightBrake(start, ramp, hold * longer), start, limits, way);
      if (kept && (best.empty() || way.size() < best.size())) best = way;
      if (kept) break;
    }
  }
  if (best.empty()) return {};
  before.insert(before.end(), best.begin(), best.end());
  return before;
}

}  // namespace tern_host
