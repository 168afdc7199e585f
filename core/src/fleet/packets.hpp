// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Messages in packets of any size from 27 bytes on. A packet says whose message it is of, the message's checksum and
// size, and where in the message its bytes belong. So packets may be lost, repeated, come in any order and be cut anew
// when the message is sent again; those of two messages are never mixed.
#ifndef TERN_FLEET_PACKETS_HPP
#define TERN_FLEET_PACKETS_HPP

#include <cstddef>
#include <cstdint>

#include "fleet/bytes.hpp"

namespace tern {

/// What a message is. Its first byte has the version of the format in the upper half, and this in the lower one.
enum class MessageKind : std::uint8_t { kState = 0, kPlan = 1, kBeacon = 2, kRangeState = 3 };
constexpr std::uint8_t kMessageVersion = 1;
constexpr std::uint8_t form_of(MessageKind kind) {
  return static_cast<std::uint8_t>(kMessageVersion << 4 | static_cast<std::uint8_t>(kind));
}

/// Packets are cut where a multiple of this many bytes of the message ends.
constexpr std::int32_t kPartBytes = 16;
constexpr std::int32_t parts_of(std::int32_t size) {
  return (size + kPartBytes - 1) / kPartBytes;
}
constexpr std::int32_t in_whole_parts(std::int32_t size) {
  return kPartBytes * parts_of(size);
}

struct PacketHead {
  std::uint8_t form;
  std::uint16_t id;     ///< the sender
  std::uint32_t crc;    ///< of the whole message
  std::uint16_t size;   ///< of the whole message, bytes
  std::uint16_t first;  ///< part of the message that this packet begins with
};
constexpr std::int32_t kPacketHeadBytes = 11;
constexpr std::int32_t kLeastPacketBytes = kPacketHeadBytes + kPartBytes;

/// Writes the packet with the parts from `first` on to `packet`, which has room for `room` bytes, at least
/// kLeastPacketBytes. Returns its size; `first` becomes the part after it.
std::int32_t write_packet(const std::uint8_t* message, std::int32_t size, std::uint32_t crc, std::uint16_t id,
                          std::uint8_t* packet, std::int32_t room, std::int32_t& first) noexcept;

/// False if the bytes are no packet, whatever its version.
bool read_packet(const std::uint8_t* packet, std::int32_t size, PacketHead& head) noexcept;

/// A message that is put together from packets. Bytes: at most so many. If every member is zero, there is none.
template <std::int32_t Bytes>
struct Assembly {
  std::uint32_t crc;
  std::int32_t size;     ///< 0: none
  std::int32_t missing;  ///< parts; 0 and size > 0: complete, and its checksum is right
  std::uint8_t has[(parts_of(Bytes) + 7) / 8];
  std::uint8_t bytes[Bytes];

  bool is_of(const PacketHead& head) const noexcept { return size > 0 && crc == head.crc && size == head.size; }
  bool is_complete() const noexcept { return size > 0 && missing == 0; }

  void clear() noexcept {
    crc = 0;
    size = missing = 0;
    for (std::uint8_t& bits : has) bits = 0;
  }
  void open(const PacketHead& head) noexcept {
    clear();
    crc = head.crc;
    size = head.size;
    missing = parts_of(size);
  }
  /// Takes the bytes of a packet that read_packet() accepted and that is of this message. If the checksum is wrong in
  /// the end, there is no message.
  void take(const PacketHead& head, const std::uint8_t* packet, std::int32_t packet_size) noexcept {
    for (std::int32_t k = kPacketHeadBytes; k < packet_size; k += kPartBytes) {
      const std::int32_t part = head.first + (k - kPacketHeadBytes) / kPartBytes;
      const auto bit = static_cast<std::uint8_t>(1u << (part % 8));
      if ((has[part / 8] & bit) != 0) continue;
      has[part / 8] = static_cast<std::uint8_t>(has[part / 8] | bit);
      --missing;
      const std::int32_t count = packet_size - k < kPartBytes ? packet_size - k : kPartBytes;
      __builtin_memcpy(bytes + part * kPartBytes, packet + k, static_cast<std::size_t>(count));
    }
    if (missing == 0 && crc32(bytes, size) != crc) clear();
  }
};

}  // namespace tern

#endif
