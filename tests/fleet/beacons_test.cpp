// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Beacons: which are heard, when they are sent, and what becomes of those that there is no room for.
#include <gtest/gtest.h>

#include <vector>

#include "fleet/fleet_access.hpp"
#include "fleet/range_pair.hpp"

namespace {

using namespace tern_test;
using tern::Heard;

TEST_F(FleetRangePair, BeaconsThatAreOldDamagedOrAhead) {
  begin(100.0);
  advance(1);
  std::uint8_t packet[tern::kFleetBeaconRoom];
  EXPECT_EQ(fleet(1).write(packet, tern::kFleetBeaconRoom - 1), 0) << "nothing is said without the beacon";
  const std::int32_t size = fleet(1).write(packet, tern::kFleetBeaconRoom);
  ASSERT_EQ(size, 48);
  EXPECT_EQ(fleet(0).receive(packet, size, now_ - 1), Heard::kClockAhead);
  EXPECT_EQ(fleet(0).receive(packet, size - 1, now_), Heard::kDamaged);
  EXPECT_EQ(fleet(0).receive(packet, size, now_ + 2 * kSecond), Heard::kOld) << "it tells nothing any more";
  EXPECT_EQ(fleet(0).receive(packet, size, now_), Heard::kNews);
  EXPECT_EQ(fleet(0).receive(packet, size, now_), Heard::kOld);
  packet[20] ^= 1;
  EXPECT_EQ(fleet(0).receive(packet, size, now_), Heard::kDamaged);
}

TEST_F(FleetRangePair, BeaconsThatAreNone) {
  begin(100.0);
  advance(1);
  const std::vector<std::uint8_t> packet = round(1)[0];
  for (const int at : {7, 9, tern::kPacketHeadBytes}) {  // the message's size, this packet's part, the message's kind
    std::vector<std::uint8_t> forged = packet;
    ++forged[static_cast<std::size_t>(at)];
    if (at == tern::kPacketHeadBytes) sign(forged);
    hear(0, {forged});
    EXPECT_EQ(last_, Heard::kDamaged) << at;
  }
}

TEST_F(FleetRangePair, NobodySpeaksOfMembersWithoutABeacon) {
  begin(15.0);
  go_on(2.0);
  announce(1);
  std::uint8_t packet[tern::kFleetBeaconRoom];
  EXPECT_EQ(fleet(1).write(packet, tern::kFleetBeaconRoom - 1), 0);
  EXPECT_EQ(fleet(1).write(packet, tern::kFleetBeaconRoom), 48);
  EXPECT_GT(fleet(1).write(packet, tern::kFleetBeaconRoom), 0);
}

TEST_F(FleetRangePair, VehiclesThatWereLeftOutAreForgottenInTime) {
  begin(100.0);
  std::int64_t now = now_;
  tern::FleetMemory& memory = *tern::memory_of(fleet(0));
  advance(0);
  // More vehicles than there is room for, all the time: first one that comes to 20 m, then all stay beyond 60 m.
  double least = 0.0;
  for (int turn = 0; turn < 40; ++turn, now += kSecond / 10) {
    now_ = now;
    advance(0);
    for (int k = 0; k < tern::kMaxBeacons + 2; ++k) {
      hear(0, {beacon_of(static_cast<std::uint16_t>(10 + k), {turn == 0 ? 20.0 : 60.0, 0, 1}, now)});
    }
    least = tern::gap_to_unkept(memory, now);
    EXPECT_TRUE(turn > 10 || least < 20.0) << turn;
  }
  EXPECT_GT(least, 40.0);
}

}  // namespace
