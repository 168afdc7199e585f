// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_TESTS_GOLDEN_GOLDEN_HASH_HPP
#define TERN_TESTS_GOLDEN_GOLDEN_HASH_HPP

#include <cstdint>

namespace tern_golden {

/// The hash that every compiler, optimisation level and platform must reach. It changes only with a deliberate change
/// of what the planner computes, which the commit explains.
constexpr std::uint64_t kGoldenHash = 0x71edb71ee747224au;

/// The same for the commands of the flight of flight_run.hpp, in every profile: it reaches no capacity.
constexpr std::uint64_t kGoldenFlightHash = 0x267fa3e225c34731u;

/// The same for the fleet of fleet_run.hpp, which reaches none either.
constexpr std::uint64_t kGoldenFleetHash = 0xee9f82bd0b3d1b26u;
/// The same fleet with members by range.
constexpr std::uint64_t kGoldenFleetRangeHash = 0x1a40f1d0daeac040u;

}  // namespace tern_golden

#endif
