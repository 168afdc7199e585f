// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// When a fence for a while counts. All that a flight asks of the times of its fences is asked here; proofs have their
// own.
#ifndef TERN_FLIGHT_FENCE_HOURS_HPP
#define TERN_FLIGHT_FENCE_HOURS_HPP

#include <cstdint>

#include "flight/flight_clock.hpp"
#include "tern/fence.hpp"

namespace tern {

/// Seconds from an instant.
struct FenceHours {
  double begin;
  double end;

  bool is_over() const noexcept { return !(end > 0.0); }
  /// It has not begun, and will.
  bool is_to_come() const noexcept { return begin > 0.0 && begin < end; }
};

/// No flight lasts as long, seconds.
constexpr double kAllHours = 1e300;

/// When a fence counts, seconds from `time`: by the clock's error longer than it says for a keep-out, and shorter for a
/// keep-in, both at its beginning and at its end.
inline FenceHours hours_of(const Fence& fence, std::int64_t time) noexcept {
  if (!is_timed(fence)) return {-kAllHours, kAllHours};
  const double later = fence.kind == FenceKind::kKeepIn ? fence.clock_error : -fence.clock_error;
  return {seconds_between(time, fence.from) + later, seconds_between(time, fence.until) - later};
}

}  // namespace tern

#endif
