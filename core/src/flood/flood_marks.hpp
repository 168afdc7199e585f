// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_FLOOD_FLOOD_MARKS_HPP
#define TERN_FLOOD_FLOOD_MARKS_HPP

#include <cstdint>

#include "base/work.hpp"
#include "flood/flood_lattice.hpp"
#include "tracks/thing.hpp"

namespace tern {

/// Clears the cells whose middles are nearer to a thing at a time than the needed distance and `more` metres. The
/// things are in the grid's local frame. Returns the operations that it took.
Operations clear_near_thing(const FloodLattice& lattice, const Grid& grid, const Things& things, const Track& track,
                            double time, double more, std::uint64_t* layer) noexcept;

/// The limits along an axis, > 0: m/s, m/s^2 and m/s^3.
struct FloodAxis {
  double fastest;
  double strongest;  ///< acceleration
  double sharpest;   ///< jerk; infinite if there is no limit
};

/// How a velocity is gained within the limits: at a steady acceleration, m/s^2, for `ramp` seconds. The acceleration
/// has to be taken up and down again, so this comes `delay` seconds later at its end, and half of that on average.
struct SpeedUp {
  double acceleration;
  double ramp;
  double delay;
};
SpeedUp speed_up(double gain, const FloodAxis& limits) noexcept;

/// A point that motion begins at, in the grid's local frame, and the limits along each axis.
struct FloodReach {
  Vec3 point;
  Vec3 velocity;
  Vec3 fastest;
  Vec3 strongest;
  Vec3 sharpest;
};

/// Clears the cells that cannot be reached from there within `time` seconds.
void clear_out_of_reach(const FloodLattice& lattice, const Grid& grid, const FloodReach& from, double time,
                        std::uint64_t* layer) noexcept;

}  // namespace tern

#endif
