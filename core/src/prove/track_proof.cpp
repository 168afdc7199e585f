// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tern/track_proof.hpp"

#include "base/fence_fault.hpp"
#include "base/math.hpp"
#include "base/track_fault.hpp"
#include "base/work.hpp"
#include "prove/track_motion.hpp"
#include "prove/track_tube.hpp"

namespace tern {
namespace {

template <typename Time>
DoubleDouble seconds(const Time& time) {
  return {time.high, time.low};
}

const DoubleDouble& earlier(const DoubleDouble& a, const DoubleDouble& b) {
  return b < a ? b : a;
}

/// Exactly the sum of all durations.
DoubleDouble length_of(const Trajectory& trajectory) {
  DoubleDouble sum(0.0);
  for (int i = 0; i < trajectory.count; ++i) sum = sum + DoubleDouble(trajectory.segments[i].duration);
  return sum;
}

bool is_sound(const Trajectory& trajectory) {
  for (int i = 0; i < trajectory.count; ++i) {
    const Segment& segment = trajectory.segments[i];
    if (!finite(segment.duration) || !(segment.duration > 0.0)) return false;
    for (const Vec3& point : segment.points) {
      if (!finite(point)) return false;
    }
  }
  return finite(trajectory.origin);
}

void take_in(const Segment& segment, Box& box) {
  for (const Vec3& point : segment.points) {
    for (int a = 0; a < 3; ++a) {
      axis(box.lower, a) = smaller(axis(box.lower, a), axis(point, a));
      axis(box.upper, a) = larger(axis(box.upper, a), axis(point, a));
    }
  }
}

Box box_of(const Trajectory& trajectory) {
  Box box{trajectory.segments[0].points[0], trajectory.segments[0].points[0]};
  for (int i = 0; i < trajectory.count; ++i) take_in(trajectory.segments[i], box);
  return box;
}

}  // namespace

Status TrackProof::begin(const Trajectory& trajectory, double from, const TrackGrounds& grounds) noexcept {
  running_ = false;
  trajectory_ = nullptr;
  report_ = ProofReport{};
  report_.until = from > 0.0 ? from : 0.0;
  report_.finding = Finding::kMalformed;
  if (trajectory.count < 1 || trajectory.count > kMaxSegments) return Status::kInvalidArgument;
  const bool fits = finite(grounds.radius) && finite(grounds.rest) && grounds.radius >= 0.0 && grounds.rest >= 0.0;
  if (!fits) return Status::kInvalidArgument;
  const TrackFault fault = find_track_fault(grounds.tracks, grounds.count);
  report_.track = fault.track;
  if (fault.status != Status::kOk) return fault.status;
  const FenceFault of_fence = find_form_fault(grounds.fences, grounds.fence_count);
  report_.fence = of_fence.fence;
  if (of_fence.status != Status::kOk) return of_fence.status;
  begin_accepted(trajectory, from, __builtin_inf(), kTrackTolerance, grounds);
  return Status::kRunning;
}

void TrackProof::begin_accepted(const Trajectory& trajectory, double from, double until, double grant,
                                const TrackGrounds& grounds) noexcept {
  trajectory_ = &trajectory;
  grounds_ = grounds;
  grant_ = grant;
  spent_ = 0;
  left_ = kNoTrack;
  is_open_ = false;
  report_ = ProofReport{};
  report_.until = from > 0.0 ? from : 0.0;
  running_ = watches(grounds) && report_.until < until;
  if (!is_sound(trajectory)) {
    running_ = false;
    report_.finding = Finding::kMalformed;
    return;
  }
  const DoubleDouble all = length_of(trajectory) + DoubleDouble(grounds.rest);
  const DoubleDouble end = earlier(all, DoubleDouble(smaller(until, 1e30)));
  from_ = {report_.until, 0.0};
  end_ = {end.high, end.low};
  bounds_ = box_of(trajectory);
  track_ = -1;
  if (running_) running_ = enter_next();
  if (running_) return;
  report_.until = larger(report_.until, end.high);
}

/// Begins with what comes next: a track, or the fences behind the last one. False if nothing is left.
bool TrackProof::enter_next() noexcept {
  if (track_ + 1 > grounds_.count) return false;
  if (track_ + 1 == grounds_.count) return enter_windows();
  enter_track(track_ + 1);
  return true;
}

/// Begins the proof against a track.
void TrackProof::enter_track(int32_t track) noexcept {
  track_ = track;
  at_ = from_;
  piece_ = 0;
  gap_ = 0.0;
  const Track& thing = grounds_.tracks[track];
  const DoubleDouble measured = seconds_between(trajectory_->begin, thing.measured);
  const DoubleDouble until = seconds_between(trajectory_->begin, thing.until);
  measured_ = piece_begin_ = {measured.high, measured.low};
  until_ = {until.high, until.low};
  segment_ = 0;
  segment_begin_ = {0.0, 0.0};
  if (is_far()) at_ = end_;
}

/// True if the box around the trajectory is apart from all that a thing without pieces may reach until the end.
bool TrackProof::is_far() const noexcept {
  const Track& thing = grounds_.tracks[track_];
  if (thing.piece_count > 0 || !(seconds(from_) < seconds(end_))) return false;
  const TrackTimes times{seconds(measured_), seconds(until_)};
  DoubleDouble from = seconds(from_) < times.measured ? times.measured : seconds(from_);
  DoubleDouble to = seconds(end_) < times.measured ? times.measured : seconds(end_);
  const bool ends = thing.end != TrackEnd::kGoesOn && times.until < to;
  double growth = 0.0;
  if (ends) {
    growth = thing.end == TrackEnd::kReach ? thing.reach * (to - times.until).high : 0.0;
    to = times.until;
    if (to < from) from = to;
  }
  ThingMotion motion;
  move_thing(thing, trajectory_->origin, times, {SpanKind::kMoves, 0, times.measured, never()}, from, to, motion);
  const double reach = (motion.error[kDegree] + growth) + (grounds_.radius + ball_of(thing));
  return are_apart(thing, motion, reach, bounds_);
}

/// True if the box around the segment, or around the end, is apart from all that a thing without pieces may reach from
/// at_ to to_, while it moves.
bool TrackProof::is_beside() const noexcept {
  const Track& thing = grounds_.tracks[track_];
  if (thing.piece_count > 0) return false;
  const DoubleDouble measured = seconds(measured_);
  ThingMotion motion;
  sketch_motion(thing, trajectory_->origin, (seconds(at_) - measured).high, (seconds(to_) - measured).high, motion);
  const bool rests = segment_ == trajectory_->count;
  const Segment& segment = trajectory_->segments[rests ? segment_ - 1 : segment_];
  Box box{segment.points[kDegree], segment.points[kDegree]};
  if (!rests) take_in(segment, box);
  return are_apart(thing, motion, motion.error[kDegree] + (grounds_.radius + ball_of(thing)), box);
}

/// Goes on to the next stretch that something is to be proven of.
void TrackProof::next_stretch(Work& work) noexcept {
  work.spend(ops::kPiece);
  const DoubleDouble at = seconds(at_);
  const DoubleDouble end = seconds(end_);
  if (!(at < end)) {
    work.spend(ops::kCurve);
    running_ = enter_next();
    if (!running_) report_.until = larger(report_.until, end.high);
    return;
  }
  DoubleDouble to = end;
  while (segment_ < trajectory_->count) {
    const DoubleDouble behind = seconds(segment_begin_) + DoubleDouble(trajectory_->segments[segment_].duration);
    to = earlier(behind, end);
    if (at < behind) break;
    segment_begin_ = {behind.high, behind.low};
    ++segment_;
    to = end;
  }
  if (is_in_windows()) {
    is_open_ = true;
    return load_windows({to.high, to.low}, work);
  }
  const DoubleDouble leave = seconds(from_) + DoubleDouble(kLeaveTime);
  if (grounds_.leaves && at < leave) to = earlier(to, leave);
  is_open_ = load({to.high, to.low}, work);
  if (!is_open_) pass();
}

/// The curve from at_ to `to`, which is in one segment or in the rest.
void TrackProof::load_curve(Time to, Vec3* points) const noexcept {
  const bool rests = segment_ == trajectory_->count;
  const Segment& segment = trajectory_->segments[rests ? segment_ - 1 : segment_];
  for (int i = 0; i < kControlPoints; ++i) points[i] = segment.points[rests ? kDegree : i];
  if (rests) return;
  const DoubleDouble begin = seconds(segment_begin_);
  take_part(points, share_of(seconds(at_), begin, segment.duration), share_of(seconds(to), begin, segment.duration));
}

/// Loads the tubes from at_ to `to`, or to the end of the track's span. True if the curve is near all of them.
bool TrackProof::load(Time to, Work& work) noexcept {
  const Track& thing = grounds_.tracks[track_];
  const TrackTimes times{seconds(measured_), seconds(until_)};
  const DoubleDouble at = seconds(at_);
  const TrackSpan span = span_at(thing, times, piece_, seconds(piece_begin_), at);
  const DoubleDouble end = earlier(seconds(to), span.end);
  to_ = {end.high, end.low};
  piece_ = span.piece;
  piece_begin_ = {span.begin.high, span.begin.low};
  number_ = depth_ = looked_at_ = 0;
  if (span.kind == SpanKind::kAbsent) return false;
  work.spend(2 * ops::kPiece);
  if (span.kind == SpanKind::kMoves && is_beside()) return false;
  work.spend(4 * ops::kCurve);

  Vec3 points[kControlPoints];
  load_curve({end.high, end.low}, points);
  ThingMotion motion;
  move_thing(thing, trajectory_->origin, times, span, at, end, motion);
  const double distance = (grounds_.radius + ball_of(thing)) - grant_;
  slack_ = make_tube(points, motion, distance, tube_[kError].points) + rounding_of_size(shape_size(thing));
  has_[kReach] = thing.reach > 0.0;
  if (has_[kReach]) {
    const double since = (at - times.measured).high;
    const Vec3 place = first_place(thing, trajectory_->origin);
    hold(place, thing.error + thing.reach * since, thing.reach * (end - at).high, motion);
    slack_ =
        larger(slack_, make_tube(points, motion, distance, tube_[kReach].points) + rounding_of_size(shape_size(thing)));
  }
  has_[kError] = true;
  has_[kLeave] = false;
  if (grounds_.leaves && !(seconds(from_) < at)) look_at_start();
  if (gap_ > 0.0) {
    const double since = (at - seconds(from_)).high - kLeaveTime;
    const bool leads_away = !(since < 0.0);
    has_[kLeave] = true;
    widen(tube_[kError].points, gap_ - grant_ + (leads_away ? kLeaveSpeed * since : 0.0),
          leads_away ? kLeaveSpeed * (end - at).high : 0.0, tube_[kLeave].points);
  }
  for (int t = 0; t < kTubes; ++t) {
    if (has_[t] && axis_keeps_off(thing, tube_[t].points, slack_)) return false;
  }
  return true;
}

Status TrackProof::step(Work& work) noexcept {
  const Operations before = work.operations();
  while (running_ && work.left()) {
    if (!is_open_) {
      next_stretch(work);
    } else {
      is_in_windows() ? look_at_windows(work) : look_at_piece(work);
    }
  }
  spent_ += before - work.operations();
  report_.work = static_cast<uint32_t>((spent_ + kUnit - 1) / kUnit);
  return running_ ? Status::kRunning : Status::kOk;
}

double clear_until(const Trajectory& trajectory, double from, const TrackGrounds& grounds,
                   ProofReport* report) noexcept {
  TrackProof proof;
  const bool begun = proof.begin(trajectory, from, grounds) == Status::kRunning;
  Work work;
  // A stretch for each segment, each piece and what lies between, of each track.
  for (int i = 0; begun && i <= (kMaxTracks + 1) * (kMaxSegments + 8) + kMaxTrackPieces + 2 * kMaxFences; ++i) {
    work.add(~uint32_t{0});
    if (proof.step(work) == Status::kOk) break;
  }
  if (report != nullptr) *report = proof.report();
  return proof.report().until;
}

}  // namespace tern
