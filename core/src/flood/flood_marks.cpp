// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "flood/flood_marks.hpp"

#include "flood/flood_layers.hpp"
#include "grid/lattice.hpp"

namespace tern {
namespace {

/// What a box around what can be reached has to spare, in cells: a cell counts as reached by its middle.
constexpr double kSpare = 0.6;

/// The way along an axis in `time` from velocity v0, at full acceleration up to the speed.
double reach_of(double v0, double speed, double acceleration, double time) {
  const double from = smaller(v0, speed);
  const double ramp = (speed - from) / acceleration;
  const double t = smaller(time, ramp);
  return from * t + 0.5 * acceleration * t * t + speed * larger(0.0, time - ramp);
}

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

void clear_out_of_reach(const FloodLattice& lattice, const Grid& grid, const FloodReach& from, double time,
                        std::uint64_t* layer) noexcept {
  const double spare = kSpare * lattice.size;
  Voxel low{};
  Voxel high{};
  for (int a = 0; a < 3; ++a) {
    const double speed = axis(from.fastest, a);
    const double strength = axis(from.strongest, a);
    const double base = axis(lattice.low, a) * grid.spec().cell;
    const double up = axis(from.point, a) + reach_of(axis(from.velocity, a), speed, strength, time) + spare;
    const double down = axis(from.point, a) - reach_of(-axis(from.velocity, a), speed, strength, time) - spare;
    axis(low, a) = floor_index((down - base) / lattice.size, -1, axis(lattice.cells, a));
    axis(high, a) = floor_index((up - base) / lattice.size, -1, axis(lattice.cells, a));
  }
  keep_box(lattice, low, high, layer);
}

}  // namespace tern
