// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tern_stacks/fleet_packets.hpp"

#include "mavlink_frame.hpp"

namespace tern {
namespace {

constexpr MavlinkMessage kTunnel{385, 147};
/// payload_type, target_system, target_component and payload_length, before the payload.
constexpr int32_t kTunnelHeadBytes = 5;
constexpr int32_t kTunnelPayload = kTunnelHeadBytes + kMavlinkFleetRoom;
static_assert(kMavlinkHeadBytes + kTunnelPayload + kMavlinkChecksumBytes == kMavlinkTunnelBytes);

}  // namespace

int32_t mavlink_tunnel(const uint8_t* packet, int32_t size, const MavlinkHeader& header, uint8_t* frame) noexcept {
  if (size <= 0 || size > kMavlinkFleetRoom) return 0;
  uint8_t* const payload = frame + kMavlinkHeadBytes;
  payload[0] = static_cast<uint8_t>(kMavlinkFleetType & 0xFF);
  payload[1] = static_cast<uint8_t>(kMavlinkFleetType >> 8);
  payload[2] = header.target_system;
  payload[3] = header.target_component;
  payload[4] = static_cast<uint8_t>(size);
  __builtin_memcpy(payload + kTunnelHeadBytes, packet, static_cast<uint32_t>(size));
  // MAVLink 2 leaves out zeros at the end, and so what the packet does not fill.
  int32_t count = kTunnelHeadBytes + size;
  while (payload[count - 1] == 0) --count;
  return complete_mavlink_frame(kTunnel, header, count, frame);
}

int32_t mavlink_tunnelled(const uint8_t* frame, int32_t size, uint8_t* packet) noexcept {
  if (size < kMavlinkHeadBytes + kMavlinkChecksumBytes || frame[0] != kMavlinkMagic || frame[2] != 0) return 0;
  const int32_t count = frame[1];
  const uint32_t id = frame[7] | uint32_t{frame[8]} << 8 | uint32_t{frame[9]} << 16;
  const bool is_whole = size == kMavlinkHeadBytes + count + kMavlinkChecksumBytes;
  if (!is_whole || id != kTunnel.id || count < kTunnelHeadBytes || count > kTunnelPayload) return 0;
  const uint16_t crc = mavlink_checksum(frame, count, kTunnel);
  const uint8_t* const end = frame + kMavlinkHeadBytes + count;
  if (end[0] != (crc & 0xFF) || end[1] != crc >> 8) return 0;
  const uint8_t* const payload = frame + kMavlinkHeadBytes;
  const int32_t type = payload[0] | payload[1] << 8;
  const int32_t length = payload[4];
  if (type != kMavlinkFleetType || length > kMavlinkFleetRoom) return 0;
  // Zeros at the end may have been left out.
  for (int32_t k = 0; k < length; ++k) packet[k] = kTunnelHeadBytes + k < count ? payload[kTunnelHeadBytes + k] : 0;
  return length;
}

}  // namespace tern
