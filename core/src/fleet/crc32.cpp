// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fleet/bytes.hpp"

namespace tern {
namespace {

/// The remainders of all bytes with 0 to 3 zeros behind them, so that four bytes are taken at a time: in a large fleet,
/// a good part of receiving is this. Four kilobytes.
struct Remainders {
  std::uint32_t of[4][256];
  constexpr Remainders() : of{} {
    for (std::uint32_t byte = 0; byte < 256; ++byte) {
      std::uint32_t rest = byte;
      for (int bit = 0; bit < 8; ++bit) rest = (rest & 1u) != 0 ? 0xEDB88320u ^ (rest >> 1) : rest >> 1;
      of[0][byte] = rest;
    }
    for (int zeros = 1; zeros < 4; ++zeros) {
      for (int byte = 0; byte < 256; ++byte) {
        const std::uint32_t rest = of[zeros - 1][byte];
        of[zeros][byte] = of[0][rest & 255u] ^ (rest >> 8);
      }
    }
  }
};
constexpr Remainders kRemainders;

}  // namespace

std::uint32_t crc32(const std::uint8_t* bytes, std::int32_t size) noexcept {
  const auto& of = kRemainders.of;
  std::uint32_t rest = 0xFFFFFFFFu;
  std::int32_t k = 0;
  for (; k + 4 <= size; k += 4) {
    const std::uint32_t a = (rest ^ bytes[k]) & 255u;
    const std::uint32_t b = ((rest >> 8) ^ bytes[k + 1]) & 255u;
    const std::uint32_t c = ((rest >> 16) ^ bytes[k + 2]) & 255u;
    const std::uint32_t d = (rest >> 24) ^ bytes[k + 3];
    rest = of[3][a] ^ of[2][b] ^ of[1][c] ^ of[0][d];
  }
  for (; k < size; ++k) rest = of[0][(rest ^ bytes[k]) & 255u] ^ (rest >> 8);
  return ~rest;
}

}  // namespace tern
