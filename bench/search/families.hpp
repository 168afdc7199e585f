// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Seeded worlds of several kinds, for choosing the settings of a search and for judging them on other seeds.
#ifndef TERN_BENCH_FAMILIES_HPP
#define TERN_BENCH_FAMILIES_HPP

#include <cstdint>

#include "search/worlds.hpp"

namespace tern_bench {

enum class Family : std::uint8_t {
  kNoise,    ///< single voxels
  kPlates,   ///< plates, one voxel thick
  kMaze,     ///< a maze on several levels, with some loops
  kPillars,  ///< columns from the floor to the ceiling
  kStoreys,  ///< floors with stairwells, rooms with doors, furniture
};
constexpr int kFamilies = 5;

const char* family_name(Family family);

/// A world of 200 x 160 x 40 voxels, with gaps that suit a robot of this radius in voxels, and a query between two free
/// voxels at least 60 voxels apart. There may be no path.
Query build(Family family, int radius, std::uint64_t seed, World& world);

}  // namespace tern_bench

#endif
