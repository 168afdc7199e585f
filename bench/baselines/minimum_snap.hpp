// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Ordinary minimum-snap polynomials, what the paper's Table 7 compares Bezier curves with: through every waypoint,
// blind to obstacles and limits, which are looked at afterwards and mended by iteration.
#ifndef TERN_BENCH_MINIMUM_SNAP_HPP
#define TERN_BENCH_MINIMUM_SNAP_HPP

#include <vector>

#include "host/scenario.hpp"
#include "tern/trajectory.hpp"

namespace tern_bench {

/// The one trajectory of degree 7 that goes through the waypoints with these durations (seconds, one a segment), rests
/// at both ends, is continuous to jerk, and has the least integral of |snap|^2. Closed form: velocity, acceleration and
/// jerk at the interior waypoints solve one linear system. World frame. Throws std::invalid_argument for fewer than two
/// waypoints, a wrong number of durations, one that is not positive, or more than tern::kMaxSegments.
tern::Trajectory minimum_snap(const std::vector<tern::Vec3>& waypoints, const std::vector<double>& durations);

/// Its quadratic form on [0, 1]: the integral of the squared fourth derivative from position, velocity, acceleration
/// and jerk at 0, then at 1.
void snap_form_of_unit_segment(double form[8][8]);

/// What mending came to.
struct MendedPolynomial {
  tern::Trajectory trajectory;
  int solves = 0;      ///< linear systems solved, the first included
  int inserted = 0;    ///< waypoints put into the middle of segments that hit something
  bool clear = false;  ///< keeps the scenario's radius from every block at every sample
};

/// As the paper has it (Section 3.4): solve, look for collisions along the curve, put a waypoint into the middle of the
/// straight leg of each segment that has one and halve its time, solve again; until none is left, `rounds` are over or
/// tern::kMaxSegments are used.
MendedPolynomial mend_collisions(std::vector<tern::Vec3> waypoints, std::vector<double> durations,
                                 const tern_host::Scenario& scenario, int rounds);

/// The same path flown so slowly that no axis exceeds its limits: all durations times one factor (below 1 where it
/// could be faster). Peaks are found by sampling.
tern::Trajectory stretched_to_limits(const tern::Trajectory& trajectory, const tern_host::Scenario& scenario);

}  // namespace tern_bench

#endif
