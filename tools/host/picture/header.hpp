// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_PICTURE_HEADER_HPP
#define TERN_HOST_PICTURE_HEADER_HPP

#include <string>
#include <vector>

#include "host/figures.hpp"
#include "host/picture/legend.hpp"
#include "host/session.hpp"

namespace tern_host {

/// Name, settings, key figures or why there is no plan, and the legend of the map views. Returns where it ends.
double draw_header(Canvas& canvas, const PlanResult& result, const Figures& figures);

/// What draws the world: each view names what it shows.
enum class WorldLegend { kViews, kOblique };
std::vector<LegendEntry> world_entries(const Scenario& scenario, WorldLegend legend);

/// The speed of the last colour, m/s.
double speed_scale(const Figures& figures);

/// The scenario's file name without folder and ".txt".
std::string scenario_title(const PlanResult& result);

}  // namespace tern_host

#endif
