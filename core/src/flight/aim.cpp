// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "flight/aim.hpp"

#include "base/math.hpp"
#include "base/too_narrow.hpp"
#include "grid/lattice.hpp"

namespace tern {
namespace {

/// Voxels around the vehicle that are looked at for a way out, along each axis and direction.
constexpr std::int32_t kMaxWayOut = 8;
/// How often a place is moved back to make room: each time out of the reach of one more vehicle.
constexpr int kMostMoves = 8;

/// A place that is moved back is so many clearances from the thing that rests there: another vehicle fits between them,
/// so that what rests there can leave.
constexpr double kRoomBetween = 3.0;

/// True if it is known where the thing comes to rest: its curve ends, or it stands still for certain.
bool has_rest(const Track& track) {
  const bool stands = same(track.velocity, kZero) && !(track.error_speed + track.error_growth + track.reach > 0.0);
  return track.end != TrackEnd::kGone && (track.piece_count > 0 || stands);
}

Vec3 rest_of(const Track& track) {
  return track.piece_count > 0 ? track.position + track.pieces[track.piece_count - 1].points[kDegree] : track.position;
}

/// How far from the centre of a thing that rests a vehicle may rest, at least.
double room_of(const Track& track, double clearance) {
  const double size = track.shape == TrackShape::kBall ? track.radius : track.radius + length(track.half);
  return clearance + size + track.error;
}

/// The first thing that comes to rest too near to this place; null if there is none.
const Track* resting_at(const TrackTable& things, const Vec3& place, double clearance) {
  for (std::int32_t k = 0; k < things.count; ++k) {
    const Track& track = things.tracks[k];
    if (has_rest(track) && distance(rest_of(track), place) < room_of(track, clearance)) return &track;
  }
  return nullptr;
}

}  // namespace

void Aim::begin(const JointState& from, std::uint32_t mission_number) noexcept {
  start = from;
  mission = mission_number;
  moved = beside_target = at_reachable = false;
}

/// The plan passes all points that are less than a horizon away, along straight lines, and then leads towards the
/// target. That is the first point that is further away or has a dwell, or the goal.
void Aim::choose_points(const FlightFacts& flight, std::int64_t takeover) noexcept {
  const Itinerary& itinerary = flight.itinerary;
  asked_count = 0;
  target = itinerary.leg_at(flight.plans.in_flight, takeover);
  double way = distance(start.d[0], itinerary.points[target].position);
  while (target != itinerary.last() && way <= flight.spec.horizon &&
         flight.in_window(itinerary.points[target].position)) {
    if (itinerary.points[target].dwell > 0.0) break;
    const Vec3& passed = itinerary.points[target].position;
    ask_for(target, itinerary);
    target = itinerary.after(target);
    way += distance(passed, itinerary.points[target].position);
  }
  target_place = itinerary.points[target].position;
}

void Aim::ask_for(std::int32_t point, const Itinerary& itinerary) noexcept {
  asked_point[asked_count] = point;
  asked[asked_count++] = itinerary.points[point];
}

void Aim::follow_points(const Commitment& in_flight, const Itinerary& itinerary, std::int64_t takeover) noexcept {
  const std::int32_t leg = itinerary.leg_at(in_flight, takeover);
  asked_count = 0;
  for (std::int32_t i = 0; i < in_flight.passages; ++i) {
    const std::int32_t point = in_flight.passage[i].point;
    if (point >= leg && !(in_flight.at_target && point == in_flight.target)) ask_for(point, itinerary);
  }
  target = in_flight.target;
  target_place = itinerary.points[target].position;
}

void Aim::follow_place(const Commitment& in_flight) noexcept {
  place = in_flight.place;
  at_target = in_flight.at_target;
}

void Aim::choose_place(const FlightFacts& flight, double most) noexcept {
  const Vec3& from = place_before_target();
  const GridSpec& window = flight.map.safe().spec();
  const double margin = window.clearance() + kAimVoxels * window.cell;
  const Vec3 way = target_place - from;
  const double far = length(way);
  double part = far > most ? most / far : 1.0;
  for (int a = 0; a < 3; ++a) {
    const double room = axis(way, a) > 0.0 ? axis(window.boundary.upper, a) - margin - axis(from, a)
                                           : axis(from, a) - margin - axis(window.boundary.lower, a);
    const double length_a = absolute(axis(way, a));
    if (length_a > room) part = smaller(part, larger(0.0, room) / length_a);
  }
  at_target = part >= 1.0;
  place = at_target ? target_place : from + part * way;
}

void Aim::choose_way_out(const FlightFacts& flight) noexcept {
  const Vec3& from = start.d[0];
  const Grid& safe = flight.map.safe();
  const GridSpec& window = safe.spec();
  const Vec3 local = safe.to_local(from);
  const Voxel at = safe.voxel_of(local);
  const std::int32_t extent = ceil_index(window.clearance() / window.cell, 0, kMaxWayOut);
  Vec3 away = kZero;
  for (std::int32_t z = at.z - extent; z <= at.z + extent; ++z) {
    for (std::int32_t y = at.y - extent; y <= at.y + extent; ++y) {
      for (std::int32_t x = at.x - extent; x <= at.x + extent; ++x) {
        if (safe.obstacle({x, y, z})) away = away + (local - safe.center({x, y, z}));
      }
    }
  }
  const double size = length(away);
  if (size > 0.0) lead_to(from + (window.clearance() / size) * away);
}

void Aim::lead_to(const Vec3& elsewhere) noexcept {
  place = elsewhere;
  at_target = false;
}

void Aim::pass_first(std::int32_t number, const Itinerary& itinerary, double cell) noexcept {
  if (number < asked_count) target = asked_point[number];
  asked_count = number;
  target_place = itinerary.points[target].position;
  const bool ends_beside = number > 0 && distance(place, asked[number - 1].position) < cell;
  if (ends_beside) end_at_point(number - 1, itinerary);
}

void Aim::end_at_point(std::int32_t number, const Itinerary& itinerary) noexcept {
  asked_count = number;
  target = asked_point[number];
  target_place = place = itinerary.points[target].position;
  at_target = true;
  moved = beside_target = false;
}

void Aim::ask_for_less(const Report& found, const Itinerary& itinerary) noexcept {
  const bool on_way = found.status == Status::kNoPath || lacks_via_voxel(found.status) ||
                      found.status == Status::kViaFenced || lacks_goal_voxel(found.status) ||
                      found.status == Status::kGoalFenced;
  const std::int32_t reached_points = !on_way ? 0 : (found.via == kNoVia ? asked_count : found.via);
  end_at_point(reached_points > 1 ? reached_points - 1 : 0, itinerary);
}

void Aim::forget_points() noexcept {
  asked_count = 0;
  at_target = beside_target = false;
}

void Aim::shorten(const Path& way, const GridSpec& window, double horizon, const Itinerary& itinerary) noexcept {
  double ahead = horizon;
  std::int32_t passed = 0;
  for (int i = 1; i < way.count; ++i) {
    const double leg = distance(way.points[i - 1], way.points[i]);
    if (leg > ahead) {
      place = window.origin + way.points[i - 1] + (ahead / leg) * (way.points[i] - way.points[i - 1]);
      at_target = beside_target = moved = false;
      pass_first(passed, itinerary, window.cell);
      return;
    }
    ahead -= leg;
    const Vec3 corner = window.origin + way.points[i];
    while (passed < asked_count && distance(corner, asked[passed].position) < kSamePlace) ++passed;
  }
}

bool Aim::move_to_free(const Report& found) noexcept {
  if (!lacks_goal_voxel(found.status) || !found.has_nearest_free || moved) return false;
  moved = true;
  place = found.nearest_free;
  return true;
}

void Aim::end_beside(const Commitment* followed, double slack) noexcept {
  const bool is_same = followed != nullptr && followed->beside_target && followed->target == target;
  if (is_same && distance(followed->place, target_place) <= distance(place, target_place) + slack)
    place = followed->place;
  beside_target = at_target || is_same;
  at_target = false;
}

void Aim::move_to_reachable(const Vec3& reachable) noexcept {
  place = reachable;
  at_reachable = true;
  at_target = beside_target = false;
}

bool Aim::leave_room(const TrackTable& things, double clearance, double cell) noexcept {
  const Vec3& from = place_before_target();
  for (int move = 0; move < kMostMoves; ++move) {
    const Track* const there = resting_at(things, place, clearance + 0.5 * cell);
    const double far = distance(from, place);
    if (there == nullptr || !(far > 0.0)) return move > 0;
    const Vec3 back = (1.0 / far) * (from - place);
    const Vec3 off = place - rest_of(*there);
    const double room = room_of(*there, kRoomBetween * clearance);
    const double along = dot(off, back);
    const double step = square_root(larger(0.0, along * along - dot(off, off) + room * room)) - along;
    lead_to(step < far ? place + step * back : from);
    beside_target = moved = false;
  }
  return true;
}

void Aim::return_to_line(const FlightFacts& flight) noexcept {
  moved = beside_target = false;
  choose_place(flight, flight.spec.horizon);
}

double Aim::way_length(const Vec3& to) const noexcept {
  double sum = 0.0;
  Vec3 from = start.d[0];
  for (std::int32_t i = 0; i < asked_count; ++i) {
    sum += distance(from, asked[i].position);
    from = asked[i].position;
  }
  return sum + distance(from, to);
}

std::int32_t Aim::point_at_fault(const Report& found, const Itinerary& itinerary) const noexcept {
  const bool at_via = lacks_via_voxel(found.status) || found.status == Status::kViaFenced;
  const bool at_end = lacks_goal_voxel(found.status) || found.status == Status::kGoalFenced;
  if (at_via && found.via != kNoVia) return asked_point[found.via];
  return at_end && at_target && target != itinerary.last() ? target : -1;
}

}  // namespace tern
