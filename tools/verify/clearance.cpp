// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "verify/nearest.hpp"
#include "verify/proofs.hpp"

namespace tern_verify {

void prove_clearance(const Subject& subject, Claims& claims) {
  if (subject.solid.empty()) return;
  std::vector<Solid> solids;
  for (const Cells& cells : subject.solid) solids.push_back({box_of(subject.lattice, cells), 0});
  const Nearest nearest = nearest_of(subject.curves(), solids);
  Claim claim;
  claim.what = "curve off obstacles";
  claim.unit = "m";
  claim.least = nearest.least - subject.problem.clearance;
  claim.most = nearest.most - subject.problem.clearance;
  // The planner takes one for where it puts a plane, one for how far a control point may be beyond it.
  claim.tolerance = subject.tolerance.half_space + subject.tolerance.point;
  claim.place = place_of(subject.plan.segments, nearest.curve, nearest.u);
  claims.push_back(claim);
}

}  // namespace tern_verify
