// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "flood/flood_marks.hpp"

#include "grid/lattice.hpp"

namespace tern {
namespace {

/// The cells along an axis whose middles are within `reach` of `at`.
IndexRange cells_within(const FloodLattice& lattice, const Vec3& first, double at, double reach, int a) {
  const std::int32_t count = axis(lattice.cells, a);
  const double from = (at - reach - axis(first, a)) / lattice.size;
  const double to = (at + reach - axis(first, a)) / lattice.size;
  return {ceil_index(from, 0, count), floor_index(to, -1, count - 1) + 1};
}

/// How much of the squared distance `need` two gaps across leave for the third.
double left_of(double need, double gap_y, double gap_z) {
  return need * need - (larger(0.0, gap_y) * larger(0.0, gap_y) + larger(0.0, gap_z) * larger(0.0, gap_z));
}

void clear_near(const FloodLattice& lattice, const Vec3& first, const Vec3& half, const Vec3& place, double need,
                std::uint64_t* layer, Operations& spent) {
  const IndexRange ys = cells_within(lattice, first, place.y, need + half.y, 1);
  const IndexRange zs = cells_within(lattice, first, place.z, need + half.z, 2);
  for (std::int32_t z = zs.begin; z < zs.end; ++z) {
    const double gap_z = absolute(first.z + z * lattice.size - place.z) - half.z;
    for (std::int32_t y = ys.begin; y < ys.end; ++y) {
      const double gap_y = absolute(first.y + y * lattice.size - place.y) - half.y;
      const double left = left_of(need, gap_y, gap_z);
      spent += ops::kRow;
      if (left < 0.0) continue;
      const IndexRange xs = cells_within(lattice, first, place.x, square_root(left) + half.x, 0);
      if (xs.begin >= xs.end) continue;
      std::uint64_t* const row = layer + lattice.row(y, z);
      for (std::int32_t k = xs.begin >> 6; k <= (xs.end - 1) >> 6; ++k) row[k] &= ~bits_within(xs, k);
    }
  }
}

}  // namespace

Operations clear_near_thing(const FloodLattice& lattice, const Grid& grid, const Things& things, const Track& track,
                            double time, double more, std::uint64_t* layer) noexcept {
  Operations spent = ops::kPiece + ops::kTurn * track.piece_count + (track.piece_count > 0 ? ops::kCurve : 0);
  Vec3 place{};
  double need = 0.0;
  if (!thing_now(things, track, time, place, need)) return spent;
  const Vec3 first = middle_of(lattice, grid, {0, 0, 0});
  clear_near(lattice, first, half_extent(track), place, larger(0.0, need + more), layer, spent);
  return spent;
}

}  // namespace tern
