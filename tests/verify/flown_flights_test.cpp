// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Flights of the simulator in which plans are withdrawn while they wait for their takeover.
#include <gtest/gtest.h>

#include "host/flight/simulated_flight.hpp"
#include "verify/course.hpp"

namespace tern_verify {
namespace {

/// A flight that is cut off after some seconds.
struct Cut {
  const char* world;
  std::vector<std::string> settings;
};

/// In the first two, a new plan takes over from what was flown before a withdrawn one; in the others, brakes do.
const std::vector<Cut> kFlights = {
    {"S20:1", {"depth_noise=0.01", "outliers=0.01", "time_limit=19.6"}},
    {"O:2", {"depth_noise=0.01", "outliers=0.01", "time_limit=33"}},
    {"P25:1", {"depth_noise=0.01", "outliers=0.001", "speckle_filter=0", "hits=1", "support=0", "time_limit=4"}},
    {"B:1", {"depth_noise=0.01", "outliers=0.001", "speckle_filter=0", "hits=1", "support=0", "time_limit=4"}}};

TEST(FlownFlights, GoOnAlongWhatWasNotWithdrawn) {
  std::size_t withdrawn = 0;
  for (const Cut& cut : kFlights) {
    const tern_host::FlightWorld world = tern_host::read_flight_world(cut.world, cut.settings);
    const std::string log = tern_host::flight_json(world, tern_host::simulate_flight(world), true);
    const Flight flight = parse_flight(log, cut.world);
    Claims claims;
    prove_flown(flight, solids_of(flight.world), claims);
    for (std::size_t c = 0; c < flight.commits.size(); ++c) {
      withdrawn += flight.commits[c].withdrawn ? 1 : 0;
      prove_takeover(flight, c, claims);
    }
    for (const Claim& claim : claims) {
      EXPECT_EQ(claim.verdict(), Verdict::kProven) << cut.world << ": " << line_of(claim);
    }
  }
  EXPECT_GE(withdrawn, 3u) << "these flights no longer show what they are here for";
}

}  // namespace
}  // namespace tern_verify
