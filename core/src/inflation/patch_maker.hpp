// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_INFLATION_PATCH_MAKER_HPP
#define TERN_INFLATION_PATCH_MAKER_HPP

#include <cstdint>

#include "base/work.hpp"
#include "grid/bit_rows.hpp"
#include "grid/stencil.hpp"

namespace tern {

struct InflationTile;

/// A rectangle of the blocked layer, in one plane.
struct Patch {
  std::int32_t z;
  IndexRange rows;
  IndexRange words;
};

/// Makes patches of a grid's blocked layer. Rows and planes must lie inside the boundary.
class PatchMaker {
 public:
  PatchMaker(const Grid& grid, const Stencil& stencil, std::uint64_t* blocked) noexcept;

  /// Rows and planes that can be free: those inside the boundary.
  const IndexRange& rows_inside() const noexcept { return rows_inside_; }
  const IndexRange& planes_inside() const noexcept { return planes_inside_; }

  /// The most operations of copying and making the rows of one word of a strip, in all its patches.
  Operations most_operations() const noexcept;
  /// Makes the patch from the obstacles around it.
  void make(const Patch& patch, Work& work) const noexcept;
  /// Makes voxels [x.begin, x.end) of the patch's rows, and no others. The range must lie within the patch's words, and
  /// narrow() must be true for it.
  void make_narrow(const Patch& patch, const IndexRange& x, Work& work) const noexcept;
  /// True if a word can hold this many voxels together with everything along x that can block them.
  bool narrow(const IndexRange& x) const noexcept { return x.end - x.begin + 2 * reach_x_ <= kWordBits; }
  /// Copies the patch from the plane below.
  void copy_below(const Patch& patch, Work& work) const noexcept;

 private:
  Operations make_operations(const Patch& patch) const noexcept;
  IndexRange with_halo(const IndexRange& words) const noexcept;
  bool rows_apart(std::int32_t first, std::int32_t end) const noexcept;
  void store(const InflationTile& tile, const IndexRange& words) const noexcept;
  void store_narrow(const InflationTile& tile, const IndexRange& x, std::int32_t k) const noexcept;

  const Grid& grid_;
  const Stencil& stencil_;
  const BitRows rows_;  ///< the obstacle layer; also locates rows of the blocked layer
  std::uint64_t* blocked_;
  const std::int32_t reach_x_;
  IndexRange rows_inside_;
  IndexRange planes_inside_;
  std::uint64_t outside_x_[kMaxRowWords];  ///< a row's bits outside the boundary
  Operations tile_operations_;             ///< of making a tile, besides its words
  Operations word_operations_;
};

/// The most operations of inflating the whole grid, in pieces of at least one plane of one strip.
Operations inflation_operations(const Grid& grid) noexcept;

}  // namespace tern

#endif
