// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The grid that a flight plans on: a copy of the map's route grid, so that the map may go on while a plan is made.
// Unseen voxels near the vehicle are obstacles in the copy, because no sensor will show them before the vehicle is
// there. So may those be that follow a wall upwards or downwards: a level camera sees of a near wall but a strip, and
// what is above and below is hardly ever a way through.
#ifndef TERN_FLIGHT_ROUTE_COPY_HPP
#define TERN_FLIGHT_ROUTE_COPY_HPP

#include <cstddef>
#include <cstdint>

#include "base/progress.hpp"
#include "base/work.hpp"
#include "grid/bit_rows.hpp"
#include "tern/map.hpp"

namespace tern {

/// So many obstacles one above the other are a wall.
constexpr int kWallVoxels = 4;

/// Which unseen voxels are solid in the copy. Lengths in metres around the vehicle; 0 for none.
struct CopyRule {
  double near;     ///< those within this along every axis,
  double hole;     ///< but for those within this along every axis
  double emptied;  ///< and nothing at all is solid within this distance
  bool has_walls;  ///< those above and below walls as well, to the next voxel that was seen
};

class RouteCopy {
 public:
  /// Binds the copy to storage of grid_words(dims) words.
  Status bind(const RollingMap& map, std::uint64_t* words, std::size_t count) noexcept;
  /// Begins to copy. `center`: of the vehicle, world frame.
  void begin(const RollingMap& map, const Vec3& center, const CopyRule& rule) noexcept;
  bool done() const noexcept;
  /// Does one piece: it copies some columns of words, or inflates a part. Must not be called once done() is true; the
  /// map must not change before that.
  void advance(const RollingMap& map, Work& work) noexcept;

  const Grid& grid() const noexcept { return grid_; }
  /// True if unseen voxels are solid because they are above or below a wall.
  bool presumes_walls() const noexcept { return presumes_; }

 private:
  IndexRange emptied_voxels(std::int32_t y, std::int32_t z) const noexcept;
  bool copy_column(const RollingMap& map, std::int32_t y, std::int32_t k, std::int32_t& changed) noexcept;
  std::int32_t compose_column(const RollingMap& map, std::int32_t y, std::int32_t k, bool is_walled) noexcept;

  Grid grid_;
  IndexRange hole_[3];
  IndexRange near_[3];    ///< voxels along x, y and z
  Vec3 center_{};         ///< in voxels
  double emptied_ = 0.0;  ///< radius around the centre in which nothing is solid, in voxels
  bool has_walls_ = false;
  bool presumes_ = false;
  std::int32_t column_ = 0;  ///< the next column of words to copy
  std::int32_t piece_ = 0;   ///< the next piece of the inflation
  /// Of a column of words, from the lowest voxels up: what follows a wall downwards.
  std::uint64_t below_wall_[kMaxDimension];
};

}  // namespace tern

#endif
