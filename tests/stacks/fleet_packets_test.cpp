// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A fleet's packets over the stacks' links: two vehicles agree over each, and what is cut or damaged is refused.
#include "tern_stacks/fleet_packets.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <functional>
#include <memory>
#include <vector>

#include "support/random.hpp"
#include "tern/fleet.hpp"

namespace {

using namespace tern;
using Bytes = std::vector<std::uint8_t>;

constexpr MavlinkHeader kHeader{7, 191, 0, 0, 42, 0};
constexpr std::int64_t kSecond = 1000000000;

Bytes tunnel(const Bytes& packet) {
  Bytes frame(kMavlinkTunnelBytes);
  const std::int32_t size =
      mavlink_tunnel(packet.data(), static_cast<std::int32_t>(packet.size()), kHeader, frame.data());
  frame.resize(static_cast<std::size_t>(size));
  return frame;
}

Bytes tunnelled(const Bytes& frame) {
  Bytes packet(kMavlinkFleetRoom);
  packet.resize(static_cast<std::size_t>(
      mavlink_tunnelled(frame.data(), static_cast<std::int32_t>(frame.size()), packet.data())));
  return packet;
}

TEST(FleetPackets, ComeOutOfATunnelAsTheyWentIn) {
  tern_test::Random random(11);
  for (std::size_t size = 1; size <= kMavlinkFleetRoom; ++size) {
    Bytes packet(size);
    for (std::uint8_t& byte : packet)
      byte = static_cast<std::uint8_t>(random.integer(0, 3) == 0 ? 0 : random.integer(0, 255));
    if (size % 3 == 0) packet.back() = 0;
    const Bytes frame = tunnel(packet);
    ASSERT_GE(frame.size(), 12u + 5u);
    EXPECT_LE(frame.size(), 17u + size);
    EXPECT_EQ(tunnelled(frame), packet) << size;
  }
  EXPECT_TRUE(tunnel({}).empty());
  EXPECT_TRUE(tunnel(Bytes(kMavlinkFleetRoom + 1)).empty());
}

// By the public definition: number 385, checksum's byte 147, fields by size.
TEST(FleetPackets, AreFramesOfTunnel) {
  const Bytes frame = tunnel({1, 2, 3});
  const Bytes head{0xFD, 8, 0, 0, 42, 7, 191, 0x81, 0x01, 0x00, 0xEE, 0xF1, 0, 0, 3, 1, 2, 3};
  ASSERT_EQ(frame.size(), head.size() + 2);
  EXPECT_EQ(std::memcmp(frame.data(), head.data(), head.size()), 0);
  std::uint16_t crc = 0xFFFF;
  const auto add = [&crc](unsigned byte) {
    crc = static_cast<std::uint16_t>(crc ^ byte);
    for (int bit = 0; bit < 8; ++bit) crc = static_cast<std::uint16_t>(crc & 1 ? crc >> 1 ^ 0x8408 : crc >> 1);
  };
  for (std::size_t k = 1; k < head.size(); ++k) add(frame[k]);
  add(147);
  EXPECT_EQ(frame[head.size()] | frame[head.size() + 1] << 8, crc);
}

TEST(FleetPackets, RefuseWhatIsCutOrDamaged) {
  const Bytes frame = tunnel({9, 8, 7, 6, 5});
  for (std::size_t size = 0; size < frame.size(); ++size) {
    EXPECT_TRUE(tunnelled(Bytes(frame.begin(), frame.begin() + static_cast<std::ptrdiff_t>(size))).empty());
  }
  for (std::size_t k = 0; k < frame.size(); ++k) {
    Bytes other = frame;
    other[k] = static_cast<std::uint8_t>(other[k] ^ 0x10);
    EXPECT_TRUE(tunnelled(other).empty()) << k;
  }
}

/// A vehicle at rest at x, with one other member.
std::unique_ptr<Fleet> at_rest(std::uint16_t id, double x) {
  Trajectory rest{};
  rest.count = 1;
  rest.origin = {x, 0, 0};
  rest.segments[0].duration = 1.0;
  FleetSpec spec;
  spec.id = id;
  spec.incarnation = 1;
  spec.radius = 0.3;
  spec.tick = kSecond / 10;
  auto fleet = std::make_unique<Fleet>();
  EXPECT_EQ(fleet->begin(spec, rest, 0), Status::kOk);
  EXPECT_EQ(fleet->add(static_cast<std::uint16_t>(3 - id), 0), Status::kOk);
  return fleet;
}

/// The second of two vehicles gets a plan through over a link with so much room.
void expect_agreement(std::int32_t room, const std::function<Bytes(const Bytes&)>& link) {
  const std::unique_ptr<Fleet> fleets[2] = {at_rest(1, 0.0), at_rest(2, 5.0)};
  Trajectory plan = *fleets[1]->flown();
  plan.begin = 3 * kSecond;
  for (int tick = 1; tick <= 40; ++tick) {
    const std::int64_t now = tick * kSecond / 10;
    if (tick == 10) {
      EXPECT_EQ(fleets[1]->announce(plan, plan.begin, now), Status::kOk);
    }
    for (int v = 0; v < 2; ++v) {
      Work work(1000);
      fleets[v]->advance(now, work);
      Bytes packet(static_cast<std::size_t>(room));
      for (std::int32_t size; (size = fleets[v]->write(packet.data(), room)) > 0;) {
        const Bytes arrived = link(Bytes(packet.begin(), packet.begin() + size));
        const Heard heard = fleets[1 - v]->receive(arrived.data(), static_cast<std::int32_t>(arrived.size()), now);
        EXPECT_TRUE(heard == Heard::kNews || heard == Heard::kOld);
      }
    }
  }
  EXPECT_EQ(fleets[1]->report().announcement, Announcement::kTaken);
}

TEST(FleetPackets, AgreeThroughMavlink) {
  expect_agreement(kMavlinkFleetRoom, [](const Bytes& packet) { return tunnelled(tunnel(packet)); });
}

/// As the Crazyflie's radiolink.h has it: size, signal strength, port, data.
struct PeerPacket {
  std::uint8_t size, rssi, port, data[60];
};

TEST(FleetPackets, AgreeThroughTheCrazyfliesRadio) {
  static_assert(sizeof PeerPacket::data == kCrazyflieFleetRoom);
  expect_agreement(kCrazyflieFleetRoom, [](const Bytes& packet) {
    PeerPacket sent{};
    sent.size = static_cast<std::uint8_t>(packet.size());
    std::memcpy(sent.data, packet.data(), packet.size());
    return Bytes(sent.data, sent.data + sent.size);
  });
}

}  // namespace
