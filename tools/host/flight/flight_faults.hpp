// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What goes wrong in a flight besides its sensor: ticks that are skipped, goals that move, obstacles that appear.
#ifndef TERN_HOST_FLIGHT_FLIGHT_FAULTS_HPP
#define TERN_HOST_FLIGHT_FLIGHT_FAULTS_HPP

#include <cstdint>
#include <vector>

#include "host/flight/curve_pieces.hpp"
#include "host/flight/flight_world.hpp"
#include "host/flight/noise.hpp"

namespace tern_host {

class FlightFaults {
 public:
  /// What appears becomes part of `truth`, which must outlive this.
  explicit FlightFaults(FlightWorld& truth);

  /// True where this tick is skipped; to be asked once a tick.
  bool skips_tick();
  /// True where the goal moves in this tick, or moves back for good: `goal` becomes its place.
  bool moves_goal(double t, tern::Vec3& goal);
  /// Lets appear what is due at time `t`, in nanoseconds. `commands` say what lies ahead. True where something appears.
  bool appear(std::int64_t t, const Commands& commands);
  const std::vector<Appearance>& appeared() const { return appeared_; }
  /// The world without what appeared.
  const FlightWorld& still_world() const { return still_; }

 private:
  void add(const Appearance& appearance);
  bool pillar_ahead(std::int64_t t, const Commands& commands, Cylinder& pillar) const;

  FlightWorld& truth_;
  FlightWorld still_;
  Noise tick_noise_, goal_noise_;
  int skips_left_ = 0;
  bool did_tick_ = false;
  bool goal_is_off_ = false;
  bool pillar_is_due_;
  std::vector<Appearance> due_;
  std::vector<Appearance> appeared_;
};

}  // namespace tern_host

#endif
