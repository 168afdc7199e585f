// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Logs of flights, and what in them must fit together.
#include <algorithm>

#include "verify/emptiness.hpp"
#include "verify/fence_records.hpp"
#include "verify/flight.hpp"

namespace tern_verify {
namespace {

constexpr long kSecond = 1000000000;

Box box_of(const Json& json) {
  return {point_of(json), point_of(json, 3)};
}

Solid cylinder_of(const Json& json) {
  const Rational x = number_of(json.at(0)), y = number_of(json.at(1));
  return {{{x, y, number_of(json.at(2))}, {x, y, number_of(json.at(3))}}, number_of(json.at(4))};
}

World world_of(const Json& json) {
  const Json& truth = json.at("true_world");
  const Json& settings = json.at("settings");
  World world;
  world.boundary = box_of(truth.at("boundary"));
  for (const Json& block : truth.at("blocks")) world.blocks.push_back(box_of(block));
  for (const Json& cylinder : truth.at("cylinders")) world.cylinders.push_back(cylinder_of(cylinder));
  for (const Json& fence : truth.at("fences")) world.fences.push_back(fence_of(fence));
  const std::optional<std::size_t> empty = empty_fence(world.fences, world.boundary);
  if (empty) throw InputError("fence " + std::to_string(*empty + 1) + ": " + empty_text(world.fences[*empty]));
  world.start = point_of(json.at("start"));
  for (const Json& point : json.at("mission")) world.mission.push_back(point_of(point.at("position")));
  if (world.mission.empty() || world.mission.back() != point_of(json.at("goal"))) {
    throw InputError("its mission does not end at its goal");
  }
  for (const std::string& key : kWorldSettings) world.settings[key] = number_of(settings.at(key));
  world.tracking = settings.at("tracking").get<std::string>();
  return world;
}

Rational seconds_of(const Json& json, const char* key) {
  return Rational(json.at(key).get<long>()) / kSecond;
}

Commit commit_of(const Json& json) {
  Commit commit{seconds_of(json, "time_ns"), seconds_of(json, "begin_ns"), {}, point_of(json.at("origin")), {}};
  if (json.contains("withdrawn_ns")) commit.withdrawn = seconds_of(json, "withdrawn_ns");
  for (const Json& segment : json.at("segments")) commit.segments.push_back(segment_of(segment));
  if (commit.segments.empty()) throw InputError("a commit has no segments");
  return commit;
}

std::vector<Point> points_of(const Json& json) {
  std::vector<Point> points;
  for (const Json& point : json) points.push_back(point_of(point));
  return points;
}

/// One point of each kind for each tick, until the time that the flight took.
Track track_of(const Json& json) {
  const Json& all = json.at("track");
  Track track{seconds_of(all, "tick_ns"), points_of(all.at("commanded")), points_of(all.at("believed")),
              points_of(all.at("true"))};
  const std::size_t ticks = track.commanded.size();
  if (ticks == 0 || track.believed.size() != ticks || track.real.size() != ticks) {
    throw InputError("its track does not have a point of each kind for each tick");
  }
  const Rational half = decimal(5, 10);  // of a nanosecond
  const Rational rate = number_of(json.at("settings").at("tick_hz"));
  if (track.tick <= 0 || abs(1 / rate - track.tick) > half) throw InputError("the ticks of its track are not tick_hz");
  if (abs(number_of(json.at("time_s")) - track.end()) > half) throw InputError("its track does not end at time_s");
  return track;
}

/// A commit comes after the one before has taken over, or was withdrawn.
void check_order(const std::vector<Commit>& commits, const Rational& end) {
  for (std::size_t c = 0; c < commits.size(); ++c) {
    const Commit& commit = commits[c];
    const auto refuse = [&](const char* why) { throw InputError("commit " + std::to_string(c + 1) + why); };
    if (commit.time < 0 || commit.time > end) refuse(" was committed before or after the flight");
    if (commit.withdrawn) {
      const bool waited = *commit.withdrawn > commit.time && *commit.withdrawn < commit.begin;
      if (!waited || *commit.withdrawn > end) refuse(" was withdrawn while it did not wait");
    }
    if (c == 0) continue;
    const Commit& before = commits[c - 1];
    if (commit.time <= before.time) refuse(" was not committed after the one before");
    const bool is_free = before.withdrawn ? *before.withdrawn <= commit.time : before.takeover() <= commit.time;
    if (!is_free) refuse(" was committed while the one before waited");
  }
}

Flight flight_of(const Json& json) {
  if (!json.contains("commits")) throw InputError("it has no 'commits': fly it with 'tern fly --json FILE --commits'");
  if (json.contains("column") || json.contains("land")) {
    throw InputError(
        "it begins or ends on the ground ('column', 'land'), where no radius is kept: nothing is proven of it");
  }
  if (!json.contains("track")) throw InputError("it has no 'track': fly it again with this version's 'tern fly'");
  Flight flight;
  flight.world = world_of(json);
  flight.world_name = json.at("world").get<std::string>();
  flight.is_world_given = false;
  flight.reached = json.at("status").get<std::string>() == "reached";
  flight.tracking_error = number_of(json.at("tracking_error").at("max"));
  flight.clearance = number_of(json.at("min_clearance"));
  for (const Json& commit : json.at("commits")) flight.commits.push_back(commit_of(commit));
  const auto committed = json.at("plans").at("committed").get<std::size_t>();
  if (flight.commits.size() != committed) {
    throw InputError("it has " + std::to_string(flight.commits.size()) + " of the " + std::to_string(committed) +
                     " commits that its 'plans' count");
  }
  flight.track = track_of(json);
  check_order(flight.commits, flight.track.end());
  return flight;
}

}  // namespace

Flight parse_flight(const std::string& text, const std::string& name) {
  Flight flight = read_json(text, name, "log of a flight", flight_of);
  flight.name = name;
  return flight;
}

bool is_flight(const std::string& text) {
  const Json json = Json::parse(text, nullptr, false);
  return json.is_object() && json.value("format", "") == "tern-flight/1";
}

void compare(const World& world, const std::string& name, Flight& flight) {
  const std::string what = difference(flight.world, world);
  if (!what.empty()) {
    throw InputError(flight.name + ": it differs from " + name + " in '" + what +
                     "'; name the settings that it was flown with as --set KEY=VALUE");
  }
  flight.is_world_given = true;
}

std::vector<std::string> assumed_of(const Flight& flight) {
  if (flight.is_world_given) return {};
  return {"world, start, goal, body, margins and limits of the log itself; to compare them, name its world after it: " +
          flight.world_name};
}

}  // namespace tern_verify
