// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The grid that a flight plans on: a copy of the map's route grid, so that the map may go on while a plan is made.
// Unseen voxels near the vehicle are obstacles in the copy, because no sensor will show them before the vehicle is
// there.
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
  /// Binds the copy to storage of grid_words(dims) words.
  Status bind(const RollingMap& map, std::uint64_t* words, std::size_t count) noexcept;
  /// Begins to copy. Unseen voxels are solid within `near` of `center` along every axis, but not if they are within
  /// `hole` along every axis. Nothing is solid within the distance `emptied`. All in metres, world frame.
  void begin(const RollingMap& map, const Vec3& center, double near, double hole, double emptied) noexcept;
  bool done() const noexcept;
  /// Does one piece: it copies some rows, or inflates a part. Must not be called once done() is true; the map must not
  /// change before that.
  void advance(const RollingMap& map, Work& work) noexcept;

  const Grid& grid() const noexcept { return grid_; }

 private:
  struct CopiedRow {
    std::int32_t changed;  ///< words
    bool is_composed;      ///< false if it was enough to compare
  };

  IndexRange emptied_voxels(std::int32_t y, std::int32_t z) const noexcept;
  CopiedRow copy_row(const RollingMap& map, std::int32_t row) noexcept;

  Grid grid_;
  IndexRange hole_[3];
  IndexRange near_[3];      ///< voxels along x, y and z
  Vec3 center_{};           ///< in voxels
  double emptied_ = 0.0;    ///< radius around the centre in which nothing is solid, in voxels
  std::int32_t row_ = 0;    ///< the next row to copy
  std::int32_t piece_ = 0;  ///< the next piece of the inflation
};

}  // namespace tern

#endif
