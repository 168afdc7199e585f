// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Plan files ("tern-plan/1", docs/formats.md) and trajectories as tables.
#ifndef TERN_HOST_PLAN_FILE_HPP
#define TERN_HOST_PLAN_FILE_HPP

#include <string>

#include "host/session.hpp"

namespace tern_host {

/// One sentence on how the plan went: empty for an optimised plan, why and how it fell back for another, and what is
/// wrong (stage, field, nearest free voxel) where there is none.
std::string describe_status(const PlanResult& result);

/// The plan as JSON: world frame, numbers that read back to the same bits.
std::string plan_json(const PlanResult& result);

/// t, position, velocity, acceleration, jerk, snap at every `step` seconds and at the end; with a yaw plan, its angle,
/// rate and acceleration too, until both have ended. `step` > 0; throws std::invalid_argument where that makes more
/// than ten million rows.
std::string trajectory_csv(const tern::Trajectory& trajectory, double step, const tern::YawPlan* yaw = nullptr);

}  // namespace tern_host

#endif
