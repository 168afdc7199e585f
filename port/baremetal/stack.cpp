// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// High-water mark of the stack, by paint: what a run wrote over no longer holds the pattern. A frame that happens to
// write the pattern, or reserves and does not touch, is not seen; the call graph's bound stands beside it.
#include <cstddef>
#include <cstdint>

#include "baremetal/board.hpp"

extern "C" {
extern std::uintptr_t __stack_bottom[];
extern std::uintptr_t __stack_top[];
}

namespace tern_board {
namespace {

constexpr std::uintptr_t kPaint = static_cast<std::uintptr_t>(0xA5C35A3CA5C35A3Cu);

std::uintptr_t* stack_pointer() noexcept {
  std::uintptr_t* value;
  asm volatile("mov %0, sp" : "=r"(value));
  return value;
}

}  // namespace

// Not inlined: their own frames are where both measure from.
__attribute__((noinline)) void paint_stack() noexcept {
  for (volatile std::uintptr_t* word = __stack_bottom; word < stack_pointer(); ++word) *word = kPaint;
}

__attribute__((noinline)) std::size_t stack_used() noexcept {
  const std::uintptr_t* const top = stack_pointer();
  const std::uintptr_t* word = __stack_bottom;
  while (word < top && *word == kPaint) ++word;
  return static_cast<std::size_t>(top - word) * sizeof *word;
}

std::size_t stack_size() noexcept {
  return static_cast<std::size_t>(__stack_top - __stack_bottom) * sizeof *__stack_top;
}

}  // namespace tern_board
