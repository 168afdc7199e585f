// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How wide the free space is beside what is in the way of a flight.
#ifndef TERN_HOST_FLIGHT_NARROW_PLACE_HPP
#define TERN_HOST_FLIGHT_NARROW_PLACE_HPP

#include <string>

#include "tern/flight.hpp"
#include "tern/grid.hpp"
#include "tern/vec3.hpp"

namespace tern_host {

/// A row of free voxels between two that are not free, along an axis. A plan may pass none of them. Metres.
struct NarrowPlace {
  char axis = 0;             ///< x, y or z; 0: there is none
  bool at_vehicle = false;   ///< where the vehicle rests; otherwise beside the voxel that is in the way
  double free = 0.0;         ///< its width
  double vehicle = 0.0;      ///< what the vehicle needs: twice the distance that it keeps
  double plan = 0.0;         ///< what a plan needs on this grid: that distance to both sides of a whole voxel
  double cell = 0.0;         ///< the edge of those voxels
  std::string text() const;  ///< in words; empty for none
};

/// If a voxel is in the way: the narrowest such row through the place where the vehicle rests. If there is none, the
/// widest one that begins beside the voxel in the way.
NarrowPlace narrow_place(const tern::Grid& safe, const tern::FlightReport& report, const tern::Vec3& rest);

}  // namespace tern_host

#endif
