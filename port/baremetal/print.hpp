// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Text output without a C library: print("hash ", hex(h, 16), ", ", count, " plans\n").
#ifndef TERN_PORT_BAREMETAL_PRINT_HPP
#define TERN_PORT_BAREMETAL_PRINT_HPP

#include <cstdint>

namespace tern_board {

/// A value as hexadecimal digits, leading zeros included.
struct Hex {
  std::uint64_t value;
  int digits;
};
/// A number or text in a column: numbers right-aligned, text left-aligned; wider ones push the column.
struct Column {
  std::uint64_t value;
  int width;
};
struct TextColumn {
  const char* text;
  int width;
};

constexpr Hex hex(std::uint64_t value, int digits) {
  return {value, digits};
}
constexpr Column column(std::uint64_t value, int width) {
  return {value, width};
}
constexpr TextColumn column(const char* text, int width) {
  return {text, width};
}

void put(const char* text) noexcept;
void put(unsigned long long value) noexcept;
void put(long long value) noexcept;
void put(const Hex& value) noexcept;
void put(const Column& value) noexcept;
void put(const TextColumn& value) noexcept;
// Every integer type by its own name: which of them std::uint32_t and std::uint64_t are differs between boards.
inline void put(int value) noexcept {
  put(static_cast<long long>(value));
}
inline void put(long value) noexcept {
  put(static_cast<long long>(value));
}
inline void put(unsigned value) noexcept {
  put(static_cast<unsigned long long>(value));
}
inline void put(unsigned long value) noexcept {
  put(static_cast<unsigned long long>(value));
}

template <typename... Parts>
void print(const Parts&... parts) noexcept {
  (put(parts), ...);
}

}  // namespace tern_board

#endif
