// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The map around the vehicle at half its resolution. An octet is 2 x 2 x 2 voxels. It is known if the vehicle's centre
// may be in one of its voxels for all that is known, and open if that holds only as long as nothing is in what was not
// seen. Obstacles are grown by the radius already, so that no way leads through a wall from octet to octet.
#ifndef TERN_LOOKOUT_OCTETS_HPP
#define TERN_LOOKOUT_OCTETS_HPP

#include <cstddef>
#include <cstdint>

#include "base/work.hpp"
#include "grid/bit_rows.hpp"
#include "tern/map.hpp"

namespace tern {

/// Octets along x: a row is one word.
constexpr std::int32_t kOctetsX = kWordBits;
/// Octets along y and z, at most: by the capacities of the profile, because each row of them takes nine words.
constexpr std::int32_t kOctetsY = kMaxDimension >= 2048 ? 64 : (kMaxDimension >= 512 ? 32 : 16);
constexpr std::int32_t kOctetsZ = kMaxDimension >= 2048 ? 32 : (kMaxDimension >= 512 ? 16 : 8);

/// Words of one layer for a map of these dimensions.
std::size_t octet_layer_words(const Voxel& dims) noexcept;

struct Octets {
  Voxel origin;          ///< the lower voxel of octet (0, 0, 0)
  Voxel count;           ///< octets along each axis
  std::uint64_t* known;  ///< a word a row
  std::uint64_t* open;   ///< octets that are open and not known
  double edge;           ///< of an octet, metres

  /// Chooses the octets around a voxel. `words`: two layers.
  void place(const Grid& window, const Voxel& around, std::uint64_t* words) noexcept;
  /// Reads a plane of octets from the map. Both of its grids must be inflated.
  void read_plane(const RollingMap& map, std::int32_t z, Work& work) noexcept;
  /// Makes all open octets whose centre is within `radius` of a voxel's centre neither open nor known; radius in
  /// metres.
  void close_around(const Voxel& voxel, double radius) const noexcept;

  bool has(const Voxel& octet) const noexcept {
    return octet.x >= 0 && octet.y >= 0 && octet.z >= 0 && octet.x < count.x && octet.y < count.y && octet.z < count.z;
  }
  /// The octet of a voxel, which may be outside.
  Voxel of(const Voxel& voxel) const noexcept;
  std::int32_t rows() const noexcept { return count.y * count.z; }
  std::int32_t row(const Voxel& octet) const noexcept { return octet.z * count.y + octet.y; }
  /// A number for an octet, and the octet of a number.
  std::int32_t index(const Voxel& octet) const noexcept { return row(octet) * kOctetsX + octet.x; }
  Voxel octet(std::int32_t index) const noexcept;
  bool bit(const std::uint64_t* layer, const Voxel& octet) const noexcept {
    return (layer[row(octet)] >> octet.x & 1u) != 0;
  }
  /// The first of an octet's voxels that is free in the grid, from the lower layer on or from the upper one; one that
  /// is not if none is.
  Voxel free_voxel(const Grid& grid, const Voxel& octet, bool from_top = false) const noexcept;
  /// Of an octet's middle, local frame, metres.
  double middle_height(const Voxel& octet, double cell) const noexcept;
};

}  // namespace tern

#endif
