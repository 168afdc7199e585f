// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A fleet's packets as messages of ROS 1 and 2: one packet in the data of one std_msgs/UInt8MultiArray, without layout.
// Publish with "best effort": a packet that is late is worth nothing, and the fleet sends again by itself.
#ifndef TERN_ROS_FLEET_PACKETS_HPP
#define TERN_ROS_FLEET_PACKETS_HPP

#include <cstddef>
#include <cstdint>

#include "tern/fleet.hpp"

namespace tern_ros {

/// Bytes of a packet, which fit a datagram of the usual networks.
constexpr std::int32_t kFleetRoom = 1400;

/// Publishes one round of packets: `publish` takes a std_msgs/UInt8MultiArray.
template <typename Message, typename Publish>
void publish_round(tern::Fleet& fleet, Publish publish) {
  std::uint8_t packet[kFleetRoom];
  for (std::int32_t size; (size = fleet.write(packet, kFleetRoom)) > 0;) {
    Message message;
    message.data.assign(packet, packet + size);
    publish(message);
  }
}

/// Gives the fleet what a message brought. Longer ones than any packet are no packets.
template <typename Message>
tern::Heard receive(tern::Fleet& fleet, const Message& message, std::int64_t now) {
  const std::size_t size = message.data.size();
  return size > 65535 ? tern::Heard::kDamaged
                      : fleet.receive(message.data.data(), static_cast<std::int32_t>(size), now);
}

}  // namespace tern_ros

#endif
