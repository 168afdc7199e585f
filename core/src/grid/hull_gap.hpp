// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How far the hulls of a few points each are apart, and along which normal: the algorithm of Gilbert, Johnson and
// Keerthi on the points' differences.
#ifndef TERN_GRID_HULL_GAP_HPP
#define TERN_GRID_HULL_GAP_HPP

#include "tern/vec3.hpp"

namespace tern {

/// Points whose convex hull is meant.
struct Hull {
  const Vec3* points;
  int count;  ///< >= 1
};

/// A plane between the two: every point of the second lies `distance` or more further along `normal` than every point of
/// the first. True of any outcome, however early the iteration ended.
struct HullGap {
  Vec3 normal;      ///< unit; zero where no plane was found between the two
  double distance;  ///< metres, >= 0; 0 where they meet or nearly so
};

/// min of normal . p over the hull, and max.
double hull_support(const Vec3& normal, const Hull& hull) noexcept;
double hull_reach(const Vec3& normal, const Hull& hull) noexcept;

/// The widest gap, to rounding; at most kGapSteps supports of either hull.
HullGap hull_gap(const Hull& first, const Hull& second) noexcept;
constexpr int kGapSteps = 48;

/// The same from a segment; equal ends are a point.
HullGap segment_hull_gap(const Vec3& from, const Vec3& to, const Hull& hull) noexcept;

}  // namespace tern

#endif
