// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A yaw plan ends later than its trajectory. An export goes on until then and holds the position meanwhile.
#ifndef TERN_HOST_EXPORT_HELD_END_HPP
#define TERN_HOST_EXPORT_HELD_END_HPP

#include "host/session.hpp"

namespace tern_host {

/// Does the trajectory end at rest, so that the vehicle can stay there?
bool ends_at_rest(const tern::Trajectory& trajectory);

/// When an export ends, in seconds since the plan's beginning: with the yaw plan if there is one and the trajectory
/// ends at rest, else with the trajectory.
double export_end(const PlanResult& result);

/// The trajectory, and segments that hold its last position until export_end(). Throws std::runtime_error if there is
/// no room for them.
tern::Trajectory held_trajectory(const PlanResult& result);

}  // namespace tern_host

#endif
