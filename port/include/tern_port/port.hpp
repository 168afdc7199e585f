// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The few things that Tern asks of a platform. The core never calls them: whoever runs the core hands ticks() to
// Planner::set_clock, and uses the rest around it. One folder a platform implements this header.
#ifndef TERN_PORT_PORT_HPP
#define TERN_PORT_PORT_HPP

#include <cstdint>

namespace tern_port {

/// Nanoseconds of a clock that never runs backwards, from an arbitrary start.
std::uint64_t monotonic_nanoseconds() noexcept;

/// The platform's finest monotonic counter, in the shape of tern::ClockFn. `context` is not used.
std::uint64_t ticks(void* context) noexcept;

/// Ticks a second, constant while the program runs, > 0.
double ticks_per_second() noexcept;

}  // namespace tern_port

#endif
