// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Proves that a trajectory keeps clear of tracks, for all t. Proof and the planner's check contain such a proof; alone
// it needs no grid. docs/tracks.md explains the method.
#ifndef TERN_TRACK_PROOF_HPP
#define TERN_TRACK_PROOF_HPP

#include <stdint.h>

#include "tern/proof_report.hpp"
#include "tern/status.hpp"
#include "tern/track.hpp"
#include "tern/trajectory.hpp"
#include "tern/work.hpp"

namespace tern {

/// Proves a trajectory against tracks, one after the other, and then against fences for a while. The curve minus the
/// thing's curve is again a Bezier curve, piece by piece. A piece is proven if a plane keeps it off the thing's shape
/// by what each control point needs; otherwise it is halved, at most kTrackDepth times over. The proof may end too
/// early, never too late: at all times before its end, the distance is at least the radius and the error less what is
/// granted, in real numbers, however far from the world's origin and however old the tracks are.
class TrackProof {
 public:
  /// Begins. The trajectory and the tracks must stay until the proof is done. `from`: as for Proof::begin(). kRunning,
  /// or why the tracks are refused: as for a Request, and kInvalidArgument for an empty trajectory or a radius or rest
  /// that is negative or not finite. report().track is then the track at fault, report().fence the fence. Whether a
  /// fence is empty is not looked at.
  Status begin(const Trajectory& trajectory, double from, const TrackGrounds& grounds) noexcept;
  /// As begin(), with tracks that were accepted before and did not change, and with a grant of `grant` metres. Proves
  /// no more than what lies before `until`, seconds since the trajectory's beginning.
  void begin_accepted(const Trajectory& trajectory, double from, double until, double grant,
                      const TrackGrounds& grounds) noexcept;
  /// Goes on as long as work is left. kRunning, or kOk: the report is complete.
  Status step(Work& work) noexcept;
  /// What is known so far. Its `until` may be past the end of the trajectory, if rest is to stay clear. The finding is
  /// kTrack, kFence, kMalformed or kNone; `track` says which of the tracks, `fence` which of the fences.
  const ProofReport& report() const noexcept { return report_; }
  /// The first track that the trajectory begins too near to, and is proven to leave; kNoTrack: none.
  int32_t left() const noexcept { return left_; }

 private:
  /// The trajectory's curve less the thing's, and what distance from the thing's shape each control point needs.
  struct Tube {
    double points[kControlPoints][4];
  };
  enum { kError, kReach, kLeave, kTubes };
  /// Seconds, the unevaluated sum of two numbers.
  struct Time {
    double high;
    double low;
  };

  void enter_track(int32_t track) noexcept;
  bool enter_next() noexcept;
  bool is_far() const noexcept;
  bool is_beside() const noexcept;
  void next_stretch(Work& work) noexcept;
  bool load(Time to, Work& work) noexcept;
  void load_curve(Time to, Vec3* points) const noexcept;
  void look_at_start() noexcept;
  void look_at_piece(Work& work) noexcept;
  void go_on() noexcept;
  void pass() noexcept;
  void lose() noexcept;
  void end_here() noexcept;

  // track_windows.cpp: fences for a while.
  bool enter_windows() noexcept;
  bool is_in_windows() const noexcept { return track_ == grounds_.count; }
  void load_windows(Time to, Work& work) noexcept;
  int32_t broken_fence(const Vec3* points, int count, Work& work) const noexcept;
  void look_at_windows(Work& work) noexcept;
  void lose_to_fence(int32_t fence, const Vec3& point) noexcept;

  const Trajectory* trajectory_ = nullptr;
  TrackGrounds grounds_{};
  bool running_ = false;
  bool is_open_ = false;  // a stretch is being proven
  bool has_[kTubes] = {};
  int32_t track_ = 0;  // grounds_.count for the fences
  int32_t left_ = kNoTrack;
  int32_t segment_ = 0;  // that at_ is in; the number of segments for the rest
  int32_t piece_ = 0;    // of the track, that at_ is in
  int32_t number_ = 0;   // of the piece of the stretch, and how often it was halved
  int32_t depth_ = 0;
  int32_t looked_at_ = 0;  // pieces of this stretch
  double grant_ = 0.0;
  double slack_ = 0.0;  // for rounding, m
  double gap_ = 0.0;    // from the shape at the beginning, if the trajectory leaves it
  Time from_{};
  Time at_{};  // seconds since the trajectory's beginning
  Time end_{};
  Time to_{};             // the end of the stretch
  Time segment_begin_{};  // of segment_
  Time piece_begin_{};    // of piece_
  Time measured_{};
  Time until_{};  // Track::until
  Box bounds_{};  // of the trajectory, relative to its origin
  Tube tube_[kTubes] = {};
  int64_t spent_ = 0;
  ProofReport report_{};
};

/// The most halvings of a stretch: of what a segment of the trajectory and a piece of a track share in time.
constexpr int kTrackDepth = 18;
/// The most pieces of one stretch that a proof looks at.
constexpr int kTrackPieces = 2048;

/// True if there is something to be clear of: a track, or a fence for a while.
bool watches(const TrackGrounds& grounds) noexcept;

/// A whole proof in one call. The time until which the trajectory is proven clear of the tracks, in seconds since its
/// beginning: duration(trajectory) + grounds.rest if all of it is, `from` if nothing is or if begin() refuses. `report`
/// may be null.
double clear_until(const Trajectory& trajectory, double from, const TrackGrounds& grounds,
                   ProofReport* report = nullptr) noexcept;

}  // namespace tern

#endif
