// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Do half-spaces have a point in common? The point that is nearest to a given one is kept up to date while they come
// one by one (Seidel's incremental method). A half-space that does not hold the nearest point has the new one on its
// plane; there the earlier half-spaces are gone through in the same way, down to a line. All of it is in twice the
// precision of doubles, because users' normals may be parallel but for rounding.
#ifndef TERN_BASE_COMMON_POINT_HPP
#define TERN_BASE_COMMON_POINT_HPP

#include "base/double_double.hpp"
#include "base/triple.hpp"
#include "tern/config.hpp"
#include "tern/halfspace.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// For kMaxFencePlanes half-spaces: at most their number to the power of three, over six, tests of a point.
class CommonPoint {
 public:
  /// The points near `center` matter; world frame, metres. Each half-space counts as larger by `margin`. `scale`: how
  /// far from the centre planes can be expected, > 0.
  CommonPoint(const Vec3& center, double margin, double scale) noexcept;

  /// Adds a half-space whose normal and offset are finite, the normal's length within the bounds for fences. False if
  /// it has no point in common with the earlier ones; then there is nothing to add any more.
  bool add(const Halfspace& plane) noexcept;
  /// True if the nearest common point is at most kFarthest times as far away as the scale, or as one of the planes.
  /// Planes that should be parallel, but for rounding, meet further away.
  bool within_reach() const noexcept;

  static constexpr double kFarthest = 1e5;

 private:
  using Place = Triple<DoubleDouble>;
  /// normal . p <= offset, p relative to the centre.
  struct Wall {
    Vec3 normal;
    double norm;
    DoubleDouble offset;
  };
  /// Points from + s along of a line, from lower to upper.
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
