// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// PMU event 0x08, instructions retired: under QEMU's -icount with a fixed shift it is exact and the same in every run,
// which no clock is. Event counters of ARMv8.0 are 32 bits wide and are widened here.
#include "baremetal-aarch64/counters.hpp"

#include "baremetal/board.hpp"
#include "tern_port/port.hpp"

namespace tern_board {
namespace {

constexpr std::uint64_t kInstructionsRetired = 0x08;
constexpr std::uint64_t kEventCounter0 = 1u << 0;
constexpr std::uint64_t kCycleCounter = 1u << 31;
// PMCR_EL0: enable, reset event counters, reset the cycle counter, 64-bit cycle overflow.
constexpr std::uint64_t kEnable = 1u << 0;
constexpr std::uint64_t kResetEvents = 1u << 1;
constexpr std::uint64_t kResetCycles = 1u << 2;
constexpr std::uint64_t kLongCycles = 1u << 6;

std::uint64_t wraps;  // of event counter 0, times 2^32

}  // namespace

const char* name() noexcept {
  return "aarch64 bare metal (QEMU virt, cortex-a57)";
}
const char* counter_unit() noexcept {
  return "instructions retired";
}

void start_counters() noexcept {
  asm volatile("msr pmevtyper0_el0, %0" : : "r"(kInstructionsRetired));
  asm volatile("msr pmccfiltr_el0, %0" : : "r"(std::uint64_t{0}));
  asm volatile("msr pmovsclr_el0, %0" : : "r"(kEventCounter0 | kCycleCounter));
  asm volatile("msr pmcntenset_el0, %0" : : "r"(kEventCounter0 | kCycleCounter));
  asm volatile("msr pmcr_el0, %0" : : "r"(kEnable | kResetEvents | kResetCycles | kLongCycles));
  asm volatile("isb");
}

// A wrap between two reads is seen by its overflow flag. The value comes first: a wrap after it raises the flag, and
// the value is then read again.
std::uint64_t instructions() noexcept {
  std::uint64_t value;
  std::uint64_t overflow;
  asm volatile("isb\n mrs %0, pmevcntr0_el0\n mrs %1, pmovsclr_el0" : "=&r"(value), "=r"(overflow) : : "memory");
  if ((overflow & kEventCounter0) != 0) {
    asm volatile("msr pmovsclr_el0, %1\n isb\n mrs %0, pmevcntr0_el0" : "=r"(value) : "r"(kEventCounter0) : "memory");
    wraps += std::uint64_t{1} << 32;
  }
  return wraps + (value & 0xFFFFFFFFu);
}

std::uint64_t cycles() noexcept {
  std::uint64_t value;
  asm volatile("isb\n mrs %0, pmccntr_el0" : "=r"(value) : : "memory");
  return value;
}

std::uint64_t counter() noexcept {
  return instructions();
}

}  // namespace tern_board
