// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The calls, and one tick.
#include "tern/flight.hpp"

#include <new>

#include "base/math.hpp"
#include "flight/branch.hpp"
#include "flight/flight_state.hpp"
#include "planner/validate.hpp"

namespace tern {
namespace {

/// What the spec's numbers may be.
constexpr std::uint32_t kLeastWork = 256;
constexpr std::int64_t kLongestTick = std::int64_t{10} * 1000000000;

std::size_t state_words() {
  return (sizeof(FlightState) + sizeof(std::uint64_t) - 1) / sizeof(std::uint64_t);
}

bool positive(double x) {
  return finite(x) && x > 0.0;
}

bool spec_fits(const FlightSpec& spec) {
  return spec.tick > 0 && spec.tick <= kLongestTick && spec.work_per_tick >= kLeastWork && spec.plan_work > 0 &&
         positive(spec.horizon) && spec.stale_after >= 0 && finite(spec.near) && spec.near >= 0.0 &&
         positive(spec.yaw_rate) && spec.yaw_rate >= 1e-3;
}

/// Along x, where it moves by a word of voxels at a time, the window is longer than the horizon to either side.
bool window_fits(const FlightSpec& spec, const GridSpec& window) {
  return window.clearance() > 0.0 && spec.horizon < 0.5 * (window.boundary.upper.x - window.boundary.lower.x);
}

std::int32_t count_points(const Itinerary& itinerary, PointState state) {
  std::int32_t count = 0;
  for (std::int32_t i = 0; i < itinerary.count; ++i) count += itinerary.state[i] == state ? 1 : 0;
  return count;
}

/// One segment that stays at a point.
void hover(const Vec3& position, std::int64_t t, Commitment& commitment) {
  commitment.begin = t;
  commitment.flown.origin = commitment.aim = position;
  const JointState rest{};
  append_between(rest, rest, kMinDuration, commitment.flown);
  commitment.wished = commitment.flown;
  commitment.branch = kMinDuration;
}

}  // namespace

FlightSpec flight_spec(const Limits& limits) noexcept {
  FlightSpec spec{};
  spec.limits = limits;
  spec.time_weight = 1000.0;
  spec.tick = 10000000;
  spec.work_per_tick = 4000;
  spec.plan_work = 16000;
  spec.horizon = 8.0;
  spec.near = 2.5;
  spec.yaw_rate = 2.5;
  return spec;
}

size_t flight_words(const Voxel& dims) noexcept {
  const std::size_t grid = grid_words(dims);
  return grid == 0 ? 0 : state_words() + grid;
}

Status Flight::start(const FlightSpec& spec, const RollingMap& map, Planner& planner, uint64_t* words,
                     size_t word_count, const Vec3& position, int64_t t) noexcept {
  state_ = nullptr;
  if (!finite(position)) return Status::kNonFiniteInput;
  if (!spec_fits(spec) || !map.bound() || map.busy() || words == nullptr) return Status::kInvalidArgument;
  const Verdict limits = validate_limits(spec.limits);
  if (limits.status != Status::kOk) return limits.status;
  if (!valid_time_weight(spec.time_weight)) return Status::kLimitsInvalid;
  const GridSpec& window = map.safe().spec();
  if (!window_fits(spec, window) || word_count < flight_words(window.dims)) return Status::kInvalidArgument;
  FlightState* const state = new (words) FlightState{};
  state->spec = spec;
  state->limits = MotionLimits(spec.limits);
  state->map = map;
  state->planner = &planner;
  state->time = state->frame_time = t;
  state->frames = map.frames();
  state->reason = FlightReason::kNoGoal;
  state->look_at = position;
  hover(position, t, state->now);
  const bool begun = state->proof.begin(map.safe(), state->now.flown, 0.0, nullptr, Beyond::kSolid,
                                        state->grounds_of(state->now)) == Status::kRunning;
  if (!begun || state->proof.step(2 * kProofPieces) != Status::kOk) return Status::kStartOccupied;
  if (state->proof.report().end != ProofEnd::kProven) return Status::kStartOccupied;
  const Status bound = state->route.bind(map, words + state_words(), word_count - state_words());
  if (bound != Status::kOk) return bound;
  state_ = state;
  return Status::kOk;
}

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
  if (state_->job != Job::kEvade) state_->job = Job::kIdle;  // its plan led to the goal
  return Status::kOk;
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

FlightMode FlightState::mode() const noexcept {
  const bool gave_up = parked && rests();
  if (alarmed || ((threat || meets_before) && !gave_up)) return FlightMode::kThreat;
  if (hovers()) return is_looking ? FlightMode::kLook : FlightMode::kRest;
  return seconds_between(now.begin, time) < now.branch ? FlightMode::kFly : FlightMode::kStop;
}

/// Copies and proofs are about one map, which must not change meanwhile.
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

/// A flight that gave up for want of frames goes on.
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
  const Contact first = meets_before ? before : contact;
  report.contact_time = report.mode == FlightMode::kThreat ? first.time : 0;
  report.contact_speed = report.mode == FlightMode::kThreat ? first.speed : 0.0;
}

Status Flight::tick(int64_t t, FlightReport& report) noexcept {
  report = FlightReport{};
  if (state_ == nullptr || t < state_->time) return Status::kInvalidArgument;
  FlightState& state = *state_;
  state.time = t;
  state.alarmed = false;
  state.pass_points();
  state.take_over();
  state.note_frame();
  Work work = state.begin_work();
  state.step_map(work);
  state.run_watch(work);
  state.turn_nose(work);
  state.advance(work);
  state.finish_report(state.spec.work_per_tick - work.left);
  report = state.report;
  return Status::kOk;
}

Command Flight::command(int64_t t) const noexcept {
  if (state_ == nullptr) return Command{};
  return {state_->sample_at(t), state_->looking_at(t)};
}

PointState Flight::point_state(int32_t point) const noexcept {
  const bool exists = state_ != nullptr && point >= 0 && point < state_->itinerary.count;
  return exists ? state_->itinerary.state[point] : PointState::kAhead;
}

Status Flight::set_yaw(const FlightYaw& yaw) noexcept {
  if (state_ == nullptr) return Status::kInvalidArgument;
  const Status status = check_flight_yaw(yaw, state_->spec.yaw_rate);
  if (status == Status::kOk) state_->set_yaw(yaw);
  return status;
}

YawSample Flight::yaw(int64_t t) const noexcept {
  return state_ == nullptr ? YawSample{} : state_->yaw_at(t);
}

Vec3 Flight::rest_position() const noexcept {
  if (state_ == nullptr) return kZero;
  const Trajectory& flown = state_->latest().flown;
  return flown.origin + flown.segments[flown.count - 1].points[kDegree];
}

}  // namespace tern
