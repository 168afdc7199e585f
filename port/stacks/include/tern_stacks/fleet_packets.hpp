// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A fleet's packets on the links that flight stacks have. They are bytes already, with a checksum of their own: each
// link carries one packet in one of its messages, and needs nothing else. docs/fleet.md has the format.
//
//   link                      room that Fleet::write() gets      carried in
//   MAVLink                   kMavlinkFleetRoom                  TUNNEL, by mavlink_tunnel()
//   the Crazyflie's radio     kCrazyflieFleetRoom                P2PPacket::data, size and all
//   ROS                       any                                std_msgs/UInt8MultiArray, by
//   tern_ros/fleet_packets.hpp
#ifndef TERN_STACKS_FLEET_PACKETS_HPP
#define TERN_STACKS_FLEET_PACKETS_HPP

#include <stdint.h>

#include "tern_stacks/stacks.hpp"

namespace tern {

/// Bytes of a fleet's packet that a TUNNEL message carries, and of the whole frame.
constexpr int32_t kMavlinkFleetRoom = 128;
constexpr int32_t kMavlinkTunnelBytes = 145;
/// Bytes that a peer-to-peer packet of the Crazyflie carries: P2P_MAX_DATA_SIZE of its firmware.
constexpr int32_t kCrazyflieFleetRoom = 60;
/// TUNNEL's payload_type: of those that MAVLink leaves to everyone, above 32767.
constexpr uint16_t kMavlinkFleetType = 0xF1EE;

/// Writes a frame of TUNNEL (385) with the packet. MavlinkHeader::time_boot_ms is not in it. `frame` has room for
/// kMavlinkTunnelBytes. Returns the frame's bytes, or 0 for a packet of no bytes or more than kMavlinkFleetRoom.
int32_t mavlink_tunnel(const uint8_t* packet, int32_t size, const MavlinkHeader& header, uint8_t* frame) noexcept;

/// Reads the packet in a whole frame of TUNNEL. `packet` has room for kMavlinkFleetRoom bytes. Returns their number; 0
/// for a frame of another message or type, one that is cut or damaged, or one with a signature.
int32_t mavlink_tunnelled(const uint8_t* frame, int32_t size, uint8_t* packet) noexcept;

}  // namespace tern

#endif
