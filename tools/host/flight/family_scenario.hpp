// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_FLIGHT_FAMILY_SCENARIO_HPP
#define TERN_HOST_FLIGHT_FAMILY_SCENARIO_HPP

#include <string>
#include <vector>

#include "host/flight/flight_world.hpp"
#include "host/scenario.hpp"

namespace tern_host {

/// A scenario's file for one plan that knows the whole world: the same ends, vias, voxels, radius and limits. Cylinders
/// become blocks of at most a voxel's width that cover them. Equal worlds give equal text.
std::string scenario_text(const FlightWorld& world);

/// The scenario of a member of a family, such as P25:7 (world_family.hpp), or of a file: read_scenario(). Throws
/// ScenarioError.
Scenario named_scenario(const std::string& name, const std::vector<std::string>& overrides = {},
                        Ends ends = Ends::kRequired);

}  // namespace tern_host

#endif
