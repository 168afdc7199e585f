// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How far the vehicle was measured to be off its plan, and how much of its speed that leaves.
#ifndef TERN_FLIGHT_STRAY_HPP
#define TERN_FLIGHT_STRAY_HPP

#include <cstdint>

#include "tern/flight.hpp"

namespace tern {

/// How much of the tracking margin is used up.
enum class MarginUse : std::uint8_t {
  kLittle = 0,  ///< at most 60 %: full speed
  kMuch,        ///< more: half of the speed
  kMost,        ///< more than 80 %: a quarter of the speed
  kAll,         ///< more than all: a quarter of the speed
};

struct Stray {
  double error;        ///< the last one that was measured, metres
  MarginUse use;       ///< what the speed follows: it rises at once, and falls by one after small errors alone
  std::int64_t large;  ///< when the last error was measured that was not small, or `use` fell
  bool is_too_fast;    ///< the committed plans may be faster than is left

  /// Takes an error that was measured at `time`. True if less speed is left than before.
  bool note(double measured, double margin, std::int64_t time) noexcept;
  /// A plan with the speed that is left, or a brake, replaces the committed ones.
  void note_plan() noexcept { is_too_fast = false; }

  /// The part of the speed limits that is left.
  double speed_share() const noexcept;
  /// The limits with what is left of those on speed.
  Limits limits(const Limits& full) const noexcept;
  /// The reason to report in flight; kNone if there is nothing to say.
  FlightReason reason() const noexcept;
};

}  // namespace tern

#endif
