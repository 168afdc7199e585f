// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "flight/flight_facts.hpp"

#include "base/math.hpp"
#include "base/track_fault.hpp"
#include "flight/chain.hpp"
#include "grid/bit_rows.hpp"
#include "planner/validate.hpp"
#include "tern/track_proof.hpp"

namespace tern {
namespace {

/// How far a window's middle may be off the vehicle after it moved: a voxel, and along x half a word and the slack.
Vec3 offset_after_move(const RollingMap& map) {
  return map.safe().spec().cell * Vec3{0.5 * kWordBits + map.spec().slack + 1.0, 1.0, 1.0};
}

/// How far a plan leads away from `center` along an axis, from time `t` on.
double extent_along(const Trajectory& plan, double t, const Vec3& center, int a) {
  double extent = 0.0;
  double end = 0.0;
  for (int i = 0; i < plan.count; ++i) {
    end += plan.segments[i].duration;
    if (end < t && i + 1 < plan.count) continue;
    for (const Vec3& point : plan.segments[i].points) {
      extent = larger(extent, absolute(axis(plan.origin, a) + axis(point, a) - axis(center, a)));
    }
  }
  return extent;
}

}  // namespace

void FlightFacts::begin(const FlightSpec& how, const RollingMap& over, const Vec3& position, std::int64_t t) noexcept {
  spec = how;
  limits = MotionLimits(how.limits);
  map = over;
  clock.set(t, 0);
  asked_fences = how.fences;
  read_fences();
  shown = t;
  frames = map.frames();
  plans.hover_at(position);
  find_meetings(*this);
}

void FlightFacts::begin_tick(std::int64_t t) noexcept {
  const std::int64_t next = clock.time_of(t);
  gap = next - time;
  time = next;
  shown = t;
}

void FlightFacts::set_clock(std::int64_t t) noexcept {
  clock.set(t, time + spec.tick);
  read_fences();
  shown = clock.shown_at(time);
}

/// A window that is too far away for the flight's times is still one.
void FlightFacts::read_fences() noexcept {
  has_windows = false;
  for (std::int32_t k = 0; k < spec.fence_count; ++k) {
    fences[k] = asked_fences[k];
    if (!is_timed(fences[k])) continue;
    has_windows = true;
    fences[k].from = clock.time_of(asked_fences[k].from);
    fences[k].until = clock.time_of(asked_fences[k].until);
    if (fences[k].from == fences[k].until) --fences[k].from;
  }
  spec.fences = fences;
}

bool FlightFacts::note_frame() noexcept {
  if (map.frames() == frames) return false;
  frames = map.frames();
  frame_time = time;
  return true;
}

bool FlightFacts::note_position(const Vec3& position, std::int64_t t) noexcept {
  const std::int64_t when = clock.time_of(t);
  Vec3 planned;
  return plans.was_at(when, planned) &&
         stray.note(distance(position, planned), map.safe().spec().tracking_margin, when);
}

std::int64_t FlightFacts::time_to_answer(std::int64_t t) const noexcept {
  const std::int64_t wanted = clock.time_of(t);
  return wanted < time ? time : wanted;
}

Status FlightFacts::read_track(const Track& measured, Track& taken) const noexcept {
  taken = measured;
  const TrackFault fault = find_track_fault(&taken, 1);
  if (fault.status != Status::kOk) return fault.status;
  if (taken.piece_count == 0) taken.pieces = nullptr;
  taken.measured = clock.time_of(measured.measured);
  if (taken.end != TrackEnd::kGoesOn) taken.until = clock.time_of(measured.until);
  const bool is_ahead = taken.pieces == nullptr && taken.measured > time + spec.tick;
  return is_ahead ? Status::kInvalidArgument : Status::kOk;
}

/// The window moves no further than it must: space that leaves it is forgotten, and may hold the only way to the goal.
/// A window that is wide enough covers the horizon around the vehicle. No move cuts off the committed plan, with the
/// radius around it.
void FlightFacts::follow_vehicle() noexcept {
  const GridSpec& window = map.safe().spec();
  const Vec3 at = position();
  const Vec3 offset = offset_after_move(map);
  const double needed = spec.horizon + window.clearance() + kAimVoxels * window.cell;
  const Commitment& commitment = plans.latest();
  Vec3 center = 0.5 * (window.boundary.lower + window.boundary.upper);
  for (int a = 0; a < 3; ++a) {
    const double half = 0.5 * (axis(window.boundary.upper, a) - axis(window.boundary.lower, a));
    const double spare = larger(0.0, half - axis(offset, a) - needed);
    axis(center, a) = clamp(axis(center, a), axis(at, a) - spare, axis(at, a) + spare);
    const double room = half - axis(offset, a) - window.clearance() - window.cell;
    if (extent_along(commitment.trajectory, commitment.time_at(time), center, a) > room) return;
  }
  map.follow(center);
}

Vec3 FlightFacts::position() const noexcept {
  return plans.sample_at(time).position;
}

/// At full speed, every plan may be continued.
bool FlightFacts::is_too_fast_at(std::int64_t takeover) const noexcept {
  const double share = stray.speed_share();
  return share < 1.0 && gauge(limits.velocity, plans.sample_at(takeover).velocity) > share * (1.0 + kLimitSlack);
}

bool FlightFacts::in_window(const Vec3& place) const noexcept {
  const GridSpec& window = map.safe().spec();
  const double margin = window.clearance() + kAimVoxels * window.cell;
  for (int a = 0; a < 3; ++a) {
    if (axis(place, a) < axis(window.boundary.lower, a) + margin) return false;
    if (axis(place, a) > axis(window.boundary.upper, a) - margin) return false;
  }
  return true;
}

}  // namespace tern
