// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Contract: a newly committed plan continues the one before it without a jump, and ends at rest. The other proofs do
// not cover this, since hulls, obstacles and limits concern each segment alone.
#ifndef TERN_PROOF_PROVEN_JOINTS_HPP
#define TERN_PROOF_PROVEN_JOINTS_HPP

#include <cstdint>

#include "tern/trajectory.hpp"

namespace tern {

/// The most by which a position, a velocity and an acceleration may jump: m, m/s, m/s^2. Rounding is tolerated on top.
constexpr double kJointJump[] = {1e-9, 1e-6, 1e-4};
/// Instructions for each segment.
constexpr std::uint32_t kJointEffort = 300;

/// True if `after` follows `before` without a jump.
bool follows(const Sample& before, const Sample& after) noexcept;

/// True if position, velocity and acceleration do not jump from one segment to the next, and velocity and acceleration
/// are 0 at the end. False for NaN, and without segments.
bool joints_hold(const Trajectory& trajectory) noexcept;

}  // namespace tern

#endif
