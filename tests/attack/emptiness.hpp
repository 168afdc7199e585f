// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Whether fences have a point, by the attack's own code: one that is found, or multipliers that rule one out.
#ifndef TERN_TESTS_ATTACK_EMPTINESS_HPP
#define TERN_TESTS_ATTACK_EMPTINESS_HPP

#include <vector>

#include "attack/attack_case.hpp"
#include "attack/solid.hpp"

namespace tern_attack {

enum class Emptiness { kHasPoint, kEmpty, kDoubt };

/// Of half-spaces in a world's local frame; `size` is the world's, metres.
Emptiness emptiness_of(const std::vector<Plane>& planes, Real size);

/// Whether a call may answer kFenceEmpty, and must: by each keep-out, and by the keep-ins together.
void judge_fences(const World& world, const tern::Fence* fences, int count, tern::Status status, int named,
                  const char* what, Findings& findings);

/// Fences that are reversed, clockwise, apart or malformed, for plans and flights.
void attack_fences(Context& context, Rng& rng, tern::Planner& planner, const World& world, const Ask& ask);

}  // namespace tern_attack

#endif
