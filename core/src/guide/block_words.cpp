// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "grid/bit_rows.hpp"
#include "grid/lattice.hpp"
#include "guide/block_map.hpp"

namespace tern {
namespace {

/// Words of two planes side by side, as in one register of SSE2 and NEON.
using TwoWords __attribute__((vector_size(16))) = std::uint64_t;

/// Sets the lowest bit of each block of a word if any bit of the block is set; all other bits are clear. `Word` is one
/// word, or two at a time.
template <typename Word>
Word any_of(Word bits, int log) {
  bits |= bits >> 1;
  bits |= bits >> 2;
  if (log == kSmallBlocks) return bits & 0x1111111111111111u;
  return (bits | bits >> 4) & 0x0101010101010101u;
}

/// The rows of voxels in a row of blocks, and one word of them.
struct WordRows {
  const BitRows rows;
  const Voxel dims;
  int log;
  std::int32_t word;
  IndexRange y;
  IndexRange z;

  WordRows(const Grid& grid, int l, const Voxel& block)
      : rows(GridAccess::blocked(grid)),
        dims(grid.spec().dims),
        log(l),
        word(block.x >> (6 - l)),
        y(range(block.y, dims.y)),
        z(range(block.z, dims.z)) {}

  IndexRange range(std::int32_t block, std::int32_t count) const {
    const std::int32_t end = (block + 1) << log;
    return {block << log, end < count ? end : count};
  }
  const std::uint64_t* at(std::int32_t row_y, std::int32_t row_z) const { return rows.row(row_y, row_z) + word; }

  /// The blocks that are joined to the block before them along the axis (y or z), and those that are joined to the
  /// block after them. Two blocks are joined if a free voxel of one touches a free voxel of the other.
  template <int kAxis>
  TwoWords meet() const {
    const IndexRange& own = kAxis == 1 ? y : z;
    const IndexRange& along = kAxis == 1 ? z : y;
    const std::ptrdiff_t across = kAxis == 1 ? rows.index(1, 0) : rows.index(0, 1);
    const std::ptrdiff_t step = kAxis == 1 ? rows.index(0, 1) : rows.index(1, 0);
    const bool first = own.begin == 0;
    const bool last = own.end == axis(dims, kAxis);
    const std::ptrdiff_t before = first ? 0 : -across;
    const std::ptrdiff_t end = (own.end - own.begin - 1) * across;
    const std::ptrdiff_t after = last ? end : end + across;
    const std::uint64_t* row = at(y.begin, z.begin);
    TwoWords closed = {kAllBits, kAllBits};
    for (std::int32_t k = along.begin; k < along.end; ++k, row += step) {
      closed &= TwoWords{row[0], row[end]} | TwoWords{row[before], row[after]};
    }
    const TwoWords inside = {first ? 0 : kAllBits, last ? 0 : kAllBits};
    return any_of(~closed & inside, log);
  }
};

/// One bit for each voxel x of a word. A bit is set if its condition holds in at least one row.
struct WordBits {
  std::uint64_t blocked;  ///< x is blocked
  std::uint64_t met;      ///< voxels x - 1 and x are both free
  std::uint64_t met_end;  ///< in bit 63: voxels 63 and 64 are both free
  std::uint64_t begins;   ///< x is free, and x - 1 is not
  std::uint64_t stops;    ///< x is not free, and x - 1 is
  std::uint64_t begins_y;
  std::uint64_t stops_y;
  std::uint64_t first_y;  ///< x is not free in the first row along y
  std::uint64_t last_y;   ///< x is not free in the last row along y
};

/// WordBits of two planes. `apart` and `apart_end` are the opposites of `met` and `met_end`: in every row, one of the
/// two voxels is blocked.
struct TwoWordBits {
  TwoWords blocked = {};
  TwoWords apart = {kAllBits, kAllBits};
  TwoWords apart_end = {kAllBits, kAllBits};
  TwoWords begins = {};
  TwoWords stops = {};
  TwoWords begins_y = {};
  TwoWords stops_y = {};
  TwoWords first_y = {};
  TwoWords last_y = {};
};

/// Offsets from a word to the words beside it in its row. At the row's ends, an offset is 0, and the bits are masked.
struct Neighbours {
  std::ptrdiff_t before;
  std::ptrdiff_t after;
};

/// Adds `count` rows along y from `row` on, and the same rows of the plane that begins `next` words further on.
void add_rows(const std::uint64_t* row, std::ptrdiff_t next, std::ptrdiff_t step, std::int32_t count,
              const Neighbours& beside, TwoWordBits& bits) {
  TwoWords last = {row[0], row[next]};
  bits.first_y |= last;
  for (std::int32_t y = 0; y < count; ++y, row += step) {
    const TwoWords word = {row[0], row[next]};
    const TwoWords left = {row[beside.before], row[beside.before + next]};
    const TwoWords right = {row[beside.after], row[beside.after + next]};
    const TwoWords before = word << 1 | left >> 63;
    bits.blocked |= word;
    bits.apart &= word | before;
    bits.apart_end &= word | right << 63;
    bits.begins |= before & ~word;
    bits.stops |= word & ~before;
    bits.begins_y |= last & ~word;
    bits.stops_y |= word & ~last;
    last = word;
  }
  bits.last_y |= last;
}

std::uint64_t either(TwoWords words) {
  return words[0] | words[1];
}
std::uint64_t neither(TwoWords words) {
  return ~(words[0] & words[1]);
}

WordBits read_rows(const WordRows& rows) {
  const bool first = rows.word == 0;
  const bool last = rows.word + 1 == rows.rows.row_words;
  const Neighbours beside = {first ? 0 : -1, last ? 0 : 1};
  const std::ptrdiff_t plane = rows.rows.index(0, 1);
  TwoWordBits bits;
  // If the number of planes is odd, the last one counts twice, which changes nothing.
  for (std::int32_t z = rows.z.begin; z < rows.z.end; z += 2) {
    add_rows(rows.at(rows.y.begin, z), z + 1 < rows.z.end ? plane : 0, rows.rows.row_words, rows.y.end - rows.y.begin,
             beside, bits);
  }
  return {either(bits.blocked),
          neither(bits.apart) & ~(first ? std::uint64_t{1} : 0),
          last ? 0 : neither(bits.apart_end),
          either(bits.begins),
          either(bits.stops),
          either(bits.begins_y),
          either(bits.stops_y),
          either(bits.first_y),
          either(bits.last_y)};
}

/// Blocks with a wholly free side along x or y from which rows of free voxels lead to all their free voxels. The free
/// voxels of such a block are connected, and most blocks are like that. Blocks eight voxels wide count as connected.
std::uint64_t surely_whole(const WordBits& bits, int log) {
  const std::uint64_t first = any_of(kAllBits, log);
  if (log == kLargeBlocks) return first;
  const std::uint64_t last = first << 3;
  const std::uint64_t parted[] = {(bits.begins & ~first) | (bits.blocked & first),
                                  (bits.stops >> 1 & ~last) | (bits.blocked & last), bits.begins_y | bits.first_y,
                                  bits.stops_y | bits.last_y};
  return first & ~(any_of(parted[0], log) & any_of(parted[1], log) & any_of(parted[2], log) & any_of(parted[3], log));
}

}  // namespace

WordSides read_block_word(const Grid& grid, int log, const Voxel& block) noexcept {
  const WordRows rows(grid, log, block);
  const WordBits bits = read_rows(rows);
  const int width = 1 << rows.log;
  const std::uint64_t first = any_of(kAllBits, rows.log);
  const std::uint64_t met = bits.met & first;
  const std::uint64_t next = met >> width | bits.met_end >> 63 << (64 - width);
  const std::uint64_t some = any_of(bits.blocked, rows.log);
  const std::uint64_t whole = some & surely_whole(bits, rows.log);
  const TwoWords y = rows.meet<1>();
  const TwoWords z = rows.meet<2>();
  return {met | next << 1 | y[0] << 2 | y[1] << 3, z[0] | z[1] << 1 | (first & ~whole) << 2 | (some & ~whole) << 3};
}

}  // namespace tern
