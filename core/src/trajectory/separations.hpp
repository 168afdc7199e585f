// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Planes that keep a chain off things that move. Each belongs to a segment and a track, and moves along with the thing:
//
//   normal . (p_k - o_k) >= need_k + support(normal),   k = 0 .. 7
//
// for the control points p_k of the segment and o_k of the thing's centre over the segment's time. o_k and need_k are
// read anew at each assembly, so durations are free to change.
#ifndef TERN_TRAJECTORY_SEPARATIONS_HPP
#define TERN_TRAJECTORY_SEPARATIONS_HPP

#include <cstdint>

#include "base/work.hpp"
#include "qp/qp.hpp"
#include "tern/config.hpp"
#include "tern/trajectory.hpp"
#include "times/chain.hpp"
#include "tracks/approach.hpp"
#include "tracks/thing.hpp"
#include "trajectory/programme.hpp"

namespace tern {

/// What a chain is to be kept off.
struct Scene {
  Things things;
  const Trajectory* reference;  ///< a curve for each of the chain's segments, which says on which side to pass
  double pause[kMaxSegments];   ///< s that the plan rests before each segment
  double rest;                  ///< s that its end is to stay clear
};

struct Separation {
  std::int16_t segment;
  std::int16_t track;
  Vec3 normal;  ///< unit vector from the thing to the plan
};

/// A group of rows in a programme.
struct SeparationRows {
  std::int16_t segment;
  int point_begin;  ///< in the programme
  double length;    ///< s
  double u;         ///< where it begins and ends on the segment
  double v;
  Vec3 normal;
  double behind[kControlPoints];  ///< normal . o_k + need_k
};

struct Separations {
  bool is_full;
  int count;
  Separation list[kMaxSeparations];
  int rows_count;
  SeparationRows rows[kMaxSeparations];
  // The search for what the chain meets: next pair, and what was found.
  int segment;
  int track;
  int added;
  bool is_stuck;             ///< what follows from the ends and the durations alone comes too near to something
  bool by_reference;         ///< it is the reference that is looked at
  Box box;                   ///< around the segment
  double leave[kMaxThings];  ///< gap at the start, of tracks that the plan begins too near to; else negative
};

/// Rows keep this much more than the needed distance, m. Then the proof needs few halvings.
constexpr double kSeparationMargin = 1e-4;

void separations_begin(const Scene& scene, const Vec3& start, Separations& separations) noexcept;

/// Lowers what a stretch needs to what is asked of a plan that leaves the thing. `gap`: Separations::leave.
void ease_leaving(double gap, Stretch& stretch) noexcept;

/// When the segment begins, s since the plan's beginning.
double begin_of(const Chain& chain, const Scene& scene, int segment) noexcept;

/// Begins to look at the chain with these curves for what it meets.
void meet_begin(bool by_reference, Separations& separations) noexcept;

/// Looks at pairs of segments and tracks, and gives each that comes too near a plane, if it has none yet. A piece of
/// work is a pair. True if it has looked at all; `added` says how many planes there are more, and `is_stuck` that
/// planes do not help.
bool meet_advance(const Chain& chain, const Scene& scene, const Vec3 (*points)[kControlPoints],
                  Separations& separations, Work& work) noexcept;

/// Turns each plane to where the curves have most room beyond it, if they have any.
void turn_planes(const Chain& chain, const Scene& scene, const Vec3 (*points)[kControlPoints], Separations& separations,
                 Work& work) noexcept;

/// Appends the rows to the programme. False if there is no room.
bool add_separations(const Chain& chain, const Scene& scene, Separations& separations, ProgrammeScale& scale,
                     QpProblem& problem, Work& work) noexcept;

/// Of a group of rows: its weights, and eight points.
constexpr Operations kRowsOperations = 8 * ops::kCurve;
/// The most operations of a piece of meet_advance().
constexpr Operations kMeetOperations =
    3 * kMostSpans * (kStretchOperations + kPartOperations + kApproachOperations + ops::kTurn * kMaxTrackPieces) +
    3 * kClosestOperations + kNormalOperations;

/// Adds what the rows do to the prices of time: a segment's duration also moves where the things are then, and all
/// earlier durations do.
void add_separation_prices(const Chain& chain, const QpSolution& solution, const ProgrammeScale& scale,
                           const Vec3 (*points)[kControlPoints], const Separations& separations,
                           double* prices) noexcept;

}  // namespace tern

#endif
