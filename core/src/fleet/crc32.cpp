// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fleet/bytes.hpp"

namespace tern {

std::uint32_t crc32(const std::uint8_t* bytes, std::int32_t size) noexcept {
  // Four bits a turn: the remainders of the sixteen numbers of four bits.
  constexpr std::uint32_t kRemainders[16] = {0x00000000, 0x1DB71064, 0x3B6E20C8, 0x26D930AC, 0x76DC4190, 0x6B6B51F4,
                                             0x4DB26158, 0x5005713C, 0xEDB88320, 0xF00F9344, 0xD6D6A3E8, 0xCB61B38C,
                                             0x9B64C2B0, 0x86D3D2D4, 0xA00AE278, 0xBDBDF21C};
  std::uint32_t rest = 0xFFFFFFFFu;
  for (std::int32_t k = 0; k < size; ++k) {
    rest ^= bytes[k];
    for (int half = 0; half < 2; ++half) rest = kRemainders[rest & 15u] ^ (rest >> 4);
  }
  return ~rest;
}

}  // namespace tern
