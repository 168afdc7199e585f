// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "verify/flight.hpp"

#include <algorithm>

#include "verify/course.hpp"
#include "verify/fence_records.hpp"
#include "verify/fences.hpp"
#include "verify/proofs.hpp"

namespace tern_verify {
namespace {

/// Where a plan goes on along the one before, it is cut, and its points are computed anew: metres.
const Rational kCut = decimal(1, 11);

/// What all commits of a flight are held against.
struct Demands {
  explicit Demands(const World& world)
      : solids(solids_of(world)),
        bounds(bounds_of(world)),
        radius(world.setting("body_radius") + world.setting("pose_margin") + world.setting("tracking_margin")),
        tolerance(decimal(4, 9) * std::max<Rational>(1, world.setting("cell"))),
        fences(world.fences) {
    keep_distance(radius, fences);
  }

  std::vector<Solid> solids;
  std::vector<Bound> bounds;
  Rational radius;     ///< that curves keep
  Rational tolerance;  ///< that the flight's proof grants them (docs/flight.md)
  std::vector<Fence> fences;
};

/// In the world frame.
std::vector<Polygon<3>> curves_of(const Commit& commit) {
  std::vector<Polygon<3>> curves;
  for (const Segment& segment : commit.segments) {
    curves.push_back(segment.points);
    for (Point& point : curves.back()) point = point + commit.origin;
  }
  return curves;
}

void prove_clearance(const Demands& demands, const Commit& commit, Claims& claims) {
  const Nearest nearest = nearest_of(curves_of(commit), demands.solids);
  claims.push_back({"curve off the world", "m", nearest.least - demands.radius, nearest.most - demands.radius,
                    demands.tolerance, place_of(commit.segments, nearest.curve, nearest.u)});
}

/// Those for a while, on the flight's clock, up to where the commit rests.
void prove_fences(const Box& boundary, const Demands& demands, const Commit& commit, Claims& claims) {
  const std::vector<Polygon<3>> curves = curves_of(commit);
  TimedWay way{{}, commit.begin, 0, 0};
  for (std::size_t s = 0; s < curves.size(); ++s) way.curves.push_back({curves[s], commit.segments[s].duration});
  prove_windows(way, {demands.fences, boundary, commit.begin, demands.tolerance}, claims);
  for (std::size_t f = 0; f < demands.fences.size(); ++f) {
    if (demands.fences[f].window) continue;
    const FenceRoom room = fence_room(curves, demands.fences[f], boundary);
    claims.push_back({title_of(demands.fences, f), "m", room.least, room.most, demands.tolerance,
                      place_of(commit.segments, room.curve, room.u)});
  }
}

/// At the end, nothing moves.
void prove_rest(const Commit& commit, Claims& claims) {
  const Segment& last = commit.segments.back();
  Polygon<3> curve = last.points;
  for (int k = 1; k < 4; ++k) {
    curve = hodograph(curve, last.duration);
    Rational most = 0;
    for (const Rational& coordinate : curve.back()) most = std::max<Rational>(most, abs(coordinate));
    claims.push_back(
        {std::string("rest ") + kDerivativeNames[k], kUnits[k], -most, -most, joint_tolerance(last, k), ""});
  }
}

Claims claims_of(const Flight& flight, const Demands& demands, std::size_t number) {
  const Commit& commit = flight.commits[number];
  Claims claims;
  prove_joints(commit.segments, claims);
  if (!claims.empty()) claims.front().tolerance += kCut;
  prove_rest(commit, claims);
  prove_bounds(commit.segments, demands.bounds, claims);
  prove_turns(commit.segments, demands.bounds, claims);
  prove_fences(flight.world.boundary, demands, commit, claims);
  prove_clearance(demands, commit, claims);
  prove_takeover(flight, number, claims);
  return claims;
}

/// Of two claims of one kind, the one with less room stays.
void add_tightest(const Claim& claim, Claims& tightest) {
  const auto same = [&](const Claim& other) { return other.what == claim.what; };
  const auto found = std::find_if(tightest.begin(), tightest.end(), same);
  if (found == tightest.end()) {
    tightest.push_back(claim);
  } else if (claim.least + claim.tolerance < found->least + found->tolerance) {
    *found = claim;
  }
}

}  // namespace

Claims prove(const Flight& flight) {
  Claims tightest;
  if (flight.commits.empty()) return tightest;
  const Demands demands(flight.world);
  prove_flown(flight, demands.solids, tightest);
  for (std::size_t c = 0; c < flight.commits.size(); ++c) {
    for (Claim& claim : claims_of(flight, demands, c)) {
      claim.place = "commit " + std::to_string(c + 1) + (claim.place.empty() ? "" : ", " + claim.place);
      add_tightest(claim, tightest);
    }
  }
  prove_goal(flight, tightest);
  return tightest;
}

}  // namespace tern_verify
