// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Rays through a world, one upright plane at a time: what a plane meets is found once for all of its rays.
#ifndef TERN_HOST_FLIGHT_RAY_FAN_HPP
#define TERN_HOST_FLIGHT_RAY_FAN_HPP

#include <vector>

#include "host/flight/flight_world.hpp"

namespace tern_host {

/// What an upright half-plane cuts out of a thing: two distances along the ground and two heights.
struct Slab {
  double enter, leave, bottom, top;
};

/// What is nearer than `reach` along the ground, and so may be seen: most of a world is not. Blocks, cylinders and
/// boundary alone.
FlightWorld nearby(const FlightWorld& world, const tern::Vec3& eye, double reach);

/// The rays from `eye` in the upright half-plane that contains the horizontal direction (x, y), of any length.
/// Distances are in that length, `far` at most.
class RayFan {
 public:
  RayFan(const FlightWorld& near, const tern::Vec3& eye, double far, double x, double y);

  /// Distance along the ground at which the ray that falls by `down` for each unit of it meets something, or leaves the
  /// boundary.
  double distance(double down) const;

 private:
  double height_;
  Slab room_;
  std::vector<Slab> slabs_;  ///< nearest first
};

}  // namespace tern_host

#endif
