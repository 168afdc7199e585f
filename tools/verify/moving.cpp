// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "verify/proofs.hpp"

namespace tern_verify {

TimedWay way_of(const Subject& subject) {
  const Problem& problem = subject.problem;
  TimedWay way{{}, problem.start_time, problem.rest_clear, problem.clearance};
  const std::vector<Polygon<3>> curves = subject.curves();
  for (std::size_t s = 0; s < curves.size(); ++s) way.curves.push_back({curves[s], subject.plan.segments[s].duration});
  return way;
}

void prove_tracks(const Subject& subject, Claims& claims) {
  const Problem& problem = subject.problem;
  const TimedWay way = way_of(subject);
  for (const Thing& thing : problem.things) {
    Claim claim;
    claim.what = "track " + thing.name;
    claim.unit = "m";
    claim.tolerance = decimal(2, 9);
    const RoomInTime room = room_beside(way, thing, -claim.tolerance);
    if (!room.noted) continue;
    claim.least = room.least;
    claim.most = room.most;
    claim.place = "t = " + text_below(room.when) + " s" + (room.leaves ? ", which the plan leaves" : "");
    claims.push_back(claim);
  }
}

}  // namespace tern_verify
