// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_PORT_CORTEX_M7_REGISTERS_HPP
#define TERN_PORT_CORTEX_M7_REGISTERS_HPP

#include <cstdint>

namespace tern_board {

/// A register of the processor's system control space.
inline volatile std::uint32_t& system_register(std::uintptr_t address) {
  return *reinterpret_cast<volatile std::uint32_t*>(address);
}

constexpr std::uintptr_t kSysTickControl = 0xE000E010;
constexpr std::uintptr_t kSysTickReload = 0xE000E014;
constexpr std::uintptr_t kSysTickValue = 0xE000E018;
constexpr std::uintptr_t kFaultStatusRegister = 0xE000ED28;  // CFSR: memory, bus and usage faults
constexpr std::uintptr_t kHardFaultStatus = 0xE000ED2C;      // HFSR
constexpr std::uintptr_t kMemoryFaultAddress = 0xE000ED34;   // MMFAR
constexpr std::uintptr_t kBusFaultAddress = 0xE000ED38;      // BFAR

}  // namespace tern_board

#endif
