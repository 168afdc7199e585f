// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Volumes in space and time that hold the tube of a plan: those of its operational intent.
#ifndef TERN_HOST_INTENT_TUBE_VOLUMES_HPP
#define TERN_HOST_INTENT_TUBE_VOLUMES_HPP

#include <vector>

#include "host/airspace/zone.hpp"
#include "host/intent/timed_path.hpp"

namespace tern_host {

struct TubeSettings {
  Instant epoch = 0;         ///< when the scenario's clock is 0
  double looseness = 10.0;   ///< m, horizontally and vertically: no place in a volume is farther from the tube
  double longest = 60.0;     ///< s, of the plan in one volume
  double clock_error = 0.0;  ///< s, by which the vehicle's clock may be off, to both sides
};

/// As few volumes as the settings allow, in order of time; each begins where the plan leaves the one before. Wherever
/// the vehicle is in its tube, at an instant that its clock may show, is in one of the volumes that hold then. Outlines
/// are convex polygons or circles; where the plan stays in place or climbs straight up, one circle will do for all of
/// its heights. Times are whole milliseconds. Throws std::invalid_argument with the reason and what to do: settings out
/// of range, a plan farther from the origin than a frame is good for, a looseness that is less than outlines take.
std::vector<Zone> tube_volumes(const TimedPath& path, const LocalFrame& frame, const TubeSettings& settings);

}  // namespace tern_host

#endif
