// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/flight_watch.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "host/flight/vectors.hpp"
#include "host/nanoseconds.hpp"
#include "host/number.hpp"

namespace tern_host {
namespace {

using tern::Sample;
using tern::Vec3;

constexpr std::int64_t kMostTicks = 1000000;  // of a plan: the slowest take some ten thousand
constexpr std::int64_t kPicks = 32;           // instants that are compared where nothing was committed
constexpr int kNear = 8;                      // stretches of a tick before which nothing may take over
constexpr double kDistanceError = 1e-6;       // metres
constexpr double kLeastWay = 1e-3;            // metres between two points where there is no room
constexpr double kMostSnap = 1e7;             // m/s^4
constexpr std::int64_t kMinute = 60000000000;

Vec3 between(const Vec3& a, const Vec3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

bool same_bits(const Sample& a, const Sample& b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

/// But for rounding: where a plan is extended, its last segment is cut in another place.
bool nearly_same(const Sample& a, const Sample& b) {
  const JointRounding& most = kJointRounding;
  return length(between(a.position, b.position)) <= most.position * (1.0 + length(a.position)) &&
         length(between(a.velocity, b.velocity)) <= most.velocity &&
         length(between(a.acceleration, b.acceleration)) <= most.acceleration &&
         length(between(a.jerk, b.jerk)) <= most.jerk;
}

bool is_finite(const Sample& s) {
  return std::isfinite(length(s.position) + length(s.velocity) + length(s.acceleration) + length(s.jerk) +
                       length(s.snap));
}

bool at_rest(const Sample& s, const Vec3& end) {
  const double moves = length(s.velocity) + length(s.acceleration) + length(s.jerk);
  return !(moves > 0.0) && length(between(s.position, end)) <= kDistanceError;
}

std::string after(std::int64_t t, std::int64_t from) {
  return fixed(seconds_of(t - from), 3) + " s after its commit";
}

}  // namespace

FlownCommands commands_of(const tern::Flight& flight) {
  return {[&flight](std::int64_t t) { return flight.command(t).sample; }, [&flight] { return flight.rest_position(); }};
}

FlightWatch::FlightWatch(const FlightWorld& world, const tern::FlightSpec& spec, const tern::RollingMap& map,
                         FlownCommands commands)
    : spec_(spec), commands_(std::move(commands)), rooms_(world, map) {
  ahead_.push_back({0, at(0)});
}

void FlightWatch::fail(int invariant, const std::string& what, std::int64_t t) {
  if (!broken_.empty()) return;
  broken_ = "invariant " + std::to_string(invariant) + " at t = " + fixed(seconds_of(t), 3) + ": " + what;
}

void FlightWatch::before(std::int64_t t) {
  near_.clear();
  for (int k = 0; k <= kNear; ++k) near_.push_back({t + spec_.tick * k / kNear, at(t + spec_.tick * k / kNear)});
  while (ahead_.size() > 1 && ahead_.front().t < t) ahead_.pop_front();
}

void FlightWatch::look(std::int64_t t, const tern::FlightReport& report) {
  ++counts_.ticks;
  check_report(report, t);
  // A threat may take back what was committed but is not flown yet.
  const bool threat = report.mode == tern::FlightMode::kThreat;
  if (report.committed == last_.committed && !threat) {
    check_unchanged(t);
  } else {
    take_commit(t, !threat);
  }
  last_ = report;
}

void FlightWatch::check_report(const tern::FlightReport& report, std::int64_t t) {
  if (report.work > spec_.work_per_tick) fail(7, "a tick spent " + std::to_string(report.work) + " units", t);
  if (report.asked < last_.asked || report.committed < last_.committed || report.dropped < last_.dropped ||
      report.failed < last_.failed || report.committed > last_.committed + 1) {
    fail(7, "the counts of plans fell, or two plans were committed in one tick", t);
  }
  const bool threat = report.mode == tern::FlightMode::kThreat;
  if (!threat && (report.contact_time != 0 || report.contact_speed > 0.0)) {
    fail(7, "a contact is announced without a threat", t);
  }
}

/// Without a commit, the commands that are to come are the same bits as before; the window may move. In one tick some
/// instants are compared, evenly along the plan, and in as many ticks as lie between two of them all are.
void FlightWatch::check_unchanged(std::int64_t t) {
  const auto is_changed = [this](const TimedSample& was) { return !same_bits(at(was.t), was.sample); };
  const std::int64_t stride = static_cast<std::int64_t>(ahead_.size()) / kPicks + 1;
  bool changed = std::any_of(near_.begin(), near_.end(), is_changed) || is_changed(ahead_.back());
  for (const TimedSample& was : ahead_) {
    const auto number = was.t / spec_.tick + static_cast<std::int64_t>(counts_.ticks);
    changed = changed || (number % stride == 0 && is_changed(was));
  }
  if (changed) fail(1, "commands changed without a commit", t);
  check_window(t);
}

/// A sample each tick, up to the rest.
std::vector<TimedSample> FlightWatch::sample_to_rest(std::int64_t t) {
  // Near rest is not enough: the vehicle may rest where a plan that hardly moves it is about to take over.
  const Sample rest = at(t + kMostTicks * spec_.tick);
  std::vector<TimedSample> fresh;
  do {
    const std::int64_t now = t + static_cast<std::int64_t>(fresh.size()) * spec_.tick;
    fresh.push_back({now, at(now)});
    if (!is_finite(fresh.back().sample)) fail(1, "a command is not finite", t);
  } while (!same_bits(fresh.back().sample, rest) && fresh.size() < kMostTicks && broken_.empty());
  const Vec3 end = commands_.rest_position();
  if (!at_rest(fresh.back().sample, end) || !at_rest(at(fresh.back().t + kMinute), end)) {
    fail(1, "the committed plan does not end at rest", t);
  }
  return fresh;
}

void FlightWatch::take_commit(std::int64_t t, bool proven) {
  ++counts_.commits;
  const std::vector<TimedSample> fresh = sample_to_rest(t);
  const std::int64_t last = fresh.back().t;
  check_before_takeover(t);
  check_joints(t, std::min(last, t + longest_lead()));
  check_curve(fresh, t);
  const std::int64_t changed = unchanged_until(fresh);
  note_place(t, changed, proven);
  // Whatever alarms it raised: the true world stands still.
  if (rooms_.readable()) check_clear(t, changed, last, proven);
  ahead_.assign(fresh.begin(), fresh.end());
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  origin_ = {kNone, kNone, kNone};
  check_window(t);
}

/// What was committed up to the next tick is still flown.
void FlightWatch::check_before_takeover(std::int64_t t) {
  for (const TimedSample& was : near_) {
    if (!nearly_same(at(was.t), was.sample)) fail(4, "a commit took over too early", t);
  }
}

/// Plans take over at ticks: both sides of each must agree, position to jerk.
void FlightWatch::check_joints(std::int64_t t, std::int64_t end) {
  for (std::int64_t k = t + spec_.tick; k <= end; k += spec_.tick) {
    if (!is_continuous({k - 1, at(k - 1)}, {k, at(k)})) fail(3, "a joint jumps", k);
  }
}

/// All of it, and not samples alone: smooth inside, and within the limits, those of brakes under a threat as well.
void FlightWatch::check_curve(const std::vector<TimedSample>& fresh, std::int64_t t) {
  CurveCheck check(commands_.at, spec_.limits);
  for (std::size_t k = 0; k + 1 < fresh.size(); ++k) check.look(fresh[k], fresh[k + 1]);
  counts_.snap = std::max(counts_.snap, check.snap());
  counts_.slivers += check.slivers();
  if (check.fault().what != nullptr) {
    const std::string what = std::string("the committed plan ") + check.fault().what + ", " + after(check.fault().t, t);
    fail(check.fault().is_limit ? 2 : 1, what, t);
  }
  if (check.snap() > kMostSnap) fail(3, "a snap of " + brief(check.snap()) + " m/s^4", t);
}

/// A vehicle that rests at the takeover, or two ticks later, with something within the radius may leave that place, as
/// long as it comes no nearer to it. What takes over while it still leaves, keeps to the place that it left. Under a
/// threat it must rest already: a brake may end soon, and nothing leaves from there yet. The takeover is the last tick
/// before what is committed is `changed`.
void FlightWatch::note_place(std::int64_t t, std::int64_t changed, bool proven) {
  const std::int64_t takeover = proven ? std::max(t, changed - spec_.tick) : t;
  const std::int64_t latest = proven ? takeover + 2 * spec_.tick : t;
  if (ahead_.back().t > latest || !rooms_.readable()) return;
  rooms_.rest_at(at(takeover).position);
}

/// From the beginning of a plan to its takeover, at most: late plans get more ticks, up to eight times as many.
std::int64_t FlightWatch::longest_lead() const {
  return (8 * std::int64_t{spec_.plan_work / (spec_.work_per_tick / 2)} + 2) * spec_.tick;
}

/// Until when a commit leaves everything as it was, up to the latest takeover. That part was proven at its own commit,
/// on the map of that time. After the last sample, the vehicle was to rest.
std::int64_t FlightWatch::unchanged_until(const std::vector<TimedSample>& fresh) const {
  const std::int64_t latest = fresh.front().t + longest_lead();
  std::size_t k = 0;
  while (k < fresh.size() && fresh[k].t < latest &&
         nearly_same(fresh[k].sample, ahead_[std::min(k, ahead_.size() - 1)].sample)) {
    ++k;
  }
  return fresh.front().t + static_cast<std::int64_t>(k) * spec_.tick;
}

/// Nanoseconds in which the vehicle cannot fly further than `way`, at the limit of its acceleration.
std::int64_t FlightWatch::time_for(double way, const Sample& sample) const {
  const double most = std::hypot(spec_.limits.a_horizontal, spec_.limits.a_max.z) * 1.001;
  const double speed = length(sample.velocity);
  return static_cast<std::int64_t>(1e9 * (std::sqrt(speed * speed + 2.0 * most * way) - speed) / most) + 1;
}

/// Where the way is too near to the true world. If the map says free there, the flight is not to blame: no frame showed
/// what is there, or the start's surroundings were stated free.
std::string FlightWatch::too_near(const Vec3& p, double room) const {
  const std::string place = "at " + fixed(p.x, 2) + " " + fixed(p.y, 2) + " " + fixed(p.z, 2);
  const bool says_free = rooms_.readable() && rooms_.from_solid(p) >= -kDistanceError;
  return fixed(-room, 4) + " m too near to the true world " + place +
         (says_free ? ", where the map says free: no frame showed what is there" : "");
}

/// The whole way, not points of it alone: from a point, the vehicle cannot come nearer than the room there allows. A
/// millimetre without room is flown nearly straight, and so comes nearer than its ends by less than a micrometre.
/// Fences count from `fresh` on, since a vehicle may rest in a keep-out that has begun; so does unproven space, if the
/// commit is said to be `proven`.
void FlightWatch::check_clear(std::int64_t from, std::int64_t fresh, std::int64_t to, bool proven) {
  for (std::int64_t t = from; t <= to && broken_.empty();) {
    ++counts_.points;
    const Sample sample = at(t);
    const Vec3& p = sample.position;
    constexpr double kFar = std::numeric_limits<double>::infinity();
    const double real = knows_world_ ? rooms_.from_world(p) : kFar;
    const double solid = t < fresh || !proven ? kFar : rooms_.from_solid(p);
    std::int64_t change = std::numeric_limits<std::int64_t>::max();
    const double fenced = t < fresh ? kFar : rooms_.from_fences(p, t, change);
    if (real < -kDistanceError) fail(6, too_near(p, real) + ", " + after(t, from), from);
    if (solid < -kDistanceError) fail(2, fixed(-solid, 4) + " m too near to unproven space, " + after(t, from), from);
    if (fenced < -kDistanceError) fail(2, fixed(-fenced, 4) + " m into a fence, " + after(t, from), from);
    const double room = std::min({solid, real, fenced, kLeastWay + spec_.horizon});
    const std::int64_t next = std::min(change, t + time_for(std::max(kLeastWay, room), sample));
    t = t < fresh && fresh <= to ? std::min(next, fresh) : next;
  }
}

void FlightWatch::check_window(std::int64_t t) {
  if (!rooms_.readable()) return;
  const Vec3& origin = rooms_.window().origin;
  if (!(length(between(origin, origin_)) > 0.0) && !std::isnan(origin_.x)) return;
  origin_ = origin;
  for (std::int64_t now = t; now <= ahead_.back().t && broken_.empty();) {
    const Sample sample = at(now);
    const double room = rooms_.from_faces(sample.position);
    if (room < -kDistanceError) fail(5, "the window cuts what is flown", t);
    now += time_for(std::max(kLeastWay, room), sample);
  }
}

}  // namespace tern_host
