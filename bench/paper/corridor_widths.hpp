// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_BENCH_CORRIDOR_WIDTHS_HPP
#define TERN_BENCH_CORRIDOR_WIDTHS_HPP

#include "host/session.hpp"

namespace tern_bench {

/// How wide a corridor is, measured against the passages that it runs through. The paper defines no such ratio, so two:
struct CorridorWidths {
  double used = 0.0;     ///< mean of corridor over passage along the same line, at most 1 where the corridor is safe
  double extreme = 0.0;  ///< mean over the segments of the corridor's widest over the passage's narrowest line
  double passage = 0.0;  ///< narrowest passage on the way, metres, for the robot's centre
  double over = 0.0;     ///< most by which the corridor reached past a passage's end, metres
};

/// Lines across each segment, at nine places and in eight directions. A passage ends where the robot's centre would
/// come nearer than the radius to a block or leave the boundary; lines along which it is free for 2 m both ways are
/// left out, because there the local box ends the corridor and nothing else does.
CorridorWidths measure_widths(const tern_host::PlanResult& plan);

}  // namespace tern_bench

#endif
