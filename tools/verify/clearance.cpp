// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "verify/nearest.hpp"
#include "verify/proofs.hpp"

namespace tern_verify {

void prove_clearance(const Subject& subject, Claims& claims) {
  if (subject.solid.empty()) return;
  std::vector<Polygon<3>> curves;
  for (std::size_t s = 0; s < subject.plan.segments.size(); ++s) curves.push_back(subject.world_points(s));
  std::vector<Solid> solids;
  for (const Cells& cells : subject.solid) solids.push_back({box_of(subject.lattice, cells), 0});
  const Nearest nearest = nearest_of(curves, solids);
  Claim claim;
  claim.what = "curve off obstacles";
  claim.unit = "m";
  claim.least = nearest.least - subject.problem.clearance;
  claim.most = nearest.most - subject.problem.clearance;
  // One for the half-space, one for the control point.
  claim.tolerance = subject.tolerance.half_space + subject.tolerance.point;
  claim.place = place_of(subject.plan.segments, nearest.curve, nearest.u);
  claims.push_back(claim);
}

}  // namespace tern_verify
