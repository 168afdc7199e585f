// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The flight behind a handle of the C interface.
#ifndef TERN_FLIGHT_FLIGHT_HANDLE_HPP
#define TERN_FLIGHT_FLIGHT_HANDLE_HPP

#include <cstdint>
#include <new>

#include "tern/tern_flight.h"

namespace tern {

/// A tern_flight's first word once a flight was started there; the flight follows it.
constexpr std::uint64_t kFlightTag = 0x7465726E2D666C79u;

/// The flight in this memory, or one that was not started if there is none. The memory may never have been written;
/// reading its first word as volatile makes sure that the word has one value.
inline Flight object(const tern_flight* flight) {
  if (flight == nullptr || *static_cast<const volatile std::uint64_t*>(flight->opaque) != kFlightTag) return Flight{};
  return *std::launder(reinterpret_cast<const Flight*>(flight->opaque + 1));
}

}  // namespace tern

#endif
