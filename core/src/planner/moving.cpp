// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planner/moving.hpp"

#include "base/capacity.hpp"
#include "base/math.hpp"
#include "curve/rest.hpp"

namespace tern {
namespace {

/// Seconds. The longest outlasts a keep-out of half a minute in the middle of the way.
constexpr double kWait[kWaits] = {0.0,  0.25, 0.5,  0.75, 1.0,  1.25, 1.5,  1.75, 2.0,  2.5,
                                  3.0,  3.5,  4.0,  4.5,  5.0,  6.0,  7.0,  8.0,  9.0,  10.0,
                                  11.5, 13.0, 15.0, 18.0, 22.0, 27.0, 33.0, 40.0, 50.0, 60.0};
/// Factors of each segment's duration.
constexpr double kPace[kPaces] = {1.0, 1.08, 1.18, 1.3, 1.5, 1.8, 2.2};

/// s. A wait is as short as can be, to this.
constexpr double kFinestWait = 0.04;
/// s. No segment has no duration, so that of a plan that waits for nothing has this one.
constexpr double kLeastWait = 1e-2;
/// What a plan is granted, as by the check.
constexpr double kGrant = 0.5 * kTrackTolerance;

/// A time and seconds later, or the last or first time there is.
std::int64_t later_by(double seconds, std::int64_t time) {
  constexpr double kLast = 9.2e18;
  const double by = clamp(1e9 * seconds, -kLast, kLast);
  const double at = static_cast<double>(time) + by;
  if (absolute(at) > kLast) return at > 0.0 ? INT64_MAX : INT64_MIN;
  return time + static_cast<std::int64_t>(by);
}

struct Try {
  double wait;
  double pace;
  double ends;  ///< s since the plan comes to its rest
};

/// If the try would end later than Waiting::longest but a shorter wait than the one before would not, it waits for as
/// long as that allows. A negative wait: it does not.
Try try_at(int index, const Waiting& waiting) {
  const int wait = index / kPaces;
  const double pace = kPace[index % kPaces];
  const double flies = pace * waiting.after;
  const double most = waiting.longest - waiting.before - flies;
  if (!(most > 0.0) || (wait > 0 && !(most > kWait[wait - 1]))) return {-1.0, pace, 0.0};
  if (kWait[wait] < most) return {kWait[wait], pace, kWait[wait] + flies};
  return {most, pace, most + flies};
}

/// The plan's segment before which it rests, or -1.
int resting_joint(const Problem& problem, const EndStop* stops) {
  const State& start = problem.asked.start;
  if (at_rest(start)) return 0;
  return stops[0].count > 0 ? stops[0].count : -1;
}

/// A plan that flies more slowly has other velocities at its end and at vias.
bool may_slow_down(const Problem& problem) {
  if (!at_rest(problem.asked.goal)) return false;
  for (std::int32_t v = 0; v < problem.via_count; ++v) {
    if (problem.vias[v].has_velocity) return false;
  }
  return true;
}

/// Inserts a segment that rests before the joint, and moves the vias behind it.
void insert_wait(int joint, std::int32_t via_count, Trajectory& trajectory, ViaMemory& vias) {
  for (int s = trajectory.count; s > joint; --s) trajectory.segments[s] = trajectory.segments[s - 1];
  Segment& wait = trajectory.segments[joint];
  for (Vec3& point : wait.points) point = trajectory.segments[joint + 1].points[0];
  ++trajectory.count;
  for (std::int32_t v = 0; v < via_count; ++v) vias.joint[v] += vias.joint[v] > joint ? 1 : 0;
}

/// The next try in the order of when the plan ends; -1: none is left.
int next_try(const Waiting& waiting) {
  int next = -1;
  double soonest = 0.0;
  for (int k = 1; k < kWaitingTries; ++k) {
    const Try of = try_at(k, waiting);
    const bool rests = k >= kPaces;
    if (of.wait < 0.0 || (rests && !waiting.has_rest) || (of.pace > 1.0 && !waiting.may_slow_down)) continue;
    const bool is_over = of.ends < waiting.ends || (!(waiting.ends < of.ends) && k <= waiting.last);
    if (is_over || (next >= 0 && !(of.ends < soonest))) continue;
    next = k;
    soonest = of.ends;
  }
  return next;
}

/// Sets the durations of a plan that waits and flies on at a pace.
void set_out(double wait, double pace, Waiting& waiting, Trajectory& trajectory) {
  const int first = waiting.joint + (waiting.has_rest ? 1 : 0);
  for (int s = first; s < trajectory.count; ++s) trajectory.segments[s].duration = pace * waiting.duration[s];
  if (waiting.has_rest) trajectory.segments[waiting.joint].duration = larger(wait, kLeastWait);
  waiting.waits = wait;
  waiting.pace = pace;
}

/// Takes the waits and paces out of the durations again.
void undo(Waiting& waiting, Trajectory& trajectory) {
  if (waiting.joint >= 0) set_out(0.0, 1.0, waiting, trajectory);
}

/// Sets the durations of what is proven next. False if no try is left.
bool set_next(Waiting& waiting, Trajectory& trajectory) {
  if (waiting.joint < 0) return false;
  if (waiting.step == WaitingStep::kHalves) {
    set_out(0.5 * (waiting.too_short + waiting.clear), waiting.clear_pace, waiting, trajectory);
    return true;
  }
  if (waiting.step == WaitingStep::kFaster) {
    set_out(waiting.ends - waiting.after, 1.0, waiting, trajectory);
    return true;
  }
  const int next = next_try(waiting);
  if (next < 0) return false;
  const Try of = try_at(next, waiting);
  waiting.last = next;
  waiting.ends = of.ends;
  set_out(of.wait, of.pace, waiting, trajectory);
  return true;
}

/// The longest of the tries' waits that are shorter: with the same pace, it was tried, and is not clear. Without a
/// shorter one, the same.
double shorter_than(double wait) {
  double shorter = smaller(wait, kWait[0]);
  for (const double tried : kWait) {
    if (tried < wait) shorter = tried;
  }
  return shorter;
}

/// The trajectory gets the shortest wait that is known to be clear.
void settle(Waiting& waiting, Trajectory& trajectory) {
  waiting.is_over = true;
  set_out(waiting.clear, waiting.clear_pace, waiting, trajectory);
}

/// What a proof found of the plan with the current durations. True if no shorter wait is worth a try.
bool take(bool is_clear, Waiting& waiting, Trajectory& trajectory) {
  if (waiting.step == WaitingStep::kHalves) {
    (is_clear ? waiting.clear : waiting.too_short) = waiting.waits;
    ++waiting.halvings;
  } else {
    if (is_clear) {
      waiting.clear = waiting.waits;
      waiting.clear_pace = waiting.pace;
      waiting.too_short = shorter_than(waiting.waits);
    }
    if (waiting.clear < 0.0) return false;
    const bool may_be_faster = waiting.step == WaitingStep::kTries && waiting.pace > 1.0 && waiting.has_rest;
    waiting.step = may_be_faster ? WaitingStep::kFaster : WaitingStep::kHalves;
    if (may_be_faster) return false;
  }
  const bool is_short = waiting.clear - waiting.too_short <= kFinestWait || waiting.halvings == kWaitHalvings;
  if (is_short) settle(waiting, trajectory);
  return is_short;
}

/// Begins the proof against all things, or a first look at the one that a try met last: the next try mostly meets it,
/// too.
void begin_proof(const TrackGrounds& grounds, bool is_first_look, const Trajectory& trajectory, Waiting& waiting,
                 Work& work) {
  work.spend(ops::kCurve * trajectory.count);
  TrackGrounds against = grounds;
  if (is_first_look) {
    against.tracks += waiting.met;
    against.count = 1;
    against.fence_count = 0;
  }
  waiting.proof.begin_accepted(trajectory, 0.0, __builtin_inf(), kGrant, against);
  waiting.is_first_look = is_first_look;
  waiting.is_proving = true;
}

}  // namespace

void copy_tracks(const Track* list, std::int32_t count, AskedTracks& asked, Operations& spent) noexcept {
  asked.count = count;
  std::int32_t used = 0;
  for (std::int32_t i = 0; i < count; ++i) {
    asked.track[i] = list[i];
    asked.track[i].pieces = list[i].piece_count > 0 ? asked.pieces + used : nullptr;
    for (std::int32_t p = 0; p < list[i].piece_count; ++p) asked.pieces[used++] = list[i].pieces[p];
  }
  spent += 2 * ops::kPiece * count + ops::kPiece * used;
}

void take_things(const Solids& solids, AskedTracks& asked, Problem& problem) noexcept {
  problem.tracks = asked.track;
  problem.track_count = problem.thing_count = asked.count;
  problem.solids = asked.solids;
  if (!problem.has_windows) return;
  for (std::int32_t k = 0; k < solids.timed_count; ++k) {
    const SolidParts& parts = solids.parts[solids.solid_count + k];
    const Fence& fence = problem.asked_world->fence[parts.index];
    Track& track = asked.track[asked.count + k] = Track{};
    track.measured = later_by(-fence.clock_error, fence.from);
    track.until = later_by(fence.clock_error, fence.until);
    track.end = TrackEnd::kGone;
    track.position = problem.grid->spec().origin;
    track.shape = kConvex;
    asked.solids[k] = solid_of(solids, parts);
  }
  problem.thing_count += solids.timed_count;
}

Conflict conflict_of(const ProofReport& found, std::int32_t left) noexcept {
  const bool is_at_start = found.finding == Finding::kTrack && found.track == left;
  return {is_at_start ? Status::kStartInContact : Status::kNoClearTime, found.track, found.fence, found.until};
}

bool meets_in_time(const Problem& problem, const ProofReport& found) noexcept {
  if (found.finding != Finding::kFence || !problem.has_windows) return found.finding == Finding::kTrack;
  return is_timed(problem.asked_world->fence[found.fence]);
}

void waiting_begin(const Problem& problem, const EndStop* stops, double longest, Trajectory& trajectory,
                   ViaMemory& vias, Waiting& waiting) noexcept {
  const double all = duration(trajectory);
  waiting = Waiting{};
  waiting.is_tried = true;
  waiting.longest = longest;
  waiting.joint = resting_joint(problem, stops);
  waiting.may_slow_down = waiting.joint >= 0 && may_slow_down(problem);
  if (waiting.joint < 0) return;
  waiting.has_rest = !is_full(trajectory.count == kMaxSegments) && waiting.joint < trajectory.count;
  if (waiting.has_rest) insert_wait(waiting.joint, problem.via_count, trajectory, vias);
  for (int s = 0; s < trajectory.count; ++s) waiting.duration[s] = trajectory.segments[s].duration;
  for (int s = 0; s < waiting.joint; ++s) waiting.before += waiting.duration[s];
  waiting.after = all - waiting.before;
  waiting.ends = waiting.after;
  waiting.last = 0;
  if (waiting.has_rest) trajectory.segments[waiting.joint].duration = kLeastWait;
}

Progress waiting_advance(const TrackGrounds& grounds, Trajectory& trajectory, Waiting& waiting, Work& work) noexcept {
  // Each try is two proofs at most; one more is the wait at full pace.
  for (int k = 0; k <= 2 * (kWaitingTries + 1 + kWaitHalvings); ++k) {
    if (waiting.is_proving) {
      if (waiting.proof.step(work) == Status::kRunning) return Progress::kMore;
      waiting.is_proving = false;
      const ProofReport& found = waiting.proof.report();
      const bool is_clear = found.finding == Finding::kNone;
      if (is_clear && waiting.is_first_look) {
        begin_proof(grounds, false, trajectory, waiting, work);
        continue;
      }
      if (!is_clear && !waiting.is_first_look) waiting.met = found.track;
      if (take(is_clear, waiting, trajectory)) return Progress::kDone;
    }
    if (!work.left()) return Progress::kMore;
    work.spend(ops::kTurn * kWaitingTries);
    if (!set_next(waiting, trajectory)) break;
    begin_proof(grounds, waiting.met != kNoTrack, trajectory, waiting, work);
  }
  undo(waiting, trajectory);
  waiting.is_over = true;
  return Progress::kFailed;
}

bool waiting_stop(Trajectory& trajectory, Waiting& waiting) noexcept {
  if (waiting.is_over || waiting.clear < 0.0) return false;
  settle(waiting, trajectory);
  return true;
}

}  // namespace tern
