// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Tracks: things that move, as tubes in time. A track belongs to one request or one proof and changes nothing in the
// grid. docs/tracks.md says what is promised of plans among tracks, and what is not.
#ifndef TERN_TRACK_HPP
#define TERN_TRACK_HPP

#include <stdint.h>

#include "tern/fence.hpp"
#include "tern/status.hpp"
#include "tern/trajectory.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// The shape of a thing around its centre, axes as in the world frame. Any other number is refused.
enum class TrackShape : uint8_t {
  kBall = 0,      ///< of Track::radius
  kCylinder = 1,  ///< upright, of Track::radius, Track::half.z up and down
  kBox = 2,       ///< Track::half to both sides on each axis
};

/// What holds after Track::until. Any other number is refused.
enum class TrackEnd : uint8_t {
  kGoesOn = 0,  ///< motion and growth of the error never end; Track::until is not read
  kGone = 1,    ///< the thing is in nobody's way any more
  kStays = 2,   ///< it stays where its curve is at `until`, with the error of then
  kReach = 3,   ///< as kStays, and the error grows on by Track::reach metres a second
};

/// A piece of a thing's curve: a Bezier curve of degree 7, as a Segment. Curves of a lower degree have one of degree 7
/// that is equal.
struct TrackPiece {
  double duration;              ///< s, > 0
  Vec3 points[kControlPoints];  ///< m, relative to Track::position, axes as in the world frame
};

/// A thing that moves: its shape about a centre that moves along a curve, and how far the centre may be from that
/// curve. If every member is zero, the track is a point that never moves and never ends. World frame, metres, seconds,
/// and nanoseconds of the clock of Request::begin and Trajectory::begin.
///
/// s seconds after `measured`, the centre is within error + error_speed * s + error_growth * s^2 / 2 of its curve. The
/// quadratic term is for what may accelerate: a thing that was measured with a velocity and has an acceleration of a at
/// most has error_growth a. Before `measured`, there is no such thing. Times that are never during a plan are no error:
/// plans do not keep clear of it (docs/tracks.md says how to notice).
///
/// Numbers must be finite (kNonFiniteInput) and no larger than kMaxTrackNumber; sizes, errors and `reach` are not
/// negative; durations are above 0; `until` is not before `measured` if it counts. Else the answer is kInvalidArgument.
struct Track {
  /// When it was measured, ns: its curve and its error begin then.
  int64_t measured = 0;
  /// The time to which its motion is known, ns: see `end`.
  int64_t until = 0;
  /// Its centre at `measured`, m. With pieces: the point that they are relative to.
  Vec3 position{};
  /// m/s. With pieces, it counts for nothing.
  Vec3 velocity{};
  /// Null for a thing that keeps its velocity. Else `piece_count` pieces in order, which the caller owns; the first one
  /// begins at `measured`. After the last one, it stays where that ended.
  const TrackPiece* pieces = nullptr;
  /// At most kMaxTrackPieces for all tracks of a request together (kTrackPiecesFull).
  int32_t piece_count = 0;
  /// Yours, for your own use: who it is, and of what class.
  uint32_t id = 0;
  uint32_t kind = 0;
  TrackShape shape = TrackShape::kBall;
  TrackEnd end = TrackEnd::kGoesOn;
  /// m, of a ball or a cylinder.
  double radius = 0.0;
  /// m, of a box; of a cylinder, z is half its height.
  Vec3 half{};
  double error = 0.0;         ///< m
  double error_speed = 0.0;   ///< m/s
  double error_growth = 0.0;  ///< m/s^2
  /// m/s: the thing also stays within error + reach * s of its place at `measured`. What is clear of one of the two
  /// tubes is clear of the thing. 0: nothing is known.
  double reach = 0.0;
};
/// The largest number that a track may have.
constexpr double kMaxTrackNumber = 1e12;

/// Means "no track" in place of a track's index, as in Report::track.
constexpr int32_t kNoTrack = -1;

/// Another vehicle's trajectory as a track: a ball of `radius` along it, without error, that stays at its end. `pieces`
/// has room for `room` pieces and must stay as long as the track is used. For another clock's error, set Track::error
/// to it times the largest speed. kOk; kInvalidArgument for a trajectory without segments or a null pointer;
/// kTrackPiecesFull if it has more segments than there is room. Then `track` is untouched.
Status track_of(const Trajectory& trajectory, double radius, TrackPiece* pieces, int32_t room, Track& track) noexcept;

/// What a trajectory is to keep clear of.
struct TrackGrounds {
  /// An array of `count`, which must stay until the proof is done; null with count 0.
  const Track* tracks = nullptr;
  int32_t count = 0;
  /// m, >= 0: how far the robot's centre stays from each thing.
  double radius = 0.0;
  /// s, >= 0: for how long the end of the trajectory is to stay clear, too.
  double rest = 0.0;
  /// The trajectory may begin nearer to a thing than it should, if it leads away: from its beginning it may come no
  /// nearer to the thing's curve than it is then, and after kLeaveTime, its distance grows by kLeaveSpeed at least.
  bool leaves = false;
  /// Fences, of which only those for a while count: an array of `fence_count`, which must stay until the proof is done;
  /// null with fence_count 0.
  const Fence* fences = nullptr;
  int32_t fence_count = 0;
};
/// s and m/s: how a trajectory leads away from a thing that it begins too near to.
constexpr double kLeaveTime = 1.0;
constexpr double kLeaveSpeed = 0.25;
/// s: reports do not say until when a rest stays clear if that is longer than this.
constexpr double kRestHorizon = 3600.0;
/// m: by this much less than `radius` and its error a trajectory may be away from a thing. A plan is granted half of
/// it.
constexpr double kTrackTolerance = 4e-9;

}  // namespace tern

#endif
