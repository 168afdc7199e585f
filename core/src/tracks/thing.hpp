// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A track as the planner reads it: where the thing is, and how far a plan has to keep away from it, over an interval of
// time. Plain doubles: what the planner makes of them is proven by code of its own (prove/track_motion.hpp).
#ifndef TERN_TRACKS_THING_HPP
#define TERN_TRACKS_THING_HPP

#include <cstdint>

#include "base/math.hpp"
#include "tern/track.hpp"
#include "tern/trajectory.hpp"
#include "tern/vec3.hpp"
#include "world/solids.hpp"

namespace tern {

/// A convex solid, of a fence for a while: Things::solids has it, relative to the centre. No request has it.
constexpr TrackShape kConvex = static_cast<TrackShape>(3);
/// The most things: tracks, and keep-outs for a while.
constexpr std::int32_t kMaxThings = kMaxTracks + kMaxFences;

/// What a plan is to keep clear of, in the plan's frame and clock.
struct Things {
  const Track* tracks = nullptr;
  std::int32_t count = 0;
  double radius = 0.0;                  ///< m, of the robot
  Vec3 origin{};                        ///< of the plan's frame, world frame
  std::int64_t begin = 0;               ///< ns: when the plan begins
  const ConvexSolid* solids = nullptr;  ///< one for each thing from `first_solid` on
  std::int32_t first_solid = 0;

  /// Of a thing with the shape kConvex. The track is one of `tracks`.
  const ConvexSolid& solid_of(const Track& track) const noexcept { return solids[(&track - tracks) - first_solid]; }
};

/// What a thing does from some instant on. Times are seconds since the plan's beginning.
struct ThingSpan {
  enum Kind : std::uint8_t {
    kAbsent,
    kMoves,  ///< along its velocity or a piece
    kRests,  ///< past its last piece
    kStays,  ///< past Track::until
  };
  Kind kind;
  double end;          ///< what it does until then; infinite if for good
  std::int32_t piece;  ///< that it moves along
  double piece_begin;
};

/// The centre's control points over an interval, and the distance from the thing's shape that a plan has to keep. A
/// ball counts as its centre, and its radius as part of the distance.
struct ThingPart {
  Vec3 points[kControlPoints];
  double need[kControlPoints];
};

/// Seconds from the plan's beginning to a time of its clock.
double seconds_to(std::int64_t time, std::int64_t begin) noexcept;

/// The span that holds from `at` on.
ThingSpan thing_at(const Track& track, std::int64_t begin, double at) noexcept;

/// The thing from `from` to `to`, both in the span.
ThingPart part_of(const Things& things, const Track& track, const ThingSpan& span, double from, double to) noexcept;

/// The centre at an instant, and the distance from the shape that a plan has to keep then. False if the thing is not
/// there.
bool thing_now(const Things& things, const Track& track, double at, Vec3& place, double& need) noexcept;

/// The point of the thing's shape that is closest to `point`, both relative to its centre.
inline Vec3 closest_in(const Things& things, const Track& track, const Vec3& point) {
  const Vec3& half = track.half;
  if (track.shape == kConvex) {
    const HullGap gap = hull_gap({&point, 1}, things.solid_of(track).hull);
    return point + gap.distance * gap.normal;
  }
  if (track.shape == TrackShape::kBall) return kZero;
  const double z = clamp(point.z, -half.z, half.z);
  if (track.shape == TrackShape::kBox) return {clamp(point.x, -half.x, half.x), clamp(point.y, -half.y, half.y), z};
  const double across = horizontal_length(point);
  const double share = across > track.radius ? track.radius / across : 1.0;
  return {share * point.x, share * point.y, z};
}

/// True if a plan at `point` is too near to the thing at an instant.
inline bool is_too_near(const Things& things, const Track& track, const Vec3& point, double at) {
  Vec3 place{};
  double need = 0.0;
  if (!thing_now(things, track, at, place, need)) return false;
  const Vec3 from = point - place;
  return distance(from, closest_in(things, track, from)) < need;
}

/// How far the shape reaches from its centre along a normal.
inline double support_of(const Things& things, const Track& track, const Vec3& normal) {
  if (track.shape == kConvex) return solid_reach(normal, things.solid_of(track));
  const Vec3& half = track.half;
  const double up = absolute(normal.z) * half.z;
  if (track.shape == TrackShape::kBall) return 0.0;
  if (track.shape == TrackShape::kBox) return (absolute(normal.x) * half.x + absolute(normal.y) * half.y) + up;
  return track.radius * horizontal_length(normal) + up;
}

/// The box around the shape, relative to its centre; a ball counts as its centre.
Box extent_of(const Things& things, const Track& track) noexcept;

}  // namespace tern

#endif
