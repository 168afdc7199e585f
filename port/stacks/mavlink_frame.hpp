// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What all frames of MAVLink 2 have around their payload.
#ifndef TERN_STACKS_MAVLINK_FRAME_HPP
#define TERN_STACKS_MAVLINK_FRAME_HPP

#include <stdint.h>

#include "tern_stacks/stacks.hpp"

namespace tern {

constexpr uint8_t kMavlinkMagic = 0xFD;
constexpr int32_t kMavlinkHeadBytes = 10;
constexpr int32_t kMavlinkChecksumBytes = 2;

/// A message's number, and the byte that its definition adds to the checksum.
struct MavlinkMessage {
  uint32_t id;
  uint8_t crc_extra;
};

/// CRC-16/MCRF4XX, which MAVLink calls X.25, of a frame without its magic and checksum.
uint16_t mavlink_checksum(const uint8_t* frame, int32_t payload, const MavlinkMessage& message) noexcept;

/// Writes head and checksum around the payload that `frame` has from kMavlinkHeadBytes on. Returns the frame's bytes.
int32_t complete_mavlink_frame(const MavlinkMessage& message, const MavlinkHeader& header, int32_t payload,
                               uint8_t* frame) noexcept;

}  // namespace tern

#endif
