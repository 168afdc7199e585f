// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Finds out whether half-spaces have a point in common. Half-spaces are added one by one, and their common point
// nearest to a given point is kept up to date (Seidel's incremental method). If a new half-space does not contain the
// nearest point, the new nearest point lies on its plane. The earlier half-spaces are then tried again: first on that
// plane, then on its lines with other planes. All numbers have twice the precision of doubles, because users' normals
// may be parallel but for rounding.
#ifndef TERN_BASE_COMMON_POINT_HPP
#define TERN_BASE_COMMON_POINT_HPP

#include "base/double_double.hpp"
#include "base/triple.hpp"
#include "tern/config.hpp"
#include "tern/halfspace.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// Takes up to kMaxFencePlanes half-spaces. For n of them, it makes at most n^3 / 6 tests of a point.
class CommonPoint {
 public:
  /// Finds the common point nearest to `center`; world frame, metres. Each half-space is enlarged by `margin`. `scale`
  /// > 0: the expected distance of the planes from the centre.
  CommonPoint(const Vec3& center, double margin, double scale) noexcept;

  /// Adds a half-space. Its normal and offset must be finite, and the normal's length within the bounds for fences.
  /// False if it has no point in common with the earlier ones; then no more may be added.
  bool add(const Halfspace& plane) noexcept;
  /// True if the distance of the nearest common point is at most kFarthest times the scale or the distance of the
  /// farthest plane, whichever is larger. Planes that are parallel but for rounding meet further away.
  bool within_reach() const noexcept;
  /// The nearest common point, world frame.
  Vec3 nearest() const noexcept;

  static constexpr double kFarthest = 1e5;

 private:
  using Place = Triple<DoubleDouble>;
  /// The half-space normal . p <= offset, with p relative to the centre.
  struct Wall {
    Vec3 normal;
    double norm;
    DoubleDouble offset;
  };
  /// The points from + s * along with lower <= s <= upper.
  struct Line {
    Place from;
    Place along;
    DoubleDouble lower;
    DoubleDouble upper;
  };

  static bool breaks(const Wall& wall, const Place& p) noexcept;
  static bool shorten(const Wall& wall, Line& line) noexcept;
  bool move_onto(int plane) noexcept;
  bool move_onto(int plane, int other) noexcept;

  Vec3 center_;
  double margin_;
  double scale_;
  int count_ = 0;
  Place nearest_;
  Wall walls_[kMaxFencePlanes];
};

}  // namespace tern

#endif
