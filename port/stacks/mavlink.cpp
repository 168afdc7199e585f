// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mavlink_frame.hpp"
#include "tern_stacks/stacks.hpp"

namespace tern {
namespace {

constexpr MavlinkMessage kSetpoint{84, 143};
constexpr int32_t kPayload = 53;
constexpr uint8_t kLocalNed = 1;
// The type mask's bits, each of which says that a field is to be ignored. Bit 9 says that accelerations are forces.
constexpr int kYawBit = 10;
constexpr int kYawRateBit = 11;

void put(uint8_t*& at, uint32_t value, int bytes) {
  for (int i = 0; i < bytes; ++i) *at++ = static_cast<uint8_t>(value >> (8 * i));
}

/// The numbers of a frame as they are written.
struct Numbers {
  uint8_t* at;
  uint32_t mask = 0;  // bits of the fields that are NaN
  bool infinite = false;

  /// NaN becomes 0 with its bit in the mask, so a receiver that does not read the mask never computes with NaN.
  void add(float value, int bit) {
    const bool number = value <= 0.0f || value >= 0.0f;
    if (!number) mask |= 1u << bit;
    const float written = number ? value : 0.0f;
    infinite = infinite || !(written - written <= 0.0f);
    uint32_t bits;
    __builtin_memcpy(&bits, &written, sizeof bits);
    put(at, bits, 4);
  }

  void add(const float (&v)[3], int first_bit) {
    for (int a = 0; a < 3; ++a) add(v[a], first_bit + a);
  }
};

/// CRC-16/MCRF4XX, which MAVLink calls X.25.
uint16_t accumulate(uint16_t crc, uint8_t byte) {
  uint8_t t = static_cast<uint8_t>(byte ^ (crc & 0xFF));
  t = static_cast<uint8_t>(t ^ (t << 4));
  return static_cast<uint16_t>((crc >> 8) ^ (t << 8) ^ (t << 3) ^ (t >> 4));
}

}  // namespace

uint16_t mavlink_checksum(const uint8_t* frame, int32_t payload, const MavlinkMessage& message) noexcept {
  uint16_t crc = 0xFFFF;
  for (int32_t i = 1; i < kMavlinkHeadBytes + payload; ++i) crc = accumulate(crc, frame[i]);
  return accumulate(crc, message.crc_extra);
}

int32_t complete_mavlink_frame(const MavlinkMessage& message, const MavlinkHeader& header, int32_t payload,
                               uint8_t* frame) noexcept {
  const uint8_t head[kMavlinkHeadBytes] = {kMavlinkMagic,
                                           static_cast<uint8_t>(payload),
                                           0,
                                           0,
                                           header.sequence,
                                           header.system,
                                           header.component,
                                           static_cast<uint8_t>(message.id & 0xFF),
                                           static_cast<uint8_t>(message.id >> 8 & 0xFF),
                                           static_cast<uint8_t>(message.id >> 16)};
  __builtin_memcpy(frame, head, kMavlinkHeadBytes);
  uint8_t* at = frame + kMavlinkHeadBytes + payload;
  put(at, mavlink_checksum(frame, payload, message), kMavlinkChecksumBytes);
  return kMavlinkHeadBytes + payload + kMavlinkChecksumBytes;
}

int32_t mavlink_setpoint(const SetpointNed& setpoint, const MavlinkHeader& header, uint8_t* frame) noexcept {
  uint8_t* at = frame + kMavlinkHeadBytes;
  put(at, header.time_boot_ms, 4);
  Numbers numbers{at};
  numbers.add(setpoint.position, 0);
  numbers.add(setpoint.velocity, 3);
  numbers.add(setpoint.acceleration, 6);
  numbers.add(setpoint.yaw, kYawBit);
  numbers.add(setpoint.yaw_rate, kYawRateBit);
  if (numbers.infinite) return 0;
  at = numbers.at;
  put(at, numbers.mask, 2);
  *at++ = header.target_system;
  *at++ = header.target_component;
  *at++ = kLocalNed;  // not 0, so MAVLink 2 has no zeros at the end to leave out
  return complete_mavlink_frame(kSetpoint, header, kPayload, frame);
}

}  // namespace tern
