// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "baremetal/semihosting.hpp"

#include <cstdint>

namespace tern_board {
namespace {

constexpr int kSysWrite0 = 0x04;
constexpr int kSysGetCommandLine = 0x15;
constexpr int kSysExitExtended = 0x20;
constexpr std::uintptr_t kApplicationExit = 0x20026;

/// One call: operation and a pointer to its parameters in, result out. The trap's immediate is the interface's.
std::intptr_t call(int operation, const void* parameters) noexcept {
#if defined(__aarch64__)
  register std::intptr_t x0 asm("x0") = operation;
  register const void* x1 asm("x1") = parameters;
  asm volatile("hlt #0xf000" : "+r"(x0) : "r"(x1) : "memory");
  return x0;
#else
  register std::intptr_t r0 asm("r0") = operation;
  register const void* r1 asm("r1") = parameters;
  asm volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
  return r0;
#endif
}

}  // namespace

void write(const char* text) noexcept {
  call(kSysWrite0, text);
}

void leave(int status) noexcept {
  const std::uintptr_t block[2] = {kApplicationExit, static_cast<std::uintptr_t>(status)};
  // A debugger may let the processor go on: stay here then.
  for (;;) call(kSysExitExtended, block);
}

bool command_line(char* out, int size) noexcept {
  struct {
    char* text;
    std::uintptr_t length;
  } block = {out, static_cast<std::uintptr_t>(size)};
  out[0] = '\0';
  return call(kSysGetCommandLine, &block) == 0;
}

}  // namespace tern_board
