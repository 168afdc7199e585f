// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Regions of a layer, and numbers that tell their content apart.
#ifndef TERN_GRID_REGIONS_HPP
#define TERN_GRID_REGIONS_HPP

#include <cstdint>

#include "grid/bit_rows.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// Rows of a region.
constexpr std::int32_t kBlockRows = kWordBits;

/// A layer's regions. A region is one word of each of 64 consecutive rows of a plane.
struct Regions {
  std::int32_t words;   ///< along x
  std::int32_t blocks;  ///< along y
  std::int32_t planes;  ///< along z

  explicit Regions(const Voxel& dims) noexcept : words(words_for(dims.x)), blocks(words_for(dims.y)), planes(dims.z) {}

  std::int32_t count() const noexcept { return words * blocks * planes; }
  std::int32_t at(std::int32_t z, std::int32_t block, std::int32_t word) const noexcept {
    return (z * blocks + block) * words + word;
  }
};

/// The number of a content after one more change: a hash of all changes since the grid was bound. Equal numbers mean
/// equal histories, and therefore equal contents, except with a probability of 2^-64.
constexpr std::uint64_t content_after(std::uint64_t content, std::uint64_t change) noexcept {
  content ^= change;
  content = (content ^ content >> 32) * 0x9E3779B97F4A7C15u;
  content = (content ^ content >> 29) * 0xD6E8FEB86659FD93u;
  return content ^ content >> 32;
}

}  // namespace tern

#endif
