// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The way to a lookout, and the look from there.
#include "base/math.hpp"
#include "flight/lookouts.hpp"
#include "yaw/angle.hpp"

namespace tern {
namespace {

/// The earliest search after a lookout.
constexpr std::int64_t kAfterLookout = 300000000;
/// The vehicle has arrived at a place within this distance, metres.
constexpr double kArrivedAt = 0.05;
/// The sensor points there within this angle, rad: its cosine. Then so many frames show the voxels, and not sooner than
/// kFrameDelay after it.
constexpr double kAlignedCosine = 0.998;
constexpr std::uint64_t kLookFrames = 3;
constexpr std::int64_t kFrameDelay = 150000000;
constexpr std::int64_t kLongestLook = 4000000000;
/// A lookout from which nothing new was seen at all counts as so many more.
constexpr int kBlindPrice = 2;
/// A flight to a lookout takes at most so many times as long as it should, and kSlackOnWay seconds.
constexpr double kLateOnWay = 2.5;
constexpr double kSlackOnWay = 3.0;
/// From nearer than this to the middle of what it looks at, seen from above, the sensor keeps its heading, metres.
constexpr double kLeastFlat = 1.0;
constexpr double kLookAhead = 4.0;

}  // namespace

std::int32_t Lookouts::count_unseen(const FlightFacts& flight) const noexcept {
  std::int32_t sum = 0;
  for (std::int32_t k = 0; k < search.lookout.hidden_count; ++k) {
    sum += is_unseen_at(flight.map, search.lookout.hidden[k]) ? 1 : 0;
  }
  return sum;
}

/// `looked`: the voxels that are still unseen were looked at. `failed`: the lookout was of no use.
void Lookouts::end(const FlightFacts& flight, bool looked, bool failed) noexcept {
  const Viewpoint& lookout = search.lookout;
  const double cell = flight.map.safe().spec().cell;
  for (std::int32_t k = 0; k < lookout.hidden_count && looked; ++k) {
    if (is_unseen_at(flight.map, lookout.hidden[k])) tried.note_voxel(lookout.hidden[k], lookout.place, cell);
  }
  // The sensor may be blind: then no lookout helps.
  const bool is_blind = looked && flight.map.learned() == learned;
  if (is_blind) left = left > kBlindPrice ? left - kBlindPrice : 0;
  if (failed) tried.note_failure(lookout.place, lookout.look);
  const bool showed_some = !failed || count_unseen(flight) < lookout.hidden_count;
  if (showed_some && ++shown <= kMostShown) ++left;  // it does not count as in vain
  phase = LookoutPhase::kIdle;
  anchored = -1;
  not_before = flight.time + kAfterLookout;
}

void Lookouts::note_aligned(const FlightFacts& flight, const Nose& nose) noexcept {
  if (aligned >= 0) return;
  const Heading& wanted = search.lookout.heading;
  if (nose.is_planned) {
    const YawSample now = nose.at(flight.time);
    if (now.yaw.cosine * wanted.cosine + now.yaw.sine * wanted.sine < kAlignedCosine) return;
  } else if (seconds_between(began, flight.time) * flight.spec.yaw_rate < kPi) {
    return;
  }
  aligned = flight.time;
  aligned_frames = flight.frames;
}

/// As soon as all voxels are seen, the flight goes on to its goal.
void Lookouts::follow(const FlightFacts& flight, const Nose& nose, const PlanCounts& plans) noexcept {
  if (!is_active() || !flight.map.safe().bound()) return;
  const Viewpoint& lookout = search.lookout;
  const Vec3 at = flight.position();
  const bool leads_on = lookout.hidden_count == 0;
  const bool is_done = leads_on ? distance(at, lookout.place) < kPassed : count_unseen(flight) == 0;
  if (is_done) return end(flight, false, false);
  if (phase == LookoutPhase::kOnWay) {
    const bool is_there = flight.rests() && distance(at, lookout.place) < kArrivedAt;
    if (is_there) {
      phase = LookoutPhase::kLooking;
      began = flight.time;
      return;
    }
    const double most = kLateOnWay * lookout.seconds + kSlackOnWay;
    const bool gets_no_further = stands_still(flight, plans) && !needs_no_plan(flight);
    if (gets_no_further || seconds_between(began, flight.time) > most) end(flight, false, true);
    return;
  }
  note_aligned(flight, nose);
  const bool has_looked = aligned >= 0 && flight.time - aligned >= kFrameDelay &&
                          flight.frames >= aligned_frames + kLookFrames && !flight.map.busy();
  if (has_looked || flight.time - began > kLongestLook) end(flight, true, true);
}

void Lookouts::note_failure(const FlightFacts& flight) noexcept {
  if (phase == LookoutPhase::kOnWay && ++failed_cycles >= kFailedCycles) end(flight, false, true);
}

bool Lookouts::needs_no_plan(const FlightFacts& flight) const noexcept {
  if (phase == LookoutPhase::kLooking) return true;
  return leads() && distance(flight.plans.latest().end(), place()) < kArrivedAt;
}

Vec3 Lookouts::look_at(const Vec3& position) const noexcept {
  const Viewpoint& lookout = search.lookout;
  const Vec3 way = lookout.look - position;
  const bool keeps_heading = phase == LookoutPhase::kLooking || horizontal_length(way) < kLeastFlat;
  if (!keeps_heading) return lookout.look;
  const Vec3 from_there = lookout.look - lookout.place;
  const double steepness = from_there.z / larger(horizontal_length(from_there), kArrivedAt);
  return position + kLookAhead * Vec3{lookout.heading.cosine, lookout.heading.sine, steepness};
}

}  // namespace tern
