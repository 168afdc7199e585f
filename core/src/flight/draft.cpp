// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "flight/draft.hpp"

#include "base/math.hpp"
#include "flight/branch.hpp"
#include "flight/lift.hpp"
#include "prove/joints.hpp"

namespace tern {
namespace {

/// Operations of a brake along the committed plan: three curves for each piece.
constexpr Operations kSlowDownOperations = 3 * ops::kCurve * kMaxSegments;
/// How much later than the plan in flight a new plan may pass the next point, seconds.
constexpr double kLaterAtPoint = 0.25;
/// The shortest ramp of a brake that ends a plan, seconds. At a limit on speed and without one on jerk, a stop may
/// level off in a fraction of a millisecond. Only a threat is worth such a jolt.
constexpr double kShortestRamp = 0.004;

/// What a thing may do grows with the time that a brake takes, so the first brake among things is the flat one.
bool ends_flat(const Draft& draft, int way) {
  return way == 0 && draft.plan.tubes.count > 0;
}

}  // namespace

void Draft::begin(const FlightFacts& flight, std::int64_t ticks) noexcept {
  takeover = flight.time + ticks * flight.spec.tick;
  deadline = takeover - flight.spec.tick;
}

void Draft::shift(std::int64_t by) noexcept {
  takeover += by;
  deadline += by;
  if (extends) return;
  plan.planned.begin += by;
  plan.trajectory.begin += by;
}

void Draft::extend(const Commitment& in_flight) noexcept {
  plan = in_flight;
  extends = true;
}

void Draft::compose(const Aim& aim, const Trajectory& planned, bool hemmed_in, bool looks_out) noexcept {
  static_cast<Destination&>(plan) = aim;
  plan.planned = planned;
  plan.planned.begin = takeover;
  plan.branch = 0.0;
  plan.evades = false;
  plan.hemmed_in = hemmed_in;
  plan.departed = aim.start.d[0];
  plan.lifts = plan.lands = false;
  plan.looks_out = looks_out;
}

void Draft::lift(const FlightFacts& flight, const Vec3& to, double speed, const Vec3& stand, double ground) noexcept {
  static_cast<Destination&>(plan) = {to, false, false, flight.itinerary.number, flight.itinerary.leg};
  plan.planned.begin = takeover;
  plan.planned.origin = flight.plans.sample_at(takeover).position;
  plan.planned.count = 0;
  append_lift(to - plan.planned.origin, speed, flight.limits, plan.planned);
  plan.branch = 0.0;
  plan.passages = 0;
  plan.evades = plan.hemmed_in = plan.looks_out = plan.lands = extends = false;
  plan.lifts = true;
  plan.departed = stand;
  plan.ground = ground;
}

void Draft::list_passages(const Aim& aim, const Report& found, const Trajectory& planned) noexcept {
  plan.passages = aim.asked_count;
  for (std::int32_t i = 0; i < aim.asked_count; ++i) plan.passage[i] = {aim.asked_point[i], found.vias[i].time};
  plan.target = aim.target;
  if (aim.at_target) plan.passage[plan.passages++] = {aim.target, duration(planned)};
}

void Draft::follow_to_end(double until) noexcept {
  plan.trajectory = plan.planned;
  plan.branch = until;
}

Operations Draft::branch_operations(const FlightFacts& flight, int way) const noexcept {
  if (!ends_flat(*this, way)) return kBrakeOperations;
  return limits_anything(flight.limits.jerk) ? kFlatStopOperations : kFlatStopOperations / 4;
}

bool Draft::branch_off(const FlightFacts& flight, double at, int way) noexcept {
  plan.branch = at;
  take_first_part(plan.planned, at, plan.trajectory);
  const JointState joint = joint_at(plan.planned, at, plan.planned.origin);
  if (ends_flat(*this, way)) {
    if (!append_flat_stop(joint, flight.limits, plan.trajectory)) return false;
    return plan.trajectory.segments[plan.trajectory.count - 1].duration >= kShortestRamp;
  }
  return append_stop(joint, flight.limits, way, stop, plan.trajectory) && stop.segments[0].duration >= kShortestRamp;
}

/// Becomes a plan without segments that begins on the committed plan, at the takeover.
const Commitment& Draft::leave_committed_plan(const FlightFacts& flight, bool evades) noexcept {
  const Commitment& committed = flight.plans.at(takeover);
  extends = false;
  plan.branch = 0.0;
  plan.passages = 0;
  plan.evades = evades;
  plan.looks_out = false;
  plan.hemmed_in = committed.hemmed_in;
  plan.departed = committed.departed;
  plan.lifts = committed.lifts;
  plan.ground = committed.ground;
  plan.lands = false;
  plan.trajectory.count = 0;
  plan.trajectory.begin = takeover;
  plan.trajectory.origin = evaluate(committed.trajectory, committed.time_at(takeover)).position;
  return committed;
}

void Draft::end_as_brake(const FlightFacts& flight) noexcept {
  plan.planned = plan.trajectory;
  static_cast<Destination&>(plan) = {plan.end(), false, false, flight.itinerary.number, flight.itinerary.leg};
}

bool Draft::brake(const FlightFacts& flight, int number, bool evades, Work& work) noexcept {
  work.spend(number < kStops ? kStopOperations / 2 : kSlowDownOperations);
  const Commitment& committed = leave_committed_plan(flight, evades);
  if (!append_brake(flight, committed, number)) return false;
  end_as_brake(flight);
  return true;
}

bool Draft::sidestep(const FlightFacts& flight, const Vec3& side, double far, Work& work) noexcept {
  work.spend(kStopOperations / 2);
  const Commitment& committed = leave_committed_plan(flight, false);
  const JointState at = joint_at(committed.trajectory, committed.time_at(takeover), plan.trajectory.origin);
  if (!append_push(at, flight.limits, side, far, plan.trajectory)) return false;
  end_as_brake(flight);
  return true;
}

bool Draft::step_to(const FlightFacts& flight, const Vec3& place, Work& work) noexcept {
  work.spend(kStopOperations / 2);
  leave_committed_plan(flight, false);
  const Vec3 way = place - plan.trajectory.origin;
  if (!append_lift(way, kAnywhere, flight.limits, plan.trajectory)) return false;
  end_as_brake(flight);
  return true;
}

/// Appends a brake straight ahead, or along the committed plan.
bool Draft::append_brake(const FlightFacts& flight, const Commitment& committed, int number) noexcept {
  const double from = committed.time_at(takeover);
  const JointState at = joint_at(committed.trajectory, from, plan.trajectory.origin);
  if (number == 0) return append_sharp_stop(at, flight.limits, plan.trajectory);
  if (number < kStraight) return append_stop(at, flight.limits, number - 1, stop, plan.trajectory);
  const double time = slow_down_time(at.d[1], flight.limits, number - kStraight);
  return append_slow_down(committed.trajectory, from, time, plan.trajectory);
}

bool Draft::prove_hover(const FlightFacts& flight) noexcept {
  const Commitment& hover = flight.plans.in_flight;
  proof.begin_accepted(flight.map.safe(), hover.trajectory, 0.0, nullptr, Beyond::kSolid,
                       grounds_of(flight.spec, hover));
  return proof.step(~std::uint32_t{0}) == Status::kOk && proof.report().finding == Finding::kNone;
}

Status Draft::begin_proof(const FlightFacts& flight, const Trajectory& trajectory, double from) noexcept {
  proven_on = flight.map.safe().revision();
  return proof.begin_accepted(flight.map.safe(), trajectory, from, &flight.spec.limits, Beyond::kSolid,
                              grounds_of(flight.spec, plan));
}

Status Draft::begin_proof(const FlightFacts& flight, double from, Beyond beyond, const ProofGrounds& grounds) noexcept {
  proven_on = flight.map.safe().revision();
  return proof.begin_accepted(flight.map.safe(), plan.trajectory, from, &flight.spec.limits, beyond, grounds);
}

Status Draft::begin_proof_of_remainder(const FlightFacts& flight, const Grid& copy, const TrackTable& expected,
                                       double from) noexcept {
  ProofGrounds grounds;
  grounds.fences = flight.spec.fences;
  grounds.fence_count = flight.spec.fence_count;
  grounds.tracks = expected.tracks;
  grounds.track_count = expected.count;
  return proof.begin_accepted(copy, flight.plans.in_flight.planned, from, nullptr, Beyond::kEmpty, grounds);
}

double Draft::start_of_proof() const noexcept {
  return larger(0.0, plan.time_at(takeover));
}

bool Draft::passes_later(const FlightFacts& flight) const noexcept {
  const Commitment& in_flight = flight.plans.in_flight;
  const std::int32_t leg = flight.itinerary.leg_at(in_flight, takeover);
  if (leg == flight.itinerary.last()) return false;
  const double kept = in_flight.time_of(leg);
  return kept < kNever && kept - in_flight.time_at(takeover) + kLaterAtPoint < plan.time_of(leg);
}

bool Draft::joins_committed_plan(const CommittedPlans& plans, Work& work) const noexcept {
  const Commitment& committed = plans.at(takeover);
  work.spend(kJointOperations * (plan.trajectory.count + 2));
  return follows(evaluate(committed.trajectory, committed.time_at(takeover)),
                 evaluate(plan.trajectory, start_of_proof())) &&
         joints_hold(plan.trajectory);
}

}  // namespace tern
