// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// One flight of a companion program with the simulated autopilot, through a world that only the simulation knows.
#ifndef TERN_AUTOPILOT_COMPANION_FLIGHT_HPP
#define TERN_AUTOPILOT_COMPANION_FLIGHT_HPP

#include <functional>
#include <string>
#include <vector>

#include "autopilot/companion_process.hpp"
#include "autopilot/simulated_autopilot.hpp"
#include "host/flight/flight_world.hpp"

namespace tern_autopilot {

/// What the pilot and the world do, at each step. `t`: seconds.
struct FlightHands {
  SimulatedAutopilot& autopilot;
  CompanionProcess& companion;
  bool& camera_works;
};

struct CompanionFlight {
  std::string program;                 ///< path of tern_companion
  std::vector<std::string> arguments;  ///< more than those that follow from the world; they win
  AutopilotSettings autopilot;
  std::string sensors = "camera";  ///< as BodySensors has it
  bool goal_by_link = false;       ///< the program is not told the goal when it starts; otherwise it ends there
  bool real_time = false;          ///< by the clock, with the delays of this computer; otherwise in lockstep
  double after_end = 0.0;          ///< s for which the autopilot flies on once the program has ended
  /// Called at each step; empty: after a second it is armed and in the air, and from then on the pilot tries the
  /// switch.
  std::function<void(double t, const FlightHands&)> pilot;
};

struct FlightOutcome {
  bool touched = false;    ///< the body touched something of the true world
  double clearance = 1e9;  ///< least distance of the body from anything, m
  double time = 0.0;       ///< s
  double length = 0.0;     ///< m
  double from_goal = 0.0;  ///< where it ended, m
  double speed_at_end = 0.0;
  int exit_status = -1;  ///< of the program; -1: it had to be ended
  AutopilotCounts counts;
  std::string said;                               ///< by the program
  std::vector<tern_companion::StatusText> texts;  ///< for the ground station
};

/// Settings of worlds that a PX4 with default gains can fly, for read_flight_world().
std::vector<std::string> companion_world_settings();

/// The pilot of most flights: arms, is in the air a second later, and tries the switch until the autopilot takes it.
void plain_pilot(double t, const FlightHands& hands);

/// Flies until the program ends and `after_end` is over, or the world's time limit. Throws std::runtime_error if the
/// program does not start or does not answer.
FlightOutcome fly(const tern_host::FlightWorld& world, const CompanionFlight& flight);

}  // namespace tern_autopilot

#endif
