// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where a thing that moves may be, as the certifier reads it: its curve and its error on an interval of time. Times are
// seconds since a trajectory's beginning, in twice a double's precision, and places are relative to its origin: neither
// the age of a track nor the distance from the world's origin costs any digits.
#ifndef TERN_PROVE_TRACK_MOTION_HPP
#define TERN_PROVE_TRACK_MOTION_HPP

#include <cstdint>

#include "base/double_double.hpp"
#include "base/work.hpp"
#include "tern/track.hpp"
#include "tern/trajectory.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// Seconds from one instant to another, both in nanoseconds.
DoubleDouble seconds_between(std::int64_t from, std::int64_t to) noexcept;

/// Stands for a time that never comes.
inline DoubleDouble never() noexcept {
  return DoubleDouble(1e30);
}

/// What the thing does for a while.
enum class SpanKind : std::uint8_t {
  kAbsent,  ///< there is none
  kMoves,   ///< along its velocity, or along a piece
  kRests,   ///< past its last piece: the error still grows
  kStays,   ///< past Track::until
};
struct TrackSpan {
  SpanKind kind;
  std::int32_t piece;  ///< that it moves along
  DoubleDouble begin;  ///< of the piece
  DoubleDouble end;
};

/// Track::measured and Track::until.
struct TrackTimes {
  DoubleDouble measured;
  DoubleDouble until;
};

/// The span that holds from `at` on. `piece` and `begin` are those of an earlier span of the track, or 0 and
/// `times.measured`.
TrackSpan span_at(const Track& track, const TrackTimes& times, std::int32_t piece, DoubleDouble begin,
                  const DoubleDouble& at) noexcept;

/// Control points of the thing's curve and of its error over an interval.
struct ThingMotion {
  Vec3 points[kControlPoints];
  double error[kControlPoints];
  double size;  ///< no less than any number that the points were made of, metres
};

/// The thing's motion from `at` to `to`, both in the span.
void move_thing(const Track& track, const Vec3& origin, const TrackTimes& times, const TrackSpan& span,
                const DoubleDouble& at, const DoubleDouble& to, ThingMotion& motion) noexcept;

/// Of a thing that keeps its velocity: the first and the last of these points and of its error, in doubles alone.
/// `from` and `to`: s since Track::measured. The size covers the rounding, as above.
void sketch_motion(const Track& track, const Vec3& origin, double from, double to, ThingMotion& motion) noexcept;

/// The place at Track::measured, relative to `origin`.
Vec3 first_place(const Track& track, const Vec3& origin) noexcept;

/// `points` become those of the part from u to v, 0 <= u < v <= 1.
void take_part(Vec3* points, double u, double v) noexcept;

/// The part of `duration` that has passed at `at`, within [0, 1].
double share_of(const DoubleDouble& at, const DoubleDouble& begin, double duration) noexcept;

}  // namespace tern

#endif
