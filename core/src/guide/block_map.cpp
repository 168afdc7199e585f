// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "guide/block_map.hpp"

#include "grid/lattice.hpp"

namespace tern {
namespace {

/// Blocks are eight voxels wide instead of four if the radius is at least four voxels. Obstacles are then too thick to
/// split a block.
constexpr int kSmallLog = 2;
constexpr int kLargeLog = 3;
constexpr double kLargeRadius = 4.0;

/// One bit for each block in a word of voxels: the lowest bit of the block. The others are ignored.
std::uint64_t squeeze(std::uint64_t bits, int log) {
  if (log == kSmallLog) {
    bits &= 0x1111111111111111u;
    bits = (bits | bits >> 3) & 0x0303030303030303u;
    bits = (bits | bits >> 6) & 0x000F000F000F000Fu;
    bits = (bits | bits >> 12) & 0x000000FF000000FFu;
    return (bits | bits >> 24) & 0xFFFFu;
  }
  bits &= 0x0101010101010101u;
  bits = (bits | bits >> 7) & 0x0003000300030003u;
  bits = (bits | bits >> 14) & 0x0000000F0000000Fu;
  return (bits | bits >> 28) & 0xFFu;
}

/// One bit for each block in a word of voxels: whether any bit of the block is set.
std::uint64_t any_of(std::uint64_t bits, int log) {
  bits |= bits >> 1;
  bits |= bits >> 2;
  if (log == kLargeLog) bits |= bits >> 4;
  return squeeze(bits, log);
}

/// The rows of voxels of a row of blocks, word by word.
struct Rows {
  const Grid& grid;
  int log;
  IndexRange y;
  IndexRange z;

  Rows(const Grid& g, int l, std::int32_t block_y, std::int32_t block_z)
      : grid(g), log(l), y(range(block_y, g.spec().dims.y)), z(range(block_z, g.spec().dims.z)) {}

  IndexRange range(std::int32_t block, std::int32_t count) const {
    const std::int32_t end = (block + 1) << log;
    return {block << log, end < count ? end : count};
  }

  /// Blocks in which a free voxel of plane `from` (at right angles to the axis, y or z) touches a free voxel of plane
  /// `to`.
  template <int kAxis>
  std::uint64_t meet(std::int32_t word, std::int32_t from, std::int32_t to) const {
    if (to < 0 || to >= axis(grid.spec().dims, kAxis)) return 0;
    const BitRows rows = GridView::blocked(grid);
    const IndexRange& along = kAxis == 1 ? z : y;
    const std::ptrdiff_t step = kAxis == 1 ? rows.index(0, 1) : rows.row_words;
    const std::ptrdiff_t across = (kAxis == 1 ? rows.row_words : rows.index(0, 1)) * (to - from);
    const std::uint64_t* row = (kAxis == 1 ? rows.row(from, z.begin) : rows.row(y.begin, from)) + word;
    std::uint64_t closed = ~std::uint64_t{0};
    for (std::int32_t k = along.begin; k < along.end; ++k, row += step) closed &= row[0] | row[across];
    return any_of(~closed, log);
  }
};

/// Properties of 64 blocks, one bit each: whether the block is joined at each side, and whether it is full.
struct BlockBits {
  std::uint64_t of[8];
};

/// Reads a word of voxels: 16 or 8 of the blocks, from bit `shift` on.
void read_word(const Rows& rows, std::int32_t word, int shift, BlockBits& bits) {
  // The words beside it; past the row's ends its own, whose bits are masked.
  const std::ptrdiff_t before = word == 0 ? 0 : -1;
  const std::ptrdiff_t after = word + 1 == rows.grid.row_words() ? 0 : 1;
  std::uint64_t some = 0;
  std::uint64_t below = ~std::uint64_t{0};  // in bit x: voxels x - 1 and x do not meet
  std::uint64_t above = ~std::uint64_t{0};  // in bit 0: voxels 63 and 64
  for (std::int32_t z = rows.z.begin; z < rows.z.end; ++z) {
    const std::uint64_t* row = rows.grid.blocked_row(rows.y.begin, z) + word;
    for (std::int32_t y = rows.y.begin; y < rows.y.end; ++y, row += rows.grid.row_words()) {
      some |= row[0];
      below &= row[0] | row[0] << 1 | row[before] >> 63;
      above &= row[0] >> 63 | row[after];
    }
  }
  if (before == 0) below |= 1;
  if (after == 0) above |= 1;
  const int log = rows.log;
  const std::uint64_t met = squeeze(~below, log);
  bits.of[0] |= met << shift;
  bits.of[1] |= (met >> 1 | (~above & 1) << ((64 >> log) - 1)) << shift;
  bits.of[2] |= rows.meet<1>(word, rows.y.begin, rows.y.begin - 1) << shift;
  bits.of[3] |= rows.meet<1>(word, rows.y.end - 1, rows.y.end) << shift;
  bits.of[4] |= rows.meet<2>(word, rows.z.begin, rows.z.begin - 1) << shift;
  bits.of[5] |= rows.meet<2>(word, rows.z.end - 1, rows.z.end) << shift;
  const std::uint64_t blocks = ~std::uint64_t{0} >> (64 - (64 >> log));
  bits.of[kSides] |= (~any_of(some, log) & blocks) << shift;
}

/// Block::sides of eight blocks, a byte each: eight bits of eight words, transposed.
std::uint64_t eight_blocks(const BlockBits& bits, std::int32_t first) {
  std::uint64_t square = 0;
  for (int k = 0; k < 8; ++k) square |= (bits.of[k] >> first & 0xFFu) << 8 * k;
  std::uint64_t swap = (square ^ square >> 7) & 0x00AA00AA00AA00AAu;
  square ^= swap ^ swap << 7;
  swap = (square ^ square >> 14) & 0x0000CCCC0000CCCCu;
  square ^= swap ^ swap << 14;
  swap = (square ^ square >> 28) & 0x00000000F0F0F0F0u;
  return square ^ swap ^ swap << 28;
}

/// Makes 64 blocks along x.
void make_word(BlockMap& map, const Grid& grid, const Voxel& block) {
  const Rows rows(grid, map.log, block.y, block.z);
  const std::int32_t across = 1 << map.log;  // words of voxels
  const std::int32_t from = (block.x >> 6) * across;
  BlockBits bits{};
  for (std::int32_t k = 0; k < across && from + k < grid.row_words(); ++k) {
    read_word(rows, from + k, k * (64 >> map.log), bits);
  }
  const std::int32_t left = map.dims.x - (block.x & ~63);
  Block* out = map.blocks + map.index({block.x & ~63, block.y, block.z});
  for (std::int32_t k = 0; k < 64 && k < left; k += 8) {
    const std::uint64_t sides = eight_blocks(bits, k);
    for (std::int32_t i = 0; i < 8 && k + i < left; ++i) {
      const auto of = static_cast<std::uint8_t>(sides >> 8 * i);
      out[k + i] = {kFar, of, kHere, (of & Block::kFull) != 0 ? Block::kParts : std::uint8_t{0}};
    }
  }
}

/// Sets the bit. True if it was not set before.
bool first_time(std::uint64_t* bits, std::int32_t index) {
  const std::uint64_t bit = std::uint64_t{1} << (index & 63);
  if ((bits[index >> 6] & bit) != 0) return false;
  bits[index >> 6] |= bit;
  return true;
}

/// Makes the block's word and those around it.
void touch_around(BlockMap& map, const Grid& grid, const Voxel& block) {
  for (int d = 0; d < kDirections; ++d) {
    const Voxel step = offset(d);
    const Voxel at{block.x + 64 * step.x, block.y + step.y, block.z + step.z};
    const bool inside =
        at.x >> 6 >= 0 && at.x >> 6 < map.words && at.y >= 0 && at.y < map.dims.y && at.z >= 0 && at.z < map.dims.z;
    if (inside) block_touch(map, grid, at);
  }
}

/// The move across a side, and the moves that go on from there across those sides at right angles at which that block
/// is joined.
struct CornerTable {
  CellMask moves[kSides][1 << kSides];
};
constexpr CornerTable make_corners() {
  CornerTable table{};
  for (int side = 0; side < kSides; ++side) {
    for (int joined = 0; joined < 1 << kSides; ++joined) {
      CellMask& moves = table.moves[side][joined];
      moves = cell_bit(kSideMove[side]);
      for (int on = 0; on < kSides; ++on) {
        const bool corner = (joined >> on & 1) != 0 && on / 2 != side / 2;
        if (corner) moves |= cell_bit(kSideMove[side] + kSideMove[on] - kHere);
      }
    }
  }
  return table;
}
constexpr CornerTable kCorners = make_corners();

std::int32_t blocks_along(std::int32_t voxels, int log) {
  return (voxels + (1 << log) - 1) >> log;
}

}  // namespace

bool block_map_begin(BlockMap& map, const Grid& grid) noexcept {
  const GridSpec& spec = grid.spec();
  map.log = spec.radius >= kLargeRadius * spec.cell ? kLargeLog : kSmallLog;
  map.dims = {blocks_along(spec.dims.x, map.log), blocks_along(spec.dims.y, map.log),
              blocks_along(spec.dims.z, map.log)};
  map.words = (map.dims.x + 63) / 64;
  for (int move = 0; move < kDirections; ++move) map.offsets[move] = map.index(offset(move));
  const std::int64_t rows = std::int64_t{map.dims.y} * map.dims.z;
  if (rows * map.dims.x > kGuideBlocks || rows * map.words > kBlockWords) return false;
  for (std::int64_t k = 0; k <= rows * map.words / 64; ++k) map.made[k] = map.around[k] = 0;
  return true;
}

void block_touch(BlockMap& map, const Grid& grid, const Voxel& block) noexcept {
  if (first_time(map.made, map.word(block))) make_word(map, grid, block);
}

void block_find_parts(BlockMap& map, const Grid& grid, const Voxel& block, Block& at) noexcept {
  const bool whole = map.log != kSmallLog || one_part(block_voxels(grid, block));
  at.flags = static_cast<std::uint8_t>(at.flags | Block::kParts | (whole ? 0 : Block::kSplit));
}

CellMask block_moves(BlockMap& map, const Grid& grid, const Voxel& block, SideMask sides) noexcept {
  if (first_time(map.around, map.word(block))) touch_around(map, grid, block);
  Block* const at = &map.at(block);
  CellMask moves = 0;
  for (SideMask left = at->sides & sides & kAllSides; left != 0; left &= left - 1) {
    const int side = __builtin_ctz(left);
    Block& beside = at[map.offsets[kSideMove[side]]];
    const bool split = block_split(map, grid, block + kMoveOf.at[kSideMove[side]].step, beside);
    moves |= kCorners.moves[side][split ? 0 : beside.sides & kAllSides];
  }
  return moves;
}

}  // namespace tern
