// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A segment relative to a thing: how near it comes, and the plane in the thing's frame that parts them best.
#ifndef TERN_TRACKS_APPROACH_HPP
#define TERN_TRACKS_APPROACH_HPP

#include "base/work.hpp"
#include "tern/track.hpp"
#include "tern/trajectory.hpp"
#include "tracks/thing.hpp"

namespace tern {

/// A segment of a plan in the plan's frame and clock.
struct TimedCurve {
  const Vec3* points;  ///< kControlPoints
  double begin;        ///< s since the plan's beginning
  double duration;
};

/// The part of a segment over which the thing does one thing, less the thing's centre.
struct Stretch {
  double begin;  ///< s since the plan's beginning
  double end;
  double u;  ///< where it begins and ends on the segment, 0 .. 1
  double v;
  Vec3 points[kControlPoints];
  double need[kControlPoints];  ///< distance from the thing's shape
};

/// Of what a thing does during a segment, so much is looked at.
constexpr int kMostSpans = 16;
/// Shorter stretches are left out, s.
constexpr double kLeastStretch = 1e-6;

/// The stretch of the segment that begins at `from` or later. False if there is none. `spent` grows by the operations
/// that it took.
bool next_stretch(const Things& things, const Track& track, const TimedCurve& curve, double from, Stretch& stretch,
                  Operations& spent) noexcept;

/// True if a box around the segment shows that all of it keeps `spare` times the needed distance more than that.
/// `spent` grows by the operations that it took.
bool is_far_from(const Things& things, const Track& track, const TimedCurve& curve, const Box& box, double spare,
                 Operations& spent) noexcept;

/// How near a stretch comes: the least distance from the shape less what is needed, and where. If there is plenty, it
/// is rough.
struct Approach {
  double room;
  double u;  ///< on the stretch
};
Approach approach_of(const Things& things, const Track& track, const Stretch& stretch) noexcept;

/// The normal, from the thing to the plan, along which the stretch's control points have the most room; `room` is how
/// much, and negative if no plane was found that parts them.
Vec3 parting_normal(const Things& things, const Track& track, const Stretch& stretch, double& room) noexcept;

/// Of a part of a thing's curve, and of a stretch.
constexpr Operations kPartOperations = 2 * ops::kCurve;
constexpr Operations kStretchOperations = 4 * ops::kCurve;
/// Of an approach and of a normal, but for a convex solid's closest points.
constexpr Operations kApproachOperations = 20 * ops::kCurve;
constexpr Operations kNormalOperations = 60 * 8 * ops::kDot;
/// Of the closest points to the instants of a stretch that are looked at: three steps each.
constexpr Operations closest_operations(const Things& things, const Track& track) noexcept {
  return track.shape == kConvex ? 75 * 3 * (things.solid_of(track).hull.count + 24) * ops::kDot : 0;
}
constexpr Operations kClosestOperations = 75 * 3 * (kMaxSolidCorners + 24) * ops::kDot;

}  // namespace tern

#endif
