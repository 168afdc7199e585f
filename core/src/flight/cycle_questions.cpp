// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A cycle's questions to the planner: a plan to its aim or a route, and another one after a failure.
#include "base/math.hpp"
#include "flight/cycle.hpp"
#include "grid/distance.hpp"
#include "path/polyline.hpp"

namespace tern {
namespace {

/// The part of a plan's units that the optimiser may spend: if it needs more, it answers with the best plan so far.
constexpr std::uint32_t kOptimiserPart = 2;
/// Among things that move, the part that may go into ways and times. The optimiser may spend the rest. A plan that
/// takes longer than it may is dropped, and the next one begins later: meanwhile, the things move on.
constexpr std::uint32_t kTracksPart = 4;
/// Operations of a plan or a route without the planner's: choosing an aim and a draft, and copies of trajectories.
constexpr Operations kPlanOperations = kMaxSegments * ops::kCurve;

/// After so many plans that met things that move, each shorter than the one before, the next one is of full length
/// again.
constexpr std::uint32_t kShorterPlans = 4;

/// At this part of its speed, a vehicle asks only for plans that beat the one in flight. A slower one may find plans
/// that are far better than that, and the search for them begins with long durations.
constexpr double kCruise = 0.3;

/// For so long, the end of a plan must stay clear of what things that move are expected to do, seconds.
constexpr double kRestClear = 0.2;

/// A request from the start to the aim, at rest, through the points that are asked for.
Request request_to(const Aim& aim, const FlightFacts& flight) {
  const FlightSpec& spec = flight.spec;
  Request request{};
  request.start.position = aim.start.d[0];
  request.goal.position = aim.place;
  request.limits = flight.stray.limits(spec.limits);
  request.fences = spec.fences;
  request.fence_count = spec.fence_count;
  request.vias = aim.asked;
  request.via_count = aim.asked_count;
  return request;
}

bool cruises(const Aim& aim, const Request& request) {
  const Vec3& most = request.limits.v_max;
  return length(aim.start.d[1]) >= kCruise * smaller(most.x, most.y);
}

/// True if the vehicle will rest, and a plan would bring it no nearer to the target. The aim was in an obstacle, and is
/// now the nearest free point to it.
bool gets_no_nearer(const FlightFacts& flight, const Aim& aim, std::int64_t takeover) {
  const double slack = kAimVoxels * flight.map.route().spec().cell;
  return flight.rests_at(takeover) &&
         !(distance(aim.start.d[0], aim.target_place) > distance(aim.place, aim.target_place) + slack);
}

/// True if the aim was the target, and something that was seen is within the radius of it. If only its voxel is
/// occupied, the vehicle looks around first.
bool is_target_occupied(const FlightFacts& flight, const Aim& aim) {
  const Grid& seen = flight.map.route();
  return seen.bound() && aim.at_target && !point_clear(seen, seen.to_local(aim.target_place), seen.spec().clearance());
}

}  // namespace

/// Asks for a plan to the aim; if the aim is further away than the horizon, for a route to it.
void Cycle::ask(const FlightFacts& flight) noexcept {
  job = aim.way_length(aim.place) > horizon(flight) ? Job::kAskRoute : Job::kAskPlan;
}

double Cycle::horizon(const FlightFacts& flight) const noexcept {
  return flight.spec.horizon / static_cast<double>(1u << (met_things % kShorterPlans));
}

Progress Cycle::ask_route(const FlightFacts& flight, Work& work) noexcept {
  Request request = request_to(aim, flight);
  if (has_closed) request.fences = routed;
  planner->begin_route(route.grid(), request);
  work.spend(kPlanOperations);
  job = Job::kRoute;
  return Progress::kDone;
}

Progress Cycle::ask_plan(const FlightFacts& flight, std::int64_t takeover, Work& work) noexcept {
  const double cell = flight.map.safe().spec().cell;
  const double clearance = flight.map.safe().spec().clearance();
  const bool makes_room = aim.leave_room(expected, clearance, cell);
  if (makes_room && flight.rests_at(takeover) && distance(aim.place, aim.start.d[0]) < cell) return Progress::kFailed;
  Request request = request_to(aim, flight);
  request.begin = takeover;
  request.tracks = expected.tracks;
  request.track_count = expected.count;
  const bool has_times = expected.count > 0 || flight.has_windows;
  request.rest_clear = has_times ? kRestClear : 0.0;
  request.start = {aim.start.d[0], aim.start.d[1], aim.start.d[2], aim.start.d[3]};
  request.budget.tracks = flight.spec.plan_work / kTracksPart;
  request.budget.trajectory =
      has_times ? flight.spec.plan_work - request.budget.tracks : flight.spec.plan_work / kOptimiserPart;
  request.time_weight = flight.spec.time_weight;
  const Commitment& in_flight = flight.plans.in_flight;
  const double from = in_flight.time_at(takeover);
  const bool has_pace = from >= 0.0 && from < in_flight.branch && !flight.stray.is_too_fast;
  must_beat =
      has_pace && remainder_is_free && same(aim.place, in_flight.place) && !leaves_fence && cruises(aim, request);
  if (has_pace) {
    planner->begin(route.grid(), request, in_flight.planned, from, must_beat);
  } else {
    planner->begin(route.grid(), request);
  }
  work.spend(kPlanOperations);
  job = Job::kPlan;
  return Progress::kDone;
}

Status Cycle::finish(Report& found) noexcept {
  return job == Job::kRoute ? planner->finish_route(found) : planner->finish(plan, found);
}

bool Cycle::keeps_remainder(const Report& found) const noexcept {
  return job == Job::kPlan && must_beat && found.status == Status::kNoTrajectory;
}

FoundRoute Cycle::route_found() const noexcept {
  const Path& path = *planner->path();
  const Vec3 end = route.grid().spec().origin + path.points[path.count - 1];
  return {aim.start.d[0], end, polyline_length(path.points, path.count)};
}

void Cycle::follow_route(const FlightFacts& flight) noexcept {
  aim.shorten(*planner->path(), route.grid().spec(), horizon(flight), flight.itinerary);
  job = Job::kAskPlan;
}

bool Cycle::may_move_to_reachable(const Report& found) const noexcept {
  return found.status == Status::kNoPath && found.has_reachable && (all_free || is_last_resort) && !aim.at_reachable &&
         aim.asked_count == 0;
}

/// No way through the window leads to the aim, even with all unseen voxels free: asks for a plan to the reachable point
/// nearest to it, once. False if the vehicle rests there already; then the target may be cut off. A vehicle that found
/// no other way, and looks around, does the same where unseen voxels near it are solid: with all of them free, plans
/// may lead right into what nobody saw.
bool Cycle::moves_to_reachable(const FlightFacts& flight, const Report& found, std::int64_t takeover) noexcept {
  const double nearer = distance(aim.start.d[0], aim.target_place) - distance(found.reachable, aim.target_place);
  const bool is_there = flight.rests_at(takeover) && nearer <= flight.map.route().spec().cell;
  if (all_free) cut_off = is_there && (aim.at_target || aim.beside_target);
  if (is_there) return false;
  aim.move_to_reachable(found.reachable);
  ask(flight);
  return true;
}

/// A plan past fewer points is asked for only if the plan in flight does not go on anyway.
NextPlan Cycle::ask_for_less(const FlightFacts& flight, const Report& found) noexcept {
  if (remainder_is_free) return NextPlan::kNone;
  aim.ask_for_less(found, flight.itinerary);
  job = Job::kAskPlan;
  return NextPlan::kAsked;
}

/// If there is no route at all, the plan leads along the straight line.
NextPlan Cycle::next_after_route(const FlightFacts& flight, const Report& found, std::int64_t takeover) noexcept {
  if (aim.move_to_free(found)) {
    aim.end_beside(nullptr, 0.0);
    job = Job::kAskRoute;
    return NextPlan::kAsked;
  }
  if (aim.asked_count > 0) return ask_for_less(flight, found);
  const bool may_move = may_move_to_reachable(found);
  if (may_move && moves_to_reachable(flight, found, takeover)) return NextPlan::kAsked;
  if (cut_off) return may_move ? NextPlan::kCutOff : NextPlan::kNone;
  aim.return_to_line(flight);
  job = Job::kAskPlan;
  return NextPlan::kAsked;
}

NextPlan Cycle::next_after_plan(const FlightFacts& flight, const Report& found, std::int64_t takeover) noexcept {
  if (aim.move_to_free(found)) {
    if (aim.asked_count == 0 && gets_no_nearer(flight, aim, takeover)) {
      if (is_target_occupied(flight, aim)) return NextPlan::kNearest;
      if (all_free) cut_off = aim.at_target;  // something unseen is in between
      return NextPlan::kNone;
    }
    const double slack = kAimVoxels * flight.map.route().spec().cell;
    aim.end_beside(remainder_is_free ? &flight.plans.in_flight : nullptr, slack);
    job = Job::kAskPlan;
    return NextPlan::kAsked;
  }
  if (may_move_to_reachable(found)) {
    if (moves_to_reachable(flight, found, takeover)) return NextPlan::kAsked;
    return cut_off ? NextPlan::kCutOff : NextPlan::kNone;
  }
  return aim.asked_count > 0 ? ask_for_less(flight, found) : NextPlan::kNone;
}

}  // namespace tern
