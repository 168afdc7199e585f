// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_TESTS_GOLDEN_GOLDEN_HASH_HPP
#define TERN_TESTS_GOLDEN_GOLDEN_HASH_HPP

#include <cstdint>

namespace tern_golden {

/// The hash that every compiler, optimisation level and platform must reach. It changes only with a deliberate change
/// of what the planner computes, which the commit explains.
constexpr std::uint64_t kGoldenHash = 0x71edb71ee747224au;

/// The same for the commands of the flight of flight_run.hpp. Capacities decide how much work a plan takes, and so when
/// the next one begins: the hash of the mcu profile is that of a Cortex-M7.
#if defined(TERN_PROFILE_MCU)
constexpr std::uint64_t kGoldenFlightHash = 0x29fe63482173e67eu;
#else
constexpr std::uint64_t kGoldenFlightHash = 0xd052903fc2c68e9fu;
#endif

/// The same for the fleet of fleet_run.hpp, which reaches none either.
constexpr std::uint64_t kGoldenFleetHash = 0xee9f82bd0b3d1b26u;
/// The same fleet with members by range.
constexpr std::uint64_t kGoldenFleetRangeHash = 0x1a40f1d0daeac040u;

}  // namespace tern_golden

#endif
