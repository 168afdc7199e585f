// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Things that move, and fences for a while, that have nothing to do with a plan because they are there at other times.
// Most likely their times are in another unit, or those of another clock.
#ifndef TERN_HOST_PRESENCE_HPP
#define TERN_HOST_PRESENCE_HPP

#include <string>
#include <vector>

#include "host/scenario.hpp"

namespace tern_host {

/// When something is there, s of one clock.
struct Presence {
  std::string name;
  double from;
  double until;  ///< infinite if it never leaves
};

/// Of all things and fences for a while of a scenario.
std::vector<Presence> presences_of(const Scenario& scenario);

/// "not there during the plan: late, keepout 3", of a plan with its rest from `begin` to `end`, s of the same clock.
/// Empty if all are there at some time. At most eight are named.
std::string absence_text(const std::vector<Presence>& presences, double begin, double end);

}  // namespace tern_host

#endif
