// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A map and a plan seen along one axis: obstacles with the space that the radius takes around them, corridor, paths,
// and the trajectory coloured by speed.
#ifndef TERN_HOST_PICTURE_MAP_VIEW_HPP
#define TERN_HOST_PICTURE_MAP_VIEW_HPP

#include "host/picture/axes.hpp"
#include "host/session.hpp"

namespace tern_host {

/// Which world axes (0, 1, 2) a view shows, and which it looks along.
struct Projection {
  int horizontal;
  int vertical;
  int depth;
  bool down;  ///< the vertical axis points downwards, so that a turned view is not a mirrored one
};

double component(const tern::Vec3& v, int axis);

/// What a view shows of the world along one axis.
AxisRange view_range(const PlanResult& result, int axis);

/// The corners of a fence as far as it lies within the boundary.
std::vector<tern::Vec3> fence_corners(const FenceRecord& fence, const tern::Box& boundary);

/// Where a point of the world stands in a view.
Pixel project(const Axes& axes, const Projection& projection, const tern::Vec3& point);

/// The blocks, with the space that the radius takes around them below; merged where there are many.
void draw_obstacles(Canvas& canvas, const Axes& axes, const Projection& projection, const Scenario& scenario);

/// Keep-outs and keep-ins, as far as they lie within the boundary.
void draw_fences(Canvas& canvas, const Axes& axes, const Projection& projection, const std::vector<FenceRecord>& fences,
                 const tern::Box& boundary);

/// The outlines of the corridor's polyhedra, where there is a corridor.
void draw_corridor(Canvas& canvas, const Axes& axes, const Projection& projection, const PlanResult& result);

/// Start and goal with their names, where these hide least of the way. `way`: a chain of pixels; may be empty.
void draw_ends(Canvas& canvas, const Axes& axes, const Projection& projection, const Scenario& scenario,
               const std::vector<Pixel>& way);

/// Draws into axes.frame, with frame and axis titles; its ranges are those of view_range(). `speed_scale`: the speed of
/// the last colour, m/s.
void draw_map_view(Canvas& canvas, const Axes& axes, const Projection& projection, const PlanResult& result,
                   double speed_scale);

}  // namespace tern_host

#endif
