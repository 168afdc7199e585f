// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_PLANNER_REQUEST_HPP
#define TERN_PLANNER_REQUEST_HPP

#include "tern/grid.hpp"
#include "tern/request.hpp"
#include "tern/status.hpp"

namespace tern {

/// A refusal and the field that it speaks of.
struct Verdict {
  Status status;
  Field field;
};

/// Looks at every field of a request before any stage runs, finite numbers first. World frame.
Verdict validate(const Grid& grid, const Request& request) noexcept;

/// The request in the grid's local frame; positions that rounding left outside the boundary are put on it.
Request to_local(const Grid& grid, const Request& request) noexcept;

}  // namespace tern

#endif
