// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Two vehicles whose members come by range.
#ifndef TERN_TESTS_FLEET_RANGE_PAIR_HPP
#define TERN_TESTS_FLEET_RANGE_PAIR_HPP

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "fleet/beacons.hpp"
#include "fleet/plans.hpp"
#include "fleet/slices.hpp"
#include "tern/fleet.hpp"

namespace tern_test {

/// What a vehicle of half a metre says of itself.
inline std::vector<std::uint8_t> beacon_of(std::uint16_t id, const tern::Vec3& place, std::int64_t now) {
  std::uint8_t bytes[tern::kBeaconBytes];
  tern::ByteWriter out(bytes);
  out.put(tern::form_of(tern::MessageKind::kBeacon));
  out(id, now, place.x, place.y, place.z, std::uint16_t{500});
  std::vector<std::uint8_t> packet(tern::kFleetBeaconRoom);
  std::int32_t first = 0;
  const std::int32_t size = tern::write_packet(bytes, tern::kBeaconBytes, tern::crc32(bytes, tern::kBeaconBytes), id,
                                               packet.data(), tern::kFleetBeaconRoom, first);
  packet.resize(static_cast<std::size_t>(size));
  return packet;
}

/// Gives a packet with a whole message the right checksum.
inline void sign(std::vector<std::uint8_t>& packet) {
  const auto size = static_cast<std::int32_t>(packet.size()) - tern::kPacketHeadBytes;
  const std::uint32_t crc = tern::crc32(packet.data() + tern::kPacketHeadBytes, size);
  for (int k = 0; k < 4; ++k) packet[3 + k] = static_cast<std::uint8_t>(crc >> (8 * k));
}

/// Vehicles 1 and 2 at rest, which hear each other as often as the test says.
class FleetRangePair : public testing::Test {
 protected:
  void begin(double apart) {
    for (int v = 0; v < 2; ++v)
      ASSERT_EQ(fleet(v).begin(spec(v), resting(place(v, apart), 0), now_), tern::Status::kOk);
    apart_ = apart;
  }
  tern::FleetSpec spec(int v) const {
    tern::FleetSpec spec;
    spec.id = static_cast<std::uint16_t>(v + 1);
    spec.incarnation = incarnation_;
    spec.priority = priorities_[v];
    spec.radius = 0.5;
    spec.clock_error = clock_error_;
    spec.tick = kSecond / 10;
    spec.range.join = 20.0;
    spec.range.heard = 200.0;
    spec.range.speed = 5.0;
    spec.range.within = kSecond;
    spec.range.lease = lease_;
    return spec;
  }
  static tern::Vec3 place(int v, double apart) { return {v * apart, 0.0, 1.0}; }
  tern::Fleet& fleet(int v) { return *fleets_[v]; }
  /// All packets of a round.
  std::vector<std::vector<std::uint8_t>> round(int from) {
    std::vector<std::vector<std::uint8_t>> packets;
    std::uint8_t packet[1400];
    while (const std::int32_t size = fleet(from).write(packet, sizeof packet)) {
      packets.emplace_back(packet, packet + size);
    }
    return packets;
  }
  void hear(int to, const std::vector<std::vector<std::uint8_t>>& packets) {
    for (const auto& packet : packets) {
      last_ = fleet(to).receive(packet.data(), static_cast<std::int32_t>(packet.size()), now_);
    }
  }
  void say(int from) { hear(1 - from, round(from)); }
  void advance(int v) {
    tern::Work work(100000);
    fleet(v).advance(now_, work);
  }
  /// Ticks in which each hears the other.
  void go_on(double seconds) {
    for (const std::int64_t end = now_ + static_cast<std::int64_t>(1e9 * seconds); now_ < end;) {
      now_ += kSecond / 10;
      for (const int v : {0, 1}) {
        advance(v);
        say(v);
      }
    }
  }
  /// Announces a straight plan, a second ahead.
  void fly(int v, const tern::Vec3& from, const tern::Vec3& to, double seconds) {
    const std::int64_t takeover = now_ + kSecond;
    ASSERT_EQ(fleet(v).announce(straight(from, to, takeover, seconds), takeover, now_), tern::Status::kOk);
    advance(v);
  }
  /// Two metres aside, in 4 s.
  void announce(int v) {
    const tern::Vec3 from = place(v, apart_);
    fly(v, from, {from.x, from.y + 2.0, from.z}, 4.0);
  }
  void expect_dropped(int v, tern::FleetBlock why, std::uint16_t by) {
    EXPECT_EQ(fleet(v).report().announcement, tern::Announcement::kDropped);
    EXPECT_EQ(fleet(v).report().blocked, why);
    EXPECT_EQ(fleet(v).report().blocked_by, by);
  }

  std::int64_t now_ = kSecond;
  double apart_ = 0.0;
  std::int64_t lease_ = 8 * kSecond;
  std::int64_t clock_error_ = 0;
  std::uint32_t incarnation_ = 1;
  std::uint8_t priorities_[2] = {};
  tern::Heard last_ = tern::Heard::kNews;
  std::unique_ptr<tern::Fleet> fleets_[2] = {std::make_unique<tern::Fleet>(), std::make_unique<tern::Fleet>()};
};

}  // namespace tern_test

#endif
