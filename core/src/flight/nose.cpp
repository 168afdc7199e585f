// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "flight/nose.hpp"

#include "base/math.hpp"
#include "flight/branch.hpp"
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
constexpr std::int64_t kLeastTurn = 400000000;
/// A longer gap between ticks counts as this, nanoseconds: no yaw plan waits longer for a tick.
constexpr std::int64_t kLongestGap = std::int64_t{10} * 1000000000;
/// The committed plan ends soon if its end is less than this part of the horizon away.
constexpr double kSeekPart = 0.5;
/// A point that moved by less than this counts as the same, metres.
constexpr double kSameWish = 0.1;
/// A look around stays this much longer in each direction than the turn takes, seconds: frames are late.
constexpr double kLookTime = 0.3;
constexpr double kQuarterTurn = 0.5 * kPi;
/// NoseWish::commits of a wish that no yaw plan was made for.
constexpr std::uint32_t kNoCommits = 0xFFFFFFFFu;

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
std::int64_t tick_gap(const FlightFacts& flight) {
  if (flight.gap > kLongestGap) return kLongestGap;
  return flight.gap > flight.spec.tick ? flight.gap : flight.spec.tick;
}

/// The earliest takeover of a yaw plan that is begun now. It is later by as much as ticks come late.
std::int64_t soonest_turn(const FlightFacts& flight) {
  return flight.time + (kNoseTicks - 1) * flight.spec.tick + tick_gap(flight);
}

}  // namespace

Status Nose::check(const FlightSpec& spec, const FlightYaw& wanted) const noexcept {
  if (!finite(wanted.acceleration_max) || !finite(wanted.field_of_view)) return Status::kNonFiniteInput;
  if (!yaw_limits_valid(spec.yaw_rate, wanted.acceleration_max)) return Status::kLimitsInvalid;
  if (wanted.field_of_view < 0.0 || wanted.field_of_view > 2.0 * kPi) return Status::kInvalidArgument;
  const Status start_fits = is_planned ? Status::kOk : check_heading(wanted.start);
  return start_fits != Status::kOk ? start_fits : check_mode(wanted);
}

/// A pending yaw plan still takes over, unless it turns more sharply than the nose may now. Otherwise the nose would
/// never follow a wish that changes at every tick.
void Nose::set(const FlightFacts& flight, const FlightYaw& wanted) noexcept {
  if (!is_planned) {
    in_flight.plan = at_rest(wanted.start);
    in_flight.begin = flight.time - kLeastTurn;  // the first plan may take over at once
  }
  is_pending = is_pending && wanted.acceleration_max >= yaw.acceleration_max;
  is_planned = true;
  yaw = wanted;
  const std::int32_t count = wanted.mode == FlightYawMode::kAtPoints ? wanted.heading_count : 0;
  for (std::int32_t i = 0; i < count; ++i) headings[i] = wanted.headings[i];
  yaw.headings = nullptr;
  least_cosine = heading_of(0.5 * wanted.field_of_view).cosine;
  wish.commits = kNoCommits;
}

YawSample Nose::at(std::int64_t t) const noexcept {
  const NoseTurn& turn = has_waiting && t >= waiting.begin ? waiting : in_flight;
  YawSample sample = evaluate(turn.plan, seconds_between(turn.begin, t));
  sample.angle += 2.0 * kPi * turn.turns;
  return sample;
}

/// The wish is as asked for, unless the nose must turn to the next thing to see. It must if the vehicle rests or flies
/// to a lookout, or if the committed plan ends soon and that thing is out of view.
NoseWish Nose::wish_of(const FlightFacts& flight, const Vec3& look_at, bool looks_out,
                       std::uint32_t commits) const noexcept {
  NoseWish wanted{yaw.mode, yaw.point, yaw.heading, commits};
  const CommittedPlans& plans = flight.plans;
  const bool ends_soon = distance(flight.position(), plans.latest().end()) < kSeekPart * flight.spec.horizon;
  const bool looks = flight.rests() || looks_out || (ends_soon && waits_for_nose(flight));
  const bool turns_there = flight.itinerary.goes_on() && !flight.itinerary.is_reached_by(plans.in_flight) && looks;
  if (!turns_there && wanted.mode != FlightYawMode::kTowardsUnseen) return wanted;
  wanted.mode = FlightYawMode::kTowardsPoint;
  wanted.point = look_at;
  return wanted;
}

/// Spends a share of the tick's work. No plan for the trajectory waits for it.
void Nose::turn(const FlightFacts& flight, const Vec3& look_at, bool looks_out, std::uint32_t commits,
                Work& work) noexcept {
  if (!is_planned) return;
  if (has_waiting && flight.time >= waiting.begin) {
    in_flight = waiting;
    has_waiting = false;
  }
  drop_late(flight);
  const bool is_due = !is_pending && !has_waiting && soonest_turn(flight) >= in_flight.begin + kLeastTurn;
  if (is_due) {
    const NoseWish wanted = wish_of(flight, look_at, looks_out, commits);
    if (!same_wish(wanted, wish)) begin(flight, wanted);
  }
  if (is_pending) advance(flight, work);
}

/// Drops a pending yaw plan that is not done one tick before its takeover, as is done with plans of the trajectory. It
/// begins where the nose was to be at that takeover, so a late one would make the nose jump.
void Nose::drop_late(const FlightFacts& flight) noexcept {
  if (!is_pending || flight.time <= waiting.begin - flight.spec.tick) return;
  is_pending = false;
  wish.commits = kNoCommits;
}

void Nose::begin(const FlightFacts& flight, const NoseWish& wanted) noexcept {
  const Commitment& latest = flight.plans.latest();
  const std::int64_t soonest = soonest_turn(flight);
  waiting.begin = soonest > latest.begin() ? soonest : latest.begin();
  take_remainder(latest.trajectory, latest.time_at(waiting.begin), kNoseAhead, way);
  const YawSample from = at(waiting.begin);
  const double most = yaw.acceleration_max;
  YawRequest request = yaw_request({from.yaw.cosine, from.yaw.sine}, flight.spec.yaw_rate, most);
  request.start_rate = clamp(from.yaw.rate, -kLargestYawRate, kLargestYawRate);  // it may be rounded up
  request.start_acceleration = clamp(from.acceleration, -most, most);
  request.point = wanted.point;
  request.heading = wanted.heading;
  if (wanted.mode == FlightYawMode::kTowardsPoint) request.mode = YawMode::kTowardsPoint;
  if (wanted.mode == FlightYawMode::kFixed) request.mode = YawMode::kFixed;
  if (wanted.mode == FlightYawMode::kAtPoints) time_headings(flight, request);
  wish = wanted;
  is_pending = planner.begin(way, request) == Status::kRunning;
}

void Nose::time_headings(const FlightFacts& flight, YawRequest& request) noexcept {
  const Commitment& latest = flight.plans.latest();
  const std::int32_t last = yaw.heading_count - 1;
  const double from = latest.time_at(waiting.begin);
  request.mode = YawMode::kTimed;
  request.timed = timed;
  double latest_time = 0.0;
  for (std::int32_t i = 0; i < latest.passages && latest.mission == flight.itinerary.number; ++i) {
    const Passage& passage = latest.passage[i];
    const double t = passage.time - from;
    if (passage.time > latest.branch || !(t > latest_time)) continue;
    timed[request.timed_count++] = {t, headings[passage.point < last ? passage.point : last]};
    latest_time = t;
  }
  if (request.timed_count > 0) return;
  request.mode = YawMode::kFixed;
  request.heading = headings[flight.itinerary.leg < last ? flight.itinerary.leg : last];
}

/// Works on the yaw plan with its share of the tick's units. A plan that would be late at the next tick is taken
/// unfinished: it keeps the limits as well.
void Nose::advance(const FlightFacts& flight, Work& work) noexcept {
  Share share(work, kUnit * (flight.spec.work_per_tick / kNoseShare));
  const Status status = planner.step(share.part);
  if (status == Status::kRunning && flight.time + tick_gap(flight) <= waiting.begin - flight.spec.tick) return;
  planner.finish(waiting.plan);
  const double begins = evaluate(in_flight.plan, seconds_between(in_flight.begin, waiting.begin)).angle;
  waiting.turns = in_flight.turns + whole_turns(begins - evaluate(waiting.plan, 0.0).angle);
  is_pending = false;
  has_waiting = true;
}

void Nose::note_view(const RollingMap& map, const ProofReport& found) noexcept {
  const Grid& safe = map.safe();
  const Grid& seen = map.route();
  has_unseen = found.finding == Finding::kObstacle && seen.bound() && !seen.obstacle(found.voxel);
  if (has_unseen) unseen = safe.spec().origin + safe.center(found.voxel);
}

bool Nose::waits_for_nose(const FlightFacts& flight) const noexcept {
  const bool needs_view = is_planned && yaw.field_of_view > 0.0 && has_unseen;
  if (!needs_view || !flight.itinerary.goes_on()) return false;
  const Vec3 direction = unseen - flight.position();
  const YawSample now = at(flight.time);
  const double ahead = direction.x * now.yaw.cosine + direction.y * now.yaw.sine;
  return ahead < least_cosine * horizontal_length(direction);
}

/// A planned turn begins late, and takes time to speed up and to slow down.
double Nose::seconds_per_direction(const FlightSpec& spec) const noexcept {
  double seconds = kQuarterTurn / spec.yaw_rate + kLookTime;
  if (is_planned) seconds += spec.yaw_rate / yaw.acceleration_max + 1e-9 * kNoseTicks * static_cast<double>(spec.tick);
  return seconds;
}

}  // namespace tern
