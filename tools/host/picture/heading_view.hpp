// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A yaw plan in the picture: where the nose points along the way, the angle over time, and how fast it turns.
#ifndef TERN_HOST_PICTURE_HEADING_VIEW_HPP
#define TERN_HOST_PICTURE_HEADING_VIEW_HPP

#include "host/picture/map_view.hpp"

namespace tern_host {

/// Needles along the trajectory, in a view from above. Nothing without a yaw plan.
void draw_noses(Canvas& canvas, const Axes& axes, const Projection& projection, const PlanResult& result);

/// The angle over time, into `frame`; the title stands above it. Needs a yaw plan.
void draw_heading_profile(Canvas& canvas, const Rect& frame, const PlanResult& result);

/// Rate and acceleration over time, each with its limits.
void draw_turning_profile(Canvas& canvas, const Rect& frame, const PlanResult& result);

}  // namespace tern_host

#endif
