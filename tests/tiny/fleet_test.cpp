// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fleets that are larger than there is room for.
#include "tern/fleet.hpp"

#include <gtest/gtest.h>

namespace {

TEST(FleetFull, AsManyNeighboursAsThereIsRoomFor) {
  tern::FleetSpec spec;
  spec.id = 100;
  spec.incarnation = 1;
  spec.radius = 0.5;
  spec.tick = 1;
  tern::Trajectory rest{};
  rest.count = 1;
  rest.segments[0].duration = 1.0;
  tern::Fleet fleet;
  ASSERT_EQ(fleet.begin(spec, rest, 0), tern::Status::kOk);
  for (std::uint16_t id = 1; id <= tern::kMaxNeighbours; ++id) ASSERT_EQ(fleet.add(id, 0), tern::Status::kOk);
  EXPECT_EQ(fleet.add(99, 0), tern::Status::kNeighboursFull);
  EXPECT_EQ(fleet.add(1, 0), tern::Status::kOk) << "it is a member already";
  EXPECT_EQ(fleet.neighbours(), tern::kMaxNeighbours);
}

}  // namespace
