// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "guide/block_map.hpp"

#include "base/capacity.hpp"
#include "grid/lattice.hpp"

namespace tern {
namespace {

/// Blocks are eight voxels wide instead of four if the radius is at least four voxels. Obstacles are then too thick to
/// split a block.
constexpr double kLargeRadius = 4.0;

/// Stores `count` bytes, eight at most. A loop of eight becomes one store.
void store_bytes(std::uint64_t bytes, std::int32_t count, std::uint8_t* to) {
  if (count >= 8) {
    for (int i = 0; i < 8; ++i) to[i] = static_cast<std::uint8_t>(bytes >> 8 * i);
    return;
  }
  for (std::int32_t i = 0; i < count; ++i) to[i] = static_cast<std::uint8_t>(bytes >> 8 * i);
}

/// Makes the blocks of a word of voxels.
void make_word(BlockMap& map, const Grid& grid, const Voxel& block) {
  const WordSides sides = read_block_word(grid, map.log, block);
  const std::int32_t first = block.x & ~map.last;
  const std::int32_t count = map.dims.x - first <= map.last ? map.dims.x - first : map.last + 1;
  const std::int32_t begin = map.index({first, block.y, block.z});
  for (std::int32_t k = 0; k < count; ++k) map.blocks[begin + k] = {kFar, arrival_link(kHere)};
  for (std::int32_t k = 0; k < count; k += 8) store_bytes(sides.bytes(k, map.log), count - k, map.sides + begin + k);
}

/// Sets the bit. True if it was not set before.
bool first_time(std::uint64_t* bits, std::int32_t index) {
  const std::uint64_t bit = std::uint64_t{1} << (index & 63);
  if ((bits[index >> 6] & bit) != 0) return false;
  bits[index >> 6] |= bit;
  return true;
}

/// Makes the block's word, and the same word of the rows beside it.
void touch_rows(BlockMap& map, const Grid& grid, const Voxel& block) {
  const IndexRange y = overlap({block.y - 1, block.y + 2}, {0, map.dims.y});
  const IndexRange z = overlap({block.z - 1, block.z + 2}, {0, map.dims.z});
  for (std::int32_t at_z = z.begin; at_z < z.end; ++at_z) {
    std::int32_t word = map.word({block.x, y.begin, at_z});
    for (std::int32_t at_y = y.begin; at_y < y.end; ++at_y, word += map.words) {
      if (first_time(map.made, word)) make_word(map, grid, {block.x, at_y, at_z});
    }
  }
}

/// Makes the blocks around a block: those around its word, and those around the next word if the block is a word's
/// first or last.
void touch_around(BlockMap& map, const Grid& grid, const Voxel& block) {
  const std::int32_t at = block.x & map.last;
  const std::int32_t word = map.word(block);
  if (first_time(map.around, word)) touch_rows(map, grid, block);
  if (at == 0 && block.x > 0 && first_time(map.around, word - 1)) {
    touch_rows(map, grid, {block.x - 1, block.y, block.z});
  }
  if (at == map.last && block.x + 1 < map.dims.x && first_time(map.around, word + 1)) {
    touch_rows(map, grid, {block.x + 1, block.y, block.z});
  }
}

/// For each side, and for each byte of `sides` of the block across it: the move across the side, and the moves that go
/// on around a corner. A move goes on across a side at right angles if the block across is joined there, and is known
/// not to be split.
struct CornerTable {
  CellMask moves[kSides][256];
};
constexpr CornerTable make_corners() {
  CornerTable table{};
  for (int side = 0; side < kSides; ++side) {
    for (unsigned beside = 0; beside < 256; ++beside) {
      CellMask& moves = table.moves[side][beside];
      moves = cell_bit(kSideMove[side]);
      for (int on = 0; on < kSides && beside < kBlockSplit; ++on) {
        const bool corner = (beside >> on & 1u) != 0 && on / 2 != side / 2;
        if (corner) moves |= cell_bit(kSideMove[side] + kSideMove[on] - kHere);
      }
    }
  }
  return table;
}
constexpr CornerTable kCorners = make_corners();

/// Moves from a block across the sides in `joined`. Blocks of an unknown kind count as split.
BlockMoves moves_across(const BlockMap& map, std::int32_t at, SideMask joined) {
  unsigned any = 0;
  CellMask moves = 0;
  // Has no branches, because they would be hard to predict.
  for (int side = 0; side < kSides; ++side) {
    const unsigned is = 0u - (joined >> side & 1u);
    const unsigned beside = map.sides[at + (map.beside[side] & static_cast<std::int32_t>(is))];
    any |= beside & is;
    moves |= kCorners.moves[side][beside] & is;
  }
  return {moves, any >= kBlockSplit};
}

std::int32_t blocks_along(std::int32_t voxels, int log) {
  return (voxels + (1 << log) - 1) >> log;
}

}  // namespace

bool block_map_begin(BlockMap& map, const Grid& grid, bool small) noexcept {
  const GridSpec& spec = grid.spec();
  map.log = !small && spec.clearance() >= kLargeRadius * spec.cell ? kLargeBlocks : kSmallBlocks;
  map.dims = {blocks_along(spec.dims.x, map.log), blocks_along(spec.dims.y, map.log),
              blocks_along(spec.dims.z, map.log)};
  map.last = (kWordBits >> map.log) - 1;
  map.words = words_for(spec.dims.x);
  for (int move = 0; move < kDirections; ++move) map.offsets[move] = map.index(offset(move));
  for (int side = 0; side < kSides; ++side) map.beside[side] = map.offsets[kSideMove[side]];
  const std::int64_t rows = std::int64_t{map.dims.y} * map.dims.z;
  if (is_full(rows * map.dims.x > kGuideBlocks || rows * map.words > kBlockWords)) return false;
  for (std::int64_t k = 0; k <= rows * map.words / 64; ++k) map.made[k] = map.around[k] = 0;
  return true;
}

void block_touch(BlockMap& map, const Grid& grid, const Voxel& block) noexcept {
  if (first_time(map.made, map.word(block))) make_word(map, grid, block);
}

unsigned block_find_parts(BlockMap& map, const Grid& grid, const Voxel& block) noexcept {
  const bool whole = one_part(block_voxels(grid, block));
  std::uint8_t& sides = map.sides[map.index(block)];
  sides = static_cast<std::uint8_t>((sides & ~kBlockKinds) | (whole ? kBlockWhole : kBlockSplit));
  return sides;
}

BlockMoves block_moves(BlockMap& map, const Grid& grid, const Voxel& block, SideMask sides) noexcept {
  touch_around(map, grid, block);
  const std::int32_t at = map.index(block);
  const SideMask joined = map.sides[at] & sides & kAllSides;
  const BlockMoves across = moves_across(map, at, joined);
  if (!across.split_beside) return across;
  // Finds out whether the blocks of an unknown kind across these sides are split.
  for (SideMask left = joined; left != 0; left &= left - 1) {
    block_split(map, grid, block + kMoveOf.at[kSideMove[__builtin_ctz(left)]].step);
  }
  return moves_across(map, at, joined);
}

}  // namespace tern
