// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "path/flood.hpp"

#include <cstddef>

#include "grid/bit_rows.hpp"

namespace tern {
namespace {

/// Spreads `bits` through runs of free bits towards higher bits, as carries spread in a sum.
std::uint64_t fill_up(std::uint64_t bits, std::uint64_t free) {
  return free & ((free ^ (free + bits)) | bits);
}

/// Spreads `bits` through runs of free bits towards lower bits. Each step doubles the reach. Most words take no steps,
/// because they are wholly free, or are reached wholly or not at all.
std::uint64_t fill_down(std::uint64_t bits, std::uint64_t free) {
  if (bits == 0 || bits == free) return bits;
  if (free == kAllBits) return kAllBits >> __builtin_clzll(bits);
  for (int step = 1; step < kWordBits; step *= 2) {
    bits |= free & bits >> step;
    free &= free >> step;
  }
  return bits;
}

/// Fills each run of free voxels of a row in which some voxel has been reached: first upwards word by word, then
/// downwards.
void fill_row(std::uint64_t* dry, const std::uint64_t* blocked, std::int32_t words) {
  std::uint64_t carry = 0;
  for (std::int32_t k = 0; k < words; ++k) {
    const std::uint64_t reached = fill_up(~dry[k] | (carry & ~blocked[k]), ~blocked[k]);
    carry = reached >> 63;
    dry[k] = ~reached;
  }
  carry = 0;
  for (std::int32_t k = words; k-- > 0;) {
    const std::uint64_t reached = fill_down(~dry[k] | (carry & ~blocked[k]), ~blocked[k]);
    carry = reached << 63;
    dry[k] = ~reached;
  }
}

void enqueue(Flood& flood, std::uint32_t row) {
  std::uint64_t& waiting = flood.waiting[row >> 6];
  const std::uint64_t bit = std::uint64_t{1} << (row & 63);
  if ((waiting & bit) != 0) return;
  waiting |= bit;
  const std::uint32_t last = flood.first + flood.count++;
  flood.queue[last < flood.rows ? last : last - flood.rows] = row;
}

std::uint32_t dequeue(Flood& flood) {
  const std::uint32_t row = flood.queue[flood.first];
  if (++flood.first == flood.rows) flood.first = 0;
  --flood.count;
  flood.waiting[row >> 6] &= ~(std::uint64_t{1} << (row & 63));
  return row;
}

/// Reaches the free voxels of a row whose neighbours in the row `from` were reached.
void spread(Flood& flood, const BitRows& blocked, const std::uint64_t* from, std::int32_t y, std::int32_t z) {
  std::uint64_t* dry = flood.dry + blocked.index(y, z);
  const std::uint64_t* solid = blocked.row(y, z);
  std::uint64_t any = 0;
  for (std::int32_t k = 0; k < blocked.row_words; ++k) {
    const std::uint64_t fresh = ~from[k] & dry[k] & ~solid[k];
    dry[k] &= ~fresh;
    any |= fresh;
  }
  if (any != 0) enqueue(flood, static_cast<std::uint32_t>(z * blocked.plane_rows + y));
}

}  // namespace

bool flood_begin(Flood& flood, const Grid& grid) noexcept {
  flood.words = GridAccess::layer_words(grid);
  if (flood.words > static_cast<std::size_t>(kMaxWorldWords)) return false;
  flood.cleared = 0;
  flood.rows = static_cast<std::uint32_t>(grid.spec().dims.y * grid.spec().dims.z);
  flood.first = flood.count = 0;
  return true;
}

bool flood_clear(Flood& flood) noexcept {
  const std::size_t left = flood.words - flood.cleared;
  const std::size_t end = flood.cleared + (left < kClearedWords ? left : kClearedWords);
  // Each row has at least one word, so there are at most as many rows as words.
  for (std::size_t k = flood.cleared / 64; k <= end / 64; ++k) flood.waiting[k] = 0;
  for (std::size_t k = flood.cleared; k < end; ++k) flood.dry[k] = kAllBits;
  flood.cleared = end;
  return end == flood.words;
}

void flood_from(Flood& flood, const Grid& grid, const Voxel& voxel) noexcept {
  const BitRows blocked = GridAccess::blocked(grid);
  std::uint64_t& dry = flood.dry[blocked.index(voxel.y, voxel.z) + (voxel.x >> 6)];
  const std::uint64_t bit = std::uint64_t{1} << (voxel.x & 63);
  if ((dry & bit) == 0) return;
  dry &= ~bit;
  enqueue(flood, static_cast<std::uint32_t>(voxel.z * blocked.plane_rows + voxel.y));
}

void flood_row(Flood& flood, const Grid& grid) noexcept {
  const BitRows blocked = GridAccess::blocked(grid);
  const Voxel& dims = grid.spec().dims;
  const std::int32_t row = static_cast<std::int32_t>(dequeue(flood));
  const std::int32_t y = row % dims.y;
  const std::int32_t z = row / dims.y;
  std::uint64_t* dry = flood.dry + blocked.index(y, z);
  fill_row(dry, blocked.row(y, z), blocked.row_words);
  if (y > 0) spread(flood, blocked, dry, y - 1, z);
  if (y + 1 < dims.y) spread(flood, blocked, dry, y + 1, z);
  if (z > 0) spread(flood, blocked, dry, y, z - 1);
  if (z + 1 < dims.z) spread(flood, blocked, dry, y, z + 1);
}

Grid flooded(Flood& flood, const Grid& grid) noexcept {
  return GridAccess::with_blocked(grid, flood.dry);
}

}  // namespace tern
