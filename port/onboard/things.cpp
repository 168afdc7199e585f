// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tern_onboard/things.hpp"

#include <algorithm>
#include <cmath>

#include "tern_onboard/pose.hpp"
#include "tern_onboard/poses.hpp"

namespace tern_onboard {
namespace {

constexpr int kNobody = Notices::kNoSubject;
constexpr auto kMost = static_cast<std::size_t>(tern::kMaxFlightTracks);

bool numbers_are_good(const Sighting& s) {
  const double sizes[] = {s.deviation,    s.speed_deviation, s.error,  s.speed_error,
                          s.height_error, s.time_error,      s.radius, s.half_height};
  const auto is_size = [](double size) { return std::isfinite(size) && size >= 0.0; };
  return is_finite(s.position) && (!s.has_velocity || is_finite(s.velocity)) &&
         std::all_of(std::begin(sizes), std::end(sizes), is_size);
}

}  // namespace

bool Things::is_good(const Sighting& s, std::int64_t now, Notices& notices) const {
  const auto refuse = [&](Fault fault, const std::string& text) {
    notices.bad(fault, kNobody, now, text);
    return false;
  };
  if (s.name.empty() || !numbers_are_good(s)) {
    return refuse(Fault::kThingInvalid, "a thing that moves is refused (\"" + s.name +
                                            "\"): it has no name, or a number that is not finite or is negative");
  }
  if (s.stamp > now + kStampAhead) {
    return refuse(Fault::kThingAhead, "things that move are refused (\"" + s.name + "\"): their stamps are " +
                                          milliseconds(s.stamp - now) + " ahead of the clock. Synchronise the clocks");
  }
  if (settings_.memory > 0.0 && seconds(now - s.stamp) > settings_.memory) {
    return refuse(Fault::kThingOld, "things that move are left out (\"" + s.name + "\"): their stamps are " +
                                        milliseconds(now - s.stamp) + " behind the clock, more than thing_memory");
  }
  return true;
}

void Things::add(const Sighting& sighting, const tern::Vec3* here, std::int64_t now, Notices& notices) {
  forget_old(now);
  if (!is_good(sighting, now, notices)) return;
  tern::Track track = track_of(sighting, settings_.sigmas);
  const auto known = known_.find(sighting.name);
  const tern::Vec3 from = here == nullptr ? tern::Vec3{} : minus(sighting.position, *here);
  const double away = here == nullptr ? 0.0 : std::hypot(from.x, from.y) - track.radius - track.error;
  if (away >= settings_.range || !(settings_.range > 0.0)) {
    if (known != known_.end()) drop(known);
    return;
  }
  if (known != known_.end()) {
    Thing& thing = known->second;
    if (sighting.stamp <= thing.track.measured) return notices.count(Fault::kThingBackward);
    track.id = thing.track.id;
    keep_bounds(thing.track, track);
    thing = {track, now, away, true, thing.is_told};
  } else if (make_room(away)) {
    track.id = next_id_++;
    known_[sighting.name] = {track, now, away, true, false};
  } else {
    return notices.bad(
        Fault::kThingsFull, kNobody, now,
        "a thing that moves is left out (\"" + sighting.name + "\"): " + std::to_string(kMost) +
            " nearer ones are known, which is the most. Nothing keeps clear of it. Lower thing_range, or look "
            "for a detector that reports too much");
  }
  notices.good(Fault::kThingInvalid, Fault::kThingsFull, kNobody, now, "things that move are taken again");
}

/// Lets the furthest thing go if it is further away than `away`.
bool Things::make_room(double away) {
  if (known_.size() < kMost) return true;
  const auto nearer = [](const auto& a, const auto& b) { return a.second.away < b.second.away; };
  const auto furthest = std::max_element(known_.begin(), known_.end(), nearer);
  if (furthest->second.away <= away) return false;
  drop(furthest);
  return true;
}

void Things::drop(std::map<std::string, Thing>::iterator thing) {
  if (thing->second.is_told) gone_.push_back(thing->second.track.id);
  known_.erase(thing);
}

void Things::forget_old(std::int64_t now) {
  if (!(settings_.memory > 0.0)) return;
  for (auto thing = known_.begin(); thing != known_.end();) {
    const auto next = std::next(thing);
    if (seconds(now - thing->second.heard) > settings_.memory) drop(thing);
    thing = next;
  }
}

void Things::tell(tern::Flight& flight, tern::FlightRecorder& record, const tern::Vec3& offset, std::int64_t time,
                  Notices& notices) {
  forget_old(time);
  for (const std::uint32_t id : gone_) record.forget_track(id, flight.forget_track(id));
  gone_.clear();
  for (auto& [name, thing] : known_) {
    if (!thing.is_new || thing.track.measured > time) continue;  // the flight takes nothing from after its tick
    tern::Track track = thing.track;
    track.position = minus(track.position, offset);
    const tern::Status answer = flight.update_track(track);
    record.update_track(track, answer);
    thing.is_new = false;
    thing.is_told = thing.is_told || answer == tern::Status::kOk;
    if (answer == tern::Status::kOk) continue;
    notices.bad(Fault::kThingInvalid, kNobody, time,
                "the flight refuses a thing that moves (\"" + name + "\"): " + tern::status_name(answer) + ", " +
                    tern::status_meaning(answer));
  }
}

void Things::begin_flight() {
  gone_.clear();
  for (auto& [name, thing] : known_) {
    thing.is_new = true;
    thing.is_told = false;
  }
}

void Things::set_clock(std::int64_t now) {
  for (auto& [name, thing] : known_) {
    thing.heard = now;
    thing.track.measured = INT64_MIN;
    thing.is_new = false;
  }
}

}  // namespace tern_onboard
