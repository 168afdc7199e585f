// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_PLANNER_VALIDATE_HPP
#define TERN_PLANNER_VALIDATE_HPP

#include <cstdint>

#include "base/bounds.hpp"
#include "base/verdict.hpp"
#include "tern/grid.hpp"
#include "tern/request.hpp"

namespace tern {

/// Relative excess over a limit that a start or goal may have. It may be a state of a plan, so this is the tolerance of
/// the check (kCheckRelative) plus the rounding of its evaluation.
constexpr double kLimitSlack = 4e-8;

/// Validates every field of a request before any stage runs; first, all numbers must be finite. World frame. If the
/// request is accepted, `limits` receives its limits in the form that the stages use.
Verdict validate(const Grid& grid, const Request& request, MotionLimits& limits) noexcept;

/// Validates the limits alone.
Verdict validate_limits(const Limits& limits) noexcept;
bool valid_time_weight(double weight) noexcept;

/// True if the dwell is in range, and is zero unless the plan stops at the via.
inline bool dwell_valid(const Via& via) noexcept {
  return via.dwell >= 0.0 && via.dwell <= kMaxDwell && (via.stop || !(via.dwell > 0.0));
}

/// Validates what a request says about tracks, besides the tracks.
Verdict validate_tracks(const Request& request) noexcept;
/// A previous plan must be on the request's clock if anything depends on the time.
Verdict validate_clock(const Request& request) noexcept;

/// Validates the vias of a request that is valid otherwise. `via` receives the index of the one that is wrong, or
/// kNoVia.
Verdict validate_vias(const Grid& grid, const Request& request, const MotionLimits& limits, std::int32_t& via) noexcept;

/// The request in the grid's local frame. Positions that are outside the boundary only by rounding are moved onto it.
Request to_local(const Grid& grid, const Request& request) noexcept;
Vec3 to_local(const Grid& grid, const Vec3& position) noexcept;

}  // namespace tern

#endif
