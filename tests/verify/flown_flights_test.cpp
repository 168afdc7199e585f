// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Flights of the simulator in which plans are withdrawn while they wait for their takeover, and along a chain of
// keep-ins for a while.
#include <gtest/gtest.h>

#include <fstream>

#include "host/flight/flight_replay.hpp"
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

/// Two keep-ins that overlap in x from 4 to 6 m, and from 5 to 12 s; the second one may begin at another time.
std::string chain(const std::string& name, double begin) {
  std::string path = testing::TempDir() + "tern_" + name + ".txt";
  std::ofstream(path) << "boundary -3 -5 0 13 5 4\nstart 0 0 1.5\ngoal 10 0 1.5\ntime_limit 40\n"
                      << "keepin -3 -5 -1 6 5 5 during -1 12\nkeepin 4 -5 -1 13 5 5 during " << begin << " 60\n";
  return path;
}

/// What is not proven, in words.
std::string gaps_of(const Flight& flight) {
  std::string names;
  for (const Claim& claim : prove(flight)) {
    if (claim.verdict() != Verdict::kProven) names += claim.what + ";";
  }
  return names;
}

TEST(FlownFlights, AlongAChainAreProvenAndFlownAgainToTheSameBits) {
  const tern_host::FlightWorld world = tern_host::read_flight_world(chain("chain", 5.0), {});
  std::string record;
  const tern_host::FlightResult flown = tern_host::simulate_flight(world, {}, &record);
  EXPECT_EQ(flown.status, "reached") << flown.reason;
  const tern_host::FlightReplay replayed = tern_host::replay_flight(record);
  EXPECT_EQ(replayed.difference, "");
  EXPECT_GT(replayed.ticks, 100);
  const std::string log = tern_host::flight_json(world, flown, true);
  const Flight flight = parse_flight(log, "chain");
  EXPECT_EQ(gaps_of(flight), "");
  // The same plans would leave the first keep-in before a second one that begins when the first one ends.
  Flight spoiled = flight;
  spoiled.world =
      parse_flight(tern_host::flight_json(tern_host::read_flight_world(chain("late", 12.0), {}), flown, true), "late")
          .world;
  EXPECT_EQ(gaps_of(spoiled), "keep-ins for a while;");
}

}  // namespace
}  // namespace tern_verify
