// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A fault is reported and ends the run.
#include <cstdint>

#include "baremetal/board.hpp"
#include "cortex-m7/registers.hpp"

namespace {

using tern_board::hex;
using tern_board::print;
using tern_board::system_register;

struct Bit {
  std::uint32_t mask;
  const char* meaning;
};

// CFSR. The stacking faults mean that the program's stack is exhausted.
constexpr std::uint32_t kStackingFaults = (1u << 4) | (1u << 12);
constexpr Bit kBits[] = {
    {1u << 0, "instruction fetch refused"},
    {1u << 1, "data access refused"},
    {1u << 4, "stack exhausted (memory fault when stacking)"},
    {1u << 8, "instruction bus error"},
    {1u << 9, "precise data bus error"},
    {1u << 10, "imprecise data bus error"},
    {1u << 12, "stack exhausted (bus fault when stacking)"},
    {1u << 16, "undefined instruction"},
    {1u << 17, "invalid state: a call of an address without its Thumb bit"},
    {1u << 19, "floating point is off (CPACR)"},
    {1u << 24, "unaligned access"},
    {1u << 25, "division by zero"},
};
constexpr std::uint32_t kMemoryAddressValid = 1u << 7;
constexpr std::uint32_t kBusAddressValid = 1u << 15;

// The frame that the processor pushes: r0-r3, r12, lr, pc, xpsr.
constexpr int kFrameLink = 5;
constexpr int kFrameCounter = 6;

}  // namespace

extern "C" [[noreturn]] void tern_board_fault(std::uint32_t exception, const std::uint32_t* frame) {
  const std::uint32_t status = system_register(tern_board::kFaultStatusRegister);
  print("FAULT: exception ", exception, ", status 0x", hex(status, 8), ", hard fault status 0x",
        hex(system_register(tern_board::kHardFaultStatus), 8), "\n");
  for (const Bit& bit : kBits) {
    if ((status & bit.mask) != 0) print("  ", bit.meaning, "\n");
  }
  if ((status & kMemoryAddressValid) != 0) {
    print("  address 0x", hex(system_register(tern_board::kMemoryFaultAddress), 8), "\n");
  }
  if ((status & kBusAddressValid) != 0) {
    print("  address 0x", hex(system_register(tern_board::kBusFaultAddress), 8), "\n");
  }
  // Where stacking failed there is no frame to read.
  if ((status & kStackingFaults) == 0) {
    print("  at 0x", hex(frame[kFrameCounter], 8), ", called from 0x", hex(frame[kFrameLink], 8), "\n");
  }
  print("  stack 0x", hex(reinterpret_cast<std::uintptr_t>(frame), 8), "\n");
  tern_board::leave(tern_board::kFaultStatus);
}
