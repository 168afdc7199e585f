// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Yaw plans in flight: one after the other, each from the angle, rate and acceleration that the last one has when it
// takes over.
#include "flight/nose.hpp"

#include "base/math.hpp"
#include "flight/branch.hpp"
#include "flight/flight_state.hpp"
#include "yaw/angle.hpp"
#include "yaw/yaw_check.hpp"

namespace tern {
namespace {

/// How far ahead the nose is planned, seconds.
constexpr double kNoseAhead = 4.0;
/// The part of a tick's units that yaw plans may spend.
constexpr std::uint32_t kNoseShare = 4;
/// A yaw plan is flown for so long, nanoseconds, before the next one takes over: a plan brings the acceleration of its
/// start to 0 first, so that plans that follow each other faster would never turn.
constexpr std::int64_t kNoseHold = 400000000;
/// What is flown ends soon where it is less than this part of the horizon away.
constexpr double kSeekPart = 0.5;
/// A place that moved by less is the same, metres.
constexpr double kSameWish = 0.1;

bool points_somewhere(const Heading& h) {
  return finite(h) && has_direction(h);
}

bool headings_fit(const FlightYaw& yaw) {
  if (yaw.headings == nullptr || yaw.heading_count < 1 || yaw.heading_count > kMaxMissionPoints) return false;
  for (std::int32_t i = 0; i < yaw.heading_count; ++i) {
    if (!points_somewhere(yaw.headings[i])) return false;
  }
  return true;
}

bool mode_fits(const FlightYaw& yaw) {
  switch (yaw.mode) {
    case FlightYawMode::kTowardsUnseen:
    case FlightYawMode::kAlongMotion:
      return true;
    case FlightYawMode::kTowardsPoint:
      return finite(yaw.point);
    case FlightYawMode::kFixed:
      return points_somewhere(yaw.heading);
    case FlightYawMode::kAtPoints:
      return headings_fit(yaw);
  }
  return false;
}

/// A nose that stays where it is.
YawPlan at_rest(const Heading& heading) {
  YawPlan plan{};
  plan.count = 1;
  plan.step = 1.0;
  plan.polynomial[0] = angle_of(heading);
  for (double& point : plan.points) point = plan.polynomial[0];
  return plan;
}

bool same_heading(const Heading& a, const Heading& b) {
  return same(a.cosine, b.cosine) && same(a.sine, b.sine);
}

bool same_wish(const NoseWish& a, const NoseWish& b) {
  return a.mode == b.mode && a.commits == b.commits && same_heading(a.heading, b.heading) &&
         distance(a.point, b.point) < kSameWish;
}

}  // namespace

Status check_flight_yaw(const FlightYaw& yaw, double rate) noexcept {
  if (!finite(yaw.acceleration_max) || !finite(yaw.view)) return Status::kNonFiniteInput;
  if (!yaw_limits_valid(rate, yaw.acceleration_max)) return Status::kLimitsInvalid;
  const bool view_fits = yaw.view >= 0.0 && yaw.view <= 2.0 * kPi;
  return view_fits && points_somewhere(yaw.start) && mode_fits(yaw) ? Status::kOk : Status::kInvalidArgument;
}

void FlightState::set_yaw(const FlightYaw& yaw) noexcept {
  if (!nose.planned) {
    nose.now = at_rest(yaw.start);
    nose.begin = time - kNoseHold;  // the first plan may take over at once
  }
  nose.planned = true;
  nose.busy = false;
  nose.yaw = yaw;
  const std::int32_t count = yaw.mode == FlightYawMode::kAtPoints ? yaw.heading_count : 0;
  for (std::int32_t i = 0; i < count; ++i) nose.headings[i] = yaw.headings[i];
  nose.yaw.headings = nullptr;
  nose.least_cosine = heading_of(0.5 * yaw.view).cosine;
  nose.wish.commits = ~report.committed;  // no plan was made for this
}

YawSample FlightState::yaw_at(std::int64_t t) const noexcept {
  const bool is_next = nose.has_next && t >= nose.next_begin;
  return evaluate(is_next ? nose.next : nose.now, seconds_between(is_next ? nose.next_begin : nose.begin, t));
}

/// As asked for, unless what is flown ends soon and the next thing to see is out of view: then the nose turns to it.
NoseWish FlightState::nose_wish(std::int64_t t) const noexcept {
  NoseWish wish{nose.yaw.mode, nose.yaw.point, nose.yaw.heading, report.committed};
  const Trajectory& flown = latest().flown;
  const Vec3 end = flown.origin + flown.segments[flown.count - 1].points[kDegree];
  const bool ends_soon = distance(sample_at(t).position, end) < kSeekPart * spec.horizon;
  const bool seeks = has_goal && !parked && !reaches_goal() && (rests() || (ends_soon && waits_for_view()));
  if (!seeks && wish.mode != FlightYawMode::kTowardsUnseen) return wish;
  wish.mode = FlightYawMode::kTowardsPoint;
  wish.point = looking_at(t);
  return wish;
}

/// A share of the tick's work, and never a plan for the trajectory waits for it.
void FlightState::turn_nose(Work& work) noexcept {
  if (!nose.planned) return;
  if (nose.has_next && time >= nose.next_begin) {
    nose.now = nose.next;
    nose.begin = nose.next_begin;
    nose.has_next = false;
  }
  const bool is_due = !nose.busy && !nose.has_next && time + kNoseTicks * spec.tick >= nose.begin + kNoseHold;
  if (is_due && !same_wish(nose_wish(time), nose.wish)) begin_yaw(nose_wish(time));
  if (nose.busy) advance_yaw(work, work.left - least(work.left, spec.work_per_tick / kNoseShare));
}

void FlightState::begin_yaw(const NoseWish& wish) noexcept {
  const Commitment& flown = latest();
  const std::int64_t soonest = time + kNoseTicks * spec.tick;
  nose.next_begin = soonest > flown.begin ? soonest : flown.begin;
  take_rest(flown.flown, seconds_between(flown.begin, nose.next_begin), kNoseAhead, nose.way);
  const YawSample from = yaw_at(nose.next_begin);
  const double most = nose.yaw.acceleration_max;
  YawRequest request = yaw_request({from.yaw.cosine, from.yaw.sine}, spec.yaw_rate, most);
  request.start_rate = from.yaw.rate;
  request.start_acceleration = clamp(from.acceleration, -most, most);
  request.point = wish.point;
  request.heading = wish.heading;
  if (wish.mode == FlightYawMode::kTowardsPoint) request.mode = YawMode::kTowardsPoint;
  if (wish.mode == FlightYawMode::kFixed) request.mode = YawMode::kFixed;
  if (wish.mode == FlightYawMode::kAtPoints) time_headings(request);
  nose.wish = wish;
  nose.busy = nose.planner.begin(nose.way, request) == Status::kRunning;
}

/// The headings of the points that are passed, each at its time; where none is, that of the next point.
void FlightState::time_headings(YawRequest& request) noexcept {
  const Commitment& flown = latest();
  const std::int32_t last = nose.yaw.heading_count - 1;
  const double from = seconds_between(flown.begin, nose.next_begin);
  request.mode = YawMode::kTimed;
  request.timed = nose.timed;
  double latest_time = 0.0;
  for (std::int32_t i = 0; i < flown.passages && flown.goal == goal_number; ++i) {
    const Passage& passage = flown.passage[i];
    const double t = passage.time - from;
    if (passage.time > flown.branch || !(t > latest_time)) continue;
    nose.timed[request.timed_count++] = {t, nose.headings[passage.point < last ? passage.point : last]};
    latest_time = t;
  }
  if (request.timed_count > 0) return;
  request.mode = YawMode::kFixed;
  request.heading = nose.headings[itinerary.leg < last ? itinerary.leg : last];
}

/// As long as more than `kept` units are left. A plan that is not done in time is taken as it is: it keeps the limits,
/// too.
void FlightState::advance_yaw(Work& work, std::uint32_t kept) noexcept {
  Status status = Status::kRunning;
  while (status == Status::kRunning && work.left > kept) {
    const std::uint32_t effort = nose.planner.unit_effort();
    status = nose.planner.step(1);
    owe(effort, work);
  }
  if (status == Status::kRunning && time + spec.tick < nose.next_begin) return;
  nose.planner.finish(nose.next);
  nose.busy = false;
  nose.has_next = true;
}

/// What ended the proof at hand: something that was not seen yet?
void FlightState::note_view() noexcept {
  const Grid& safe = map.safe();
  const Grid& seen = map.route();
  const Voxel& voxel = proof.report().voxel;
  nose.has_unseen = proof.report().end == ProofEnd::kObstacle && seen.bound() && !seen.obstacle(voxel);
  if (nose.has_unseen) nose.unseen = safe.spec().origin + safe.center(voxel);
}

/// The next thing to see is outside the field of view: the flight goes on once the nose has turned.
bool FlightState::waits_for_view() const noexcept {
  if (!nose.planned || !(nose.yaw.view > 0.0) || !nose.has_unseen || !has_goal || parked) return false;
  const Vec3 way = nose.unseen - sample_at(time).position;
  const YawSample at = yaw_at(time);
  const double ahead = way.x * at.yaw.cosine + way.y * at.yaw.sine;
  return ahead < nose.least_cosine * square_root(way.x * way.x + way.y * way.y);
}

}  // namespace tern
