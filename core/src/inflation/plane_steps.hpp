// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Finds the rows of the blocked layer that equal those of the plane below. Most rows do, because obstacles are mostly
// boxes and walls.
#ifndef TERN_INFLATION_PLANE_STEPS_HPP
#define TERN_INFLATION_PLANE_STEPS_HPP

#include <cstdint>

#include "base/work.hpp"
#include "grid/bit_rows.hpp"
#include "grid/stencil.hpp"

namespace tern {

/// Planes whose marks are kept at the same time. If the radius reaches more planes up and down, planes are not
/// compared.
constexpr std::int32_t kStepPlanes = 13;
/// Number of planes for which comparing is switched off after marks were of no use.
constexpr std::int32_t kRestPlanes = 32;
/// Words of a row that are compared together.
constexpr std::int32_t kStepWords = 8;

/// A range of words of the rows of one strip.
struct StripWindow {
  std::int32_t strip;
  IndexRange rows;   ///< rows of the strip; others do not matter
  IndexRange words;  ///< at most kStepWords
};

/// The voxels that may differ, in one word of the rows of a strip: each of them is in one of `rows` and at one of
/// `bits`.
struct WordMark {
  std::uint64_t rows;
  std::uint64_t bits;
};

/// Goes through the planes of a window from the bottom up. For each plane, it compares the topmost obstacles within the
/// radius with those one plane below them, and marks the blocked voxels that the difference may change.
///
/// Obstacle voxels in plane s but not in plane s - 1 matter only for blocked planes below s. Obstacle voxels in s - 1
/// but not in s matter only for blocked planes above s. docs/grid.md says why.
class PlaneSteps {
 public:
  PlaneSteps(const Grid& grid, const Stencil& stencil);

  /// Begins at blocked plane z, for which nothing is known.
  void begin(const StripWindow& window, std::int32_t z);
  /// Goes on to the next plane.
  void advance();
  /// The operations of advance() if `follows`, else of begin().
  Operations operations(const StripWindow& window, bool follows) const;
  /// Notes whether the marks were of use for this plane. If they were of no use for many planes in a row, comparing is
  /// switched off for kRestPlanes planes.
  void judge(bool useful);
  /// The voxels in word k that may differ between the plane and the one below it. Bits of rows past the grid have no
  /// meaning.
  WordMark mark(std::int32_t k) const {
    return known_ ? marks_[z_ % kStepPlanes][k - window_.words.begin] : WordMark{kAllBits, kAllBits};
  }
  /// The range from the first to the last voxel that may differ in any row of these words. The first and the last word
  /// must have such voxels.
  IndexRange voxels(const IndexRange& words) const {
    return {kWordBits * words.begin + __builtin_ctzll(mark(words.begin).bits),
            kWordBits * words.end - __builtin_clzll(mark(words.end - 1).bits)};
  }
  /// False if nothing is known about the plane below.
  bool known() const { return known_; }

 private:
  /// Voxels that differ between two planes, with the rows that they can affect, from one word before the window to one
  /// word after it.
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
  StripWindow window_{};
  std::int32_t z_ = 0;
  bool known_ = false;
  std::int32_t useless_ = 0;  ///< planes in a row whose marks were of no use
  std::int32_t rest_ = 0;     ///< planes for which comparing is still switched off
  WordMark marks_[kStepPlanes][kStepWords];
};

}  // namespace tern

#endif
