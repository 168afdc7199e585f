// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The calls of a flight after its start, and one tick.
#include "tern/flight.hpp"

#include "base/math.hpp"
#include "flight/flight_state.hpp"
#include "map/map_state.hpp"

namespace tern {
namespace {

std::int32_t count_points(const Itinerary& itinerary, PointState state) {
  std::int32_t count = 0;
  for (std::int32_t i = 0; i < itinerary.count; ++i) count += itinerary.state[i] == state ? 1 : 0;
  return count;
}

}  // namespace

Status Flight::set_goal(const Vec3& goal) noexcept {
  if (state_ == nullptr) return Status::kInvalidArgument;
  Via point;
  point.position = goal;
  return set_mission(&point, 1, ViaPolicy::kEnd);
}

Status Flight::set_mission(const Via* points, int32_t count, ViaPolicy policy) noexcept {
  if (state_ == nullptr) return Status::kInvalidArgument;
  const Status status = check_mission(points, count, policy);
  if (status == Status::kOk) state_->begin_mission(points, count, policy);
  return status;
}

Status Flight::stop() noexcept {
  if (state_ == nullptr) return Status::kInvalidArgument;
  state_->has_goal = state_->is_looking = false;
  state_->stopping = true;
  state_->reason = FlightReason::kNoGoal;
  if (state_->job != Job::kEvade) state_->job = Job::kIdle;  // the job's plan led to the goal
  return Status::kOk;
}

/// The flight's time to answer for: never before the last tick, because the past is never commanded again.
std::int64_t FlightState::time_to_answer(std::int64_t t) const noexcept {
  const std::int64_t wanted = clock.time_of(t);
  return wanted < time ? time : wanted;
}

/// The map, too, takes any time for its next frame: frames carry times of the same clock.
void FlightState::set_clock(std::int64_t t) noexcept {
  clock.set(t, time + spec.tick);
  shown = clock.shown_at(time);
  map.state_->timed = false;
}

const Commitment& FlightState::commitment_at(std::int64_t t) const noexcept {
  return has_next && t >= next.begin ? next : now;
}

Sample FlightState::sample_at(std::int64_t t) const noexcept {
  const Commitment& commitment = commitment_at(t);
  return evaluate(commitment.flown, seconds_between(commitment.begin, t));
}

std::int64_t FlightState::rest_begins() const noexcept {
  return now.begin + nanoseconds(duration(now.flown)) + 1;
}

void FlightState::take_over() noexcept {
  if (!has_next || time < next.begin) return;
  if (watching && watched_part == Watched::kBefore) watch_all = true;
  watching = watching && watched_part != Watched::kBefore;
  now = next;
  has_next = meets_before = false;
}

/// At rest, something that is too near but comes no nearer is a threat only for kTold: the flight can only leave, or
/// say why not.
FlightMode FlightState::mode() const noexcept {
  const bool is_told = rests() && time - alarm_time > kTold;
  if (alarmed || ((threat || meets_before) && !is_told)) return FlightMode::kThreat;
  if (hovers()) return is_looking ? FlightMode::kLook : FlightMode::kRest;
  return seconds_between(now.begin, time) < now.branch ? FlightMode::kFly : FlightMode::kStop;
}

/// True while a copy or a proof reads the map, which must not change meanwhile.
bool FlightState::reads_map() const noexcept {
  switch (job) {
    case Job::kIdle:
    case Job::kKeep:
    case Job::kRoute:
    case Job::kPlan:
    case Job::kWait:
      return watching;
    default:
      return true;
  }
}

/// Notes new frames. A flight that gave up because none came goes on.
void FlightState::note_frame() noexcept {
  if (map.frames() == frames) return;
  frames = map.frames();
  frame_time = time;
  if (parked && reason == FlightReason::kMapStale) try_anew();
}

void FlightState::finish_report(std::uint32_t spent) noexcept {
  report.mode = mode();
  report.reason = reason;
  report.work = spent;
  report.waits_for_view = waits_for_view();
  report.map_stale = is_stale();
  report.frame_age = time - frame_time;
  report.leg = itinerary.leg;
  report.passed = count_points(itinerary, PointState::kPassed);
  report.skipped = count_points(itinerary, PointState::kSkipped);
  const bool has_block = is_beside() || (reason != FlightReason::kNoGoal && reason != FlightReason::kArrived);
  const Blockage& what = has_block ? block : kNoBlockage;
  report.blocked_by = what.by;
  report.blocked_at = what.at;
  report.blocked_fence = what.fence;
  const Contact first = meets_before ? before : contact;
  report.contact_time = report.mode == FlightMode::kThreat ? clock.shown_at(first.time) : 0;
  report.contact_speed = report.mode == FlightMode::kThreat ? first.speed : 0.0;
}

Status Flight::tick(int64_t t, FlightReport& report) noexcept {
  const Status status = tick(t);
  report = state_ == nullptr ? FlightReport{} : state_->report;
  return status;
}

Status Flight::tick(int64_t t) noexcept {
  if (state_ == nullptr) return Status::kInvalidArgument;
  FlightState& state = *state_;
  state.report.work = 0;
  if (t < state.shown) return Status::kClockBehind;
  const std::int64_t time = state.clock.time_of(t);
  state.gap = time - state.time;
  state.time = time;
  state.shown = t;
  state.alarmed = false;
  state.pass_points();
  state.take_over();
  state.note_frame();
  Work work = state.begin_work();
  state.step_map(work);
  state.run_watch(work);
  state.note_beside();
  state.turn_nose(work);
  state.advance(work);
  state.finish_report(state.spec.work_per_tick - work.left);
  return Status::kOk;
}

Command Flight::command(int64_t t) const noexcept {
  if (state_ == nullptr) return Command{};
  const std::int64_t time = state_->time_to_answer(t);
  return {state_->sample_at(time), state_->looking_at(time)};
}

Status Flight::set_clock(int64_t t) noexcept {
  if (state_ == nullptr) return Status::kInvalidArgument;
  state_->set_clock(t);
  return Status::kOk;
}

PointState Flight::point_state(int32_t point) const noexcept {
  const bool exists = state_ != nullptr && point >= 0 && point < state_->itinerary.count;
  return exists ? state_->itinerary.state[point] : PointState::kAhead;
}

Status Flight::set_yaw(const FlightYaw& yaw) noexcept {
  if (state_ == nullptr) return Status::kInvalidArgument;
  const Status status = state_->check_yaw(yaw);
  if (status == Status::kOk) state_->set_yaw(yaw);
  return status;
}

YawSample Flight::yaw(int64_t t) const noexcept {
  return state_ == nullptr ? YawSample{} : state_->yaw_at(state_->time_to_answer(t));
}

Vec3 Flight::rest_position() const noexcept {
  if (state_ == nullptr) return kZero;
  const Trajectory& flown = state_->latest().flown;
  return flown.origin + flown.segments[flown.count - 1].points[kDegree];
}

}  // namespace tern
