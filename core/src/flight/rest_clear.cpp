// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "flight/rest_clear.hpp"

#include "base/math.hpp"

namespace tern {

bool RestClear::is_old(const Commitment& latest) const noexcept {
  return has_news || of != &latest.trajectory || begin != latest.begin() || length < duration(latest.trajectory) ||
         length > duration(latest.trajectory);
}

void RestClear::prove(const FlightFacts& flight, Work& work) noexcept {
  work.spend(ops::kPiece + 2 * ops::kDot * flight.tracks.count);
  const Commitment& latest = flight.plans.latest();
  of = &latest.trajectory;
  begin = latest.begin();
  length = duration(latest.trajectory);
  has_news = false;
  const double from = larger(latest.time_at(flight.time), length);
  TrackGrounds grounds;
  grounds.tracks = flight.tracks.tracks;
  grounds.count = flight.tracks.count;
  grounds.radius = flight.map.safe().spec().clearance();
  grounds.rest = kRestHorizon + (from - length);
  grounds.fences = flight.spec.fences;
  grounds.fence_count = flight.spec.fence_count;
  is_running = proof.begin(*of, from, grounds) == Status::kRunning;
  until = begin + nanoseconds(from);
}

void RestClear::advance(const FlightFacts& flight, Work& work) noexcept {
  if (flight.tracks.count == 0 && !flight.has_windows) {
    is_running = false;
    until = INT64_MAX;
    return;
  }
  Share share(work, work.operations() / 4);
  if (is_old(flight.plans.latest())) prove(flight, share.part);
  if (!is_running) return;
  is_running = proof.step(share.part) == Status::kRunning;
  if (is_running) return;
  const ProofReport& found = proof.report();
  until = found.finding == Finding::kNone ? INT64_MAX : begin + nanoseconds(found.until);
}

}  // namespace tern
