// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// SysTick, 24 bits counting down, widened to 64 by its interrupt. On a chip DWT CYCCNT counts every cycle and is the
// better choice; QEMU leaves that at 0, and under -icount with a fixed shift SysTick is the same in every run.
#include "cortex-m7/systick.hpp"

#include <cstdint>

#include "baremetal/board.hpp"
#include "cortex-m7/registers.hpp"

/// Another board with the same processor core names itself.
#ifndef TERN_BOARD_NAME
#define TERN_BOARD_NAME "Cortex-M7 bare metal (QEMU mps2-an500)"
#endif

namespace {

constexpr std::uint32_t kReload = 0xFFFFFF;
constexpr std::uint32_t kEnable = 1u << 0;
constexpr std::uint32_t kInterrupt = 1u << 1;
constexpr std::uint32_t kProcessorClock = 1u << 2;

volatile std::uint32_t turns;

}  // namespace

extern "C" void tern_board_systick() {
  turns = turns + 1;
}

namespace tern_board {

const char* name() noexcept {
  return TERN_BOARD_NAME;
}
const char* counter_unit() noexcept {
  return "SysTick cycles";
}

void start_counters() noexcept {
  system_register(kSysTickReload) = kReload;
  system_register(kSysTickValue) = 0;
  system_register(kSysTickControl) = kEnable | kInterrupt | kProcessorClock;
}

// A turn between the two reads is seen by the second; ends, because turns are 2^24 cycles apart.
std::uint64_t systick_cycles() noexcept {
  for (;;) {
    const std::uint32_t before = turns;
    const std::uint32_t left = system_register(kSysTickValue);
    if (turns == before) return std::uint64_t{before} * (std::uint64_t{kReload} + 1) + (kReload - left);
  }
}

std::uint64_t counter() noexcept {
  return systick_cycles();
}

}  // namespace tern_board
