// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tern/proof.hpp"

#include "base/capacity.hpp"
#include "base/math.hpp"
#include "base/work.hpp"
#include "prove/allowed.hpp"
#include "prove/bernstein.hpp"
#include "prove/grants.hpp"

namespace tern {
namespace {

constexpr Voxel kNoVoxel{-1, -1, -1};

}  // namespace

/// The curve is proven until report_.until. Against the tracks, no more needs to be.
void Proof::begin_tracks() noexcept {
  is_watching_ = watches(watched_) && report_.finding != Finding::kMalformed;
  if (!is_watching_) return;
  const bool is_whole = report_.finding == Finding::kNone;
  tracks_.begin_accepted(*trajectory_, from_, is_whole ? __builtin_inf() : report_.until, track_grant_, watched_);
}

/// Goes on with the tracks. What ends that proof ends this one.
void Proof::step_tracks() noexcept {
  if (tracks_.step(*work_) == Status::kRunning) return;
  is_watching_ = false;
  const ProofReport& found = tracks_.report();
  if (found.finding == Finding::kNone || found.finding == Finding::kMalformed) return;
  report_ = found;
}

/// Enters the segment at report_.until.
void Proof::enter(const Trajectory& trajectory) noexcept {
  trajectory_ = &trajectory;
  segment_ = 0;
  begin_ = 0.0;
  while (segment_ + 1 < trajectory.count && report_.until >= begin_ + trajectory.segments[segment_].duration) {
    begin_ += trajectory.segments[segment_].duration;
    ++segment_;
  }
  running_ = true;
  report_.finding = Finding::kNone;
  const double into = (report_.until - begin_) / trajectory.segments[segment_].duration;
  first_ = into >= 0.0 ? smaller(into, 1.0) : 0.0;
  enter_segment();
}

/// True if the segment is finite and has a duration.
bool Proof::sound(const Segment& segment) const noexcept {
  if (!finite(segment.duration) || !(segment.duration > 0.0)) return false;
  for (const Vec3& point : segment.points) {
    if (!finite(point)) return false;
  }
  return segment_ > 0 || finite(trajectory_->origin);
}

/// The excess over the grant of the gap between the segment and the one before, metres; else 0.
double Proof::gap_before(const Segment& segment) const noexcept {
  if (segment_ == 0) return 0.0;
  const double gap = distance(segment.points[0], trajectory_->segments[segment_ - 1].points[kDegree]);
  const double excess = gap - curve_distance(*grid_, *trajectory_);
  if (excess <= 0.0) return 0.0;
  return finite(excess) ? excess : __builtin_inf();
}

void Proof::enter_segment() noexcept {
  lost_ = 1.0;
  part_ = kPosition;
  worst_ = 0.0;
  worst_axis_ = -1;
  const Segment& segment = trajectory_->segments[segment_];
  if (!sound(segment)) return lose(first_, Finding::kMalformed);
  worst_ = gap_before(segment);
  if (!(worst_ > 0.0)) return enter_part(kPosition);
  lose(first_, Finding::kJoint);
  report_.derivative = kPosition;
}

/// Begins a part, position or a derivative: loads its curve from the parameter at which the proof begins.
void Proof::enter_part(int part) noexcept {
  part_ = part;
  pieces_ = 0;
  worst_ = 0.0;
  worst_axis_ = -1;
  const Segment& segment = trajectory_->segments[segment_];
  Piece& piece = stack_[0];
  piece.begin = first_;
  piece.depth = 0;
  const Vec3 place = part == kPosition ? trajectory_->origin - grid_->spec().origin : kZero;
  for (int i = 0; i <= kDegree; ++i) piece.c[i] = segment.points[i];
  for (int k = 0; k < part; ++k) derive(piece.c, kDegree - k, segment.duration);
  Vec3 rest[kControlPoints];
  if (first_ > 0.0) {
    cut(piece.c, kDegree - part, first_, rest);
    for (int i = 0; i <= kDegree - part; ++i) piece.c[i] = rest[i];
  }
  for (int i = 0; i <= kDegree; ++i) piece.c[i] = piece.c[i] + place;
  height_ = 1;
}

/// Notes a loss. Of the losses in a segment's parts, the earliest counts.
void Proof::lose(double u, Finding end) noexcept {
  height_ = 0;
  if (report_.finding != Finding::kNone && u >= lost_) return;
  lost_ = u;
  report_.finding = end;
  report_.segment = segment_;
  report_.axis = worst_axis_;
  report_.excess = end == Finding::kPieces || end == Finding::kMalformed ? 0.0 : worst_;
  report_.derivative = part_ != kPosition ? part_ : -1;
  if (part_ != kPosition) report_.voxel = kNoVoxel;
  if (end != Finding::kFence) report_.fence = kNoFence;
}

/// What a piece takes of the segment's parameter.
double Proof::length_of(const Piece& piece) const noexcept {
  double length = 1.0 - first_;
  for (int k = 0; k < piece.depth; ++k) length *= 0.5;
  return length;
}

/// The piece on top of the stack is proven, halved, or lost.
void Proof::look_at_piece() noexcept {
  Piece& piece = stack_[height_ - 1];
  const int degree = kDegree - part_;
  Finding end = Finding::kPieces;
  work_->spend(2 * ops::kCurve);
  if (is_full(pieces_++ == kProofPieces)) return lose(piece.begin, end);
  if (holds(piece, degree + 1, end)) {
    --height_;
    return;
  }
  note_excess(piece, degree, end);
  if (is_full(piece.depth == kProofDepth)) return lose(piece.begin, end);
  Piece first = piece;
  ++first.depth;
  piece.depth = first.depth;
  cut(first.c, degree, 0.5, piece.c);
  piece.begin = first.begin + length_of(first);
  stack_[height_++] = first;
}

/// The part that follows; kPosition after the last one.
int Proof::part_after(int part) const noexcept {
  if (part == kPosition && has_limits_) return kVelocity;
  if (part == kVelocity) return kAcceleration;
  if (part == kAcceleration && limits_jerk(limits_)) return kJerk;
  return (part == kAcceleration || part == kJerk) && limits_turning(limits_) ? kTurning : kPosition;
}

/// Goes on with the next part, then with the next segment, unless the segment was lost somewhere.
void Proof::end_part() noexcept {
  const Segment& segment = trajectory_->segments[segment_];
  const int next = part_after(part_);
  const bool is_unsound = report_.finding == Finding::kMalformed || report_.finding == Finding::kJoint;
  if (next != kPosition && !is_unsound) return enter_part(next);
  const double end = begin_ + segment.duration;
  if (report_.finding == Finding::kNone) {
    report_.voxel = kNoVoxel;
    report_.fence = kNoFence;
  }
  if (report_.finding != Finding::kNone || segment_ + 1 == trajectory_->count) {
    running_ = false;
    const double until = lost_ < 1.0 ? begin_ + lost_ * segment.duration : end;
    report_.until = larger(report_.until, smaller(until, end));
    return begin_tracks();
  }
  report_.until = begin_ = end;
  first_ = 0.0;
  ++segment_;
  enter_segment();
}

Status Proof::step(Work& work) noexcept {
  if (!running_ && trajectory_ == nullptr) return Status::kInvalidArgument;
  const Operations before = work.operations();
  work_ = &work;
  while (running_ && (height_ == 0 || work.left())) height_ == 0 ? end_part() : look_at_piece();
  if (is_watching_) step_tracks();
  work_ = nullptr;
  spent_ += before - work.operations();
  report_.work = static_cast<uint32_t>((spent_ + kUnit - 1) / kUnit);
  return running_ || is_watching_ ? Status::kRunning : Status::kOk;
}

Status Proof::step(uint32_t work) noexcept {
  slice_.add(work);
  return step(slice_);
}

double clear_until(const Grid& grid, const Trajectory& trajectory, double from, const Limits* limits, Beyond beyond,
                   ProofReport* report) noexcept {
  Proof proof;
  // There are no fences to check, and a check would take stack.
  const bool begun = proof.begin_accepted(grid, trajectory, from, limits, beyond, {}) == Status::kRunning;
  // A segment takes 5 * (kProofPieces + 1) pieces at most.
  for (int i = 0; begun && i <= kMaxSegments && proof.step(~uint32_t{0}) == Status::kRunning; ++i) {
  }
  if (report != nullptr) *report = proof.report();
  return proof.report().until;
}

}  // namespace tern
