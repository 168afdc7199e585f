// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/limit_planes.hpp"

namespace tern {
namespace {

/// cos and sin of pi / 16 and 3 pi / 16: outward normals of the polygon's sides in the first quarter of a turn are
/// (c1, s1), (c3, s3), (s3, c3), (s1, c1).
constexpr double kCos1 = kPolygonInside;
constexpr double kSin1 = 0.19509032201612827;
constexpr double kCos3 = 0.83146961230254524;
constexpr double kSin3 = 0.55557023301960218;
constexpr double kQuarter[4][2] = {{kCos1, kSin1}, {kCos3, kSin3}, {kSin3, kCos3}, {kSin1, kCos1}};

double least_limit(const Bounds& bounds) {
  double least = bounds.horizontal > 0.0 ? bounds.horizontal : bounds.upper.x;
  for (int a = 0; a < 3; ++a) least = smaller(least, smaller(axis(bounds.upper, a), -axis(bounds.lower, a)));
  return least;
}

/// Adds a half-space whose offset already leaves the margin free.
void add(LimitPlanes& limit, const Vec3& normal, double offset) {
  limit.planes[limit.count] = Halfspace{normal, offset};
  ++limit.count;
}

void add_axis(LimitPlanes& limit, const Bounds& bounds, int a, double margin) {
  const double most[2] = {axis(bounds.upper, a), -axis(bounds.lower, a)};
  for (int side = 0; side < 2; ++side) {
    if (a < 2 && bounds.horizontal > 0.0 && most[side] >= bounds.horizontal) continue;
    if (!(most[side] < kUnlimited)) continue;
    Vec3 normal{0.0, 0.0, 0.0};
    axis(normal, a) = side == 0 ? 1.0 : -1.0;
    add(limit, normal, most[side] / limit.unit * (1.0 - margin));
  }
}

void add_polygon(LimitPlanes& limit, double radius, const Vec3& along, double margin) {
  const Vec3 turn = horizontal_direction(along);
  for (int side = 0; side < kHorizontalSides; ++side) {
    add(limit, polygon_normal(turn, side), radius * kPolygonInside / limit.unit * (1.0 - margin));
  }
}

}  // namespace

Vec3 horizontal_direction(const Vec3& along) noexcept {
  const double norm = horizontal_length(along);
  return norm > 0.0 ? Vec3{along.x / norm, along.y / norm, 0.0} : Vec3{1.0, 0.0, 0.0};
}

Vec3 polygon_normal(const Vec3& corner, int side) noexcept {
  Vec3 turn = corner;
  for (int quarter = 0; quarter < side / 4; ++quarter) turn = Vec3{-turn.y, turn.x, 0.0};
  const double(&n)[2] = kQuarter[side % 4];
  return {turn.x * n[0] - turn.y * n[1], turn.x * n[1] + turn.y * n[0], 0.0};
}

LimitPlanes limit_planes(const Bounds& bounds, const Vec3& along, double margin) noexcept {
  LimitPlanes limit{};
  limit.unit = least_limit(bounds);
  for (int a = 0; a < 3; ++a) add_axis(limit, bounds, a, margin);
  if (bounds.horizontal > 0.0) add_polygon(limit, bounds.horizontal, along, margin);
  return limit;
}

}  // namespace tern
