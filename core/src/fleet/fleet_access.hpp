// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The way from a Fleet to its memory.
#ifndef TERN_FLEET_FLEET_ACCESS_HPP
#define TERN_FLEET_FLEET_ACCESS_HPP

#include <new>

#include "fleet/fleet_memory.hpp"
#include "tern/fleet.hpp"

namespace tern {

struct FleetAccess {
  static std::uint64_t* words(Fleet& fleet) { return fleet.memory_; }
  static const std::uint64_t* words(const Fleet& fleet) { return fleet.memory_; }
};

/// Null before begin().
inline FleetMemory* memory_of(Fleet& fleet) {
  FleetMemory* const memory = std::launder(reinterpret_cast<FleetMemory*>(FleetAccess::words(fleet)));
  return memory->has_begun ? memory : nullptr;
}
inline const FleetMemory* memory_of(const Fleet& fleet) {
  const FleetMemory* const memory = std::launder(reinterpret_cast<const FleetMemory*>(FleetAccess::words(fleet)));
  return memory->has_begun ? memory : nullptr;
}

}  // namespace tern

#endif
