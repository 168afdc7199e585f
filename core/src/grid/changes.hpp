// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The changes since the last inflation, in the caller's storage: one bit for each word of the obstacle layer. The bits
// of 64 consecutive rows form a word, so shifts spread a change to the rows around it.
#ifndef TERN_GRID_CHANGES_HPP
#define TERN_GRID_CHANGES_HPP

#include <cstddef>
#include <cstdint>

#include "grid/lattice.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// Rows of a strip: consecutive rows of a plane, from a multiple of 64 on.
constexpr std::int32_t kStripRows = kWordBits;
/// The most strips that a plane has.
constexpr std::int32_t kMaxStrips = (kMaxDimension + kStripRows - 1) / kStripRows;

/// The content number after one more change. It is a hash of all changes since the grid was bound. Equal numbers mean
/// equal histories, and therefore equal contents, except with a probability of 2^-64.
constexpr std::uint64_t content_after(std::uint64_t content, std::uint64_t change) noexcept {
  content ^= change;
  content = (content ^ content >> 32) * 0x9E3779B97F4A7C15u;
  content = (content ^ content >> 29) * 0xD6E8FEB86659FD93u;
  return content ^ content >> 32;
}

/// The extent of the bits set in some planes of a change map. The ranges of planes and words are empty if no bit is
/// set. `rows` has the rows of each strip, ORed over all these planes and words.
struct ChangeExtent {
  IndexRange planes;
  IndexRange words;
  std::uint64_t rows[kMaxStrips];
};

/// The change map of a grid. Bit y - 64 strip of word (z, strip, k) is set if row (y, z) has changed obstacles that can
/// block voxels of word k. So a change near a word's end is noted in both words. Plane z also has a bit of its own, set
/// if the plane has any change. Bits past the grid's last row have no meaning.
class Changes {
 public:
  Changes(const Voxel& dims, std::uint64_t* storage) noexcept
      : row_words_(words_for(dims.x)),
        strips_(words_for(dims.y)),
        planes_(dims.z),
        summary_(storage),
        bits_(storage + words_for(dims.z)) {}

  /// Words of storage for a grid of these dimensions.
  static std::size_t words(const Voxel& dims) noexcept;

  std::int32_t row_words() const noexcept { return row_words_; }
  std::int32_t strips() const noexcept { return strips_; }
  std::int32_t planes() const noexcept { return planes_; }
  /// True if anything changed.
  bool any() const noexcept;
  /// True if plane z has a change; false past the grid.
  bool plane(std::int32_t z) const noexcept {
    return z >= 0 && z < planes_ && (summary_[z >> 6] >> (z & 63) & 1u) != 0;
  }
  /// The strip's changed rows in each word; none past the grid.
  const std::uint64_t* words_of(std::int32_t z, std::int32_t strip) const noexcept {
    return plane(z) && strip >= 0 && strip < strips_ ? bits_ + at(z, strip, 0) : kNoRows;
  }

  /// The extent of the changes in these planes.
  ChangeExtent extent(const IndexRange& planes) const noexcept;
  void clear() noexcept;
  void note_all() noexcept;
  /// Notes a change of words first .. last of row (y, z).
  void note(std::int32_t y, std::int32_t z, std::int32_t first, std::int32_t last) noexcept {
    summary_[z >> 6] |= std::uint64_t{1} << (z & 63);
    std::uint64_t* words = bits_ + at(z, y >> 6, 0);
    for (std::int32_t k = first; k <= last; ++k) words[k] |= std::uint64_t{1} << (y & 63);
  }

 private:
  static constexpr std::uint64_t kNoRows[kMaxRowWords] = {};

  void set_plane(std::int32_t z, std::uint64_t value) noexcept;
  std::size_t at(std::int32_t z, std::int32_t strip, std::int32_t k) const noexcept {
    return static_cast<std::size_t>((std::int64_t{z} * strips_ + strip) * row_words_ + k);
  }

  std::int32_t row_words_;
  std::int32_t strips_;
  std::int32_t planes_;
  std::uint64_t* summary_;
  std::uint64_t* bits_;
};

}  // namespace tern

#endif
