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
/// How long a yaw plan is flown before the next one takes over, nanoseconds. A yaw plan first brings the acceleration
/// of its start to 0, so plans that followed each other faster would never turn the nose.
constexpr std::int64_t kNoseHold = 400000000;
/// A longer gap between ticks counts as this, nanoseconds: no yaw plan waits longer for a tick.
constexpr std::int64_t kLongestGap = std::int64_t{10} * 1000000000;
/// The committed plan ends soon if its end is less than this part of the horizon away.
constexpr double kSeekPart = 0.5;
/// A point that moved by less than this counts as the same, metres.
constexpr double kSameWish = 0.1;

Status check_headings(const FlightYaw& yaw) {
  const bool fits = yaw.headings != nullptr && yaw.heading_count >= 1 && yaw.heading_count <= kMaxMissionPoints;
  if (!fits) return Status::kInvalidArgument;
  for (std::int32_t i = 0; i < yaw.heading_count; ++i) {
    const Status status = check_heading(yaw.headings[i]);
    if (status != Status::kOk) return status;
  }
  return Status::kOk;
}

/// Checks the fields that the mode reads.
Status check_mode(const FlightYaw& yaw) {
  switch (yaw.mode) {
    case FlightYawMode::kTowardsUnseen:
    case FlightYawMode::kAlongMotion:
      return Status::kOk;
    case FlightYawMode::kTowardsPoint:
      return finite(yaw.point) ? Status::kOk : Status::kNonFiniteInput;
    case FlightYawMode::kFixed:
      return check_heading(yaw.heading);
    case FlightYawMode::kAtPoints:
      return check_headings(yaw);
  }
  return Status::kInvalidArgument;
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

/// Nanoseconds from one tick to the next, as far as the last two ticks tell.
std::int64_t tick_gap(const FlightState& flight) {
  if (flight.gap > kLongestGap) return kLongestGap;
  return flight.gap > flight.spec.tick ? flight.gap : flight.spec.tick;
}

/// The earliest takeover of a yaw plan that is begun now. It is later by as much as ticks come late.
std::int64_t soonest_turn(const FlightState& flight) {
  return flight.time + (kNoseTicks - 1) * flight.spec.tick + tick_gap(flight);
}

}  // namespace

Status FlightState::check_yaw(const FlightYaw& yaw) const noexcept {
  if (!finite(yaw.acceleration_max) || !finite(yaw.view)) return Status::kNonFiniteInput;
  if (!yaw_limits_valid(spec.yaw_rate, yaw.acceleration_max)) return Status::kLimitsInvalid;
  if (yaw.view < 0.0 || yaw.view > 2.0 * kPi) return Status::kInvalidArgument;
  const Status start_fits = nose.planned ? Status::kOk : check_heading(yaw.start);
  return start_fits != Status::kOk ? start_fits : check_mode(yaw);
}

/// A pending yaw plan still takes over, unless it turns more sharply than the nose may now. Otherwise the nose would
/// never follow a wish that changes at every tick.
void FlightState::set_yaw(const FlightYaw& yaw) noexcept {
  if (!nose.planned) {
    nose.now = at_rest(yaw.start);
    nose.begin = time - kNoseHold;  // the first plan may take over at once
  }
  nose.busy = nose.busy && yaw.acceleration_max >= nose.yaw.acceleration_max;
  nose.planned = true;
  nose.yaw = yaw;
  const std::int32_t count = yaw.mode == FlightYawMode::kAtPoints ? yaw.heading_count : 0;
  for (std::int32_t i = 0; i < count; ++i) nose.headings[i] = yaw.headings[i];
  nose.yaw.headings = nullptr;
  nose.least_cosine = heading_of(0.5 * yaw.view).cosine;
  nose.wish.commits = ~report.committed;  // no plan was made for this
}

YawSample FlightState::yaw_at(std::int64_t t) const noexcept {
  const bool is_next = nose.has_next && t >= nose.next_begin;
  YawSample at = evaluate(is_next ? nose.next : nose.now, seconds_between(is_next ? nose.next_begin : nose.begin, t));
  at.angle += 2.0 * kPi * (is_next ? nose.next_turns : nose.turns);
  return at;
}

/// The wish is as asked for, unless the nose must turn to the next thing to see. It must if the vehicle rests or flies
/// to a lookout, or if the committed plan ends soon and that thing is out of view.
NoseWish FlightState::nose_wish(std::int64_t t) const noexcept {
  NoseWish wish{nose.yaw.mode, nose.yaw.point, nose.yaw.heading, report.committed};
  const Trajectory& flown = latest().flown;
  const Vec3 end = flown.origin + flown.segments[flown.count - 1].points[kDegree];
  const bool ends_soon = distance(sample_at(t).position, end) < kSeekPart * spec.horizon;
  const bool looks = rests() || latest().looks_out || (ends_soon && waits_for_view());
  const bool turns_there = has_goal && !parked && !reaches_goal() && looks;
  if (!turns_there && wish.mode != FlightYawMode::kTowardsUnseen) return wish;
  wish.mode = FlightYawMode::kTowardsPoint;
  wish.point = looking_at(t);
  return wish;
}

/// Spends a share of the tick's work. No plan for the trajectory waits for it.
void FlightState::turn_nose(Work& work) noexcept {
  if (!nose.planned) return;
  if (nose.has_next && time >= nose.next_begin) {
    nose.now = nose.next;
    nose.turns = nose.next_turns;
    nose.begin = nose.next_begin;
    nose.has_next = false;
  }
  drop_late_yaw();
  const bool is_due = !nose.busy && !nose.has_next && soonest_turn(*this) >= nose.begin + kNoseHold;
  if (is_due && !same_wish(nose_wish(time), nose.wish)) begin_yaw(nose_wish(time));
  if (nose.busy) advance_yaw(work, work.left - least(work.left, spec.work_per_tick / kNoseShare));
}

/// Drops a pending yaw plan that is not done one tick before its takeover, as is done with plans of the trajectory. It
/// begins where the nose was to be at that takeover, so a late one would make the nose jump.
void FlightState::drop_late_yaw() noexcept {
  if (!nose.busy || time <= nose.next_begin - spec.tick) return;
  nose.busy = false;
  nose.wish.commits = ~report.committed;
}

void FlightState::begin_yaw(const NoseWish& wish) noexcept {
  const Commitment& flown = latest();
  const std::int64_t soonest = soonest_turn(*this);
  nose.next_begin = soonest > flown.begin ? soonest : flown.begin;
  take_rest(flown.flown, seconds_between(flown.begin, nose.next_begin), kNoseAhead, nose.way);
  const YawSample from = yaw_at(nose.next_begin);
  const double most = nose.yaw.acceleration_max;
  YawRequest request = yaw_request({from.yaw.cosine, from.yaw.sine}, spec.yaw_rate, most);
  request.start_rate = clamp(from.yaw.rate, -kLargestYawRate, kLargestYawRate);  // it may be rounded up
  request.start_acceleration = clamp(from.acceleration, -most, most);
  request.point = wish.point;
  request.heading = wish.heading;
  if (wish.mode == FlightYawMode::kTowardsPoint) request.mode = YawMode::kTowardsPoint;
  if (wish.mode == FlightYawMode::kFixed) request.mode = YawMode::kFixed;
  if (wish.mode == FlightYawMode::kAtPoints) time_headings(request);
  nose.wish = wish;
  nose.busy = nose.planner.begin(nose.way, request) == Status::kRunning;
}

/// Asks for the heading of each point that the committed plan passes, at its time. If it passes none, asks for the
/// heading of the next point.
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

/// Works on the yaw plan as long as more than `kept` units are left. A plan that would be late at the next tick is
/// taken unfinished: it keeps the limits as well.
void FlightState::advance_yaw(Work& work, std::uint32_t kept) noexcept {
  Status status = Status::kRunning;
  while (status == Status::kRunning && work.left > kept) {
    const std::uint32_t effort = nose.planner.unit_effort();
    status = nose.planner.step(1);
    owe(effort, work);
  }
  if (status == Status::kRunning && time + tick_gap(*this) <= nose.next_begin - spec.tick) return;
  nose.planner.finish(nose.next);
  const double begins = evaluate(nose.now, seconds_between(nose.begin, nose.next_begin)).angle;
  nose.next_turns = nose.turns + whole_turns(begins - evaluate(nose.next, 0.0).angle);
  nose.busy = false;
  nose.has_next = true;
}

/// Notes whether something that was not seen yet ended the last proof.
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
