// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The four functions that a compiler may call whatever the source says. Built with -fno-builtin and
// -fno-tree-loop-distribute-patterns, or each loop below would become a call to itself.
#include <cstddef>
#include <cstdint>

namespace {

/// A word at any address: single loads and stores may be unaligned on both boards (normal memory, MMU on; ARMv7-M).
struct __attribute__((packed, may_alias)) Word {
  std::uintptr_t value;
};
constexpr std::size_t kWord = sizeof(std::uintptr_t);
/// Words moved a turn: few enough to stay in registers.
constexpr std::size_t kBurst = 4;

void copy_up(unsigned char* to, const unsigned char* from, std::size_t count) {
  for (; count >= kBurst * kWord; count -= kBurst * kWord, to += kBurst * kWord, from += kBurst * kWord) {
    std::uintptr_t held[kBurst];
    for (std::size_t i = 0; i < kBurst; ++i) held[i] = reinterpret_cast<const Word*>(from)[i].value;
    for (std::size_t i = 0; i < kBurst; ++i) reinterpret_cast<Word*>(to)[i].value = held[i];
  }
  for (; count >= kWord; count -= kWord, to += kWord, from += kWord) {
    reinterpret_cast<Word*>(to)->value = reinterpret_cast<const Word*>(from)->value;
  }
  for (; count > 0; --count) *to++ = *from++;
}

void copy_down(unsigned char* to, const unsigned char* from, std::size_t count) {
  for (; count % kWord != 0; --count) to[count - 1] = from[count - 1];
  for (; count > 0; count -= kWord) {
    reinterpret_cast<Word*>(to + count - kWord)->value = reinterpret_cast<const Word*>(from + count - kWord)->value;
  }
}

}  // namespace

extern "C" {

void* memcpy(void* to, const void* from, std::size_t count) {
  copy_up(static_cast<unsigned char*>(to), static_cast<const unsigned char*>(from), count);
  return to;
}

void* memmove(void* to, const void* from, std::size_t count) {
  auto* target = static_cast<unsigned char*>(to);
  const auto* source = static_cast<const unsigned char*>(from);
  // Unsigned: also true where the target lies below the source.
  const bool apart = reinterpret_cast<std::uintptr_t>(target) - reinterpret_cast<std::uintptr_t>(source) >= count;
  apart ? copy_up(target, source, count) : copy_down(target, source, count);
  return to;
}

void* memset(void* to, int value, std::size_t count) {
  auto* target = static_cast<unsigned char*>(to);
  const std::uintptr_t pattern = ~std::uintptr_t{0} / 0xFF * static_cast<unsigned char>(value);
  for (; count >= kWord; count -= kWord, target += kWord) reinterpret_cast<Word*>(target)->value = pattern;
  for (; count > 0; --count) *target++ = static_cast<unsigned char>(value);
  return to;
}

int memcmp(const void* a, const void* b, std::size_t count) {
  const auto* left = static_cast<const unsigned char*>(a);
  const auto* right = static_cast<const unsigned char*>(b);
  for (std::size_t i = 0; i < count; ++i) {
    if (left[i] != right[i]) return left[i] < right[i] ? -1 : 1;
  }
  return 0;
}

}  // extern "C"
