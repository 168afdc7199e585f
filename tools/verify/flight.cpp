// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "verify/flight.hpp"

#include <algorithm>

#include "verify/json.hpp"
#include "verify/proofs.hpp"

namespace tern_verify {
namespace {

/// Up and down, all flights are slower and gentler (docs/formats.md).
constexpr int kMostClimb = 2;
constexpr int kMostClimbAcceleration = 6;
/// What docs/flight.md allows where a new plan takes over, in m and its derivatives.
const Rational kTakeover[] = {decimal(1, 11), decimal(1, 9), decimal(1, 6), decimal(1, 4)};

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

void add_bounds(int derivative, const Rational& most, const Rational& climb, bool horizontal, Flight& flight) {
  for (int a = 0; a < 3; ++a) {
    for (const int sign : {1, -1}) flight.bounds.push_back({derivative, a, sign, a < 2 ? most : climb});
  }
  if (horizontal) flight.bounds.push_back({derivative, kHorizontal, 1, most});
}

Commit commit_of(const Json& json) {
  Commit commit{number_of(json.at("time_s")), json.at("evades").get<bool>(), json.at("leaves").get<bool>(),
                point_of(json.at("origin")), {}};
  for (const Json& segment : json.at("segments")) commit.segments.push_back(segment_of(segment));
  if (commit.segments.empty()) throw InputError("a commit has no segments");
  return commit;
}

Flight flight_of(const Json& json) {
  if (!json.contains("commits")) throw InputError("it has no 'commits': fly it with 'tern fly --json FILE --commits'");
  const Json& settings = json.at("settings");
  Flight flight;
  flight.solids = solids_of(json.at("true_world"));
  flight.radius = 0;
  for (const char* const part : {"body_radius", "tracking_margin", "pose_margin"}) {
    flight.radius += number_of(settings.at(part));
  }
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

Claim clearance_of(const Flight& flight, const Commit& commit) {
  std::vector<Polygon<3>> curves;
  for (const Segment& segment : commit.segments) {
    curves.push_back(segment.points);
    for (Point& point : curves.back()) point = point + commit.origin;
  }
  const Nearest nearest = nearest_of(curves, flight.solids);
  Claim claim{"curve off the world", "m", nearest.least - flight.radius, nearest.most - flight.radius, 0, ""};
  // What the flight's proof forgives: docs/flight.md.
  claim.tolerance = decimal(4, 9) * std::max<Rational>(1, flight.cell);
  claim.place = place_of(commit.segments, nearest.curve, nearest.u);
  return claim;
}

/// At the end, nothing moves.
void prove_rest(const Commit& commit, Claims& claims) {
  constexpr const char* kUnits[] = {"m", "m/s", "m/s2", "m/s3"};
  const Segment& last = commit.segments.back();
  Polygon<3> curve = last.points;
  for (int k = 1; k < 4; ++k) {
    curve = hodograph(curve, last.duration);
    Rational most = 0;
    for (const Rational& coordinate : curve.back()) most = std::max<Rational>(most, abs(coordinate));
    claims.push_back({"rest, derivative " + std::to_string(k), kUnits[k], -most, -most, joint_tolerance(last, k), ""});
  }
}

Claims claims_of(const Flight& flight, const Commit& commit) {
  Claims claims;
  prove_joints(commit.segments, claims);
  for (std::size_t k = 0; k < claims.size(); ++k) claims[k].tolerance += kTakeover[k];
  prove_rest(commit, claims);
  prove_bounds(commit.segments, flight.bounds, claims);
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
  for (std::size_t c = 0; c < flight.commits.size(); ++c) {
    for (Claim& claim : claims_of(flight, flight.commits[c])) {
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
