// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "flight/committed_plans.hpp"

#include "base/math.hpp"
#include "curve/hermite.hpp"
#include "flight/branch.hpp"

namespace tern {

Vec3 Commitment::end() const noexcept {
  return trajectory.origin + trajectory.segments[trajectory.count - 1].points[kDegree];
}

std::int64_t Commitment::rests() const noexcept {
  return begin() + nanoseconds(duration(trajectory)) + 1;
}

double Commitment::time_of(std::int32_t point) const noexcept {
  for (std::int32_t i = 0; i < passages; ++i) {
    if (passage[i].point == point) return passage[i].time;
  }
  return kNever;
}

ProofGrounds grounds_of(const FlightSpec& spec, const Commitment& commitment) noexcept {
  ProofGrounds grounds;
  if (commitment.hemmed_in || commitment.lifts) grounds.departed = &commitment.departed;
  if (commitment.lifts) grounds.ground = &commitment.ground;
  grounds.fences = spec.fences;
  grounds.fence_count = spec.fence_count;
  grounds.tracks = commitment.tubes.tracks;
  grounds.track_count = commitment.tubes.count;
  return grounds;
}

Sample CommittedPlans::sample_at(std::int64_t t) const noexcept {
  const Commitment& commitment = at(t);
  return evaluate(commitment.trajectory, commitment.time_at(t));
}

/// Plans join to the jerk, so a tenth of a second back this is off by some millimetres at most.
bool CommittedPlans::was_at(std::int64_t t, Vec3& position) const noexcept {
  constexpr double kLongest = 0.1;
  const Commitment& plan = at(t);
  const double after = plan.time_at(t);
  if (after < -kLongest) return false;
  const Sample s = evaluate(plan.trajectory, larger(0.0, after));
  const double b = smaller(0.0, after);
  position = s.position + b * (s.velocity + 0.5 * b * (s.acceleration + b / 3.0 * s.jerk));
  return true;
}

std::int64_t CommittedPlans::rest_begins() const noexcept {
  return in_flight.rests();
}

void CommittedPlans::hover_at(const Vec3& position) noexcept {
  in_flight.trajectory.origin = in_flight.place = position;
  const JointState rest{};
  append_between(rest, rest, kMinDuration, in_flight.trajectory);
  in_flight.planned = in_flight.trajectory;
  in_flight.branch = kMinDuration;
}

void CommittedPlans::stand_on(double ground) noexcept {
  in_flight.lifts = true;
  in_flight.departed = in_flight.place;
  in_flight.ground = ground;
}

bool CommittedPlans::take_over(std::int64_t time) noexcept {
  if (!has_waiting || time < waiting.begin()) return false;
  in_flight = waiting;
  has_waiting = false;
  return true;
}

void CommittedPlans::commit(const Commitment& draft, bool extends) noexcept {
  has_waiting = has_waiting || !extends;
  (extends ? in_flight : waiting) = draft;
}

}  // namespace tern
