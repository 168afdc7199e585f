// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How fast to fly where things that move may come from beyond the range of what reports them.
#ifndef TERN_FROM_BEYOND_HPP
#define TERN_FROM_BEYOND_HPP

#include "tern/flight.hpp"
#include "tern/request.hpp"
#include "tern/status.hpp"

namespace tern {

/// What may come from beyond the range of a detector.
struct FromBeyond {
  /// Metres, > 0: within this distance of the vehicle, a thing's centre is measured at the next scan.
  double range;
  /// Seconds, >= 0: from one scan to the next, and from a scan to Flight::update_track().
  double delay;
  /// m/s, >= 0: its largest speed. Its tracks have that as their `reach`.
  double speed;
  /// Metres, >= 0: from its centre to its farthest point, and the error of its measured place.
  double size;
};

/// Lowers the limits of speed until a vehicle that first hears of such a thing is at rest before the thing can touch
/// it: the brake straight ahead that it then begins is proven with all that the thing may do. All limits of speed are
/// multiplied by the same number, 1 at most. `spec`: how the flight is flown; `clearance`: MapSpec::radius +
/// MapSpec::tracking_margin, metres; `room`: memory for a brake, whose content is lost. kOk; or a refusal, which leaves
/// `limits` as it was: kNonFiniteInput; kInvalidArgument (a value out of range, or a limit on body rates: a brake that
/// exceeds it gives way to a gentler one, which is not counted here); kLimitsInvalid (the limits are out of range, or
/// the range is so short that not even a hundredth of the speed is slow enough).
Status limit_speed(const FromBeyond& what, const FlightSpec& spec, double clearance, Limits& limits,
                   Trajectory& room) noexcept;

}  // namespace tern

#endif
