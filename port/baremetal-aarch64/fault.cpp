// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A fault is reported and ends the run. Compiled without floating-point registers: where the FPU itself is off, a
// handler that touched one would trap again.
#include <cstdint>

#include "baremetal/board.hpp"

namespace {

const char* kind(std::uint64_t vector) {
  static const char* const kKinds[] = {"synchronous", "interrupt", "fast interrupt", "system error"};
  return kKinds[vector & 3];
}

/// The exception classes that a planner can meet (ESR_EL1, bits 31 to 26).
const char* meaning(std::uint64_t exception_class) {
  switch (exception_class) {
    case 0x00:
      return "undefined instruction";
    case 0x07:
      return "floating point is off (CPACR_EL1)";
    case 0x0E:
      return "illegal execution state";
    case 0x20:
    case 0x21:
      return "instruction abort";
    case 0x22:
      return "misaligned program counter";
    case 0x24:
    case 0x25:
      return "data abort";
    case 0x26:
      return "misaligned stack pointer";
    case 0x2C:
      return "floating-point exception";
    case 0x3C:
      return "breakpoint";
    default:
      return "see the architecture manual, ESR_EL1";
  }
}

}  // namespace

extern "C" [[noreturn]] void tern_board_fault(std::uint64_t vector, std::uint64_t stack, std::uint64_t link) {
  std::uint64_t syndrome;
  std::uint64_t where;
  std::uint64_t address;
  asm volatile("mrs %0, esr_el1" : "=r"(syndrome));
  asm volatile("mrs %0, elr_el1" : "=r"(where));
  asm volatile("mrs %0, far_el1" : "=r"(address));
  const std::uint64_t exception_class = (syndrome >> 26) & 0x3F;
  using tern_board::hex;
  tern_board::print("FAULT: ", kind(vector), ", ", meaning(exception_class), " (class 0x", hex(exception_class, 2),
                    ", vector ", vector, ")\n  at 0x", hex(where, 16), ", called from 0x", hex(link, 16),
                    "\n  address 0x", hex(address, 16), ", syndrome 0x", hex(syndrome, 8), ", stack 0x", hex(stack, 16),
                    "\n");
  tern_board::leave(tern_board::kFaultStatus);
}
