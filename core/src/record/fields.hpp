// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The fields of each structure that a record holds, in their order. Each list serves the writer, with a constant
// object, and the reader.
#ifndef TERN_RECORD_FIELDS_HPP
#define TERN_RECORD_FIELDS_HPP

#include <cstddef>

#include "tern/trajectory.hpp"

namespace tern {

template <typename Words, typename Spec>
void list_grid(Words& words, Spec& spec) {
  words(spec.origin);
  words(spec.cell);
  words(spec.dims.x);
  words(spec.dims.y);
  words(spec.dims.z);
  words(spec.boundary.lower);
  words(spec.boundary.upper);
  words(spec.radius);
  words(spec.tracking_margin);
}
constexpr std::size_t kGridFields = 15;

template <typename Words, typename AnyState>
void list_state(Words& words, AnyState& state) {
  words(state.position);
  words(state.velocity);
  words(state.acceleration);
  words(state.jerk);
}
constexpr std::size_t kStateFields = 12;

template <typename Words, typename AnyLimits>
void list_limits(Words& words, AnyLimits& limits) {
  words(limits.v_max);
  words(limits.a_max);
  words(limits.v_min);
  words(limits.a_min);
  words(limits.v_horizontal);
  words(limits.a_horizontal);
  words(limits.j_max);
  words(limits.j_horizontal);
  words(limits.thrust_max);
  words(limits.thrust_min);
  words(limits.tilt_tangent);
  words(limits.rate_max);
}
constexpr std::size_t kLimitFields = 22;

template <typename Words, typename AnyRequest>
void list_settings(Words& words, AnyRequest& request) {
  words(request.budget.search);
  words(request.budget.shortcut);
  words(request.budget.corridor);
  words(request.budget.trajectory);
  words(request.budget.tracks);
  words(request.search);
  words(request.goal_mode);
  words(request.time_weight);
  words(request.previous_time);
  words(request.begin);
}
constexpr std::size_t kSettingFields = 9;

template <typename Words, typename AnyVia>
void list_via(Words& words, AnyVia& via) {
  words(via.position);
  words(via.tolerance);
  words(via.stop);
  words(via.has_velocity);
  words(via.velocity);
  words(via.dwell);
}
constexpr std::size_t kViaFields = 9;

template <typename Words, typename Plane>
void list_plane(Words& words, Plane& plane) {
  words(plane.normal);
  words(plane.offset);
}
constexpr std::size_t kPlaneFields = 4;

template <typename Words, typename AnySegment>
void list_segment(Words& words, AnySegment& segment) {
  words(segment.duration);
  for (auto& point : segment.points) words(point);
  words(segment.polyhedron);
}
constexpr std::size_t kSegmentFields = 2 + 3 * kControlPoints;

}  // namespace tern

#endif
