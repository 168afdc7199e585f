// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "verify/proofs.hpp"

namespace tern_verify {
namespace {

const Rational kGranted = decimal(2, 9);  ///< m: what docs/fences.md grants a plan

}  // namespace

Subject::Subject(const Problem& asked, const Plan& claimed)
    : problem(asked),
      plan(claimed),
      lattice(lattice_of(asked)),
      solid(solid_cells(asked, lattice)),
      tolerance(tolerance_of(asked, lattice, claimed)) {}

std::vector<Polygon<3>> Subject::curves() const {
  std::vector<Polygon<3>> curves;
  for (const Segment& segment : plan.segments) {
    curves.push_back(segment.points);
    for (Point& point : curves.back()) point = point + plan.origin;
  }
  return curves;
}

std::string place_of(const std::vector<Segment>& segments, std::size_t segment, const Rational& u) {
  Rational t = u * segments[segment].duration;
  for (std::size_t s = 0; s < segment; ++s) t += segments[s].duration;
  return "segment " + std::to_string(segment) + ", t = " + text_below(t) + " s";
}

Claims prove(const Problem& problem, const Plan& plan) {
  const Subject subject(problem, plan);
  Claims claims;
  prove_joints(plan.segments, claims);
  prove_ends(subject, claims);
  prove_vias(subject, claims);
  prove_boundary(subject, claims);
  prove_fences(subject, claims);
  prove_windows(way_of(subject), {problem.fences, problem.boundary, problem.start_time, kGranted}, claims);
  prove_clearance(subject, claims);
  prove_tracks(subject, claims);
  prove_bounds(plan.segments, problem.bounds, claims);
  prove_turns(plan.segments, problem.bounds, claims);
  return claims;
}

}  // namespace tern_verify
