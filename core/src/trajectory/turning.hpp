// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Limits on body rates in a programme. A rate is the jerk across the thrust over the thrust, so its limit is no
// half-space. A programme bounds the jerk at each of its points from above instead, and each segment's vertical thrust
// from below. Both follow from the last solution: from its thrust and the direction of its jerk, from its rates, and
// from what each of the two bounds cost it.
#ifndef TERN_TRAJECTORY_TURNING_HPP
#define TERN_TRAJECTORY_TURNING_HPP

#include "trajectory/candidate.hpp"
#include "trajectory/programme.hpp"

namespace tern {

/// Before the first solution: the jerk that turns the hover's thrust at the limit, and a part of the hover's thrust.
/// Near both ends of the chain, what the boundary state has and allows.
void first_turning(const Chain& chain, const MotionLimits& limits, Turning& turning) noexcept;

/// Learns from a solution, flown with this stretch: the jerk that turns its thrust at the limit, and a thrust about as
/// low as its own, lower where its rates leave room. Both bounds of a segment rise where the jerk's rows cost more, and
/// fall where the thrust's do.
void learn_turning(const Candidate& candidate, double stretch, const QpProblem& problem, const QpSolution& solution,
                   const ProgrammeScale& scale, const MotionLimits& limits, Turning& turning) noexcept;

}  // namespace tern

#endif
