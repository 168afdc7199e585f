// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_SEARCH_TURN_WRITER_HPP
#define TERN_SEARCH_TURN_WRITER_HPP

#include "base/capacity.hpp"
#include "base/direction.hpp"
#include "grid/lattice.hpp"
#include "tern/grid.hpp"
#include "tern/path.hpp"
#include "tern/status.hpp"

namespace tern {

/// Writes the turning points of a path over voxels to Path::raw one by one, and then the path's length. A point in line
/// with the last two replaces the last one.
struct TurnWriter {
  const Grid& grid;
  Path& path;
  int capacity;  ///< most points of Path::raw
  Voxel last;
  int heading = kHere;  ///< direction of the last run; kHere before the first run
  bool full = false;
  MoveCounts moves{0, 0, 0};

  /// Begins at `start`, and leaves room for `reserve` more points.
  TurnWriter(const Grid& g, Path& out, int reserve, const Voxel& start) noexcept
      : grid(g), path(out), capacity(kMaxJumpPoints - reserve), last(start) {
    point(start);
  }

  void point(const Voxel& voxel) noexcept {
    full = full || is_full(path.raw_count >= capacity);
    if (!full) path.raw[path.raw_count++] = free_point(grid, voxel);
  }

  /// Continues the path by `steps` equal moves.
  void run(int move, std::int32_t steps) noexcept {
    if (steps == 0) return;
    const Voxel step = offset(move);
    last = {last.x + steps * step.x, last.y + steps * step.y, last.z + steps * step.z};
    count(axes_of(move), steps);
    if (heading == move && !full) {
      path.raw[path.raw_count - 1] = free_point(grid, last);
      return;
    }
    heading = move;
    point(last);
  }

  /// Ends the path after its last run, and sets Path::grid_length. kOk, or kJumpPointsFull.
  Status finish() noexcept {
    constexpr double kSqrt2 = 1.4142135623730951;
    constexpr double kSqrt3 = 1.7320508075688772;
    path.grid_length = (kSqrt3 * moves.space + kSqrt2 * moves.plane) + moves.straight;
    return full ? Status::kJumpPointsFull : Status::kOk;
  }

 private:
  void count(int axes, std::int32_t steps) noexcept {
    (axes == 1 ? moves.straight : (axes == 2 ? moves.plane : moves.space)) += steps;
  }
};

}  // namespace tern

#endif
