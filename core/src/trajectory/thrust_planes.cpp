// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/thrust_planes.hpp"

#include "base/math.hpp"

namespace tern {
namespace {

/// Cosine and sine of the step of the tilt from ring to ring, pi / 8.
constexpr double kCosStep = 0.92387953251128674;
constexpr double kSinStep = 0.38268343236508977;
/// Steps that are surely enough for a quarter of a turn.
constexpr int kMostSteps = 5;
/// Tilts whose difference has a sine below this count as equal: a face between them would have no sure direction.
constexpr double kSameTilt = 1e-6;

/// A tilt of the thrust.
struct Tilt {
  double cosine;
  double sine;
};

Tilt turned(const Tilt& tilt, double sine) {
  return {tilt.cosine * kCosStep - tilt.sine * sine, tilt.sine * kCosStep + tilt.cosine * sine};
}

/// A face, seen along its ring: the outward normal, and the offset for thrusts.
struct Face {
  double radial;
  double vertical;
  double offset;
};

struct Builder {
  const Bounds& bounds;
  Vec3 turn;
  double unit;
  Halfspace* planes;
  int count;
};

void add(Builder& builder, const Vec3& normal, double offset) {
  const double room = offset - builder.bounds.hover * normal.z;
  builder.planes[builder.count++] = Halfspace{normal, room / builder.unit * (1.0 - kConstraintMargin)};
}

void add_ring(Builder& builder, const Face& face) {
  for (int side = 0; side < kHorizontalSides; ++side) {
    const Vec3 out = polygon_normal(builder.turn, side);
    add(builder, {face.radial * out.x, face.radial * out.y, face.vertical}, face.offset);
  }
}

/// The face that holds the middles of its edges at two tilts, each on the ball or at zero.
Face face_between(double upper_radius, const Tilt& upper, double lower_radius, const Tilt& lower) {
  const double x = kPolygonInside * upper_radius * upper.sine;
  const double z = upper_radius * upper.cosine;
  const double dx = kPolygonInside * lower_radius * lower.sine - x;
  const double dz = lower_radius * lower.cosine - z;
  const double norm = square_root(dx * dx + dz * dz);
  const Face face{-dz / norm, dx / norm, 0.0};
  return {face.radial, face.vertical, face.radial * x + face.vertical * z};
}

/// The largest tilt that matters: that of the cone, or where the vertical thrust is least.
Tilt largest_tilt(const Bounds& bounds) {
  if (bounds.slope > 0.0) {
    const double cosine = 1.0 / square_root(1.0 + bounds.slope * bounds.slope);
    return {cosine, bounds.slope * cosine};
  }
  const double cosine = clamp((bounds.hover + bounds.lower.z) / bounds.thrust, 0.0, 1.0);
  return {cosine, square_root((1.0 - cosine) * (1.0 + cosine))};
}

/// The tilt of the first ring's lower edge: that of `along`, less as many whole steps as leave some.
Tilt first_tilt(const Vec3& along, double hover, const Tilt& last) {
  const double vertical = along.z + hover;
  const double horizontal = horizontal_length(along);
  const double norm = square_root(vertical * vertical + horizontal * horizontal);
  if (horizontal < kSameTilt * norm) return {kCosStep, kSinStep};
  Tilt tilt = vertical > last.cosine * norm ? Tilt{vertical / norm, horizontal / norm} : last;
  for (int i = 0; i < kMostSteps; ++i) {
    const Tilt above = turned(tilt, -kSinStep);
    if (above.sine < kSameTilt) break;
    tilt = above;
  }
  return tilt;
}

void add_ball(Builder& builder, const Vec3& along, const Tilt& last) {
  const Bounds& bounds = builder.bounds;
  const double highest = bounds.hover + bounds.upper.z;
  const double lowest = bounds.hover + bounds.lower.z;
  Tilt upper{1.0, 0.0};
  Tilt lower = first_tilt(along, bounds.hover, last);
  for (int ring = 0; ring < kMostRings && upper.cosine > last.cosine; ++ring) {
    if (last.sine * lower.cosine - last.cosine * lower.sine < kSameTilt) lower = last;
    const bool too_high = bounds.thrust * lower.cosine >= highest;
    const bool too_low = bounds.thrust * upper.cosine <= lowest;
    const bool too_wide = bounds.horizontal > 0.0 && kPolygonInside * bounds.thrust * upper.sine >= bounds.horizontal;
    if (!too_high && !too_low && !too_wide) {
      add_ring(builder, face_between(bounds.thrust, upper, bounds.thrust, lower));
    }
    upper = lower;
    lower = turned(lower, kSinStep);
  }
}

}  // namespace

int thrust_planes(const Bounds& bounds, const Vec3& along, double unit, Halfspace* planes) noexcept {
  if (!(bounds.thrust > 0.0 || bounds.slope > 0.0)) return 0;
  Builder builder{bounds, horizontal_direction(along), unit, planes, 0};
  const Tilt last = largest_tilt(bounds);
  if (bounds.slope > 0.0) add_ring(builder, face_between(1.0, last, 0.0, last));
  if (bounds.thrust > 0.0) add_ball(builder, along, last);
  return builder.count;
}

}  // namespace tern
