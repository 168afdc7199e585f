// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fleet/bytes.hpp"

namespace tern {
namespace {

/// The remainders of all bytes: a kilobyte, since in a large fleet most of receiving is this.
struct Remainders {
  std::uint32_t of[256];
  constexpr Remainders() : of{} {
    for (std::uint32_t byte = 0; byte < 256; ++byte) {
      std::uint32_t rest = byte;
      for (int bit = 0; bit < 8; ++bit) rest = (rest & 1u) != 0 ? 0xEDB88320u ^ (rest >> 1) : rest >> 1;
      of[byte] = rest;
    }
  }
};
constexpr Remainders kRemainders;

}  // namespace

std::uint32_t crc32(const std::uint8_t* bytes, std::int32_t size) noexcept {
  std::uint32_t rest = 0xFFFFFFFFu;
  for (std::int32_t k = 0; k < size; ++k) rest = kRemainders.of[(rest ^ bytes[k]) & 255u] ^ (rest >> 8);
  return ~rest;
}

}  // namespace tern
