// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What would open a way where there is none. The answer of the planner says that no free voxels connect the ends, not
// why: a fence, space that nobody knows, or a passage that is narrower than the robot or than a voxel. So the same
// request is asked again with less in the way, and what is said was planned.
#ifndef TERN_HOST_CLOSED_WAY_HPP
#define TERN_HOST_CLOSED_WAY_HPP

#include <string>

#include "host/scenario.hpp"

namespace tern_host {

/// The resolution is halved so often at most, and no grid of more voxels than that is planned in.
constexpr int kClosedWayHalvings = 3;
constexpr double kClosedWayVoxels = 1.6e7;

/// For a scenario whose goal no path leads to. Names the first of these that opens a way: no geofences, unknown space
/// taken for free, a finer resolution, a smaller radius. Begins with a semicolon; empty if the grid is too large. Plans
/// some ten times.
std::string describe_closed_way(const Scenario& scenario);

}  // namespace tern_host

#endif
