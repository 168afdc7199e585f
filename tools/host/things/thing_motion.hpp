// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where things truly are: a function of time, but for hunters, which depend on the vehicle.
#ifndef TERN_HOST_THINGS_THING_MOTION_HPP
#define TERN_HOST_THINGS_THING_MOTION_HPP

#include <vector>

#include "host/things/thing.hpp"

namespace tern_host {

/// World frame, m and m/s.
struct ThingState {
  tern::Vec3 position;
  tern::Vec3 velocity;
};

/// A part of a motion with one acceleration. Times are s.
struct SteadyPart {
  double begin;
  ThingState from;
  tern::Vec3 acceleration;

  ThingState at(double t) const;
};

/// The parts of a walk in order, the first at time 0. The last one has no end.
std::vector<SteadyPart> parts_of(const Walk& walk);
/// Why a walk cannot be: too short a way for its turns. Empty where it can.
std::string walk_fault(const Walk& walk);

class ThingMotion {
 public:
  explicit ThingMotion(const Thing& thing);

  /// At time t, s. A hunter knows the time since its last step alone.
  ThingState at(double t) const;
  /// A hunter's next `step` seconds from time t on, while the vehicle is at `prey`. Other things do nothing.
  void hunt(double t, double step, const tern::Vec3& prey);
  /// What the motion never exceeds.
  const ThingBounds& bounds() const { return bounds_; }

 private:
  std::variant<Trefoil, Walk, Hunt> motion_;
  std::vector<SteadyPart> parts_;  ///< of a walk
  double period_ = 0.0;            ///< of a loop, s
  SteadyPart chase_{};             ///< of a hunter
  ThingBounds bounds_;
};

/// Of all things, in their order.
std::vector<ThingMotion> motions_of(const std::vector<Thing>& things);

}  // namespace tern_host

#endif
