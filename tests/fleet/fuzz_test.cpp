// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A Fleet that hears altered packets, also such whose checksums are right: it answers each, and goes on.
#include <gtest/gtest.h>

#include <cstring>
#include <memory>
#include <vector>

#include "fleet/packets.hpp"
#include "fleet/plans.hpp"
#include "tern/fleet.hpp"

namespace {

using namespace tern_test;

tern::FleetSpec vague_spec(std::uint16_t id, bool by_range) {
  tern::FleetSpec spec;
  spec.id = id;
  spec.incarnation = 1;
  spec.radius = 0.5;
  spec.clock_error = 1000;
  spec.tick = kSecond / 10;
  if (!by_range) return spec;
  spec.range.join = 20.0;
  spec.range.heard = 200.0;
  spec.range.speed = 5.0;
  spec.range.within = 5;
  spec.range.lease = 60 * kSecond;
  return spec;
}

/// Changes some bytes; half of the time of the message, with the checksum that it then has.
void alter(Random& random, std::uint8_t* packet, std::int32_t size) {
  const bool is_forged = random.chance(0.5);
  const std::int32_t first = is_forged ? tern::kPacketHeadBytes : 0;
  for (int k = random.integer(1, 4); k > 0; --k) {
    packet[random.integer(first, size - 1)] = static_cast<std::uint8_t>(random.integer(0, 255));
  }
  if (!is_forged) return;
  const std::uint32_t crc = tern::crc32(packet + tern::kPacketHeadBytes, size - tern::kPacketHeadBytes);
  for (int k = 0; k < 4; ++k) packet[3 + k] = static_cast<std::uint8_t>(crc >> (8 * k));
}

/// Vehicle 1 hears what 2 says, often altered.
void hear_altered_packets(bool by_range) {
  Random random(1);
  const auto first = std::make_unique<tern::Fleet>();
  const auto second = std::make_unique<tern::Fleet>();
  int news = 0;
  for (int turn = 0; turn < scaled(300); ++turn) {
    ASSERT_EQ(first->begin(vague_spec(1, by_range), resting({0, 0, 1}, 0), 0), tern::Status::kOk);
    ASSERT_EQ(second->begin(vague_spec(2, by_range), resting({10, 0, 1}, 0), 0), tern::Status::kOk);
    first->add(2, 0);
    second->add(1, 0);
    for (std::int64_t now = 1; now < 40; ++now) {
      std::uint8_t packet[2000];
      while (const std::int32_t size = second->write(packet, 2000)) {
        if (random.chance(0.7)) alter(random, packet, size);
        news += first->receive(packet, random.chance(0.1) ? random.integer(0, size) : size, now) == tern::Heard::kNews;
      }
      while (const std::int32_t size = first->write(packet, 2000)) second->receive(packet, size, now);
      second->announce(straight({10, 0, 1}, {10, 5, 1}, now + 3, 4.0), now + 3, now);
      for (tern::Fleet* fleet : {first.get(), second.get()}) {
        tern::Work work(2000);
        fleet->advance(now, work);
      }
      tern::Track tracks[4];
      std::vector<tern::TrackPiece> pieces(256);
      std::int32_t count = 0;
      ASSERT_EQ(first->traffic(now, tracks, 4, pieces.data(), 256, count), tern::Status::kOk);
    }
    // Nobody but its own vehicle makes it fly anything else.
    ASSERT_EQ(first->flown()->segments[0].duration, 1.0);
  }
  EXPECT_GT(news, 0);
}

TEST(FleetFuzz, AlteredPacketsDoNoHarm) {
  hear_altered_packets(false);
}

TEST(FleetFuzz, AlteredPacketsDoNoHarmByRange) {
  hear_altered_packets(true);
}

}  // namespace
