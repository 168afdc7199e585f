// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What keeps the flight from going on, for its report and for lookouts.
#ifndef TERN_FLIGHT_BLOCKED_HPP
#define TERN_FLIGHT_BLOCKED_HPP

#include <cstdint>

#include "flight/aim.hpp"
#include "flight/draft.hpp"
#include "flight/flight_facts.hpp"
#include "tern/flight.hpp"
#include "tern/grid.hpp"
#include "tern/vec3.hpp"

namespace tern {

struct NearestSolid {
  bool found;
  Voxel voxel;
  double distance;      ///< of the place from the voxel's cube, metres
  std::uint32_t words;  ///< words of the obstacle layer that were read, plus rows
};

/// The marked voxel whose cube is nearest to a place of the local frame, of those less than `most` away. Of equal
/// ones, the one with the least z, then y. Reads the rows within that distance.
NearestSolid nearest_solid(const Grid& grid, const Vec3& local, double most) noexcept;

/// What is in the way, and where, world frame.
struct Blockage {
  BlockedBy by;
  Vec3 at;
  std::int32_t fence;  ///< its index for kFence, otherwise kNoFence

  /// It goes away by itself: something that moves, a keep-out that will end, a chain of keep-ins of which one will
  /// begin.
  bool is_temporary(const FlightFacts& flight, Work& work) const noexcept;
  bool is_voxel() const noexcept { return by == BlockedBy::kObstacle || by == BlockedBy::kUnseen; }
  /// Notes the solid voxel of the safe or route grid that is too near to a place. Returns its distance, or more than
  /// the radius if there is none; kAnywhere while the map slides, because nothing is known of it then.
  double note_near(const RollingMap& map, const Vec3& place, const Grid& grid, Work& work) noexcept;
  /// True if the vehicle may descend to a place, as far as is known: nothing was seen above the ground there, and the
  /// ground was stated or seen, no higher than `ground` and at most two voxels deeper. Otherwise notes what is in the
  /// way or where the ground was not seen; kNothing if it was seen not to be there.
  bool note_site(const RollingMap& map, const Vec3& place, double ground, Work& work) noexcept;
  /// Notes what ended the proof of the draft.
  void note_unproven(const RollingMap& map, const Draft& draft) noexcept;
  /// Notes what is in the way of a plan that failed, unless an earlier proof named a voxel that is still solid.
  void note_no_plan(const FlightFacts& flight, const Aim& aim, const Report& found, Work& work) noexcept;
  /// Notes what comes next on the straight line from the reachable point to the target.
  void note_beyond(const FlightFacts& flight, const Aim& aim, const Vec3& reachable, Work& work) noexcept;
};

/// True if what moves, or a fence for a while, is why there is no plan.
bool is_by_time(Status status) noexcept;

constexpr Blockage kNoBlockage{BlockedBy::kNothing, kZero, kNoFence};

/// The blockage by a voxel that is solid in the safe grid: kObstacle if something was seen or marked in it, else
/// kUnseen.
Blockage block_at(const RollingMap& map, const Voxel& voxel) noexcept;

}  // namespace tern

#endif
