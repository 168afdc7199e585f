// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fleet/packets.hpp"

namespace tern {

std::int32_t write_packet(const std::uint8_t* message, std::int32_t size, std::uint32_t crc, std::uint16_t id,
                          std::uint8_t* packet, std::int32_t room, std::int32_t& first) noexcept {
  const std::int32_t begin = first * kPartBytes;
  const std::int32_t most = (room - kPacketHeadBytes) / kPartBytes * kPartBytes;
  const std::int32_t count = size - begin < most ? size - begin : most;
  ByteWriter out(packet);
  out.put(message[0]);
  out.put(id);
  out.put(crc);
  out.put(static_cast<std::uint16_t>(size));
  out.put(static_cast<std::uint16_t>(first));
  for (std::int32_t k = 0; k < count; ++k) out.put(message[begin + k]);
  first += parts_of(count);
  return out.size();
}

bool read_packet(const std::uint8_t* packet, std::int32_t size, PacketHead& head) noexcept {
  if (packet == nullptr || size <= kPacketHeadBytes) return false;
  ByteReader in(packet, size);
  in.get(head.form);
  in.get(head.id);
  in.get(head.crc);
  in.get(head.size);
  in.get(head.first);
  const std::int32_t begin = head.first * kPartBytes;
  const std::int32_t count = size - kPacketHeadBytes;
  const bool is_last = begin + count == head.size;
  return begin + count <= head.size && (is_last || count % kPartBytes == 0);
}

}  // namespace tern
