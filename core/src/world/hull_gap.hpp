// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The gap between two hulls of a few points each: how wide it is, and along which normal. Uses the algorithm of
// Gilbert, Johnson and Keerthi on the differences of the points.
#ifndef TERN_WORLD_HULL_GAP_HPP
#define TERN_WORLD_HULL_GAP_HPP

#include "base/work.hpp"
#include "tern/halfspace.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// The convex hull of some points.
struct Hull {
  const Vec3* points;
  int count;  ///< >= 1
};

/// A gap between two hulls: every point of the second hull lies at least `distance` further along `normal` than every
/// point of the first. This holds however early the iteration ended.
struct HullGap {
  Vec3 normal;      ///< unit; zero if no plane between the two was found
  double distance;  ///< metres, >= 0; 0 if they meet or nearly meet
};

/// False if no plane was found.
bool has_normal(const HullGap& gap) noexcept;

/// The minimum of normal . p over the hull (hull_support), and the maximum (hull_reach).
double hull_support(const Vec3& normal, const Hull& hull) noexcept;
double hull_reach(const Vec3& normal, const Hull& hull) noexcept;

/// The widest gap, to within rounding. Computes at most kGapSteps supports of either hull.
HullGap hull_gap(const Hull& first, const Hull& second) noexcept;
/// Operations of a gap between hulls of so many points together, in ten steps: each finds the extreme points of both,
/// and tries all faces of a simplex.
constexpr Operations gap_operations(int points) noexcept {
  return 10 * (points + 24) * ops::kDot;
}
/// Of hulls of eight points each.
constexpr Operations kGapOperations = gap_operations(2 * 8);
constexpr int kGapSteps = 48;

/// The widest gap between a segment and a hull; equal ends are a point.
HullGap segment_hull_gap(const Vec3& from, const Vec3& to, const Hull& hull) noexcept;

/// The widest gap between the segment and the hull of a polyhedron's corners. If segment_hull_gap() is less than
/// `enough`, also tries the segment from its other end, and the polyhedron's faces. Nearly equal corners can tilt a
/// normal by 1e-8, which makes the gap narrower by that share of a face's extent. If even the best face leaves no room,
/// `distance` is < 0 and the normal is that of this face.
HullGap widest_gap(const Vec3& from, const Vec3& to, const Hull& hull, const Halfspace* faces, int face_count,
                   double enough) noexcept;

}  // namespace tern

#endif
