// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Limits on body rates in a programme. A rate is the jerk across the thrust over the thrust, so its limit is no
// half-space. At each instant with a jerk point, a programme bounds the jerk across the thrust from above, and the
// thrust from below. Both follow from a plan, flown at the programme's durations: the directions of thrust and jerk,
// how much rate is left, and what each of the two bounds cost the last solution.
#ifndef TERN_TRAJECTORY_TURNING_HPP
#define TERN_TRAJECTORY_TURNING_HPP

#include "trajectory/candidate.hpp"
#include "trajectory/programme.hpp"

namespace tern {

/// Before the first solution: the jerk that turns the hover's thrust at the limit, and a part of the hover's thrust.
/// Near both ends of the chain, what the boundary state has and allows.
void first_turning(const Chain& chain, const MotionLimits& limits, Turning& turning) noexcept;

/// Takes the rows from a plan, whose points may be those of other durations.
void follow_turning(const Candidate& plan, const MotionLimits& limits, Turning& turning) noexcept;

}  // namespace tern

#endif
