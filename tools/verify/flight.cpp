// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "verify/flight.hpp"

#include <algorithm>

#include "verify/fence_room.hpp"
#include "verify/json.hpp"
#include "verify/proofs.hpp"

namespace tern_verify {
namespace {

/// Up and down, all flights are slower and gentler (docs/formats.md).
constexpr int kMostClimb = 2;
constexpr int kMostClimbAcceleration = 6;
/// What docs/flight.md allows where a new plan takes over: metres, and m/s3 of jerk. Between them it names nothing.
const Rational kTakeover[] = {decimal(1, 11), decimal(1, 10), decimal(1, 7), decimal(1, 4)};
constexpr const char* kNames[] = {"position", "velocity", "acceleration", "jerk"};
constexpr const char* kUnits[] = {"m", "m/s", "m/s2", "m/s3"};

Box box_of(const Json& json) {
  return {point_of(json), point_of(json, 3)};
}

/// Beyond each face of the boundary, as thick and wide as the boundary is long.
std::vector<Solid> walls_of(const Box& boundary) {
  Rational size = 1;
  for (std::size_t a = 0; a < 3; ++a) size += boundary.upper[a] - boundary.lower[a];
  std::vector<Solid> walls;
  for (std::size_t a = 0; a < 3; ++a) {
    Box around = boundary;
    for (std::size_t i = 0; i < 3; ++i) {
      around.lower[i] -= size;
      around.upper[i] += size;
    }
    Box below = around;
    below.upper[a] = boundary.lower[a];
    Box above = around;
    above.lower[a] = boundary.upper[a];
    walls.push_back({below, 0});
    walls.push_back({above, 0});
  }
  return walls;
}

Solid cylinder_of(const Json& json) {
  const Rational x = number_of(json.at(0)), y = number_of(json.at(1));
  return {{{x, y, number_of(json.at(2))}, {x, y, number_of(json.at(3))}}, number_of(json.at(4))};
}

std::vector<Solid> solids_of(const Json& world) {
  std::vector<Solid> solids = walls_of(box_of(world.at("boundary")));
  for (const Json& block : world.at("blocks")) solids.push_back({box_of(block), 0});
  for (const Json& cylinder : world.at("cylinders")) solids.push_back(cylinder_of(cylinder));
  return solids;
}

Fence fence_of(const Json& json) {
  Fence fence{json.at("kind").get<std::string>() == "keep_in", {}};
  for (const Json& plane : json.at("half_spaces")) fence.planes.push_back({point_of(plane), number_of(plane.at(3))});
  if (fence.planes.empty()) throw InputError("a fence has no half-spaces");
  return fence;
}

void add_bounds(int derivative, const Rational& most, const Rational& climb, bool horizontal, Flight& flight) {
  for (int a = 0; a < 3; ++a) {
    for (const int sign : {1, -1}) flight.bounds.push_back({derivative, a, sign, a < 2 ? most : climb});
  }
  if (horizontal) flight.bounds.push_back({derivative, kHorizontal, 1, most});
}

Commit commit_of(const Json& json) {
  constexpr long kSecond = 1000000000;
  Commit commit{Rational(json.at("time_ns").get<long>()) / kSecond,
                Rational(json.at("begin_ns").get<long>()) / kSecond,
                json.at("evades").get<bool>(),
                json.at("leaves").get<bool>(),
                point_of(json.at("origin")),
                {}};
  for (const Json& segment : json.at("segments")) commit.segments.push_back(segment_of(segment));
  if (commit.segments.empty()) throw InputError("a commit has no segments");
  return commit;
}

Flight flight_of(const Json& json) {
  if (!json.contains("commits")) throw InputError("it has no 'commits': fly it with 'tern fly --json FILE --commits'");
  const Json& settings = json.at("settings");
  Flight flight;
  flight.boundary = box_of(json.at("true_world").at("boundary"));
  flight.solids = solids_of(json.at("true_world"));
  for (const Json& fence : json.at("true_world").at("fences")) flight.fences.push_back(fence_of(fence));
  flight.radius = 0;
  for (const char* const part : {"body_radius", "tracking_margin", "pose_margin"}) {
    flight.radius += number_of(settings.at(part));
  }
  flight.body = number_of(settings.at("body_radius"));
  flight.tracking_margin = number_of(settings.at("tracking_margin"));
  flight.tracking_error = number_of(json.at("tracking_error").at("max"));
  flight.clearance = number_of(json.at("min_clearance"));
  flight.cell = number_of(settings.at("cell"));
  const Rational speed = number_of(settings.at("v_max"));
  const Rational acceleration = number_of(settings.at("a_max"));
  const Rational jerk = number_of(settings.at("j_max"));
  add_bounds(1, speed, std::min<Rational>(speed, kMostClimb), true, flight);
  add_bounds(2, acceleration, std::min<Rational>(acceleration, kMostClimbAcceleration), true, flight);
  if (jerk > 0) add_bounds(3, jerk, jerk, false, flight);
  for (const Json& commit : json.at("commits")) flight.commits.push_back(commit_of(commit));
  return flight;
}

/// In the world frame.
std::vector<Polygon<3>> curves_of(const Commit& commit) {
  std::vector<Polygon<3>> curves;
  for (const Segment& segment : commit.segments) {
    curves.push_back(segment.points);
    for (Point& point : curves.back()) point = point + commit.origin;
  }
  return curves;
}

/// What the flight's proof forgives: docs/flight.md.
Rational proof_tolerance(const Flight& flight) {
  return decimal(4, 9) * std::max<Rational>(1, flight.cell);
}

Claim clearance_of(const Flight& flight, const Commit& commit) {
  const Nearest nearest = nearest_of(curves_of(commit), flight.solids);
  Claim claim{"curve off the world", "m", nearest.least - flight.radius, nearest.most - flight.radius, 0, ""};
  claim.tolerance = proof_tolerance(flight);
  claim.place = place_of(commit.segments, nearest.curve, nearest.u);
  return claim;
}

void prove_fences(const Flight& flight, const Commit& commit, Claims& claims) {
  const std::vector<Polygon<3>> curves = curves_of(commit);
  for (std::size_t f = 0; f < flight.fences.size(); ++f) {
    const FenceRoom room = fence_room(curves, flight.fences[f], flight.boundary, flight.radius);
    claims.push_back({"fence " + std::to_string(f + 1), "m", room.least, room.most, proof_tolerance(flight),
                      place_of(commit.segments, room.curve, room.u)});
  }
}

/// What the simulator saw at its ticks: that the vehicle kept its margin, which all proofs assume, and touched nothing.
void prove_flown(const Flight& flight, Claims& claims) {
  const Rational left = flight.tracking_margin - flight.tracking_error;
  const Rational room = flight.clearance - flight.body;
  claims.push_back({"flown: tracking error", "m", left, left, decimal(1, 9) * flight.tracking_margin, ""});
  claims.push_back({"flown: body off the world", "m", room, room, 0, ""});
}

/// At the end, nothing moves.
void prove_rest(const Commit& commit, Claims& claims) {
  const Segment& last = commit.segments.back();
  Polygon<3> curve = last.points;
  for (int k = 1; k < 4; ++k) {
    curve = hodograph(curve, last.duration);
    Rational most = 0;
    for (const Rational& coordinate : curve.back()) most = std::max<Rational>(most, abs(coordinate));
    claims.push_back({std::string("rest ") + kNames[k], kUnits[k], -most, -most, joint_tolerance(last, k), ""});
  }
}

/// Position, world frame, to jerk at a time since the flight's beginning; at rest after the end.
Motion motion_at(const Commit& commit, const Rational& time) {
  Rational left = time - commit.begin;
  std::size_t s = 0;
  for (; s + 1 < commit.segments.size() && left > commit.segments[s].duration; ++s) left -= commit.segments[s].duration;
  const Segment& segment = commit.segments[s];
  const Rational u = std::min<Rational>(left / segment.duration, 1);
  Motion motion;
  Polygon<3> curve = segment.points;
  for (std::size_t k = 0; k < motion.size(); ++k) {
    motion[k] = point_at(curve, u);
    curve = hodograph(curve, segment.duration);
  }
  motion[0] = motion[0] + commit.origin;
  return motion;
}

/// A plan goes on as the one before is at that time: where it begins, or if it extends it, where it is committed.
void prove_takeover(const Commit& before, const Commit& after, Claims& claims) {
  const Rational time = std::max(after.begin, after.time);
  const Motion from = motion_at(before, time);
  const Motion to = motion_at(after, time);
  for (std::size_t k = 0; k < from.size(); ++k) {
    Rational jump = 0;
    for (std::size_t a = 0; a < 3; ++a) jump = std::max<Rational>(jump, abs(to[k][a] - from[k][a]));
    claims.push_back({std::string("takeover ") + kNames[k], kUnits[k], -jump, -jump, kTakeover[k], ""});
  }
}

Claims claims_of(const Flight& flight, const Commit& commit) {
  Claims claims;
  prove_joints(commit.segments, claims);
  // A plan that goes on along the one before is cut there, and its points are computed anew.
  if (!claims.empty()) claims.front().tolerance += kTakeover[0];
  prove_rest(commit, claims);
  prove_bounds(commit.segments, flight.bounds, claims);
  prove_fences(flight, commit, claims);
  if (!commit.evades && !commit.leaves) claims.push_back(clearance_of(flight, commit));
  return claims;
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

Claims prove(const Flight& flight) {
  Claims tightest;
  if (flight.commits.empty()) return tightest;
  prove_flown(flight, tightest);
  for (std::size_t c = 0; c < flight.commits.size(); ++c) {
    Claims claims = claims_of(flight, flight.commits[c]);
    // A brake may take the place of a plan that has not begun.
    const bool follows = c > 0 && !flight.commits[c].evades && !flight.commits[c - 1].evades;
    if (follows) prove_takeover(flight.commits[c - 1], flight.commits[c], claims);
    for (Claim& claim : claims) {
      claim.place = "commit " + std::to_string(c + 1) + (claim.place.empty() ? "" : ", " + claim.place);
      const auto same = [&](const Claim& other) { return other.what == claim.what; };
      const auto found = std::find_if(tightest.begin(), tightest.end(), same);
      if (found == tightest.end()) {
        tightest.push_back(claim);
      } else if (claim.least + claim.tolerance < found->least + found->tolerance) {
        *found = claim;
      }
    }
  }
  return tightest;
}

}  // namespace tern_verify
