// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Everything in the way of a plan: the voxels of a grid, and convex solids. Every stage asks this one type. It knows
// geometry alone, and not why a solid is there. Local frame, metres.
#ifndef TERN_WORLD_WORLD_HPP
#define TERN_WORLD_WORLD_HPP

#include <cstdint>

#include "tern/grid.hpp"
#include "world/solids.hpp"

namespace tern {

/// The least value of normal . p over the box.
double least_over(const Box& box, const Vec3& normal) noexcept;

/// A view: whoever made it owns the grid and the solids, which must not change while it is used. Cheap to copy.
///
/// Walls: half-spaces that the centre stays in. Solids: bodies that the centre keeps its clearance from, as from
/// obstacles. Both count to within touching(). Indices are those of the request's list.
class World {
 public:
  /// A world of voxels alone.
  explicit World(const Grid& voxels) noexcept : voxels_(&voxels), solids_(nullptr) {}
  /// Before a search, the blocked layer of `voxels` must include the voxels that walls and solids block.
  World(const Grid& voxels, const Solids& solids) noexcept : voxels_(&voxels), solids_(&solids) {}

  /// The obstacle layer holds marked voxels alone. The blocked layer holds everything that is in the way.
  const Grid& voxels() const noexcept { return *voxels_; }
  const GridSpec& spec() const noexcept { return voxels_->spec(); }

  /// Metres by which a point may come closer than the clearance to anything.
  double touching() const noexcept;

  /// False: a world of voxels alone.
  bool has_solids() const noexcept { return solids_ != nullptr; }
  int wall_count() const noexcept { return solids_ != nullptr ? solids_->wall_count : 0; }
  const Halfspace& wall(int k) const noexcept { return solids_->walls[k]; }
  int solid_count() const noexcept { return solids_ != nullptr ? solids_->solid_count : 0; }
  ConvexSolid solid(int k) const noexcept { return solid_of(*solids_, solids_->parts[k]); }

  /// The index of the first wall or solid that the segment breaks (equal ends make a point). Walls are tested first.
  /// kNoSolid if it breaks none.
  std::int32_t first_broken(const Vec3& from, const Vec3& to) const noexcept;
  /// The index of the first wall or solid that the closed cube of a voxel breaks. The cube breaks a wall that does not
  /// contain all of the cube. It breaks a solid unless it lies, by the clearance, beyond a face of the solid, or beyond
  /// the solid along an axis. kNoSolid if it breaks none: then the blocked layer leaves a voxel with this cube free
  /// (world/solid_layer.hpp).
  std::int32_t first_over(const Box& cube) const noexcept;

  /// True if the segment, or the cube, breaks no wall and no solid.
  bool solids_clear(const Vec3& from, const Vec3& to) const noexcept { return first_broken(from, to) == kNoSolid; }
  bool solids_clear(const Box& cube) const noexcept { return first_over(cube) == kNoSolid; }
  /// True if the segment also keeps the clearance from all obstacles and stays in the boundary, as segment_clear.
  bool line_clear(const Vec3& from, const Vec3& to) const noexcept;

 private:
  const Grid* voxels_;
  const Solids* solids_;  // null: none
};

}  // namespace tern

#endif
