// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How wide the free space is where a flight did not get through.
#ifndef TERN_HOST_FLIGHT_NARROW_PLACE_HPP
#define TERN_HOST_FLIGHT_NARROW_PLACE_HPP

#include <string>

#include "tern/flight.hpp"
#include "tern/grid.hpp"
#include "tern/vec3.hpp"

namespace tern_host {

/// The narrowest place of the widest way to the goal, where no plan may pass. Metres.
struct NarrowPlace {
  bool found = false;
  tern::Vec3 at{};           ///< the centre of its voxel, world frame
  double gap = 0.0;          ///< of the way from what is not known to be free
  char axis = 0;             ///< x, y or z: the row of free voxels along it is too short; 0: none is, but all together
  double free = 0.0;         ///< that row's length
  double vehicle = 0.0;      ///< the width that the vehicle needs: twice the distance that it keeps
  double width = 0.0;        ///< the width that a plan needs on this grid: that distance to both sides of a whole voxel
  double cell = 0.0;         ///< the edge of those voxels
  std::string text() const;  ///< in words; empty for none
};

/// The shortest such row across the widest way from where the vehicle rests; of equal ones, the first.
NarrowPlace narrow_place(const tern::Grid& safe, const tern::Vec3& rest, const tern::Vec3& goal);

}  // namespace tern_host

#endif
