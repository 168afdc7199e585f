// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_PICTURE_MAP_PICTURE_HPP
#define TERN_HOST_PICTURE_MAP_PICTURE_HPP

#include <string>

#include "host/map/scenario_grid.hpp"

namespace tern_host {

/// A scenario's map without a plan: seen from above and the side, where the ground is the darker the more of what
/// stands above it is unknown; and horizontal slices of one voxel.
std::string map_svg(const Scenario& scenario, const GridMap& map);

}  // namespace tern_host

#endif
