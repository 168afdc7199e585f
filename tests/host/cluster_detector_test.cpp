// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Flights that track what their own sensors see move.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "host/flight/simulated_flight.hpp"
#include "host/text_records.hpp"
#include "support/random.hpp"

namespace {

tern_host::ThingTotals flown_with_clusters(const std::string& world, std::vector<std::string> settings) {
  settings.insert(settings.begin(), {"detection_source=clusters,person", "thing_memory=3", "time_limit=20"});
  return tern_host::simulate_flight(tern_host::read_flight_world(world, settings)).things;
}

// Walls are hit with noise all the time; none of them is a track.
TEST(ClusterDetector, TellsOfNothingWhereAllStandsStill) {
  for (const std::string sensor : {"camera", "lidar", "livox"}) {
    const auto totals =
        flown_with_clusters("CW:1", {"things=0", "depth_noise=0.01", "time_limit=8", "sensor=" + sensor});
    EXPECT_GT(totals.tracking.scans, 50u) << sensor;
    EXPECT_EQ(totals.tracking.told, 0u) << sensor;
  }
}

/// The figures of port/tracker/README.md, with room for other seeds.
TEST(ClusterDetector, KnowsWhoWalksInView) {
  tern_host::TrackingFigures sum;
  for (int seed = 1; seed <= tern_test::scaled(6); ++seed) {
    const auto f = flown_with_clusters("CW:10" + std::to_string(seed), {}).tracking;
    sum.in_view += f.in_view;
    sum.missed += f.missed;
    sum.births += f.births;
    sum.late += f.late;
    sum.told += f.told;
    sum.outside += f.outside;
    sum.false_tracks += f.false_tracks;
  }
  EXPECT_GT(sum.births, 0u);
  EXPECT_LT(sum.late, 0.8 * static_cast<double>(sum.births));
  EXPECT_LT(static_cast<double>(sum.missed), 0.4 * static_cast<double>(sum.in_view));
  EXPECT_LT(static_cast<double>(sum.outside), 0.1 * static_cast<double>(sum.told));
  EXPECT_EQ(sum.false_tracks, 0u);
}

TEST(ClusterDetector, AClassMustBeSaid) {
  for (const std::string wrong : {"clusters", "clusters,tree", "truth,person", "nothing"}) {
    EXPECT_THROW(tern_host::read_flight_world("CW:1", {"detection_source=" + wrong}), tern_host::RecordError) << wrong;
  }
  const auto settings = tern_host::read_flight_world("CW:1", {"detection_source=clusters,car"}).settings;
  EXPECT_EQ(settings.cluster_class, tern::TrackClass::kCar);
  EXPECT_EQ(settings.things_seen, 1);
  EXPECT_EQ(tern_host::read_flight_world("CW:1", {"detection_source=truth"}).settings.things_seen, 0);
}

}  // namespace
