// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "verify/course.hpp"

#include <algorithm>

namespace tern_verify {
namespace {

/// What docs/flight.md allows where a new plan takes over: metres, and m/s3 of jerk. Between them it names nothing.
const Rational kTakeover[] = {decimal(1, 11), decimal(1, 10), decimal(1, 7), decimal(1, 4)};
/// Rounding of a command and of the goal, metres.
const Rational kRounding = decimal(1, 11);
/// Rounding of the figures that the log derives from its track, metres.
const Rational kFigure = decimal(1, 9);

/// The segment that is flown at a time since the flight's beginning, and how much of it is behind; after the end, all
/// of the last one.
struct Place {
  const Segment* segment;
  Rational u;
};

Place place_at(const Commit& commit, const Rational& time) {
  Rational left = time - commit.begin;
  std::size_t s = 0;
  for (; s + 1 < commit.segments.size() && left > commit.segments[s].duration; ++s) left -= commit.segments[s].duration;
  return {&commit.segments[s], std::min<Rational>(left / commit.segments[s].duration, 1)};
}

/// Position to jerk, world frame.
Motion motion_at(const Commit& commit, const Rational& time) {
  const Place place = place_at(commit, time);
  Motion motion;
  Polygon<3> curve = place.segment->points;
  for (std::size_t k = 0; k < motion.size(); ++k) {
    motion[k] = point_at(curve, place.u);
    curve = hodograph(curve, place.segment->duration);
  }
  motion[0] = motion[0] + commit.origin;
  return motion;
}

/// The commit that number `commit` takes over from: what was withdrawn never took over. Null for the start.
const Commit* flown_before(const Flight& flight, std::size_t commit) {
  while (commit > 0 && flight.commits[commit - 1].withdrawn) --commit;
  return commit > 0 ? &flight.commits[commit - 1] : nullptr;
}

/// The commits that took over by a time, one after the other.
class Flown {
 public:
  explicit Flown(const Flight& flight) : commits_(flight.commits) {}

  /// The one that is flown at a time, which must not fall from call to call. Null before the first one.
  const Commit* at(const Rational& time) {
    for (; next_ < commits_.size(); ++next_) {
      if (commits_[next_].withdrawn) continue;
      if (commits_[next_].takeover() > time) break;
      flown_ = &commits_[next_];
    }
    return flown_;
  }

 private:
  const std::vector<Commit>& commits_;
  const Commit* flown_ = nullptr;
  std::size_t next_ = 0;
};

/// Before the first commit takes over, the vehicle hovers at the start.
Motion commanded(const Flight& flight, const Commit* commit, const Rational& time) {
  if (commit != nullptr) return motion_at(*commit, time);
  return {flight.world.start, Point{0, 0, 0}, Point{0, 0, 0}, Point{0, 0, 0}};
}

void claim_no_jump(const std::string& what, const Motion& from, const Motion& to, Claims& claims) {
  for (std::size_t k = 0; k < from.size(); ++k) {
    const Rational jump = largest_gap(from[k], to[k]);
    claims.push_back({what + " " + kDerivativeNames[k], kUnits[k], -jump, -jump, kTakeover[k], ""});
  }
}

std::string tick_place(const Flight& flight, std::size_t tick) {
  return "t = " + text_below(flight.track.tick * tick) + " s";
}

/// At each tick, the command is a point of the commit that is flown then.
void prove_commands(const Flight& flight, Claims& claims) {
  Tightest tightest("flown: commands", "m");
  Flown commits(flight);
  for (std::size_t tick = 0; tick < flight.track.commanded.size(); ++tick) {
    const Rational time = flight.track.tick * tick;
    const Commit* const flown = commits.at(time);
    Point position = flight.world.start;
    if (flown != nullptr) {
      const Place place = place_at(*flown, time);
      position = point_at(place.segment->points, place.u) + flown->origin;
    }
    const Rational gap = largest_gap(position, flight.track.commanded[tick]);
    tightest.note(-gap, kRounding, [&] { return tick_place(flight, tick); });
  }
  claims.push_back(tightest.claim());
}

/// A log that makes its flight better than its track is contradicts itself.
void require_honest(const Flight& flight, const char* name, bool honest, const Rational& found) {
  if (honest) return;
  throw InputError(flight.name + ": its " + name + " is better than that of its track, " + text_below(found) + " m");
}

void prove_margin(const Flight& flight, Claims& claims) {
  const Track& track = flight.track;
  Rational square = 0;
  std::size_t worst = 0;
  for (std::size_t tick = 0; tick < track.believed.size(); ++tick) {
    const Point off = track.believed[tick] - track.commanded[tick];
    if (dot(off, off) <= square) continue;
    square = dot(off, off);
    worst = tick;
  }
  const Rational& said = flight.tracking_error;
  require_honest(flight, "tracking_error", said + kFigure >= root_above(square), root_above(square));
  const Rational& margin = flight.world.setting("tracking_margin");
  claims.push_back({"flown: tracking error", "m", margin - std::max(said, root_above(square)),
                    margin - std::max(said, root_below(square)), decimal(1, 9) * margin, tick_place(flight, worst)});
}

void prove_body(const Flight& flight, const std::vector<Solid>& solids, Claims& claims) {
  const Nearest nearest = nearest_point(flight.track.real, solids);
  const Rational& said = flight.clearance;
  require_honest(flight, "min_clearance", said <= std::max<Rational>(nearest.most, 0) + kFigure, nearest.most);
  const Rational& body = flight.world.setting("body_radius");
  claims.push_back({"flown: body off the world", "m", std::min(said, nearest.least) - body,
                    std::min(said, nearest.most) - body, 0, tick_place(flight, nearest.curve)});
}

}  // namespace

void prove_takeover(const Flight& flight, std::size_t commit, Claims& claims) {
  const Commit& next = flight.commits[commit];
  const Rational time = next.takeover();
  claim_no_jump("takeover", commanded(flight, flown_before(flight, commit), time), motion_at(next, time), claims);
}

void prove_goal(const Flight& flight, Claims& claims) {
  if (!flight.reached) return;
  const Rational end = flight.track.end();
  const Point none{0, 0, 0};
  claim_no_jump("goal", commanded(flight, Flown(flight).at(end), end), {flight.world.mission.back(), none, none, none},
                claims);
}

void prove_flown(const Flight& flight, const std::vector<Solid>& solids, Claims& claims) {
  prove_commands(flight, claims);
  prove_margin(flight, claims);
  prove_body(flight, solids, claims);
}

}  // namespace tern_verify
