// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a flight remembers of its lookouts: voxels that were looked at and not seen, with the directions from which, and
// lookouts that led to nothing. A voxel that was not seen from three directions is hopeless: glass, or the inside of a
// thing.
#ifndef TERN_LOOKOUT_TRIED_HPP
#define TERN_LOOKOUT_TRIED_HPP

#include <cstdint>

#include "tern/flight_report.hpp"
#include "tern/map.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// Voxels and lookouts that are remembered. New ones take the place of the oldest.
constexpr std::int32_t kTriedVoxels = 64;
constexpr std::int32_t kFailedLookouts = 16;
/// So many directions make a voxel hopeless.
constexpr std::int32_t kHopelessAfter = 3;

struct TriedVoxel {
  Vec3 centre;                       ///< world frame
  Vec3 direction[kRememberedViews];  ///< unit vectors from the lookout to the voxel
  std::int32_t directions;           ///< how often it was tried

  bool is_hopeless() const noexcept { return directions >= kHopelessAfter; }
  /// True if it was not seen from about this direction.
  bool was_tried_from(const Vec3& place) const noexcept;
};

struct FailedLookout {
  Vec3 place;
  Vec3 look;
};

struct Tried {
  TriedVoxel voxel[kTriedVoxels];
  FailedLookout failed[kFailedLookouts];
  std::int32_t voxels;  ///< noted since clear(); so many of the last are there
  std::int32_t failures;

  void clear() noexcept { voxels = failures = 0; }
  /// A voxel was looked at from a place, and not seen.
  void note_voxel(const Vec3& centre, const Vec3& from, double cell) noexcept;
  /// A lookout was of no use.
  void note_failure(const Vec3& place, const Vec3& look) noexcept;
  /// The entry of a voxel; negative if there is none.
  std::int32_t find(const Vec3& centre, double cell) const noexcept;
  /// A lookout like this one was of no use.
  bool has_failed(const Vec3& place, const Vec3& look, double cell) const noexcept;
  std::int32_t kept_voxels() const noexcept { return voxels < kTriedVoxels ? voxels : kTriedVoxels; }
  /// The voxel that was looked at from the most directions, of those that are still unseen: its entry, or negative.
  std::int32_t most_tried(const RollingMap& map) const noexcept;
  /// Writes the first `capacity` of the voxels that are still unseen, and returns how many there are.
  std::int32_t list_unseen(const RollingMap& map, UnseenVoxel* list, std::int32_t capacity) const noexcept;
};

}  // namespace tern

#endif
