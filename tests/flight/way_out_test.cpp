// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A vehicle at rest beside which something appears flies away from it first, at the window's face too.
#include <gtest/gtest.h>

#include "support/flown.hpp"

namespace {

using tern_test::FlightSettings;
using tern_test::Flown;
using tern_test::Scene;

TEST(FlightWayOut, LeavesWhatAppearsBesideItAtTheWindowsFace) {
  FlightSettings settings;
  settings.window.z = 8;
  settings.start.z = -0.04;  // the window begins at -0.4, and the vehicle may be 0.35 m from there
  Flown flown(Scene{}, settings);
  ASSERT_EQ(flown.started, tern::Status::kOk);
  flown.frames = false;
  flown.may_touch = true;
  // Voxels from 0.2 m on.
  ASSERT_EQ(flown.owned.map.mark_box({{0.3, -0.1, -0.1}, {0.5, 0.1, 0.1}}), tern::Status::kOk);
  EXPECT_LT(flown.solid_distance(settings.start), 0.21);
  ASSERT_EQ(flown.flight.set_goal({3.0, 0.0, 0.4}), tern::Status::kOk);
  for (int k = 0; k < 1000 && flown.solid_distance(flown.position()) < settings.radius; ++k) {
    ASSERT_NO_FATAL_FAILURE(flown.tick());
  }
  EXPECT_GE(flown.solid_distance(flown.position()), settings.radius);
}

}  // namespace
