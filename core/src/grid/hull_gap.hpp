// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How far the hulls of a few points each are apart, and along which normal: the algorithm of Gilbert, Johnson and
// Keerthi on the points' differences.
#ifndef TERN_GRID_HULL_GAP_HPP
#define TERN_GRID_HULL_GAP_HPP

#include "tern/halfspace.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// Points whose convex hull is meant.
struct Hull {
  const Vec3* points;
  int count;  ///< >= 1
};

/// A plane between the two: every point of the second lies `distance` or more further along `normal` than every point
/// of the first. True of any outcome, however early the iteration ended.
struct HullGap {
  Vec3 normal;      ///< unit; zero where no plane was found between the two
  double distance;  ///< metres, >= 0; 0 where they meet or nearly so
};

/// False where no plane was found.
bool has_normal(const HullGap& gap) noexcept;

/// min of normal . p over the hull, and max.
double hull_support(const Vec3& normal, const Hull& hull) noexcept;
double hull_reach(const Vec3& normal, const Hull& hull) noexcept;

/// The widest gap, to rounding; at most kGapSteps supports of either hull.
HullGap hull_gap(const Hull& first, const Hull& second) noexcept;
constexpr int kGapSteps = 48;

/// The same from a segment; equal ends are a point.
HullGap segment_hull_gap(const Vec3& from, const Vec3& to, const Hull& hull) noexcept;

/// The widest gap between the segment and the hull of a polyhedron's corners. Where the one above is less than `enough`
/// it is sought from the other end as well, and among the polyhedron's faces: nearly equal corners can tilt a normal by
/// 1e-8, which costs a face that much of its extent. `distance` is < 0 where even the best face, whose normal it then
/// has, leaves no room.
HullGap widest_gap(const Vec3& from, const Vec3& to, const Hull& hull, const Halfspace* faces, int face_count,
                   double enough) noexcept;

}  // namespace tern

#endif
