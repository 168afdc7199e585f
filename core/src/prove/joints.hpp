// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where segments meet, and where a trajectory begins and ends. Proofs of obstacles and limits look at each segment
// alone.
#ifndef TERN_PROVE_JOINTS_HPP
#define TERN_PROVE_JOINTS_HPP

#include <cstdint>

#include "base/work.hpp"
#include "prove/bernstein.hpp"
#include "tern/proof_report.hpp"
#include "tern/request.hpp"
#include "tern/trajectory.hpp"

namespace tern {

/// The most by which position, velocity, acceleration and jerk may differ.
struct Granted {
  double most[kOrders];
};

/// True if two states agree to within the grant. If false, `found` receives the derivative, the axis of the largest
/// difference, and its excess over the grant.
bool agree(const Jet& a, const Jet& b, const Granted& granted, ProofReport& found) noexcept;

/// True if the positions have the same bits, and the derivatives to jerk agree to within the rounding of both sides.
bool segments_join(const Segment& before, const Segment& after, ProofReport& found) noexcept;

/// True if a state of the segment is the one asked for: the position to within `distance`, the derivatives to within
/// rounding. `origin`: of the segment's frame.
bool state_met(const Jet& state, const Segment& segment, const State& asked, const Vec3& origin, double distance,
               ProofReport& found) noexcept;

/// The most by which a position, a velocity and an acceleration may jump in a committed plan: m, m/s, m/s^2. Rounding
/// is granted on top. A jerk may jump.
constexpr double kJointJump[] = {1e-9, 1e-6, 1e-4};
/// Operations for each segment: the differences at both of its ends.
constexpr Operations kJointOperations = 16 * ops::kDot;

/// True if `after` follows `before` without a jump.
bool follows(const Sample& before, const Sample& after) noexcept;

/// True if position, velocity and acceleration do not jump from one segment to the next, and velocity and acceleration
/// are 0 at the end. False for NaN, and without segments.
bool joints_hold(const Trajectory& trajectory) noexcept;

}  // namespace tern

#endif
