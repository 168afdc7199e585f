// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Messages in packets: sizes, any order, repeated, cut anew, mixed with those of another message, altered.
#include "fleet/packets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <vector>

#include "fleet/state_bytes.hpp"
#include "support/random.hpp"

namespace {

using tern_test::Random;
using tern_test::scaled;
using Bytes = std::vector<std::uint8_t>;
using Assembly = tern::Assembly<1024>;

Bytes random_message(Random& random, int size) {
  Bytes message(static_cast<std::size_t>(size));
  for (std::uint8_t& byte : message) byte = static_cast<std::uint8_t>(random.next());
  return message;
}

std::vector<Bytes> packets_of(const Bytes& message, int room) {
  std::vector<Bytes> packets;
  const auto size = static_cast<std::int32_t>(message.size());
  for (std::int32_t first = 0; first < tern::parts_of(size);) {
    Bytes packet(static_cast<std::size_t>(room));
    const std::int32_t used =
        tern::write_packet(message.data(), size, tern::crc32(message.data(), size), 9, packet.data(), room, first);
    packet.resize(static_cast<std::size_t>(used));
    packets.push_back(packet);
  }
  return packets;
}

bool take(const Bytes& packet, Assembly& assembly) {
  tern::PacketHead head{};
  const auto size = static_cast<std::int32_t>(packet.size());
  if (!tern::read_packet(packet.data(), size, head) || head.size > 1024) return false;
  if (!assembly.is_of(head)) assembly.open(head);
  assembly.take(head, packet.data(), size);
  return true;
}

bool holds(const Assembly& assembly, const Bytes& message) {
  return assembly.is_complete() && assembly.size == static_cast<std::int32_t>(message.size()) &&
         std::equal(message.begin(), message.end(), assembly.bytes);
}

TEST(FleetPackets, ChecksumIsTheUsualOne) {
  EXPECT_EQ(tern::crc32(reinterpret_cast<const std::uint8_t*>("123456789"), 9), 0xCBF43926u);
  EXPECT_EQ(tern::crc32(nullptr, 0), 0u);
}

// What docs/fleet.md says of a plan of ten segments.
TEST(FleetPackets, NumbersOfPackets) {
  Random random(1);
  const Bytes message = random_message(random, 560);
  EXPECT_EQ(packets_of(message, 27).size(), 35u);
  EXPECT_EQ(packets_of(message, 128).size(), 5u);
  EXPECT_EQ(packets_of(message, 1400).size(), 1u);
}

TEST(FleetPackets, AnyOrderRepeatedAndCutAnew) {
  Random random(2);
  for (int turn = 0; turn < scaled(2000); ++turn) {
    const Bytes message = random_message(random, random.integer(1, 1024));
    Assembly assembly{};
    for (int round = 0; round < 60 && !assembly.is_complete(); ++round) {
      std::vector<Bytes> packets = packets_of(message, random.integer(tern::kLeastPacketBytes, 200));
      for (std::size_t k = packets.size(); k > 1; --k) std::swap(packets[k - 1], packets[random.next() % k]);
      for (const Bytes& packet : packets) {
        if (random.chance(0.4)) continue;
        ASSERT_TRUE(take(packet, assembly));
        ASSERT_TRUE(random.chance(0.8) || take(packet, assembly));
      }
    }
    ASSERT_TRUE(holds(assembly, message)) << "turn " << turn;
  }
}

TEST(FleetPackets, NeverMixesMessages) {
  Random random(3);
  for (int turn = 0; turn < scaled(2000); ++turn) {
    const Bytes a = random_message(random, random.integer(20, 300));
    Bytes b = a;
    b[random.next() % b.size()] ^= 1;
    std::vector<Bytes> packets = packets_of(a, 27);
    for (const Bytes& packet : packets_of(b, 27)) packets.push_back(packet);
    Assembly assembly{};
    for (int k = 0; k < 200; ++k) {
      ASSERT_TRUE(take(packets[random.next() % packets.size()], assembly));
      ASSERT_TRUE(!assembly.is_complete() || holds(assembly, a) || holds(assembly, b));
    }
  }
}

TEST(FleetPackets, AlteredBytesGiveNoMessage) {
  Random random(4);
  for (int turn = 0; turn < scaled(5000); ++turn) {
    const Bytes message = random_message(random, random.integer(1, 200));
    std::vector<Bytes> packets = packets_of(message, 64);
    Bytes& packet = packets[random.next() % packets.size()];
    packet[random.next() % packet.size()] ^= static_cast<std::uint8_t>(1u << (random.next() % 8));
    Assembly assembly{};
    for (const Bytes& each : packets) take(each, assembly);
    // A packet's number of the sender is not part of the message.
    ASSERT_TRUE(!assembly.is_complete() || holds(assembly, message));
  }
}

TEST(FleetPackets, RefusesWhatDoesNotFitTheMessage) {
  Random random(5);
  const Bytes message = random_message(random, 50);
  const Bytes packet = packets_of(message, 27)[0];
  tern::PacketHead head{};
  for (std::int32_t size = 0; size < 27; ++size) EXPECT_FALSE(tern::read_packet(packet.data(), size, head));
  EXPECT_TRUE(tern::read_packet(packet.data(), 27, head));
  Bytes beyond = packet;
  beyond[9] = 4;  // part 4 of 50 bytes is past the end
  EXPECT_FALSE(tern::read_packet(beyond.data(), 27, head));
  EXPECT_FALSE(tern::read_packet(nullptr, 27, head));
}

void expect_state_comes_back(bool by_range) {
  std::uint8_t bytes[tern::state_bytes(2, true)] = {};
  tern::ByteWriter out(bytes);
  tern::write_state({4, 11, 12, -13, 14, 15, 350, 200, true, by_range ? 16 : 0}, by_range, 2, out);
  tern::append_answer({5, 21, 22, tern::Consent::kNo, false, 23, 24, false}, by_range, out);
  tern::append_answer({6, 31, 32, tern::Consent::kYes, true, 33, 34, true}, by_range, out);
  ASSERT_EQ(out.size(), by_range ? 41 + 2 * 21 : 33 + 2 * 12);
  tern::StateHead state{};
  tern::Answer answer{};
  bool is_by_range = !by_range;
  ASSERT_TRUE(tern::read_state(bytes, out.size(), 6, state, is_by_range, answer));
  EXPECT_EQ(is_by_range, by_range);
  EXPECT_EQ(state.id, 4);
  EXPECT_EQ(state.incarnation, 11u);
  EXPECT_EQ(state.counter, 12u);
  EXPECT_EQ(state.stamp, -13);
  EXPECT_EQ(state.flown, 14u);
  EXPECT_EQ(state.open, 15u);
  EXPECT_EQ(state.radius, 350);
  EXPECT_EQ(state.priority, 200);
  EXPECT_TRUE(state.has_left);
  EXPECT_EQ(state.until, by_range ? 16 : 0);
  EXPECT_EQ(answer.incarnation, 31u);
  EXPECT_EQ(answer.number, 32u);
  EXPECT_EQ(answer.consent, tern::Consent::kYes);
  EXPECT_TRUE(answer.lacks_flown);
  EXPECT_EQ(answer.link, by_range ? 33u : 0u);
  EXPECT_EQ(answer.its, by_range ? 34u : 0u);
  EXPECT_EQ(answer.promises, by_range);
  ASSERT_TRUE(tern::read_state(bytes, out.size(), 7, state, is_by_range, answer));
  EXPECT_EQ(answer.incarnation, 0u) << "no answer to 7";
  for (std::int32_t size = 0; size < out.size(); ++size)
    EXPECT_FALSE(tern::read_state(bytes, size, 6, state, is_by_range, answer));
}

TEST(FleetStateBytes, ComesBack) {
  expect_state_comes_back(false);
  expect_state_comes_back(true);
}

}  // namespace
