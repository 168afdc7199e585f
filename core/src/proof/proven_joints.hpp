// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Contract: what is committed goes on from what is flown without a jump, and ends at rest. Hulls, obstacles and limits
// say nothing of that: they hold for each segment alone.
#ifndef TERN_PROOF_PROVEN_JOINTS_HPP
#define TERN_PROOF_PROVEN_JOINTS_HPP

#include <cstdint>

#include "tern/trajectory.hpp"

namespace tern {

/// What a position, a velocity and an acceleration may jump by: m, m/s, m/s^2, and what rounding takes on top.
constexpr double kJointJump[] = {1e-9, 1e-6, 1e-4};
/// Instructions for each segment.
constexpr std::uint32_t kJointEffort = 300;

/// True where `after` follows on `before`.
bool follows(const Sample& before, const Sample& after) noexcept;

/// True where position, velocity and acceleration do not jump from one segment to the next, and velocity and
/// acceleration are 0 at the end. False for NaN, and without segments.
bool joints_hold(const Trajectory& trajectory) noexcept;

}  // namespace tern

#endif
