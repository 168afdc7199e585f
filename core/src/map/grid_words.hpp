// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Operations on a grid that only the rolling map may use: writing whole words of obstacles, inflating piece by piece,
// copying, and moving the lattice under the voxels.
#ifndef TERN_MAP_GRID_WORDS_HPP
#define TERN_MAP_GRID_WORDS_HPP

#include <cstddef>
#include <cstdint>

#include "tern/grid.hpp"

namespace tern {

/// Planes of a piece of an inflation.
constexpr std::int32_t kInflatedPlanes = 4;

class GridWords {
 public:
  explicit GridWords(Grid& grid) noexcept : grid_(grid) {}

  /// The valid bits of word k of a row.
  static std::uint64_t valid_bits(const Grid& grid, std::int32_t k) noexcept {
    const std::int32_t left = grid.spec_.dims.x - 64 * k;
    return left >= 64 ? ~std::uint64_t{0} : ~(~std::uint64_t{0} << left);
  }

  /// The layers' first words. Rows follow each other as in the grid.
  std::uint64_t* obstacles() const noexcept { return grid_.obstacles_; }
  std::uint64_t* blocked() const noexcept { return grid_.blocked_; }

  /// True if the grid's storage begins at `words`.
  bool lies_in(const std::uint64_t* words) const noexcept { return grid_.words_ == words; }

  /// Replaces word k of obstacle row (y, z). Bits past the row must be 0. The revision grows if the grid was inflated
  /// and the word changes.
  void store(std::int32_t y, std::int32_t z, std::int32_t k, std::uint64_t word) const noexcept;

  /// Number of pieces of an inflation. A piece is kInflatedPlanes planes of 64 rows each.
  static std::int32_t inflation_pieces(const Voxel& dims) noexcept;
  /// Makes one piece of the blocked layer as inflate() would. The last piece also calls finish_inflation().
  void inflate_piece(std::int32_t piece, Work& work) const noexcept;
  void finish_inflation() const noexcept;

  /// Begins to make a bound grid equal to an inflated one of the same size, cell and radius. Their origins may differ.
  /// No Grid object is bound to its words until end_copy().
  void begin_copy(const Grid& from) const noexcept;
  /// Copies both layers of planes begin .. end - 1.
  void copy_planes(const Grid& from, std::int32_t begin, std::int32_t end) const noexcept;
  /// Ends the copy: this object is bound again, and inflated.
  void end_copy(const Grid& from) const noexcept;

  /// Begins to move the content of an inflated grid. No Grid object is bound to its words until end_shift().
  void begin_shift() const noexcept;
  /// Notes that words first .. last of obstacle row (y, z) have changed, so the blocked rows around them must be made
  /// again.
  void note(std::int32_t y, std::int32_t z, std::int32_t first, std::int32_t last) const noexcept;
  /// Moves the lattice's lower corner, and the boundary with it, to another place in the world.
  void move_to(const Vec3& origin) const noexcept;
  /// Ends the move: voxel v now has the content of voxel v + by before. Only this object is bound again. The noted
  /// words wait for inflation.
  void end_shift(const Voxel& by) const noexcept;

 private:
  Grid& grid_;
};

}  // namespace tern

#endif
