// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A cycle among fences for a while: which of them its route leads around, and where its plan may end.
#include "base/math.hpp"
#include "flight/closing.hpp"
#include "flight/cycle.hpp"

namespace tern {
namespace {

/// From when on the vehicle rests where the latest plan ends.
std::int64_t rests_from(const FlightFacts& flight) {
  const std::int64_t rests = flight.plans.latest().rests();
  return rests > flight.time ? rests : flight.time;
}

}  // namespace

/// By turns, plans lead on to the goal, which may be the shorter way, and out of the fence.
void Cycle::note_closing(const FlightFacts& flight, Work& work) noexcept {
  const Commitment& latest = flight.plans.latest();
  closing = latest.lifts ? kNoFence : closing_fence(flight, latest.end(), rests_from(flight), kLeaveSpare, work);
  closings = closing == kNoFence ? 0 : closings + 1;
  leaves_fence = closings > 0 && closings % 2 == 0;
}

/// Out of the keep-out that is about to begin, or on from the keep-in that is about to end: each turn another way.
Vec3 Cycle::way_out(const FlightFacts& flight, Work& work) const noexcept {
  const Fence& fence = flight.fences[closing];
  const auto number = static_cast<std::int32_t>(closings / 2) - 1;
  if (fence.kind == FenceKind::kKeepOut) return way_out_of(flight, fence, aim.start.d[0], number, work);
  return way_on_from(flight, flight.plans.latest().end(), rests_from(flight), number, work);
}

/// What begins while the vehicle flies the next horizons is closed, too. A fence around the vehicle or the next point
/// cannot be led around.
void Cycle::close_fences(const FlightFacts& flight, std::int64_t takeover, Work& work) noexcept {
  has_closed = false;
  if (!flight.has_windows) return;
  const double ahead = kStaySpare + 2.0 * gauge(flight.limits.velocity, {flight.spec.horizon, 0.0, 0.0});
  const Vec3 from = flight.plans.sample_at(takeover).position;
  const Vec3& to = flight.itinerary.points[flight.itinerary.leg].position;
  for (std::int32_t k = 0; k < flight.spec.fence_count; ++k) {
    const Fence& fence = routed[k] = flight.fences[k];
    if (!is_closed(fence, takeover, ahead)) continue;
    if (!is_clear_of(flight, fence, from, work) || !is_clear_of(flight, fence, to, work)) continue;
    routed[k].from = routed[k].until = 0;
    has_closed = true;
  }
}

bool Cycle::ask_through(const FlightFacts& flight) noexcept {
  if (job != Job::kRoute || !has_closed) return false;
  has_closed = false;
  ask(flight);
  return true;
}

std::int32_t Cycle::fence_at_end(const FlightFacts& flight, const Draft& draft, Work& work) const noexcept {
  return closing_fence(flight, draft.plan.end(), draft.plan.rests(), leaves_fence ? 0.0 : kStaySpare, work);
}

}  // namespace tern
