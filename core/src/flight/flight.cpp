// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The calls of a flight after its start.
#include "tern/flight.hpp"

#include "base/math.hpp"
#include "flight/flight_state.hpp"

namespace tern {

Status Flight::set_goal(const Vec3& goal) noexcept {
  if (state_ == nullptr) return Status::kInvalidArgument;
  Via point;
  point.position = goal;
  return set_mission(&point, 1, ViaPolicy::kEnd);
}

Status Flight::set_mission(const Via* points, int32_t count, ViaPolicy policy) noexcept {
  if (state_ == nullptr) return Status::kInvalidArgument;
  const Status status = check_mission(points, count, policy);
  if (status != Status::kOk) return status;
  state_->leave_question();
  state_->facts.itinerary.begin(points, count, policy);
  state_->facts.landing.is_asked = false;
  state_->cycle.aim.expect(points[0].position);
  state_->evasion.forget_stop();
  state_->try_anew();
  return status;
}

Status Flight::land(const Vec3& place, double ground, double speed) noexcept {
  if (state_ == nullptr) return Status::kInvalidArgument;
  if (!finite(place) || !finite(ground) || !finite(speed)) return Status::kNonFiniteInput;
  const double top = height_above(state_->facts.map.safe().spec(), ground);
  if (!(speed > 0.0) || !(place.z < top)) return Status::kInvalidArgument;
  const Status status = set_goal({place.x, place.y, top});
  if (status == Status::kOk) state_->facts.landing = {true, place, ground, speed};
  return status;
}

/// Drops the pending plan, because it leads to the forgotten goal.
Status Flight::stop() noexcept {
  if (state_ == nullptr) return Status::kInvalidArgument;
  state_->facts.itinerary.forget_goal();
  state_->facts.landing.is_asked = false;
  state_->search.end_look();
  state_->lookouts.try_anew();
  state_->evasion.ask_for_stop();
  state_->leave_question();
  state_->cycle.leave();
  return Status::kOk;
}

Status Flight::tick(int64_t t, FlightReport& report) noexcept {
  const Status status = tick(t);
  report = state_ == nullptr ? FlightReport{} : state_->report;
  return status;
}

Status Flight::tick(int64_t t) noexcept {
  if (state_ == nullptr) return Status::kInvalidArgument;
  state_->report.work = 0;
  if (t < state_->facts.shown) return Status::kClockBehind;
  state_->tick(t);
  return Status::kOk;
}

Command Flight::command(int64_t t) const noexcept {
  if (state_ == nullptr) return Command{};
  const std::int64_t time = state_->facts.time_to_answer(t);
  return {state_->facts.plans.sample_at(time), state_->looking_at(time)};
}

/// The map, too, takes any time for its next frame: frames carry times of the same clock.
Status Flight::set_clock(int64_t t) noexcept {
  if (state_ == nullptr) return Status::kInvalidArgument;
  state_->facts.set_clock(t);
  if (state_->facts.has_windows) state_->watch.prove_all();
  state_->rest.note_news();
  return state_->facts.map.forget_time();
}

/// Drops the pending plan if it is too fast now.
Status Flight::note_position(const Vec3& position, int64_t t) noexcept {
  if (state_ == nullptr) return Status::kInvalidArgument;
  if (!finite(position)) return Status::kNonFiniteInput;
  if (!state_->facts.note_position(position, t)) return Status::kOk;
  state_->leave_question();
  state_->cycle.leave();
  return Status::kOk;
}

Status Flight::update_track(const Track& track) noexcept {
  return state_ == nullptr ? Status::kInvalidArgument : state_->update_track(track);
}

Status Flight::forget_track(uint32_t id) noexcept {
  if (state_ == nullptr || !state_->facts.tracks.forget(id)) return Status::kInvalidArgument;
  state_->rest.note_news();
  return Status::kOk;
}

uint32_t Flight::proposal(Trajectory& plan, int64_t& takeover) const noexcept {
  if (state_ == nullptr || state_->cycle.job != Job::kAnswer) return 0;
  const FlightClock& clock = state_->facts.clock;
  plan = state_->draft.plan.trajectory;
  plan.begin = clock.shown_at(state_->draft.plan.begin());
  takeover = clock.shown_at(state_->draft.takeover);
  return state_->cycle.question;
}

Status Flight::answer(uint32_t number, bool may_fly) noexcept {
  return state_ == nullptr ? Status::kInvalidArgument : state_->answer(number, may_fly);
}

Status Flight::set_clearance(int64_t clearance) noexcept {
  return state_ == nullptr ? Status::kInvalidArgument : state_->set_clearance(clearance);
}

int64_t Flight::rest_clear_until() const noexcept {
  const bool comes = state_ != nullptr && state_->rest.until < INT64_MAX;
  return comes ? state_->facts.clock.shown_at(state_->rest.until) : INT64_MAX;
}

PointState Flight::point_state(int32_t point) const noexcept {
  const bool exists = state_ != nullptr && point >= 0 && point < state_->facts.itinerary.count;
  return exists ? state_->facts.itinerary.state[point] : PointState::kAhead;
}

int32_t Flight::looked_in_vain(UnseenVoxel* voxels, int32_t capacity) const noexcept {
  return state_ == nullptr ? 0 : state_->lookouts.tried.list_unseen(state_->facts.map, voxels, capacity);
}

Status Flight::set_yaw(const FlightYaw& yaw) noexcept {
  if (state_ == nullptr) return Status::kInvalidArgument;
  const Status status = state_->nose.check(state_->facts.spec, yaw);
  if (status == Status::kOk) state_->nose.set(state_->facts, yaw);
  return status;
}

YawSample Flight::yaw(int64_t t) const noexcept {
  return state_ == nullptr ? YawSample{} : state_->nose.at(state_->facts.time_to_answer(t));
}

Status Flight::committed_plan(Trajectory& plan) const noexcept {
  if (state_ == nullptr) return Status::kInvalidArgument;
  const Commitment& latest = state_->facts.plans.latest();
  plan = latest.trajectory;
  plan.begin = state_->facts.clock.shown_at(latest.begin());
  return Status::kOk;
}

Vec3 Flight::rest_position() const noexcept {
  return state_ == nullptr ? kZero : state_->facts.plans.latest().end();
}

}  // namespace tern
