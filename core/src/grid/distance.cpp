// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Distances of points and segments from a box.
#include "grid/distance.hpp"

#include "base/math.hpp"
#include "grid/lattice.hpp"

namespace tern {
namespace {

/// The most crossings of a segment with the planes of a box's faces.
constexpr int kMaxCrossings = 6;

/// Values of t in ascending order: the crossings with the planes of faces. There is room for 0 and 1, too.
struct Breaks {
  int count;
  double t[kMaxCrossings + 2];
};

void insert(Breaks& breaks, double t) {
  if (!(t > 0.0 && t < 1.0)) return;
  int k = breaks.count++;
  for (; k > 0 && breaks.t[k - 1] > t; --k) breaks.t[k] = breaks.t[k - 1];
  breaks.t[k] = t;
}

/// The ends of the pieces: 0, the crossings in ascending order, 1.
Breaks piece_ends(const Vec3& a, const Vec3& along, const Box& box) {
  Breaks breaks;
  breaks.count = 0;
  for (int i = 0; i < 3; ++i) {
    const double d = axis(along, i);
    if (!(d < 0.0 || d > 0.0)) continue;
    insert(breaks, (axis(box.lower, i) - axis(a, i)) / d);
    insert(breaks, (axis(box.upper, i) - axis(a, i)) / d);
  }
  for (int k = breaks.count; k > 0; --k) breaks.t[k] = breaks.t[k - 1];
  breaks.t[0] = 0.0;
  breaks.t[++breaks.count] = 1.0;
  ++breaks.count;
  return breaks;
}

/// Half the derivative of the squared distance on one piece: slope * t + offset, slope >= 0.
struct Derivative {
  double slope;
  double offset;
};

/// On each axis, a whole piece is below, inside or above the box. `middle` is a t within the piece.
Derivative derivative_on_piece(const Vec3& a, const Vec3& along, const Box& box, double middle) {
  Derivative derivative{0.0, 0.0};
  for (int i = 0; i < 3; ++i) {
    const double d = axis(along, i);
    const double p = axis(a, i) + middle * d;
    const double nearest = clamp(p, axis(box.lower, i), axis(box.upper, i));
    if (!(p < nearest || p > nearest)) continue;
    derivative.slope += d * d;
    derivative.offset += d * (axis(a, i) - nearest);
  }
  return derivative;
}

/// The t of the minimum. The derivative never falls, so the minimum lies in the first piece in which the derivative
/// reaches 0.
double closest_t(const Vec3& a, const Vec3& along, const Box& box) {
  const Breaks ends = piece_ends(a, along, box);
  for (int k = 0; k + 1 < ends.count; ++k) {
    const double begin = ends.t[k];
    const double end = ends.t[k + 1];
    const Derivative derivative = derivative_on_piece(a, along, box, 0.5 * (begin + end));
    if (derivative.slope * begin + derivative.offset >= 0.0) return begin;
    if (derivative.slope * end + derivative.offset >= 0.0) {
      return clamp(-derivative.offset / derivative.slope, begin, end);
    }
  }
  return 1.0;
}

double size_of(const Vec3& v) {
  return (absolute(v.x) + absolute(v.y)) + absolute(v.z);
}

}  // namespace

double contact_tolerance(const GridSpec& spec) noexcept {
  const Vec3 extent{spec.dims.x * spec.cell, spec.dims.y * spec.cell, spec.dims.z * spec.cell};
  const double rounding = kWorldUlps * size_of(spec.origin) + (kWorldUlps + kLocalUlps) * size_of(extent);
  return kClearTolerance * larger(1.0, spec.cell) + kWorldRounding * rounding;
}

double direction_tolerance(const GridSpec& spec) noexcept {
  return kMetricDirection * larger(1.0, spec.cell);
}

Vec3 nearest_in_box(const Vec3& p, const Box& box) noexcept {
  return {clamp(p.x, box.lower.x, box.upper.x), clamp(p.y, box.lower.y, box.upper.y),
          clamp(p.z, box.lower.z, box.upper.z)};
}

ClosestPair segment_box_closest(const Vec3& a, const Vec3& b, const Box& box) noexcept {
  const Vec3 along = b - a;
  ClosestPair pair;
  pair.t = closest_t(a, along, box);
  // The end itself, not a + 1 (b - a), which may round to another point.
  pair.on_segment = pair.t < 1.0 ? a + pair.t * along : b;
  pair.on_box = nearest_in_box(pair.on_segment, box);
  const Vec3 apart = pair.on_segment - pair.on_box;
  pair.distance_squared = dot(apart, apart);
  return pair;
}

double segment_box_distance_squared(const Vec3& a, const Vec3& b, const Box& box) noexcept {
  return segment_box_closest(a, b, box).distance_squared;
}

}  // namespace tern
