// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ellipsoid/inscribe.hpp"

#include "base/polyhedron.hpp"

namespace tern {
namespace {

constexpr double kSliver = 1e-9;

void shrink_across(const Polyhedron& polyhedron, EllipsoidFrame& frame) {
  double factor = 1.0;
  for (int p = 0; p < polyhedron.count; ++p) {
    const Halfspace& plane = polyhedron.planes[p];
    const Vector normal = to_vector(plane.normal);
    const double room = plane.offset - dot(normal, frame.center);
    const double x = frame.semi_axis[0] * dot(normal, frame.direction.col(0));
    const double y = frame.semi_axis[1] * dot(normal, frame.direction.col(1));
    const double z = frame.semi_axis[2] * dot(normal, frame.direction.col(2));
    const double across = y * y + z * z;
    const double left = larger(room, 0.0) * room - x * x;
    if (left < factor * factor * across) factor = square_root(larger(left, 0.0) / across);
  }
  frame.semi_axis[1] = larger(frame.semi_axis[1] * factor, kSliver * frame.semi_axis[0]);
  frame.semi_axis[2] = larger(frame.semi_axis[2] * factor, kSliver * frame.semi_axis[0]);
}

void shrink_ball(const Polyhedron& polyhedron, EllipsoidFrame& frame) {
  const double radius = frame.semi_axis[0];
  const double room = room_at(polyhedron, to_vec3(frame.center));
  frame.semi_axis.fill(larger(smaller(radius, room), kSliver * radius));
}

}  // namespace

void inscribe(const Polyhedron& polyhedron, bool ball, EllipsoidFrame& frame) noexcept {
  if (ball) {
    shrink_ball(polyhedron, frame);
  } else {
    shrink_across(polyhedron, frame);
  }
}

}  // namespace tern
