// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The request's tracks, and the attempt to be clear of them by time alone: to wait where the plan rests, and to fly on
// more slowly. It costs proofs only, and changes no curve.
#ifndef TERN_PLANNER_MOVING_HPP
#define TERN_PLANNER_MOVING_HPP

#include <cstdint>

#include "base/progress.hpp"
#include "base/work.hpp"
#include "planner/end_stop.hpp"
#include "planner/problem.hpp"
#include "planner/vias.hpp"
#include "tern/status.hpp"
#include "tern/track.hpp"
#include "tern/track_proof.hpp"
#include "tern/trajectory.hpp"
#include "tracks/thing.hpp"

namespace tern {

/// The request's tracks, copied, and behind them the keep-outs for a while as things that stand still. The tracks point
/// into `pieces`, so they may not move.
struct AskedTracks {
  std::int32_t count;  ///< of the request's
  Track track[kMaxThings];
  ConvexSolid solids[kMaxFences];  ///< of the keep-outs
  TrackPiece pieces[kMaxTrackPieces];
};

/// Copies the caller's tracks, which find_track_fault() has accepted. `spent` grows by the operations that it took.
void copy_tracks(const Track* list, std::int32_t count, AskedTracks& asked, Operations& spent) noexcept;

/// Lists the things of the problem: the copied tracks, and the keep-outs for a while among its fences, whose solids
/// have been read in the grid's local frame. Their centre is that frame's origin.
void take_things(const Solids& solids, AskedTracks& asked, Problem& problem) noexcept;

/// What the first plan to a goal met.
struct Conflict {
  Status status = Status::kOk;  ///< kStartInContact, kGoalCovered or kNoClearTime
  std::int32_t track = kNoTrack;
  std::int32_t fence = kNoFence;
  double until = 0.0;  ///< s since the plan's beginning
};

/// Waits and paces that are tried, in the order of the plan's end.
constexpr int kWaits = 30;
constexpr int kPaces = 7;
constexpr int kWaitingTries = kWaits * kPaces;
/// Shorter waits that are tried after one that is clear, by halving.
constexpr int kWaitHalvings = 12;

enum class WaitingStep : std::uint8_t {
  kTries,   ///< waits and paces, until one is clear
  kFaster,  ///< after one at a slower pace: the wait at full pace that arrives when it does
  kHalves,  ///< shorter waits at the pace of the one that is clear
};

struct Waiting {
  bool is_tried = false;  ///< for the trajectory in memory
  bool is_over = false;   ///< and it is known whether that helps
  WaitingStep step = WaitingStep::kTries;
  double waits = 0.0;                ///< s that the trajectory in memory waits
  double pace = 1.0;                 ///< factor of its other durations
  double longest = __builtin_inf();  ///< s: no plan that takes longer is of use
  int joint = 0;                     ///< before this segment, it rests; -1: nowhere
  bool has_rest = false;             ///< a segment was inserted there
  bool may_slow_down = false;
  int last = -1;        ///< the try that was made last
  double ends = 0.0;    ///< s since the plan comes to its rest, when it arrives
  double clear = -1.0;  ///< s: the shortest wait that is clear so far; negative: none is
  double clear_pace = 1.0;
  double too_short = 0.0;  ///< s: a shorter one that is not; or `clear`, if no shorter one is tried
  int halvings = 0;
  std::int32_t met = kNoTrack;  ///< the track that the last proof against all things met
  bool is_proving = false;
  bool is_first_look = false;  ///< the proof is one against that track alone
  double before = 0.0;         ///< s that the trajectory takes before the joint
  double after = 0.0;
  double duration[kMaxSegments] = {};  ///< of each segment, before any try
  TrackProof proof;
};

/// What a plan met that the check refused because of a track: `found`. `left`: the first track that it begins too near
/// to.
Conflict conflict_of(const ProofReport& found, std::int32_t left) noexcept;

/// True if the check refused a plan because of a track or of a fence for a while.
bool meets_in_time(const Problem& problem, const ProofReport& found) noexcept;

/// Begins to look for a time for the trajectory, such that it takes `longest` seconds at most. Inserts a segment that
/// rests, if there is room for one.
void waiting_begin(const Problem& problem, const EndStop* stops, double longest, Trajectory& trajectory,
                   ViaMemory& vias, Waiting& waiting) noexcept;

/// A piece of work is one of the proof against tracks. kDone: the trajectory now is clear of all tracks. kFailed: no
/// wait and no pace helps; the trajectory flies at its own pace, and the segment that rests has the least duration.
Progress waiting_advance(const TrackGrounds& grounds, Trajectory& trajectory, Waiting& waiting, Work& work) noexcept;

/// Ends the look before it is over. True if a wait is known to be clear: the trajectory now has the shortest such one.
bool waiting_stop(Trajectory& trajectory, Waiting& waiting) noexcept;

}  // namespace tern

#endif
