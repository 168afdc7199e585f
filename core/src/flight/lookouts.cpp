// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "flight/lookouts.hpp"

#include "base/math.hpp"

namespace tern {
namespace {

/// What is committed ends at the same place if it moved by less than this, metres.
constexpr double kStandsStill = 0.4;
/// How long it must stand still before a search begins, in seconds, plans that were not dropped, and frames.
constexpr std::int64_t kStillFor = 500000000;
constexpr std::uint32_t kStillPlans = 3;
constexpr std::uint64_t kStillFrames = 4;
/// A search begins when the vehicle is less than so many seconds from the end of what is committed: more near the goal,
/// where flights gain centimetres at a time.
constexpr double kLeadNear = 0.7;
constexpr double kLeadFar = 0.4;
constexpr double kNearGoal = 2.0;  // metres
constexpr double kLeadSlack = 0.1;
/// How long the nose may take to turn to what is needed before a search begins.
constexpr std::int64_t kTurnWait = 1000000000;
/// The vehicle wanders after so many plans without coming nearer to its next point, if that is within the horizon.
/// Further away, a detour may be what it takes: then so many of the plans must have shown nothing new.
constexpr int kWanders = 6;
constexpr int kShowsNothing = 3;
/// A route turns away if it is so much longer, metres, than the way to where the last one began and along that one.
constexpr double kTurnsAway = 4.0;
/// Two routes end at the same place if their ends are no further apart than this, metres.
constexpr double kSameEnd = 0.1;
/// The earliest search after one without an answer.
constexpr std::int64_t kAfterNothing = 1000000000;
/// Without a frame for so long, no lookout helps.
constexpr std::int64_t kNoFrames = 1000000000;
/// The acceleration that a gimbal is taken to turn with, rad/s^2.
constexpr double kGimbalAcceleration = 20.0;

double least_of(double a, double b) {
  return b > 0.0 && b < a ? b : a;
}

bool looks_for_ground(const FlightFacts& flight) {
  return flight.landing.is_asked && flight.itinerary.is_reached_by(flight.plans.latest());
}

/// What the vehicle needs a way to: its next point or, if it hovers above the place to land on, as far down to that as
/// it keeps the radius from the ground.
Vec3 goal_of(const FlightFacts& flight) {
  const Vec3& point = flight.itinerary.points[flight.itinerary.leg].position;
  if (!looks_for_ground(flight)) return point;
  return {point.x, point.y, height_above(flight.map.safe().spec(), flight.landing.ground)};
}

/// How fast the vehicle moves level and turns.
Agility agility_of(const FlightFacts& flight, const Nose& nose) {
  const Limits limits = flight.stray.limits(flight.spec.limits);
  const double acceleration = nose.is_planned ? nose.yaw.acceleration_max : kGimbalAcceleration;
  return {least_of(smaller(limits.v_max.x, limits.v_max.y), limits.v_horizontal),
          least_of(smaller(limits.a_max.x, limits.a_max.y), limits.a_horizontal), flight.spec.yaw_rate, acceleration};
}

}  // namespace

void Lookouts::try_anew() noexcept {
  phase = LookoutPhase::kIdle;
  tried.clear();
  left = kMostLookouts;
  shown = 0;
  nearest = -1.0;
  found_nothing = is_last_try = false;
  in_vain = 0;
  wandering_due = 0;
  anchored = -1;
  route.length = 0.0;
  is_due = false;
  stepped = 0;
  not_before = 0;
}

void Lookouts::note_tick(const FlightFacts& flight, const PlanCounts& plans) noexcept {
  if (!flight.itinerary.goes_on()) return;
  const double remaining = distance(flight.position(), flight.itinerary.points[flight.itinerary.leg].position);
  if (nearest < 0.0 || remaining < nearest - kNearer) {
    nearest = remaining;
    left = kMostLookouts;
    shown = 0;
  }
  if (flight.itinerary.wandering == 0) wandering_due = 0;
  const Vec3 end = flight.plans.latest().end();
  if (anchored >= 0 && distance(end, anchor) <= kStandsStill) return;
  anchor = end;
  anchored = flight.time;
  anchored_plans = plans.asked - plans.dropped;
  anchored_frames = flight.frames;
  found_nothing = false;
}

bool Lookouts::wanders(const FlightFacts& flight) const noexcept {
  const Itinerary& itinerary = flight.itinerary;
  const bool is_within_horizon = distance(flight.position(), goal_of(flight)) < flight.spec.horizon;
  return itinerary.wandering >= wandering_due + kWanders && (is_within_horizon || itinerary.fruitless >= kShowsNothing);
}

bool Lookouts::stands_still(const FlightFacts& flight, const PlanCounts& plans) const noexcept {
  return anchored >= 0 && flight.time - anchored >= kStillFor &&
         plans.asked - plans.dropped - anchored_plans >= kStillPlans && flight.frames >= anchored_frames + kStillFrames;
}

bool Lookouts::is_called_for(const FlightFacts& flight, const Nose& nose, const PlanCounts& plans) const noexcept {
  const Commitment& latest = flight.plans.latest();
  const bool may_begin = phase == LookoutPhase::kIdle && left > 0 && flight.time >= not_before &&
                         (!flight.itinerary.is_reached_by(latest) || looks_for_ground(flight)) &&
                         !flight.itinerary.dwells_after(latest) && !flight.itinerary.is_right_before(flight);
  if (!may_begin || flight.map.busy() || !flight.map.safe().inflated() || !flight.map.route().inflated()) return false;
  if (is_due || wanders(flight)) return true;
  const Sample now = flight.plans.sample_at(flight.time);
  const Vec3 end = latest.end();
  const double lead_seconds = distance(end, goal_of(flight)) < kNearGoal ? kLeadNear : kLeadFar;
  if (distance(now.position, end) > lead_seconds * length(now.velocity) + kLeadSlack) return false;
  if (nose.waits_for_nose(flight) && flight.time - anchored < kTurnWait) return false;
  return stands_still(flight, plans);
}

/// Unseen voxels near the vehicle are solid for routes. So before a corner behind which nobody has looked, the route
/// may turn back to another way, though nothing is known to be in this one.
bool Lookouts::turns_away(const FoundRoute& found) noexcept {
  if (phase != LookoutPhase::kIdle) return false;
  const bool has_same_end = route.length > 0.0 && distance(found.to, route.to) <= kSameEnd;
  is_due = has_same_end && left > 0 && found.length > distance(found.from, route.from) + route.length + kTurnsAway;
  route = found;
  return is_due;
}

void Lookouts::begin(const FlightFacts& flight, const Nose& nose, const Vec3& look_at) noexcept {
  const Vec3 end = flight.plans.latest().end();
  Heading heading{1.0, 0.0};
  const Vec3 way = look_at - flight.position();
  const double flat = horizontal_length(way);
  if (flat > 0.0) heading = {way.x / flat, way.y / flat};
  if (nose.is_planned) {
    const YawSample now = nose.at(flight.time);
    heading = {now.yaw.cosine, now.yaw.sine};
  }
  search.optics = Optics(flight.spec.sensor, flight.map.spec());
  LookoutQuestion question{end, goal_of(flight), heading, agility_of(flight, nose)};
  question.flat = is_last_try;
  question.lands = looks_for_ground(flight);
  question.ground = flight.landing.ground;
  search.begin(flight.map, question, words);
  phase = LookoutPhase::kSearching;
  wandering_due = flight.itinerary.wandering;
  is_due = false;
}

/// A search that was made for another end of what is committed, or for another goal, says nothing.
bool Lookouts::accept(const FlightFacts& flight) noexcept {
  const LookoutQuestion& asked = search.question;
  const bool is_current =
      distance(asked.from, flight.plans.latest().end()) <= kStandsStill && same(asked.goal, goal_of(flight));
  if (!is_current) return false;
  if (search.answer == LookoutAnswer::kFound) return true;
  const Viewpoint& end = search.lookout;
  const bool leads_on = search.answer == LookoutAnswer::kNothingUnseen && flight.rests() &&
                        distance(end.place, flight.position()) > kPassed &&
                        !tried.has_failed(end.place, end.look, flight.map.safe().spec().cell);
  found_nothing = !leads_on;
  if (leads_on) tried.note_failure(end.place, end.look);  // once
  return leads_on;
}

void Lookouts::advance(const FlightFacts& flight, Work& work) noexcept {
  if (search.advance(flight.map, tried, work) != Progress::kDone) return;
  phase = LookoutPhase::kIdle;
  const int least = is_last_try ? kInVain : 0;
  if (!accept(flight)) {
    not_before = flight.time + kAfterNothing;
    const bool was_held_up = flight.itinerary.held_up != held_up;
    if (was_held_up || flight.map.learned() - learned >= kLearned) in_vain = least;
    held_up = flight.itinerary.held_up;
    learned = flight.map.learned();
    if (++in_vain >= kInVain && !is_last_try) searches_again(flight);
    return;
  }
  in_vain = least;
  phase = LookoutPhase::kOnWay;
  anchored = -1;
  --left;
  began = flight.time;
  aligned = -1;
  failed_cycles = 0;
  learned = flight.map.learned();
}

bool Lookouts::is_hopeless(const FlightFacts& flight) const noexcept {
  const bool has_no_sight = is_last_try && in_vain >= 2 * kInVain && search.answer == LookoutAnswer::kNoSight;
  const bool has_none_left = left == 0 && phase == LookoutPhase::kIdle && !flight.itinerary.is_held_up &&
                             !flight.itinerary.is_reached_by(flight.plans.latest()) &&
                             flight.itinerary.wandering >= wandering_due + kPlansAfterLast &&
                             flight.map.learned() - learned < kPlansAfterLast * kLearned;
  return has_no_sight || has_none_left;
}

bool Lookouts::searches_again(const FlightFacts& flight) noexcept {
  found_nothing = false;
  is_last_try = true;
  tried.clear();
  not_before = flight.time;
  return may_help(flight);
}

bool Lookouts::may_help(const FlightFacts& flight) const noexcept {
  const bool sees = flight.frames > 0 && flight.time - flight.frame_time < kNoFrames;
  return is_active() || is_searching() || (sees && left > 0 && !found_nothing);
}

bool Lookouts::has_unseen(const FlightFacts& flight, Vec3& centre) const noexcept {
  if (left == 0 && last_needed(flight, centre)) return true;
  const std::int32_t entry = tried.most_tried(flight.map);
  const bool is_hidden = search.answer == LookoutAnswer::kNoSight && search.has_needed && found_nothing;
  if (entry >= 0) centre = tried.voxel[entry].centre;
  if (entry < 0 && is_hidden) centre = search.needed;
  return entry >= 0 || is_hidden;
}

/// Of what the last lookout should have shown, the voxel nearest to the next point that is still unseen.
bool Lookouts::last_needed(const FlightFacts& flight, Vec3& centre) const noexcept {
  const Vec3 goal = goal_of(flight);
  bool found = false;
  for (std::int32_t k = 0; k < search.lookout.hidden_count; ++k) {
    const Vec3& hidden = search.lookout.hidden[k];
    if (!is_unseen_at(flight.map, hidden) || (found && distance(centre, goal) <= distance(hidden, goal))) continue;
    centre = hidden;
    found = true;
  }
  return found;
}

}  // namespace tern
