// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// One piece of a stretch beside a track: proven, halved, or lost.
#include "base/capacity.hpp"
#include "base/math.hpp"
#include "prove/track_motion.hpp"
#include "prove/track_tube.hpp"
#include "tern/track_proof.hpp"

namespace tern {

/// Notes how far from the thing's shape the trajectory begins, if that is too near.
void TrackProof::look_at_start() noexcept {
  const Track& thing = grounds_.tracks[track_];
  if (!touches(thing, tube_[kError].points[0])) return;
  if (has_[kReach] && !touches(thing, tube_[kReach].points[0])) return;
  const double gap = gap_of(thing, tube_[kError].points[0]);
  if (gap > ball_of(thing)) gap_ = gap;
  if (left_ == kNoTrack) left_ = track_;
}

/// The piece is proven, halved, or lost.
void TrackProof::look_at_piece(Work& work) noexcept {
  const Track& thing = grounds_.tracks[track_];
  if (is_full(looked_at_++ == kTrackPieces)) return lose();
  bool touches_all = true;
  for (int t = 0; t < kTubes; ++t) {
    if (!has_[t]) continue;
    work.spend(2 * ops::kCurve);
    double part[kControlPoints][4];
    take_dyadic_part(tube_[t].points, number_, depth_, part);
    if (plane_keeps_off(thing, part, slack_)) return go_on();
    touches_all = touches_all && touches(thing, part[0]);
  }
  if (touches_all || is_full(depth_ == kTrackDepth)) return lose();
  ++depth_;
  number_ *= 2;
}

/// Goes on behind a piece that is proven.
void TrackProof::go_on() noexcept {
  ++number_;
  while (depth_ > 0 && number_ % 2 == 0) {
    number_ /= 2;
    --depth_;
  }
  if (depth_ == 0) pass();
}

/// Goes on behind the stretch.
void TrackProof::pass() noexcept {
  is_open_ = false;
  at_ = to_;
}

/// The proof ends where the piece begins. Other tracks only matter if they are met earlier.
void TrackProof::lose() noexcept {
  const Track& thing = grounds_.tracks[track_];
  double part[kControlPoints][4];
  double missing = __builtin_inf();
  for (int t = 0; t < kTubes; ++t) {
    if (!has_[t]) continue;
    take_dyadic_part(tube_[t].points, number_, depth_, part);
    missing = smaller(missing, part[0][3] - gap_of(thing, part[0]));
  }
  end_here();
  report_.finding = Finding::kTrack;
  report_.track = track_;
  report_.excess = larger(missing, 0.0);
}

/// Ends the proof where the piece begins.
void TrackProof::end_here() noexcept {
  const DoubleDouble at{at_.high, at_.low};
  const double share = static_cast<double>(number_) / static_cast<double>(1 << depth_);
  const DoubleDouble lost = at + DoubleDouble(share * (DoubleDouble(to_.high, to_.low) - at).high);
  is_open_ = false;
  end_ = at_ = {lost.high, lost.low};
  report_.segment = segment_ < trajectory_->count ? segment_ : trajectory_->count - 1;
}

}  // namespace tern
