// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Corridors of axis-aligned boxes around random polylines: as rich as the trajectory stage needs, without a map.
#ifndef TERN_TESTS_SUPPORT_BOX_CORRIDOR_HPP
#define TERN_TESTS_SUPPORT_BOX_CORRIDOR_HPP

#include <cmath>
#include <cstdint>

#include "support/random.hpp"
#include "tern/corridor.hpp"
#include "tern/request.hpp"

namespace tern_test {

constexpr tern::Limits kTwo{{2.0, 2.0, 2.0}, {2.0, 2.0, 2.0}};
constexpr std::uint32_t kUnlimited = 0xFFFFFFFFu;

inline tern::State resting(const tern::Vec3& point) {
  return tern::State{point, {0, 0, 0}, {0, 0, 0}};
}

/// A box around the segment with `margin` metres to spare on every side.
inline tern::Polyhedron box_around(const tern::Vec3& from, const tern::Vec3& to, double margin) {
  tern::Polyhedron box{};
  box.from = from;
  box.to = to;
  const double a[3] = {from.x, from.y, from.z};
  const double b[3] = {to.x, to.y, to.z};
  for (int k = 0; k < 3; ++k) {
    const double normal[3] = {k == 0 ? 1.0 : 0.0, k == 1 ? 1.0 : 0.0, k == 2 ? 1.0 : 0.0};
    box.planes[box.count++] = {{normal[0], normal[1], normal[2]}, std::fmax(a[k], b[k]) + margin};
    box.planes[box.count++] = {{-normal[0], -normal[1], -normal[2]}, margin - std::fmin(a[k], b[k])};
  }
  return box;
}

/// A chain of `count` boxes around a random polyline with legs of 0.3 to `reach` metres.
inline tern::Corridor random_corridor(Random& random, int count, double reach, double least_margin) {
  tern::Corridor corridor{};
  tern::Vec3 from{random.real(0.0, 10.0), random.real(0.0, 10.0), random.real(0.0, 3.0)};
  for (int i = 0; i < count; ++i) {
    const double leg = random.real(0.3, reach);
    const double x = random.real(-1.0, 1.0), y = random.real(-1.0, 1.0), z = random.real(-0.4, 0.4);
    const double scale = leg / std::sqrt(x * x + y * y + z * z + 1e-6);
    const tern::Vec3 to{from.x + scale * x, from.y + scale * y, from.z + scale * z};
    corridor.polyhedra[corridor.count++] = box_around(from, to, random.real(least_margin, 1.5));
    from = to;
  }
  return corridor;
}

inline tern::Limits random_limits(Random& random) {
  return {{random.real(0.5, 4.0), random.real(0.5, 4.0), random.real(0.5, 3.0)},
          {random.real(0.5, 5.0), random.real(0.5, 5.0), random.real(0.5, 3.0)}};
}

/// Different limits up and down, and a horizontal norm that cuts the corners of the axes' box.
inline tern::Limits random_uneven_limits(Random& random) {
  tern::Limits limits = random_limits(random);
  limits.v_min = {0.0, 0.0, -random.real(0.3, 3.0)};
  limits.a_min = {-random.real(0.5, 5.0), 0.0, -random.real(0.3, 3.0)};
  if (random.chance(0.7)) limits.v_horizontal = random.real(0.5, 4.0);
  if (random.chance(0.7)) limits.a_horizontal = random.real(0.5, 4.0);
  return limits;
}

}  // namespace tern_test

#endif
