// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_FLIGHT_FLOWN_PLAN_HPP
#define TERN_HOST_FLIGHT_FLOWN_PLAN_HPP

#include <string>

#include "host/flight/simulated_flight.hpp"
#include "tern/trajectory.hpp"

namespace tern_host {

struct FinishedPlan {
  tern::Trajectory trajectory{};
  double tracking_margin = 0.0;  ///< that the plan leaves room for, metres; 0 where its file does not say
};

/// Reads a plan's file (docs/formats.md). Throws std::runtime_error where it has no trajectory.
FinishedPlan read_finished_plan(const std::string& path);

/// Flies a finished plan with the vehicle of the settings, with a constant yaw from its start towards its end, and
/// waits a second at the end. The result has what a vehicle can say: samples, way and tracking error.
FlightResult fly_plan(const tern::Trajectory& plan, const FlightSettings& settings);

}  // namespace tern_host

#endif
