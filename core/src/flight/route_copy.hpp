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
  bool done() const noexcept;
  /// Does a piece: some rows copied, or a piece of the inflation. Not where it is done; the map must not change before
  /// that. Returns what it took, in instructions (see Work).
  std::uint32_t advance(const RollingMap& map) noexcept;

  const Grid& grid() const noexcept { return grid_; }

 private:
  IndexRange emptied_voxels(std::int32_t y, std::int32_t z) const noexcept;
  std::int32_t copy_row(const RollingMap& map, std::int32_t row) noexcept;

  Grid grid_;
  IndexRange hole_[3];
  IndexRange near_[3];  ///< voxels along x, y and z
  Vec3 center_{};       ///< in voxels, and the voxels around it in which nothing is solid
  double emptied_ = 0.0;
  std::int32_t row_ = 0;    ///< next to copy
  std::int32_t piece_ = 0;  ///< of the inflation, next
};

}  // namespace tern

#endif
