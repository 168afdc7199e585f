// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Brakes at once, to compare a flight's with. Like all that is flown they are smooth: position to jerk are continuous,
// and the limits hold.
#ifndef TERN_HOST_FLIGHT_IMMEDIATE_BRAKE_HPP
#define TERN_HOST_FLIGHT_IMMEDIATE_BRAKE_HPP

#include <cstdint>
#include <vector>

#include "host/flight/curve_pieces.hpp"
#include "tern/request.hpp"

namespace tern_host {

struct BrakeMoment {
  tern::Vec3 position;
  double speed;  ///< m/s
};

/// A millisecond apart, from some time on up to the rest.
using BrakeWay = std::vector<BrakeMoment>;

/// What is commanded from `now` on, but from `begin` on time along it goes slower and slower, until it stands still. It
/// is as sharp as the limits allow. Nanoseconds.
BrakeWay brake_along(const Commands& commands, std::int64_t now, std::int64_t begin, const tern::Limits& limits);

/// The same with a brake straight ahead; empty where none keeps the limits.
BrakeWay brake_straight(const Commands& commands, std::int64_t now, std::int64_t begin, const tern::Limits& limits);

}  // namespace tern_host

#endif
