// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How the vehicle would get on if it were smaller.
#ifndef TERN_HOST_FLIGHT_WIDEST_WAY_HPP
#define TERN_HOST_FLIGHT_WIDEST_WAY_HPP

#include <cstddef>
#include <vector>

#include "tern/grid.hpp"
#include "tern/vec3.hpp"

namespace tern_host {

/// True for a voxel of the grid that is not solid.
bool is_free(const tern::Grid& grid, const tern::Voxel& voxel);

/// The voxel beside this one along an axis, in the direction of `sign`, 1 or -1.
tern::Voxel neighbour(const tern::Voxel& voxel, int axis, int sign);

struct WidestWay {
  std::vector<tern::Voxel> voxels;  ///< empty: there is none
  std::vector<double> gaps;         ///< of each from the nearest that is not free, metres; at most what a plan needs
  std::size_t narrowest = 0;        ///< the one with the least gap; of equal ones, the middle one
};

/// Of all ways through free voxels, from the one at `start` (local frame) to one that a plan may pass and that is
/// nearer to `goal` than all that a plan reaches, by more than a wall takes: the one that stays furthest from
/// what is not free. If there is no such way, the same to the free voxel nearest to the goal. Empty if that is not
/// nearer either, or if the voxel at `start` is not free.
WidestWay widest_way(const tern::Grid& grid, const tern::Vec3& start, const tern::Vec3& goal);

}  // namespace tern_host

#endif
