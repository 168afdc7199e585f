// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_PICTURE_MOVING_VIEW_HPP
#define TERN_HOST_PICTURE_MOVING_VIEW_HPP

#include <functional>
#include <vector>

#include "host/picture/canvas.hpp"
#include "host/picture/legend.hpp"
#include "host/session.hpp"
#include "tern/vec3.hpp"

namespace tern_host {

/// From the world to the picture.
using WorldToPixel = std::function<Pixel(const tern::Vec3&)>;

/// Things that move, while the plan is flown: what their tubes sweep, their way, and where they are once a second.
/// Without a plan, for ten seconds.
void draw_things(Canvas& canvas, const PlanResult& result, const WorldToPixel& pixel);

/// Names of things and of keep-outs for a while, where they are first; not where other text leaves no room. Last.
void draw_thing_names(Canvas& canvas, const PlanResult& result, const WorldToPixel& pixel, const Rect& frame);

/// Their entry of the legend; none for a scenario without them.
std::vector<LegendEntry> thing_entries(const Scenario& scenario);

}  // namespace tern_host

#endif
