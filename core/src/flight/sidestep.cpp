// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "flight/sidestep.hpp"

#include "base/math.hpp"
#include "flight/branch.hpp"
#include "flight/closing.hpp"
#include "flight/foresight.hpp"

namespace tern {
namespace {

/// Lengths, in clearances.
constexpr double kLengths[2] = {2.0, 5.0};
/// A vehicle gives way if it rests within so many seconds, and something is expected there within so many.
constexpr double kRestsSoon = 0.6;
constexpr double kMetSoon = 1.5;
/// Scores: so much for each step that the end stays clear, and less than that for the side.
constexpr int kPerStep = 32;
constexpr double kForSide = 15.0;

/// Along a diagonal, the box of the limits on acceleration allows more than along an axis.
Vec3 side_of(int number) {
  const int n = number % kSides;
  const int cell = n < kSides / 2 ? n : n + 1;  // without the middle
  const int along[3] = {cell % 3 - 1, cell / 3 % 3 - 1, cell / 9 - 1};
  const Vec3 side{static_cast<double>(along[0]), static_cast<double>(along[1]), static_cast<double>(along[2])};
  return (1.0 / length(side)) * side;
}

double length_of(int number, double clearance) {
  return kLengths[number / kSides] * clearance;
}

/// From -1, away from the next point, to 1.
double towards_target(const FlightFacts& flight, const Vec3& side) {
  const Vec3 way = flight.itinerary.points[flight.itinerary.leg].position - flight.position();
  const double far = length(way);
  return far > 0.0 ? dot(way, side) / far : 0.0;
}

}  // namespace

void Sidesteps::begin(int steps_of_staying) noexcept {
  stays = steps_of_staying;
  places = 0;
  begin_anew();
}

bool Sidesteps::begin_back(const Grid& safe, const Vec3& from, int steps_of_staying) noexcept {
  begin(steps_of_staying - 1);  // a place that stays clear for as long will do
  const Voxel at = safe.voxel_of(safe.to_local(from));
  for (std::int32_t z = at.z - kMostBack; z <= at.z + kMostBack; ++z) {
    for (std::int32_t y = at.y - kMostBack; y <= at.y + kMostBack; ++y) {
      for (std::int32_t x = at.x - kMostBack; x <= at.x + kMostBack; ++x) {
        if (safe.free({x, y, z})) add_place(safe.spec().origin + safe.center({x, y, z}), from);
      }
    }
  }
  return places > 0;
}

/// Of places that are equally far, the first stays first.
void Sidesteps::add_place(const Vec3& centre, const Vec3& from) noexcept {
  const double far = distance(centre, from);
  int slot = places < kPlacesBack ? places++ : kPlacesBack;
  for (; slot > 0 && distance(place[slot - 1], from) > far; --slot) {
    if (slot < kPlacesBack) place[slot] = place[slot - 1];
  }
  if (slot < kPlacesBack) place[slot] = centre;
}

void Sidesteps::begin_anew() noexcept {
  candidate = -1;
  is_proving = are_scored = false;
}

bool Sidesteps::make(const FlightFacts& flight, Draft& draft, Work& work) const noexcept {
  if (places > 0) return draft.step_to(flight, place[candidate], work);
  return draft.sidestep(flight, side_of(candidate), length_of(candidate, flight.map.safe().spec().clearance()), work);
}

/// Goes on to the candidate that is to be scored next, or to the best one that is not proven yet. False: none is left.
bool Sidesteps::next() noexcept {
  const int candidates = places > 0 ? places : kSidesteps;
  if (!are_scored) {
    are_scored = ++candidate == candidates;
    if (!are_scored) return true;
  }
  int best = stays < 0 ? 0 : kPerStep * (stays + 1) - 1;
  candidate = -1;
  for (int n = 0; n < candidates; ++n) {
    if (score[n] <= best) continue;
    best = score[n];
    candidate = n;
  }
  if (candidate < 0) return false;
  score[candidate] = 0;
  return true;
}

Progress Sidesteps::advance(const FlightFacts& flight, const TrackTable& expected, Draft& draft, Work& work) noexcept {
  for (int turn = 0; turn <= 3 * kSidesteps; ++turn) {
    if (is_proving) {
      if (draft.proof.step(work) == Status::kRunning) return Progress::kMore;
      is_proving = false;
      if (draft.proof.report().finding == Finding::kNone) return Progress::kDone;
    }
    if (!work.left()) return Progress::kMore;
    if (!next()) return Progress::kFailed;
    const bool is_made = make(flight, draft, work);
    if (are_scored) {
      is_proving = is_made && draft.begin_proof(flight, draft.plan.trajectory, 0.0) == Status::kRunning;
    } else {
      const int worth = is_made ? score_of(flight, expected, draft, work) : 0;
      score[candidate] = static_cast<std::int16_t>(worth);
    }
  }
  return Progress::kFailed;
}

int Sidesteps::score_of(const FlightFacts& flight, const TrackTable& expected, Draft& draft,
                        Work& work) const noexcept {
  const Trajectory& plan = draft.plan.trajectory;
  const double clearance = flight.map.safe().spec().clearance();
  if (meets_thing(plan, 0.0, draft.plan.tubes, clearance, work)) return 0;
  if (closing_fence(flight, draft.plan.end(), draft.plan.rests(), 0.0, work) != kNoFence) return 0;
  const int steps = rest_steps(plan, duration(plan), expected, clearance, work);
  if (places > 0) return kPerStep * steps + kPlacesBack - candidate;
  const double side = kForSide * (1.0 + towards_target(flight, side_of(candidate)));
  return kPerStep * steps + static_cast<int>(side);
}

std::int64_t sidestep_ticks(const FlightSpec& spec) noexcept {
  return std::int64_t{kSidestepWork / (spec.work_per_tick / 2)} + 2;
}

int steps_at_end(const FlightFacts& flight, const TrackTable& expected, std::int64_t takeover, Work& work) noexcept {
  const Commitment& latest = flight.plans.latest();
  const double from = larger(duration(latest.trajectory), latest.time_at(takeover));
  return rest_steps(latest.trajectory, from, expected, flight.map.safe().spec().clearance(), work);
}

bool is_in_the_way(const FlightFacts& flight, const TrackTable& expected, std::int64_t takeover, int& stays,
                   Work& work) noexcept {
  const Commitment& latest = flight.plans.latest();
  const double rests_in = seconds_between(takeover, latest.begin() + nanoseconds(duration(latest.trajectory)));
  if (expected.count == 0 || rests_in > kRestsSoon) return false;
  stays = steps_at_end(flight, expected, takeover, work);
  return larger(0.0, rests_in) + stays * kRestStep < kMetSoon;
}

}  // namespace tern
