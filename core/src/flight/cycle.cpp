// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "flight/cycle.hpp"

#include "base/math.hpp"
#include "flight/branch.hpp"
#include "grid/distance.hpp"
#include "planner/follow.hpp"

namespace tern {
namespace {

/// A new aim is chosen when less than this part of the horizon is left.
constexpr double kLeastWay = 0.6;
/// If plans from rest fail, three kinds of attempt take turns. In the first, unseen voxels near the vehicle are solid.
/// In the second, those right beside it are free, so that it has a voxel to begin at. In the third, all are free.
constexpr int kAttempts = 3;
/// In the second one, a vehicle with no free voxel to begin at, on its way to a lookout or without one, steps back
/// instead.
constexpr int kStepsBackIn = 1;
constexpr double kHoleVoxels = 2.0;

/// True if the vehicle will rest at the takeover with something within its radius: an error of a sensor, or something
/// that moved. The vehicle may get away from there.
bool is_hemmed_in(const FlightFacts& flight, std::int64_t takeover) {
  const Grid& safe = flight.map.safe();
  return flight.rests_at(takeover) &&
         !point_clear(safe, safe.to_local(flight.plans.sample_at(takeover).position), safe.spec().clearance());
}

/// True if the vehicle will rest where no voxel is free to begin a plan at: it went as far as what it knows allows.
bool is_squeezed(const FlightFacts& flight, std::int64_t takeover) {
  const Grid& safe = flight.map.safe();
  return flight.rests_at(takeover) && safe.inflated() &&
         !safe.free(safe.voxel_of(safe.to_local(flight.plans.sample_at(takeover).position)));
}

int attempt_of(const RestSearch& search, const Lookouts& lookouts) {
  return (lookouts.leads() ? lookouts.failed_cycles : search.idle_cycles) % kAttempts;
}

}  // namespace

std::int64_t Lead::ticks(const FlightSpec& spec) const noexcept {
  const std::uint32_t half = spec.work_per_tick / 2;
  return (std::int64_t{spec.plan_work / half} << (late < kMostDoublings ? late : kMostDoublings)) + 2;
}

void Lead::shorten(const FlightFacts& flight, std::int64_t takeover) noexcept {
  if (late == 0) return;
  const std::int64_t saved = ticks(flight.spec) - Lead{late - 1}.ticks(flight.spec) + 1;
  if (takeover - flight.time > (saved + flight.clearance_ticks()) * flight.spec.tick) --late;
}

/// The ways to a lookout are tried with all kinds of copies, too: they lead through known space, and where unseen
/// voxels are solid, they might leave the vehicle no voxel to begin at.
void Cycle::begin(const FlightFacts& flight, const RestSearch& search, const Lookouts& lookouts, std::int64_t takeover,
                  Work& work) noexcept {
  hemmed_in = is_hemmed_in(flight, takeover);
  remainder_is_free = false;
  const GridSpec& window = flight.map.route().spec();
  const int attempt = attempt_of(search, lookouts);
  leads_out = hemmed_in && search.idle_cycles % 2 == 1;
  const double near = attempt < 2 ? flight.spec.near : 0.0;
  all_free = !(near > 0.0);
  is_last_resort = search.is_looking && !search.surveys;
  const double hole = attempt == 1 ? window.clearance() + kHoleVoxels * window.cell : 0.0;
  const double emptied = hemmed_in ? window.clearance() : 0.0;
  const bool has_walls = attempt == 0 && !hemmed_in && without_walls == 0;
  if (without_walls > 0) --without_walls;
  route.begin(flight.map, flight.plans.sample_at(takeover).position, {near, hole, emptied, has_walls});
  expected.expect(flight.tracks, flight.time);
  note_closing(flight, work);
  close_fences(flight, takeover, work);
  job = Job::kCopy;
}

void Cycle::begin_lift(const FlightFacts& flight, std::int64_t takeover) noexcept {
  const Commitment& in_flight = flight.plans.in_flight;
  aim.begin(joint_at(in_flight.trajectory, in_flight.time_at(takeover), kZero), flight.itinerary.number);
  hemmed_in = remainder_is_free = looks_out = leaves_fence = false;
  job = Job::kWait;
}

bool Cycle::begin_sidestep(const FlightFacts& flight, Draft& draft, Work& work) noexcept {
  gave_way = !gave_way && flight.tracks.count > 0 && !flight.plans.in_flight.lifts;
  if (!gave_way) return false;
  int stays = 0;
  expected.expect(flight.tracks, flight.time);
  gave_way = is_in_the_way(flight, expected, draft.takeover, stays, work);
  if (!gave_way) return false;
  sidesteps.begin(stays);
  prove_sidesteps(flight, draft);
  return true;
}

/// Where the vehicle touches what is unseen, any curve that the planner makes may come too near to that: only a
/// straight way does not.
bool Cycle::begin_step_back(const FlightFacts& flight, const RestSearch& search, const Lookouts& lookouts, Draft& draft,
                            Work& work) noexcept {
  const bool needs_way = lookouts.leads() || lookouts.may_step_back(flight.map);
  const bool is_stuck = needs_way && attempt_of(search, lookouts) == kStepsBackIn && !flight.plans.in_flight.lifts &&
                        !is_hemmed_in(flight, draft.takeover) && is_squeezed(flight, draft.takeover);
  if (!is_stuck) return false;
  expected.expect(flight.tracks, flight.time);
  work.spend((ops::kDot + ops::kTurn) * kVoxelsBack);
  const int stays = steps_at_end(flight, expected, draft.takeover, work);
  steps_back = sidesteps.begin_back(flight.map.safe(), flight.plans.sample_at(draft.takeover).position, stays);
  if (!steps_back) return false;
  prove_sidesteps(flight, draft);
  return true;
}

/// All with the tubes and the map of now.
void Cycle::prove_sidesteps(const FlightFacts& flight, Draft& draft) noexcept {
  draft.plan.tubes.take(flight.tracks);
  draft.proven_on = flight.map.safe().revision();
  job = Job::kSidestep;
}

Progress Cycle::copy(const RollingMap& map, Work& work) noexcept {
  while (!route.done()) {
    if (!work.left()) return Progress::kMore;
    route.advance(map, work);
  }
  job = Job::kFollow;
  return Progress::kDone;
}

/// The remainder is a candidate if it fits the mission and the speed that is left, and the takeover comes before the
/// branch.
Progress Cycle::begin_remainder(const FlightFacts& flight, Draft& draft) noexcept {
  const Commitment& in_flight = flight.plans.in_flight;
  const double from = in_flight.time_at(draft.takeover);
  const bool is_candidate = in_flight.mission == flight.itinerary.number && flight.itinerary.still_fits(in_flight) &&
                            !flight.stray.is_too_fast && from < in_flight.branch;
  job = is_candidate && draft.begin_proof_of_remainder(flight, route.grid(), expected, from) == Status::kRunning
            ? Job::kRemainder
            : Job::kAim;
  return Progress::kDone;
}

Progress Cycle::prove_remainder(const FlightFacts& flight, Draft& draft, Work& work) noexcept {
  if (draft.proof.step(work) == Status::kRunning) return Progress::kMore;
  remainder_is_free =
      draft.proof.report().finding == Finding::kNone && flight.plans.in_flight.mission == flight.itinerary.number;
  job = Job::kAim;
  return Progress::kDone;
}

/// A plan leads to the same place until little of the way is left, so that plans are compared by their times.
bool Cycle::follow_aim(const FlightFacts& flight, const Lookouts& lookouts, std::int64_t takeover) noexcept {
  const Commitment& in_flight = flight.plans.in_flight;
  aim.begin(joint_at(in_flight.trajectory, in_flight.time_at(takeover), kZero), flight.itinerary.number);
  cut_off = cut_off && !all_free;
  if (!remainder_is_free) return false;
  aim.follow_points(in_flight, flight.itinerary, takeover);
  const bool leads_far = (in_flight.at_target && in_flight.target == flight.itinerary.last()) ||
                         aim.way_length(in_flight.place) > kLeastWay * flight.spec.horizon;
  const bool leads_there = in_flight.looks_out && same(in_flight.place, lookouts.place());
  if (leaves_fence || (lookouts.leads() ? !leads_there : in_flight.looks_out || !leads_far)) return false;
  aim.follow_place(in_flight);
  looks_out = in_flight.looks_out;
  job = Job::kAskPlan;
  return true;
}

void Cycle::choose_aim(const FlightFacts& flight, const Lookouts& lookouts, std::int64_t takeover,
                       Work& work) noexcept {
  looks_out = lookouts.leads() && !leaves_fence;
  aim.choose_points(flight, takeover);
  if (leads_out || looks_out || leaves_fence) aim.pass_first(0, flight.itinerary, route.grid().spec().cell);
  aim.choose_place(flight, leads_out ? flight.spec.horizon : kAnywhere);
  if (looks_out) aim.lead_to(lookouts.place());
  if (leads_out) aim.choose_way_out(flight);
  if (leaves_fence) aim.lead_to(way_out(flight, work));
  ask(flight);
}

void Cycle::list_passages(const FlightFacts& flight, const Report& found, Draft& draft) noexcept {
  if (aim.is_outdated(flight.itinerary)) aim.forget_points();
  draft.list_passages(aim, found, plan);
}

bool Cycle::choose_draft(const FlightFacts& flight, bool planned, Draft& draft) noexcept {
  const Commitment& in_flight = flight.plans.in_flight;
  draft.clear();
  if (planned) draft.compose(aim, plan, hemmed_in, looks_out);
  if (remainder_is_free && !leaves_fence) {
    const double remainder = duration(in_flight.planned) - in_flight.time_at(draft.takeover);
    const bool is_better =
        planned && (!same(aim.place, in_flight.place) || arrives_earlier(duration(draft.plan.planned), remainder));
    if (!is_better || draft.passes_later(flight)) draft.extend(in_flight);
  }
  if (!draft.extends && !planned) return false;
  job = Job::kWait;
  return true;
}

/// The map's words are true in the middle of a frame, but not in the middle of a slide.
Progress Cycle::begin_proof(const FlightFacts& flight, Draft& draft) noexcept {
  if (!flight.map.safe().bound()) return Progress::kMore;
  job = Job::kProve;
  draft.plan.tubes.take(flight.tracks);
  const bool begun = draft.begin_proof(flight, draft.plan.planned, draft.start_of_proof()) == Status::kRunning;
  return begun ? Progress::kDone : Progress::kFailed;
}

void Cycle::begin_branch(double until) noexcept {
  branches.begin(until);
  job = Job::kBranch;
}

Progress Cycle::find_branch(const FlightFacts& flight, Draft& draft, Work& work) noexcept {
  const Progress progress = branches.advance(flight, aim.start.d[0], draft, work);
  if (progress != Progress::kDone) return progress;
  job = Job::kConfirm;
  draft.begin_proof(flight, draft.plan.trajectory, draft.start_of_proof());
  return progress;
}

/// A number that comes round again is never 0.
void Cycle::ask_for_clearance() noexcept {
  job = Job::kAnswer;
  if (++question == 0) ++question;
}

Progress Cycle::begin_renewal(const FlightFacts& flight, Draft& draft) noexcept {
  if (!flight.map.safe().bound()) return Progress::kMore;
  job = Job::kRenew;
  draft.plan.tubes.take(flight.tracks);
  const bool begun = draft.begin_proof(flight, draft.plan.trajectory, draft.start_of_proof()) == Status::kRunning;
  return begun ? Progress::kDone : Progress::kFailed;
}

void Cycle::prove_anew() noexcept {
  if (proves_draft()) job = Job::kWait;
  if (job == Job::kRenew) job = Job::kCleared;
  if (job == Job::kSidestep) sidesteps.begin_anew();
}

bool Cycle::reads_map() const noexcept {
  switch (job) {
    case Job::kIdle:
    case Job::kRemainder:
    case Job::kRoute:
    case Job::kPlan:
    case Job::kWait:
    case Job::kAnswer:
    case Job::kCleared:
      return false;
    default:
      return true;
  }
}

}  // namespace tern
