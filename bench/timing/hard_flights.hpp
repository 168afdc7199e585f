// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_BENCH_TIMING_HARD_FLIGHTS_HPP
#define TERN_BENCH_TIMING_HARD_FLIGHTS_HPP

#include <cstdint>

#include "golden/flight_run.hpp"
#include "golden/flight_ticks.hpp"

namespace tern_timing {

/// Room for each of the flights here and for the golden ones.
using FlightMemory = tern_golden::FlightMemory<200000, 100000>;

/// The longest tick of each kind. Where no tick was of a kind, there is no row.
void print_ticks(const char* name, const tern_golden::TickCosts& costs, std::uint32_t work_per_tick);

/// Flies through the hard worlds and prints the longest tick of each kind. False where a flight hardly commits a plan.
bool print_hard_flights(FlightMemory& memory);

}  // namespace tern_timing

#endif
