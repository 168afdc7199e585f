// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where a simulated vehicle stands on the ground: at the start, at the goal, or at both. Over such a place, what is no
// higher than the ground there is no contact.
#ifndef TERN_HOST_FLIGHT_FLIGHT_PADS_HPP
#define TERN_HOST_FLIGHT_FLIGHT_PADS_HPP

#include <vector>

#include "host/flight/flight_world.hpp"
#include "tern/vec3.hpp"

namespace tern_host {

struct Pad {
  tern::Vec3 place;  ///< of the vehicle's centre when it stands
  double ground;     ///< the height that the ground there does not exceed
};

/// How far aside of a pad a command may be that leads straight up from it or down to it, metres.
constexpr double kOverPad = 1e-6;

std::vector<Pad> pads_of(const FlightWorld& world);

/// The pad that a point is above or on, at most `aside` metres off its vertical line; null if there is none.
const Pad* pad_below(const std::vector<Pad>& pads, const tern::Vec3& point, double aside);

/// As clearance(), but over a pad things whose top is no higher than its ground do not count.
double clearance_of_flight(const FlightWorld& world, const tern::Vec3& point, double aside);

/// Throws RecordError if something in the world is in the column that is stated to be free, or the ground where the
/// vehicle stands is higher than it is stated to be.
void refuse_untrue_ground(const FlightWorld& world);

}  // namespace tern_host

#endif
