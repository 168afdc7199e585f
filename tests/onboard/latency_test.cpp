// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tern_onboard/latency.hpp"

#include <gtest/gtest.h>

#include "onboard/onboard_sky.hpp"

namespace {

using tern_onboard::Durations;
using tern_onboard::Latency;
using tern_test::kMs;

TEST(Latency, KeepsTheLastDurationsAndCountsAll) {
  Durations durations;
  EXPECT_EQ(durations.text(), "none");
  for (int k = 1; k <= 5000; ++k) durations.add(k * kMs);
  EXPECT_EQ(durations.text(), "2952.0 / 4959.0 / 5000.0 ms (5000)");  // of 905 .. 5000
}

TEST(Latency, OfAFrameEndsAtTheFirstSetpointAfterThePlanThatSawIt) {
  Latency latency;
  latency.arrived(10 * kMs, 15 * kMs);
  latency.ticked(10 * kMs, 1, false, 20 * kMs);
  latency.sent(25 * kMs);  // its plan is older than the frame
  EXPECT_EQ(latency.ages().to_setpoint, "none");
  latency.ticked(40 * kMs, 2, false, 50 * kMs);
  latency.sent(60 * kMs);
  latency.ticked(40 * kMs, 3, false, 65 * kMs);
  latency.sent(70 * kMs);
  EXPECT_EQ(latency.ages().to_arrival, "5.0 / 5.0 / 5.0 ms (1)");
  EXPECT_EQ(latency.ages().to_map, "10.0 / 10.0 / 10.0 ms (2)");
  EXPECT_EQ(latency.ages().to_setpoint, "30.0 / 30.0 / 50.0 ms (2)");
}

TEST(Latency, SaysNothingOfFramesAtRestAndOfAnotherFlight) {
  Latency latency;
  latency.ticked(10 * kMs, 3, true, 20 * kMs);
  latency.ticked(10 * kMs, 4, false, 900 * kMs);
  latency.ticked(1000 * kMs, 4, false, 1010 * kMs);
  latency.ticked(1000 * kMs, 1, false, 5000 * kMs);
  latency.ticked(1000 * kMs, 2, false, 5005 * kMs);
  latency.sent(5010 * kMs);
  EXPECT_EQ(latency.ages().to_setpoint, "none");
}

}  // namespace
