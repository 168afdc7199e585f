// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_PLANNER_VALIDATE_HPP
#define TERN_PLANNER_VALIDATE_HPP

#include "base/bounds.hpp"
#include "base/verdict.hpp"
#include "tern/grid.hpp"
#include "tern/request.hpp"

namespace tern {

/// Looks at every field of a request before any stage runs, finite numbers first. World frame. `limits` gets the
/// request's, as the stages take them, where it is accepted.
Verdict validate(const Grid& grid, const Request& request, MotionLimits& limits) noexcept;

/// The request in the grid's local frame; positions that rounding left outside the boundary are put on it.
Request to_local(const Grid& grid, const Request& request) noexcept;

}  // namespace tern

#endif
