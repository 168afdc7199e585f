// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Times of the core, nanoseconds, and seconds.
#ifndef TERN_HOST_NANOSECONDS_HPP
#define TERN_HOST_NANOSECONDS_HPP

#include <cmath>
#include <cstdint>

namespace tern_host {

/// Seconds as nanoseconds, rounded.
inline std::int64_t nanoseconds(double seconds) {
  return std::llround(seconds * 1e9);
}

/// Nanoseconds as seconds.
inline double seconds_of(std::int64_t nanoseconds) {
  return 1e-9 * static_cast<double>(nanoseconds);
}

}  // namespace tern_host

#endif
