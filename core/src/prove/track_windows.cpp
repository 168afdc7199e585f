// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fences for a while, behind the last track. Between two instants at which a fence begins or ends, the same fences
// hold: a piece of the curve must respect each keep-out of them, and lie in one keep-in.
#include "base/capacity.hpp"
#include "base/math.hpp"
#include "prove/fences.hpp"
#include "prove/track_motion.hpp"
#include "prove/track_tube.hpp"
#include "tern/track_proof.hpp"

namespace tern {
namespace {

/// When a fence holds, s since the trajectory's beginning.
struct FenceWindow {
  DoubleDouble begin;
  DoubleDouble end;
};

/// Widened for a keep-out, and narrowed for a keep-in.
FenceWindow window_of(const Fence& fence, const Trajectory& trajectory) {
  const bool keeps_in = fence.kind == FenceKind::kKeepIn;
  const DoubleDouble later(keeps_in ? fence.clock_error : -fence.clock_error);
  return {seconds_between(trajectory.begin, fence.from) + later,
          seconds_between(trajectory.begin, fence.until) - later};
}

Vec3 place_in(const double* point) {
  return {point[0], point[1], point[2]};
}

double size_of_points(const double (*tube)[4]) {
  double size = 0.0;
  for (int i = 0; i < kControlPoints; ++i) {
    size = larger(size, (absolute(tube[i][0]) + absolute(tube[i][1])) + absolute(tube[i][2]));
  }
  return size;
}

bool has_windows(const TrackGrounds& grounds) {
  for (std::int32_t k = 0; k < grounds.fence_count; ++k) {
    if (is_timed(grounds.fences[k])) return true;
  }
  return false;
}

}  // namespace

bool watches(const TrackGrounds& grounds) noexcept {
  return grounds.count > 0 || has_windows(grounds);
}

/// Begins the proof against the fences. False if none is for a while.
bool TrackProof::enter_windows() noexcept {
  track_ = grounds_.count;
  at_ = from_;
  segment_ = 0;
  segment_begin_ = {0.0, 0.0};
  return has_windows(grounds_);
}

/// Loads the curve from at_ to `to`, or to the next instant at which a fence begins or ends.
void TrackProof::load_windows(Time to, Work& work) noexcept {
  work.spend(ops::kPiece * grounds_.fence_count);
  const DoubleDouble at{at_.high, at_.low};
  DoubleDouble end{to.high, to.low};
  for (std::int32_t k = 0; k < grounds_.fence_count; ++k) {
    if (!is_timed(grounds_.fences[k])) continue;
    const FenceWindow window = window_of(grounds_.fences[k], *trajectory_);
    if (at < window.begin && window.begin < end) end = window.begin;
    if (at < window.end && window.end < end) end = window.end;
  }
  to_ = {end.high, end.low};
  number_ = depth_ = looked_at_ = 0;
  Vec3 points[kControlPoints];
  load_curve({end.high, end.low}, points);
  for (int i = 0; i < kControlPoints; ++i) {
    for (int a = 0; a < 3; ++a) tube_[kError].points[i][a] = axis(points[i], a);
    tube_[kError].points[i][3] = 0.0;
  }
  slack_ = rounding_of_size(size_of_points(tube_[kError].points) + grounds_.radius);
}

/// The first fence that the points are not proven to respect during the stretch; kNoFence: none.
int32_t TrackProof::broken_fence(const Vec3* points, int count, Work& work) const noexcept {
  const DoubleDouble at{at_.high, at_.low};
  const DoubleDouble to{to_.high, to_.low};
  const FenceRule rule{trajectory_->origin, (grounds_.radius - grant_) + slack_, grant_ - slack_};
  int32_t keep_in = kNoFence;
  bool holds_now = false;
  bool is_inside = false;
  for (int32_t k = 0; k < grounds_.fence_count; ++k) {
    const Fence& fence = grounds_.fences[k];
    if (!is_timed(fence)) continue;
    const FenceWindow window = window_of(fence, *trajectory_);
    if (fence.kind == FenceKind::kKeepOut) {
      const bool holds = window.begin < to && at < window.end;
      if (holds && !fence_clear(fence, rule, points, count, work)) return k;
      continue;
    }
    const bool holds = !(at < window.begin) && !(window.end < to);
    if (keep_in == kNoFence || (holds && !holds_now)) keep_in = k;
    holds_now = holds_now || holds;
    is_inside = is_inside || (holds && fence_clear(fence, rule, points, count, work));
  }
  return is_inside ? kNoFence : keep_in;
}

/// The piece is proven, halved, or lost.
void TrackProof::look_at_windows(Work& work) noexcept {
  double part[kControlPoints][4];
  work.spend(2 * ops::kCurve);
  take_dyadic_part(tube_[kError].points, number_, depth_, part);
  Vec3 points[kControlPoints];
  for (int i = 0; i < kControlPoints; ++i) points[i] = place_in(part[i]);
  const int32_t broken = broken_fence(points, kControlPoints, work);
  if (broken == kNoFence) return go_on();
  const bool has_more = looked_at_++ < kTrackPieces && depth_ < kTrackDepth;
  if (is_full(!has_more) || broken_fence(points, 1, work) != kNoFence) return lose_to_fence(broken, points[0]);
  ++depth_;
  number_ *= 2;
}

/// The proof ends where the piece begins.
void TrackProof::lose_to_fence(int32_t fence, const Vec3& point) noexcept {
  const FenceRule rule{trajectory_->origin, grounds_.radius - grant_, grant_};
  end_here();
  report_.finding = Finding::kFence;
  report_.track = kNoTrack;
  report_.fence = fence;
  report_.excess = larger(fence_excess(grounds_.fences[fence], rule, point), 0.0);
}

}  // namespace tern
