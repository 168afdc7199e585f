// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a way needs to see: the voxels within the radius of it that were not seen.
#ifndef TERN_LOOKOUT_WANTED_HPP
#define TERN_LOOKOUT_WANTED_HPP

#include <cstdint>

#include "base/work.hpp"
#include "lookout/octets.hpp"
#include "tern/map.hpp"

namespace tern {

/// Voxels that a search for a lookout wants to see, at most. The first kDenseWanted are all that the first part of the
/// way needs, in its order. The others stand for the rest of the way, evenly.
constexpr std::int32_t kMaxWanted = 96;
constexpr std::int32_t kDenseWanted = 48;

struct WantedVoxel {
  Vec3 centre;      ///< world frame
  std::int32_t at;  ///< the place of the way that needs it
};

struct Wanted {
  WantedVoxel voxel[kMaxWanted];
  std::int32_t count;
  std::int32_t dense;

  void clear() noexcept { count = dense = 0; }
  /// Adds what place `at` of a way needs: all of it while the dense part has room, afterwards `share` voxels at most.
  /// `place`: local frame. Only voxels whose cube is less than `radius` away are needed.
  void add_around(const RollingMap& map, const Vec3& place, double radius, std::int32_t at, std::int32_t share,
                  Work& work) noexcept;
  /// Adds what a descent from `place` to the ground needs: unseen voxels less than `radius` away from the vertical line
  /// down to it, seen from above, and below them the highest ones that hold ground, where none was hit. `place`: local
  /// frame; `ground`: the height that the ground does not exceed, world frame.
  void add_site(const RollingMap& map, const Vec3& place, double radius, double ground, std::int32_t at,
                Work& work) noexcept;
  /// The mean of the dense voxels, and of all of them. There must be one.
  Vec3 middle(bool of_all) const noexcept;

 private:
  bool has(const Vec3& centre, double cell) const noexcept;
};

/// True if a voxel of the map's window was neither seen free nor hit.
bool is_unseen(const RollingMap& map, const Voxel& voxel) noexcept;
/// The same for the voxel at a place, world frame. False outside the window, of which nothing is known.
bool is_unseen_at(const RollingMap& map, const Vec3& place) noexcept;

}  // namespace tern

#endif
