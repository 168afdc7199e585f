// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fleets through C.
#include <gtest/gtest.h>

#include <memory>

#include "fleet/plans.hpp"
#include "tern/tern_fleet.h"

namespace {

using tern::Status;
using tern_test::resting;
using tern_test::straight;

constexpr auto kInvalid = static_cast<std::uint8_t>(Status::kInvalidArgument);

tern_fleet_spec spec_in_c(std::uint16_t id) {
  tern_fleet_spec spec{};
  spec.id = id;
  spec.incarnation = 1;
  spec.radius = 0.5;
  spec.tick = 100'000'000;
  return spec;
}

TEST(FleetC, TheSameThroughC) {
  const auto a = std::make_unique<tern_fleet>();
  const auto b = std::make_unique<tern_fleet>();
  const tern_trajectory rest = resting({0, 0, 1}, 0);
  const tern_trajectory away = resting({10, 0, 1}, 0);
  const tern_fleet_spec of_a = spec_in_c(1);
  const tern_fleet_spec of_b = spec_in_c(2);
  EXPECT_EQ(tern_fleet_add(a.get(), 2, 0), kInvalid);
  ASSERT_EQ(tern_fleet_begin(a.get(), &of_a, &rest, 0), 0);
  ASSERT_EQ(tern_fleet_begin(b.get(), &of_b, &away, 0), 0);
  ASSERT_EQ(tern_fleet_add(a.get(), 2, 0), 0);
  ASSERT_EQ(tern_fleet_add(b.get(), 1, 0), 0);
  for (int round = 0; round < 2; ++round) {
    std::uint8_t packet[1400];
    while (const std::int32_t size = tern_fleet_write(a.get(), packet, 1400))
      tern_fleet_receive(b.get(), packet, size, 1);
    while (const std::int32_t size = tern_fleet_write(b.get(), packet, 1400))
      tern_fleet_receive(a.get(), packet, size, 1);
  }
  const tern_trajectory plan = straight({0, 0, 1}, {0, 5, 1}, 10, 4.0);
  ASSERT_EQ(tern_fleet_announce(a.get(), &plan, 10, 5), 0);
  EXPECT_NE(tern_fleet_announced(a.get()), nullptr);
  tern_fleet_advance(a.get(), 6, 10000);
  tern_fleet_report report{};
  tern_fleet_get_report(a.get(), &report);
  EXPECT_TRUE(report.cleared);
  tern_fleet_advance(a.get(), 10, 10000);
  EXPECT_EQ(tern_fleet_flown(a.get())->segments[0].duration, 4.0);
  tern_neighbour neighbour{};
  tern_fleet_neighbour(a.get(), 0, &neighbour);
  EXPECT_EQ(neighbour.id, 2);
  EXPECT_EQ(tern_fleet_neighbours(a.get()), 1);
  tern_track tracks[2];
  tern_track_piece pieces[4];
  std::int32_t count = 0;
  EXPECT_EQ(tern_fleet_traffic(a.get(), 10, tracks, 2, pieces, 4, &count), 0);
  EXPECT_EQ(count, 1);
  EXPECT_EQ(tracks[0].kind, neighbour.flies);
  EXPECT_EQ(neighbour.may_fly, 0u);
  EXPECT_EQ(tern_fleet_traffic_of(a.get(), 0, 10, tracks, 2, pieces, 4, &count), 0);
  EXPECT_EQ(count, 1);
  EXPECT_EQ(tern_fleet_traffic_of(a.get(), 1, 10, tracks, 2, pieces, 4, &count), kInvalid);
  EXPECT_EQ(tern_fleet_traffic_of(a.get(), 0, 10, nullptr, 2, pieces, 4, &count), kInvalid);
  EXPECT_EQ(tern_fleet_traffic(a.get(), 10, nullptr, 2, pieces, 4, &count), kInvalid);
  EXPECT_EQ(tern_fleet_traffic(a.get(), 10, nullptr, -1, pieces, 4, &count),
            static_cast<std::uint8_t>(tern::Status::kTracksFull));
  tern_fleet_withdraw(a.get(), 11);
  tern_fleet_leave(a.get(), 11);
  EXPECT_EQ(tern_fleet_announce(a.get(), &plan, 20, 12), kInvalid);
  EXPECT_EQ(tern_fleet_remove(a.get(), 2, 12), 0);
}

TEST(FleetC, NullAndUnbegun) {
  const tern_fleet_spec spec = spec_in_c(1);
  const tern_trajectory rest = resting({}, 0);
  const auto fleet = std::make_unique<tern_fleet>();
  std::int32_t count = 0;
  EXPECT_EQ(tern_fleet_begin(nullptr, &spec, &rest, 0), kInvalid);
  EXPECT_EQ(tern_fleet_begin(fleet.get(), nullptr, &rest, 0), kInvalid);
  EXPECT_EQ(tern_fleet_begin(fleet.get(), &spec, nullptr, 0), kInvalid);
  EXPECT_EQ(tern_fleet_remove(nullptr, 1, 0), kInvalid);
  EXPECT_EQ(tern_fleet_announce(fleet.get(), &rest, 2, 1), kInvalid);
  EXPECT_EQ(tern_fleet_receive(fleet.get(), nullptr, 9, 1), TERN_HEARD_DAMAGED);
  EXPECT_EQ(tern_fleet_write(fleet.get(), nullptr, 9), 0);
  EXPECT_EQ(tern_fleet_flown(fleet.get()), nullptr);
  EXPECT_EQ(tern_fleet_announced(nullptr), nullptr);
  EXPECT_EQ(tern_fleet_neighbours(nullptr), 0);
  EXPECT_EQ(tern_fleet_traffic(fleet.get(), 0, nullptr, 0, nullptr, 0, &count), kInvalid);
  tern_fleet_withdraw(nullptr, 0);
  tern_fleet_leave(nullptr, 0);
  tern_fleet_advance(nullptr, 0, 1);
  tern_fleet_report report{};
  tern_fleet_get_report(nullptr, &report);
  EXPECT_EQ(report.announcement, tern::Announcement::kNone);
  tern_fleet_neighbour(nullptr, 0, nullptr);
}

}  // namespace
