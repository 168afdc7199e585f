// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What an operator should know of a flight that does not arrive.
#ifndef TERN_ONBOARD_PROGRESS_HPP
#define TERN_ONBOARD_PROGRESS_HPP

#include <cstdint>
#include <string>

#include "tern/flight.hpp"
#include "tern_onboard/settings.hpp"

namespace tern_onboard {

/// The least width of a way that plans fly through, metres, if the sensor sees all of it and the voxels lie well: an
/// odd number of voxels. docs/map.md (Gaps) has what comes on top.
double narrowest_way(const MapSettings& map);
/// "a way must be more than 1.50 m wide", and what it follows from.
std::string narrowest_way_text(const MapSettings& map);

/// What to do for narrower ones.
constexpr char kNarrowerWays[] =
    "For a narrower one, lower speed and acceleration, or improve the autopilot's gains, until the vehicle strays "
    "less; "
    "then lower tracking_margin to that";

/// Notices when a flight rests before its goal, or comes no nearer to it for long.
class Progress {
 public:
  /// The goal or the clock is a new one.
  void restart() { *this = {}; }
  /// After a tick: what to say, or nothing. `away`: from the goal, m.
  const char* note(const tern::FlightReport& report, double away, std::int64_t now);

 private:
  bool begun_ = false, rested_ = false;
  double nearest_ = 0.0;         // m from the goal
  std::int64_t nearest_at_ = 0;  // when it was so near, or when it was said that it is no nearer
};

}  // namespace tern_onboard

#endif
