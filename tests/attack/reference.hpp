// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What contract C5 says of every voxel, and which free voxels the grid connects, from the harness's own record.
#ifndef TERN_TESTS_ATTACK_REFERENCE_HPP
#define TERN_TESTS_ATTACK_REFERENCE_HPP

#include "attack/world.hpp"

namespace tern_attack {

enum class Space : std::uint8_t {
  kFree,
  kBlocked,
  kEither,  ///< so near to a tie that rounding decides; the grid may say either
};

/// One entry a voxel, x fastest.
std::vector<Space> blocked_layer(const World& world);

/// A number for each voxel, equal where free voxels are connected, -1 where a voxel is not free. Moves are those of
/// docs/search.md: 26 neighbours, a diagonal needs every voxel of its box. Such a diagonal can be walked along the
/// axes, so that moves along the axes connect the same.
std::vector<int> components(const World& world, const std::vector<std::uint8_t>& free);

/// The voxels that may count as the one that holds a point (local frame): docs/grid.md gives a point on a lattice plane
/// to the voxel above, on the boundary's upper face to the last one; several where the plane is met but for rounding.
std::vector<tern::Voxel> homes(const World& world, const Point& p);

/// The grid's own voxel of a world point, or if that is not free one that holds the point in a face; {-1, -1, -1} if
/// none is free. Across a thin boundary, paths may lead through either side.
tern::Voxel free_voxel_at(const World& world, const tern::Vec3& at);

/// Numbers of the components that a search from the exact point `p` (local frame) is bound to reach (docs/search.md):
/// its own voxel's where that is free; else those of the free voxels up to two away whose straight line from the point
/// keeps the radius. What holds for all homes.
std::vector<int> reachable(const World& world, const std::vector<int>& component, const Point& p);

bool share_one(const std::vector<int>& a, const std::vector<int>& b);

}  // namespace tern_attack

#endif
