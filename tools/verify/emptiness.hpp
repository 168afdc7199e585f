// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fences without a point: a keep-out that keeps nothing out, or keep-ins that nothing can be in.
#ifndef TERN_VERIFY_EMPTINESS_HPP
#define TERN_VERIFY_EMPTINESS_HPP

#include <cstddef>
#include <optional>
#include <vector>

#include "verify/problem.hpp"

namespace tern_verify {

/// True if multipliers prove (Farkas) that the half-spaces have no point in common, a nanometre on each side forgiven,
/// as far as a million times the size of the boundary and the distance of the half-spaces from it.
bool is_empty(const std::vector<HalfSpace>& planes, const Box& boundary);

/// The first keep-out that is empty, or the first keep-in that leaves no point of the keep-ins before it.
std::optional<std::size_t> empty_fence(const std::vector<Fence>& fences, const Box& boundary);

/// Why it is refused.
std::string empty_text(const Fence& fence);

}  // namespace tern_verify

#endif
