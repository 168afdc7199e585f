// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tern/export.hpp"

namespace tern {
namespace {

constexpr uint32_t kMessage = 84;
constexpr uint8_t kCrcExtra = 143;
constexpr uint8_t kMagic = 0xFD;
constexpr int kHeader = 10;
constexpr int kPayload = 53;
constexpr uint8_t kLocalNed = 1;

void put(uint8_t*& at, uint32_t value, int bytes) {
  for (int i = 0; i < bytes; ++i) *at++ = static_cast<uint8_t>(value >> (8 * i));
}

void put(uint8_t*& at, float value) {
  uint32_t bits;
  __builtin_memcpy(&bits, &value, sizeof bits);
  put(at, bits, 4);
}

void put(uint8_t*& at, const float (&v)[3]) {
  for (const float component : v) put(at, component);
}

/// CRC-16/MCRF4XX, which MAVLink calls X.25.
uint16_t accumulate(uint16_t crc, uint8_t byte) {
  uint8_t t = static_cast<uint8_t>(byte ^ (crc & 0xFF));
  t = static_cast<uint8_t>(t ^ (t << 4));
  return static_cast<uint16_t>((crc >> 8) ^ (t << 8) ^ (t << 3) ^ (t >> 4));
}

}  // namespace

int32_t mavlink_setpoint(const SetpointNed& setpoint, const MavlinkHeader& header, uint8_t* frame) noexcept {
  uint8_t* at = frame + kHeader;
  put(at, header.time_boot_ms, 4);
  put(at, setpoint.position);
  put(at, setpoint.velocity);
  put(at, setpoint.acceleration);
  put(at, setpoint.yaw);
  put(at, setpoint.yaw_rate);
  put(at, 0, 2);  // no field is masked
  *at++ = header.target_system;
  *at++ = header.target_component;
  *at++ = kLocalNed;  // not 0: so MAVLink 2 has no zeros to leave out at the end
  const uint8_t head[kHeader] = {kMagic,
                                 kPayload,
                                 0,
                                 0,
                                 header.sequence,
                                 header.system,
                                 header.component,
                                 static_cast<uint8_t>(kMessage & 0xFF),
                                 static_cast<uint8_t>(kMessage >> 8),
                                 0};
  __builtin_memcpy(frame, head, kHeader);
  uint16_t crc = 0xFFFF;
  for (int i = 1; i < kHeader + kPayload; ++i) crc = accumulate(crc, frame[i]);
  crc = accumulate(crc, kCrcExtra);
  at = frame + kHeader + kPayload;
  put(at, crc, 2);
  return kHeader + kPayload + 2;
}

}  // namespace tern
