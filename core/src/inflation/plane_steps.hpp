// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which rows of the blocked layer equal those of the plane below. Obstacles are boxes and walls, so most do.
#ifndef TERN_INFLATION_PLANE_STEPS_HPP
#define TERN_INFLATION_PLANE_STEPS_HPP

#include <cstdint>

#include "grid/bit_rows.hpp"
#include "grid/stencil.hpp"

namespace tern {

/// Planes whose marks are kept at once. A ball that reaches further along z, up and down, is not followed.
constexpr std::int32_t kStepPlanes = 13;
/// Planes to rest after marks were of no use.
constexpr std::int32_t kRestPlanes = 32;
/// Words of a row that are looked at together.
constexpr std::int32_t kStepWords = 8;

/// Some words of the rows of one block.
struct BlockWindow {
  std::int32_t block;
  IndexRange words;  ///< at most kStepWords
};

/// Voxels of one word in the rows of a block: those of the rows and of the bits, and maybe no other.
struct WordMark {
  std::uint64_t rows;
  std::uint64_t bits;
};

/// Follows a window up the planes. At each plane it compares the obstacles as far above as the ball reaches with those
/// one plane below them, and marks the blocked voxels that the difference may change.
///
/// Voxels that appear at plane s (marked there, not below) matter to blocked planes below s only, and those that vanish
/// (marked below, not there) to blocked planes above s only: further away than that, or on the other side, a voxel at
/// the same x and y that is nearer blocks as much.
class PlaneSteps {
 public:
  PlaneSteps(const Grid& grid, const Stencil& stencil);

  /// Begins at blocked plane z, of which nothing is known.
  void begin(const BlockWindow& window, std::int32_t z);
  /// Goes on to the next plane.
  void advance();
  /// Hears whether the marks were of use for this plane. Where they are not for many planes, it rests for some.
  void judge(bool useful);
  /// What may differ between the plane and the one below it, in word k. Bits of rows past the grid have no meaning.
  WordMark mark(std::int32_t k) const {
    return known_ ? marks_[z_ % kStepPlanes][k - window_.words.begin] : WordMark{kAllBits, kAllBits};
  }
  /// From the first voxel that may differ in any row to the last one, in these words, both of which have some.
  IndexRange voxels(const IndexRange& words) const {
    return {kWordBits * words.begin + __builtin_ctzll(mark(words.begin).bits),
            kWordBits * words.end - __builtin_clzll(mark(words.end - 1).bits)};
  }
  /// False where nothing is known of the plane below.
  bool known() const { return known_; }

 private:
  /// Differences of two planes, or what they reach: of the words from one before the window to one after it.
  struct Differences {
    WordMark words[kStepWords + 2];
  };

  bool followed() const { return reach_z_ > 0 && 2 * reach_z_ < kStepPlanes && reach_x_ < kWordBits; }
  void take(std::int32_t step);
  bool rows_differ(const IndexRange& rows, std::int32_t step) const;
  void add_row(const std::uint64_t* row, std::int32_t y, Differences& appearing, Differences& vanishing) const;
  void mark_planes(std::int32_t begin, std::int32_t end, const Differences& differences);

  BitRows obstacles_;
  Voxel dims_;
  std::int32_t reach_x_;
  std::int32_t reach_y_;
  std::int32_t reach_z_;
  BlockWindow window_{};
  std::int32_t z_ = 0;
  bool known_ = false;
  std::int32_t useless_ = 0;  ///< planes in a row
  std::int32_t rest_ = 0;     ///< planes to go on without comparing
  WordMark marks_[kStepPlanes][kStepWords];
};

}  // namespace tern

#endif
