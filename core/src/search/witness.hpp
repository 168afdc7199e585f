// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Witnesses: for every block of 4 x 4 x 4 voxels one voxel that the search has reached, and at what cost. They tell
// whether a way to another voxel of the block is a detour, so that sweeps do not go over the same space again and
// again.
#ifndef TERN_SEARCH_WITNESS_HPP
#define TERN_SEARCH_WITNESS_HPP

#include <cstdint>

#include "base/direction.hpp"
#include "tern/config.hpp"
#include "tern/grid.hpp"

namespace tern {

/// Blocks of the largest map. Where ceil(dims / 4) multiply to more, the last blocks have no witness.
constexpr std::int32_t kWitnesses = static_cast<std::int32_t>((kMaxCells + 63) / 64);

/// Plain data; needs no initialisation before witness_reset, which clears one bit a block.
struct WitnessMap {
  std::int32_t width;  ///< blocks along x, and in a slice of x and y
  std::int32_t slice;
  std::uint64_t known[kWitnesses / 64 + 1];  ///< one bit a block: it has a witness
  /// Its cost, rounded up to a multiple of 64, plus its place in the block, x + 4 y + 16 z.
  std::uint64_t witnesses[kWitnesses];
};

void witness_reset(WitnessMap& map, const Grid& grid) noexcept;

/// True where all voxels of the box between two corners of one block are free.
bool block_box_free(const Grid& grid, const Voxel& a, const Voxel& b) noexcept;

/// True where the block's witness proves a way to `voxel` that is cheaper than `g`: the box between the two is free.
/// Otherwise the voxel, just reached at that cost, becomes the witness if it is no dearer than the one that was.
inline bool is_detour(WitnessMap& map, const Grid& grid, const Voxel& voxel, Cost g) noexcept {
  constexpr Cost kPlaceMask = 63;
  const std::int32_t block = (voxel.x >> 2) + map.width * (voxel.y >> 2) + map.slice * (voxel.z >> 2);
  if (block >= kWitnesses) return false;
  const std::uint64_t bit = std::uint64_t{1} << (block & 63);
  const auto place = static_cast<Cost>((voxel.x & 3) | (voxel.y & 3) << 2 | (voxel.z & 3) << 4);
  std::uint64_t& witness = map.witnesses[block];
  const Cost cost = witness & ~kPlaceMask;
  if ((map.known[block >> 6] & bit) == 0 || cost >= g) {
    map.known[block >> 6] |= bit;
    witness = ((g + kPlaceMask) & ~kPlaceMask) | place;
    return false;
  }
  // Most are as good as their witness: another voxel is a step away at least.
  if (cost + kStraightCost >= g && (witness & kPlaceMask) != place) return false;
  const auto at = static_cast<std::int32_t>(witness & kPlaceMask);
  const Voxel from{(voxel.x & ~3) + (at & 3), (voxel.y & ~3) + (at >> 2 & 3), (voxel.z & ~3) + (at >> 4)};
  return cost + octile(from, voxel) < g && block_box_free(grid, from, voxel);
}

}  // namespace tern

#endif
