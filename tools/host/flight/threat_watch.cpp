// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/threat_watch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host/flight/vectors.hpp"
#include "host/nanoseconds.hpp"
#include "host/number.hpp"

namespace tern_host {
namespace {

using tern::Sample;
using tern::Vec3;

constexpr double kPlaceError = 1e-6;       // metres
constexpr double kLeastGap = 1e-3;         // metres between two points where there is no room
constexpr std::int64_t kLead = 3;          // ticks until a brake begins,
constexpr std::int64_t kLongestLead = 24;  // and after brakes that came too late
constexpr std::int64_t kMostKept = 120000000000;
constexpr std::int64_t kKeptStep = 1000000;  // nanoseconds along a way that is kept
constexpr std::int64_t kMicrosecond = 1000;  // nanoseconds
/// How much too early a proof may end, since it halves its pieces a number of times.
constexpr std::int64_t kProofEarly = 100 * kMicrosecond;
constexpr double kSpeedError = 1e-3;  // m/s, of what is announced
constexpr double kBrakeError = 0.1;   // m/s, of contacts, besides two ticks at the limit of acceleration
/// Ticks, and units of work, that a proof of what is commanded may take.
constexpr std::int64_t kNoticeTicks = 4;
constexpr std::int64_t kNoticeWork = 20000;

double nearest(const std::vector<Appearance>& things, const Vec3& p) {
  double best = std::numeric_limits<double>::infinity();
  for (const Appearance& thing : things) best = std::min(best, distance_to(thing, p));
  return best;
}

}  // namespace

ThreatWatch::ThreatWatch(const FlightSettings& settings, const tern::FlightSpec& spec, const tern::RollingMap& map,
                         const Rooms& rooms, FlownCommands commands, Meets meets)
    : settings_(settings),
      spec_(spec),
      map_(map),
      rooms_(rooms),
      commands_(std::move(commands)),
      meets_(std::move(meets)) {}

void ThreatWatch::fail(const std::string& what, std::int64_t t) {
  if (broken_.empty()) broken_ = "threat at t = " + fixed(seconds_of(t), 3) + ": " + what;
}

std::int64_t ThreatWatch::first_unproven(std::int64_t t) const {
  const double most = std::hypot(spec_.limits.a_horizontal, spec_.limits.a_max.z) * 1.001;
  for (std::int64_t now = t; now < t + kMostKept;) {
    const Sample sample = commands_.at(now);
    const double room = rooms_.from_solid(sample.position);
    if (room < -kPlaceError) return now;
    if (rests(sample) && now > t) return -1;
    const double speed = length(sample.velocity);
    const double way = std::max(kLeastGap, room);
    now += static_cast<std::int64_t>(1e9 * (std::sqrt(speed * speed + 2.0 * most * way) - speed) / most) + 1;
  }
  return -1;
}

void ThreatWatch::follow(std::int64_t t) {
  unproven_ = first_unproven(t);
  revision_ = map_.revision();
  if (unproven_ < 0) shown_ = -1;
  if (unproven_ < 0 || shown_ >= 0 || map_.busy()) return;
  shown_ = t;
  shown_way_.clear();
  do {
    shown_way_.push_back(commands_.at(t + static_cast<std::int64_t>(shown_way_.size()) * kKeptStep));
  } while (!rests(shown_way_.back()));
}

void ThreatWatch::look(std::int64_t t, const tern::FlightReport& report) {
  if (!rooms_.readable()) return;
  const bool threat = report.mode == tern::FlightMode::kThreat;
  const bool reports = threat && (last_.mode != tern::FlightMode::kThreat || report.committed != last_.committed ||
                                  report.contact_time != last_.contact_time);
  const bool is_over = unproven_ >= 0 && unproven_ < t;
  if (reports || is_over || map_.revision() != revision_ || report.committed != last_.committed) follow(t);
  if (reports && unproven_ >= 0) check_report(t, report);
  count_disagreement(report, t);
  last_ = report;
}

/// True if what is commanded for time `t`, or right after it, is too near to a tube.
bool ThreatWatch::meets_tube(std::int64_t t) const {
  return meets_(commands_.at(t).position, t) || meets_(commands_.at(t + kProofEarly).position, t + kProofEarly);
}

std::int64_t ThreatWatch::notice_ticks() const {
  return kNoticeTicks + kNoticeWork / spec_.work_per_tick;
}

/// The flight looks at whole frames, and needs some ticks for a proof. An alarm in which nothing is in the way is one
/// of a plan that was taken back, and over soon; or the vehicle rests beside something and may stay. At rest, one alarm
/// is enough; after it, the report must name what is in the way.
void ThreatWatch::count_disagreement(const tern::FlightReport& report, std::int64_t t) {
  const std::int64_t most = notice_ticks();
  const bool threat = report.mode == tern::FlightMode::kThreat;
  said_ = threat || (said_ && shown_ >= 0);
  const bool is_told = said_ && rests(commands_.at(t)) && report.blocked_by != tern::BlockedBy::kNothing;
  unnoticed_ = shown_ >= 0 && !threat && !is_told ? unnoticed_ + 1 : 0;
  const bool is_met = threat && meets_tube(report.contact_time);
  unfounded_ = unproven_ < 0 && threat && !is_met && !rooms_.leaves() && !map_.busy() ? unfounded_ + 1 : 0;
  if (unnoticed_ > most) fail("something is in the way, and the flight does not say so", t);
  if (unfounded_ > most) fail("the flight says that something is in the way, and there is not", t);
}

/// The instant and the speed of a contact that is announced. A brake that is committed answers for the time from its
/// beginning on. A plan that begins at rest hardly moves at first, and may be too near by nanometres for a while.
void ThreatWatch::check_report(std::int64_t t, const tern::FlightReport& report) {
  const double speed = length(commands_.at(report.contact_time).velocity);
  if (std::abs(speed - report.contact_speed) > kSpeedError) {
    fail("a contact is announced at " + brief(report.contact_speed) + " m/s, but at " + brief(speed) + " is commanded",
         t);
  }
  if (report.contact_time <= t) return check_past(t, report);
  const double most = std::hypot(spec_.limits.a_horizontal, spec_.limits.a_max.z);
  const double slack = (std::sqrt(speed * speed + 4.0 * most * kLeastGap) - speed) / most;
  const std::int64_t earliest = unproven_ - static_cast<std::int64_t>(1e9 * slack) - kProofEarly;
  const std::int64_t begun = t + kLongestLead * spec_.tick;
  const std::int64_t latest = unproven_ <= begun ? std::max(begun, first_unproven(begun)) : unproven_;
  const Vec3 place = commands_.at(report.contact_time).position;
  const bool is_early =
      report.contact_time < earliest && rooms_.from_solid(place) > kLeastGap && !meets_tube(report.contact_time);
  if (is_early || report.contact_time > latest + kMicrosecond) {
    fail("a contact is announced for t = " + fixed(seconds_of(report.contact_time), 4) +
             ", but what is commanded is too near at t = " + fixed(seconds_of(unproven_), 4),
         t);
  }
}

/// A contact that is past stays announced until another plan takes over. It was announced before, or was met while the
/// flight still looked at the map that showed it.
void ThreatWatch::check_past(std::int64_t t, const tern::FlightReport& report) {
  if (report.contact_time == last_.contact_time) return;
  const Vec3 place = commands_.at(report.contact_time).position;
  const double room = rooms_.from_solid(place);
  const bool is_met = room <= kLeastGap || meets_tube(report.contact_time);
  if (is_met && report.contact_time >= t - notice_ticks() * spec_.tick) return;
  fail("a contact is announced for t = " + fixed(seconds_of(report.contact_time), 4) + ", which is past, with " +
           brief(room) + " m of room there",
       t);
}

/// Of the brakes that touch nothing but these things, the one that meets them slowest: its speed where it is as near to
/// them as `near`, or 0. The brake along what was commanded is one of them, since that was proven before.
double ThreatWatch::brake_speed(const std::vector<Appearance>& things, double near) const {
  const Commands way = [this](std::int64_t t) {
    const double at = static_cast<double>(t - shown_) / static_cast<double>(kKeptStep);
    return shown_way_[std::min(static_cast<std::size_t>(std::max(0.0, at + 0.5)), shown_way_.size() - 1)];
  };
  const std::int64_t begin = shown_ + kLead * spec_.tick;
  const BrakeWay straight = brake_straight(way, shown_, begin, spec_.limits);
  double slowest = std::numeric_limits<double>::infinity();
  for (const BrakeWay& brake : {brake_along(way, shown_, begin, spec_.limits), straight}) {
    if (brake.empty() || (&brake == &straight && !is_clear(brake, things))) continue;
    const auto met = std::find_if(brake.begin(), brake.end(),
                                  [&](const BrakeMoment& moment) { return nearest(things, moment.position) <= near; });
    slowest = std::min(slowest, met == brake.end() ? 0.0 : met->speed);
  }
  return slowest;
}

/// But for the voxels that hold something of the things.
bool ThreatWatch::is_clear(const BrakeWay& way, const std::vector<Appearance>& things) const {
  const double far = 0.9 * settings_.cell + settings_.depth_margin + settings_.depth_noise * settings_.sensor_range;
  const auto is_thing = [&](const Vec3& center) { return nearest(things, center) <= far; };
  return std::all_of(way.begin(), way.end(), [&](const BrakeMoment& moment) {
    return rooms_.from_solid(moment.position, is_thing) >= -kPlaceError;
  });
}

ThreatContact ThreatWatch::meet(std::int64_t t, const std::vector<Appearance>& things) const {
  const Sample now = commands_.at(t);
  const double tick = seconds_of(spec_.tick);
  ThreatContact contact;
  contact.speed = length(now.velocity);
  contact.shown = shown_ >= 0 && shown_ + (kLead + kNoticeTicks) * spec_.tick < t;
  contact.announced = last_.mode == tern::FlightMode::kThreat;
  contact.announced_speed = last_.contact_speed;
  contact.tolerance = kBrakeError + 2.0 * tick * spec_.limits.a_horizontal;
  if (shown_ >= 0) contact.brake_speed = brake_speed(things, nearest(things, now.position));
  return contact;
}

}  // namespace tern_host
