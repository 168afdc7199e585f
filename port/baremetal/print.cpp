// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "baremetal/print.hpp"

#include <cstdint>

#include "baremetal/semihosting.hpp"

namespace tern_board {
namespace {

constexpr int kMostDigits = 20;
constexpr int kMostHexDigits = 16;

/// Decimal digits at the end of a buffer; returns where they begin.
struct Decimal {
  char text[kMostDigits + 1];
  int first;
};

Decimal decimal(std::uint64_t value) {
  Decimal out;
  out.text[kMostDigits] = '\0';
  out.first = kMostDigits;
  do {
    out.text[--out.first] = static_cast<char>('0' + value % 10);
    value /= 10;
  } while (value != 0);
  return out;
}

void spaces(int count) {
  for (int i = 0; i < count; ++i) write(" ");
}

}  // namespace

void put(const char* text) noexcept {
  write(text);
}

void put(unsigned long long value) noexcept {
  const Decimal digits = decimal(value);
  write(digits.text + digits.first);
}

void put(long long value) noexcept {
  if (value < 0) write("-");
  const auto bits = static_cast<unsigned long long>(value);
  put(value < 0 ? 0 - bits : bits);
}

void put(const Hex& value) noexcept {
  char text[kMostHexDigits + 1];
  const int digits = value.digits < kMostHexDigits ? value.digits : kMostHexDigits;
  for (int i = 0; i < digits; ++i) text[i] = "0123456789abcdef"[(value.value >> (4 * (digits - 1 - i))) & 15];
  text[digits] = '\0';
  write(text);
}

void put(const Column& value) noexcept {
  const Decimal digits = decimal(value.value);
  spaces(value.width - (kMostDigits - digits.first));
  write(digits.text + digits.first);
}

void put(const TextColumn& value) noexcept {
  int length = 0;
  while (value.text[length] != '\0') ++length;
  write(value.text);
  spaces(value.width - length);
}

}  // namespace tern_board
