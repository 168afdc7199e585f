// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "prove/joints.hpp"

#include "base/math.hpp"
#include "prove/grants.hpp"

namespace tern {
namespace {

/// Stands for the grant to a derivative that may jump.
constexpr double kAnyJump = __builtin_inf();

Granted sum_of(const Granted& a, const Granted& b) {
  Granted sum = a;
  for (int k = 0; k < kOrders; ++k) sum.most[k] += b.most[k];
  return sum;
}

/// The grant for the rounding at an end of a segment.
Granted rounding_of(const Segment& segment) {
  Granted granted{};
  for (int k = 0; k < kOrders; ++k) granted.most[k] = derivative_rounding(segment, k);
  return granted;
}

/// The grant at a joint of a flight.
Granted with_jump(Granted rounding) {
  for (int k = 0; k < 3; ++k) rounding.most[k] += kJointJump[k];
  rounding.most[3] = kAnyJump;
  return rounding;
}

}  // namespace

bool agree(const Jet& a, const Jet& b, const Granted& granted, ProofReport& found) noexcept {
  for (int k = 0; k < kOrders; ++k) {
    bool agrees = true;
    double worst = -1.0;
    for (int i = 0; i < 3; ++i) {
      const double apart = absolute(axis(a.d[k], i) - axis(b.d[k], i));
      if (apart <= granted.most[k]) continue;
      agrees = false;
      if (!(apart - granted.most[k] > worst)) continue;
      worst = apart - granted.most[k];
      found.axis = i;
    }
    if (agrees) continue;
    found.derivative = k;
    found.excess = larger(0.0, worst);
    return false;
  }
  return true;
}

bool segments_join(const Segment& before, const Segment& after, ProofReport& found) noexcept {
  Granted granted = sum_of(rounding_of(before), rounding_of(after));
  granted.most[0] = 0.0;
  return agree(jet_of(before, true), jet_of(after, false), granted, found);
}

bool state_met(const Jet& state, const Segment& segment, const State& asked, const Vec3& origin, double distance,
               ProofReport& found) noexcept {
  Granted granted = rounding_of(segment);
  granted.most[0] = distance;
  const Jet wanted{{asked.position - origin, asked.velocity, asked.acceleration, asked.jerk}};
  return agree(state, wanted, granted, found);
}

bool follows(const Sample& before, const Sample& after) noexcept {
  ProofReport found;
  const Granted granted{{kJointJump[0], kJointJump[1], kJointJump[2], kAnyJump}};
  return agree({{before.position, before.velocity, before.acceleration, kZero}},
               {{after.position, after.velocity, after.acceleration, kZero}}, granted, found);
}

bool joints_hold(const Trajectory& trajectory) noexcept {
  if (trajectory.count < 1 || trajectory.count > kMaxSegments) return false;
  ProofReport found;
  for (int i = 1; i < trajectory.count; ++i) {
    const Segment& before = trajectory.segments[i - 1];
    const Segment& after = trajectory.segments[i];
    const Granted granted = with_jump(sum_of(rounding_of(before), rounding_of(after)));
    if (!agree(jet_of(before, true), jet_of(after, false), granted, found)) return false;
  }
  const Segment& last = trajectory.segments[trajectory.count - 1];
  const Jet end = jet_of(last, true);
  return agree(end, {{end.d[0], kZero, kZero, kZero}}, with_jump(rounding_of(last)), found);
}

}  // namespace tern
