// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_NEAREST_THING_HPP
#define TERN_HOST_NEAREST_THING_HPP

#include <cstdint>
#include <string>

#include "host/scenario.hpp"
#include "tern/trajectory.hpp"

namespace tern_host {

/// The thing that moves, or keep-out box for a while, whose tube a plan comes nearest to.
struct NearestThing {
  std::int32_t index = -1;  ///< -1: none is there during the plan
  double gap = 0.0;         ///< m, of the vehicle's centre
  double when = 0.0;        ///< s since the plan's beginning
};

/// From samples, the nearest of which are refined: for people to read. `tern verify` proves it.
NearestThing nearest_thing(const tern::Trajectory& plan, const Scenario& scenario);

/// "nearest man at 0.312 m"; empty without a thing.
std::string nearest_thing_text(const NearestThing& nearest, const Scenario& scenario);

}  // namespace tern_host

#endif
