// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The core reads a grid as rows of words, one bit a voxel. All masks of bits and all indices of rows are made here.
#ifndef TERN_GRID_BIT_ROWS_HPP
#define TERN_GRID_BIT_ROWS_HPP

#include <cstddef>
#include <cstdint>

#include "tern/grid.hpp"

namespace tern {

/// Voxels of a word.
constexpr std::int32_t kWordBits = 64;
constexpr std::uint64_t kAllBits = ~std::uint64_t{0};

/// Number of words that hold this many bits.
constexpr std::int32_t words_for(std::int32_t bits) noexcept {
  return (bits + kWordBits - 1) / kWordBits;
}

/// Words of the widest grid's rows.
constexpr std::int32_t kMaxRowWords = words_for(kMaxDimension);

/// A half-open range of voxel indices on one axis.
struct IndexRange {
  std::int32_t begin;
  std::int32_t end;
};

/// The indices that two ranges share; empty (begin >= end) if they share none.
inline IndexRange overlap(const IndexRange& a, const IndexRange& b) noexcept {
  return {a.begin > b.begin ? a.begin : b.begin, a.end < b.end ? a.end : b.end};
}

inline bool contains(const IndexRange& range, std::int32_t index) noexcept {
  return index >= range.begin && index < range.end;
}

/// True if two ranges share an index.
inline bool meets(const IndexRange& a, const IndexRange& b) noexcept {
  const IndexRange both = overlap(a, b);
  return both.begin < both.end;
}

/// Masks of the word that holds voxel x: the bits from x on (bits_from), and those before x (bits_before).
inline std::uint64_t bits_from(std::int32_t x) noexcept {
  return kAllBits << (x & 63);
}
inline std::uint64_t bits_before(std::int32_t x) noexcept {
  return ~bits_from(x);
}

/// The bits of a row's word k that lie in a range. The range must not be empty, and must meet the word.
inline std::uint64_t bits_within(const IndexRange& range, std::int32_t k) noexcept {
  std::uint64_t mask = kAllBits;
  if (k == range.begin >> 6) mask &= bits_from(range.begin);
  if (k == (range.end - 1) >> 6) mask &= kAllBits >> (63 - ((range.end - 1) & 63));
  return mask;
}

/// The bits of a row's word k that lie in a range; none if the range is empty or does not meet the word.
inline std::uint64_t bits_met(const IndexRange& range, std::int32_t k) noexcept {
  const IndexRange met = overlap(range, {kWordBits * k, kWordBits * (k + 1)});
  return met.begin < met.end ? bits_within(met, k) : 0;
}

/// The middle one of three words after each bit has spread by `reach` < 64 to both sides.
inline std::uint64_t spread_bits(std::uint64_t before, std::uint64_t own, std::uint64_t after,
                                 std::int32_t reach) noexcept {
  std::uint64_t up = own;
  std::uint64_t down = own;
  for (std::int32_t done = 0; done < reach;) {
    const std::int32_t step = done + 1 < reach - done ? done + 1 : reach - done;
    up |= up << step | before >> (64 - step);
    before |= before << step;
    down |= down >> step | after << (64 - step);
    after |= after >> step;
    done += step;
  }
  return up | down;
}

/// A layer's rows along x. Voxel x of a row is bit x % 64 of its word x / 64. Rows follow one another along y, and
/// planes along z.
struct BitRows {
  const std::uint64_t* words;  ///< first word of row (0, 0)
  std::int32_t row_words;      ///< words of a row
  std::int32_t plane_rows;     ///< rows of a plane

  /// Number of words before row (y, z). The row may lie outside the layer: index(0, 1) is the step from a plane to the
  /// next.
  std::ptrdiff_t index(std::int32_t y, std::int32_t z) const noexcept {
    return (static_cast<std::ptrdiff_t>(z) * plane_rows + y) * row_words;
  }
  /// Row (y, z). It must lie in the layer.
  const std::uint64_t* row(std::int32_t y, std::int32_t z) const noexcept { return words + index(y, z); }
};

/// The core's access to parts of a grid that users cannot read.
struct GridAccess {
  /// The two layers. Bits past dims.x are 0 in the obstacle layer and 1 in the blocked one.
  static BitRows obstacles(const Grid& grid) noexcept { return rows_of(grid, grid.obstacles_); }
  static BitRows blocked(const Grid& grid) noexcept { return rows_of(grid, grid.blocked_); }
  /// Words of one layer.
  static std::size_t layer_words(const Grid& grid) noexcept {
    return static_cast<std::size_t>(obstacles(grid).index(0, grid.spec_.dims.z));
  }

  /// A view of the grid whose blocked layer is `words`: layer_words() words, used as they are.
  static Grid with_blocked(const Grid& grid, std::uint64_t* words) noexcept {
    Grid view = grid;
    view.blocked_ = words;
    return view;
  }

  /// A view of the grid in which the obstacles themselves are what is blocked, without the radius around them.
  static Grid bare(const Grid& grid) noexcept { return with_blocked(grid, grid.obstacles_); }

  /// Gives a view another boundary: local frame, inside the grid's own. Both layers stay as they are.
  static void set_boundary(Grid& view, const Box& local) noexcept { view.local_boundary_ = local; }

  /// Makes `fine` a grid with the same origin and boundary, whose cell is halved `halvings` times. It has no layers:
  /// only its geometry can be used. False if such a grid cannot be bound.
  static bool halved(const Grid& grid, int halvings, Grid& fine) noexcept {
    GridSpec spec = grid.spec_;
    for (int k = 0; k < halvings; ++k) {
      spec.cell *= 0.5;
      spec.dims = {2 * spec.dims.x, 2 * spec.dims.y, 2 * spec.dims.z};
      if (grid_words(spec.dims) == 0 || spec.cell < kMinCell || spec.clearance() > spec.cell * kMaxDimension) {
        return false;
      }
    }
    fine.spec_ = spec;
    fine.local_boundary_ = grid.local_boundary_;
    return true;
  }

 private:
  static BitRows rows_of(const Grid& grid, const std::uint64_t* layer) noexcept {
    return {layer, grid.row_words_, grid.spec_.dims.y};
  }
};

}  // namespace tern

#endif
