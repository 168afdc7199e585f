// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "path/turned.hpp"

#include "grid/lattice.hpp"

namespace tern {
namespace {

constexpr std::int32_t kSide = 64;

/// Transposes a 64 x 64 bit matrix in place: swaps ever smaller quarters off the diagonal.
void transpose(std::uint64_t (&tile)[kSide]) {
  std::uint64_t mask = 0x00000000FFFFFFFFu;
  for (std::int32_t half = kSide / 2; half > 0; half /= 2, mask ^= mask << half) {
    for (std::int32_t k = 0; k < kSide; k = ((k | half) + 1) & ~half) {
      const std::uint64_t swap = (tile[k] >> half ^ tile[k | half]) & mask;
      tile[k] ^= swap << half;
      tile[k | half] ^= swap;
    }
  }
}

}  // namespace

void turned_reset(TurnedLayer& layer, const Grid& grid, int axis_along) noexcept {
  const Voxel& dims = grid.spec().dims;
  const std::int32_t along = axis(dims, axis_along);
  const std::int32_t third = axis(dims, 3 - axis_along);
  layer.axis = axis_along;
  layer.words = (along + kSide - 1) / kSide;
  layer.width = dims.x;
  layer.blocks = (dims.x + kSide - 1) / kSide;
  if (std::int64_t{layer.words} * dims.x * third > kTurnedWords) {
    layer.words = 0;
    return;
  }
  const std::int32_t tiles = layer.words * layer.blocks * third;
  for (std::int32_t k = 0; k <= tiles / kSide; ++k) layer.ready[k] = 0;
}

void turned_fill(TurnedLayer& layer, const Grid& grid, std::int32_t block, std::int32_t third,
                 std::int32_t word) noexcept {
  const Voxel& dims = grid.spec().dims;
  const std::int32_t along = axis(dims, layer.axis);
  std::uint64_t tile[kSide];
  for (std::int32_t k = 0; k < kSide; ++k) {
    const std::int32_t at = word * kSide + k;
    tile[k] = ~std::uint64_t{0};
    if (at < along) tile[k] = (layer.axis == 1 ? grid.blocked_row(at, third) : grid.blocked_row(third, at))[block];
  }
  transpose(tile);
  const std::int32_t left = dims.x - block * kSide;
  const std::int32_t rows = left < kSide ? left : kSide;
  std::uint64_t* out =
      layer.bits + (static_cast<std::int64_t>(third) * layer.width + block * kSide) * layer.words + word;
  for (std::int32_t k = 0; k < rows; ++k) out[static_cast<std::int64_t>(k) * layer.words] = tile[k];
  const std::int32_t index = (third * layer.blocks + block) * layer.words + word;
  layer.ready[index >> 6] |= std::uint64_t{1} << (index & 63);
}

}  // namespace tern
