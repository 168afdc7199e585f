// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "grid/touching.hpp"

#include "base/math.hpp"

namespace tern {
namespace {

Vec3 unit_axis(int a, double sign) {
  Vec3 v{0.0, 0.0, 0.0};
  axis(v, a) = sign;
  return v;
}

/// e_a x u: at right angles to the box's edges along axis a and to the segment along u.
Vec3 edge_normal(int a, const Vec3& u) {
  if (a == 0) return {0.0, -u.z, u.y};
  if (a == 1) return {u.z, 0.0, -u.x};
  return {-u.y, u.x, 0.0};
}

}  // namespace

double room_along(const Vec3& from, const Vec3& to, const Box& box, const Vec3& normal) noexcept {
  return support(normal, box) - larger(dot(normal, from), dot(normal, to));
}

void offer(const Vec3& from, const Vec3& to, const Box& box, const Vec3& unit, WidestNormal& best) noexcept {
  const double room = room_along(from, to, box, unit);
  if (room > best.room) best = {unit, room};
}

WidestNormal separating_normal(const Vec3& from, const Vec3& to, const Box& box, double direction) noexcept {
  const Vec3 first = unit_axis(0, 1.0);
  WidestNormal best{first, room_along(from, to, box, first)};
  for (int a = 0; a < 3; ++a) {
    offer(from, to, box, unit_axis(a, 1.0), best);
    offer(from, to, box, unit_axis(a, -1.0), best);
  }
  const Vec3 along = to - from;
  for (int a = 0; a < 3; ++a) {
    const Vec3 normal = edge_normal(a, along);
    const double norm = length(normal);
    if (!(norm > direction)) continue;
    offer(from, to, box, (1.0 / norm) * normal, best);
    offer(from, to, box, (-1.0 / norm) * normal, best);
  }
  return best;
}

}  // namespace tern
