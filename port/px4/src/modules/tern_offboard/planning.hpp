// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The plan that is flown, and how it is made. planning.cpp has the obstacles and the world: put in yours.
#pragma once

#include <tern/tern.hpp>

#include "topics.hpp"

namespace tern_offboard {

/// The yaw of PX4's heading, which is clockwise from north; Tern's is counter-clockwise from east.
inline tern::YawSample yaw_at(double heading) {
  return {{sin(heading), cos(heading), 0.0}, 0.0, 1.57079632679489662 - heading};
}

/// Makes the map, reads PX4's limits, and plans from rest at `from` to rest at `goal`. False: there is no plan, and the
/// log says why.
bool make_plan(const Hover& from, const tern::Vec3& goal);

/// A new plan from rest at `from` to the same goal, in slices: begin, then advance until it no longer answers kRunning,
/// then finish. The last plan stays until finish_plan() has a new one.
tern::Status begin_plan(const Hover& from);
tern::Status advance_plan(uint32_t work);
bool finish_plan(const Hover& from);

/// The last plan, and how the nose turns along it.
const tern::Trajectory& the_plan();
const tern::YawPlan& the_yaw_plan();

}  // namespace tern_offboard
