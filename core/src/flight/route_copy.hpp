// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The grid that a flight plans on: a copy of the map's route grid, so that the map may go on while a plan is made.
// Unseen voxels near the vehicle are obstacles in it: what nobody has seen there, nothing will show before it is flown.
#ifndef TERN_FLIGHT_ROUTE_COPY_HPP
#define TERN_FLIGHT_ROUTE_COPY_HPP

#include <cstddef>
#include <cstdint>

#include "base/progress.hpp"
#include "base/work.hpp"
#include "grid/bit_rows.hpp"
#include "tern/map.hpp"

namespace tern {

class RouteCopy {
 public:
  /// Storage of grid_words(dims).
  Status bind(const RollingMap& map, std::uint64_t* words, std::size_t count) noexcept;
  /// Begins to copy. From `hole` to `near` away from `center` along some axis, the unseen is solid. Nothing is solid
  /// within `emptied` of the center.
  void begin(const RollingMap& map, const Vec3& center, double near, double hole, double emptied) noexcept;
  /// The map must not change before it is done. A unit is 64 words copied, or 16 inflated.
  Progress advance(const RollingMap& map, Work& work) noexcept;

  const Grid& grid() const noexcept { return grid_; }

 private:
  IndexRange emptied_voxels(std::int32_t y, std::int32_t z) const noexcept;
  void copy_row(const RollingMap& map, std::int32_t row) noexcept;
  void inflate_piece() noexcept;
  std::uint32_t price() const noexcept;

  Grid grid_;
  IndexRange hole_[3];
  IndexRange near_[3];  ///< voxels along x, y and z
  Vec3 center_{};       ///< in voxels, and the voxels around it in which nothing is solid
  double emptied_ = 0.0;
  std::int32_t row_ = 0;    ///< next to copy
  std::int32_t plane_ = 0;  ///< next to inflate
  std::uint32_t paid_ = 0;
};

}  // namespace tern

#endif
