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
double reach_of(double v0, const FloodAxis& limits, double time) {
  const double gain = larger(0.0, limits.fastest - v0);
  const SpeedUp up = speed_up(gain, limits);
  const double since = larger(0.0, time - 0.5 * up.delay);
  const double t = smaller(since, up.ramp);
  const double from = smaller(v0, limits.fastest);
  return from * time + 0.5 * up.acceleration * t * t + gain * (since - t);
}

/// The cells along an axis whose middles are between two places.
IndexRange cells_between(const FloodLattice& lattice, const Vec3& first, double low, double high, int a) {
  const std::int32_t count = axis(lattice.cells, a);
  const double from = (low - axis(first, a)) / lattice.size;
  const double to = (high - axis(first, a)) / lattice.size;
  return {ceil_index(from, 0, count), floor_index(to, -1, count - 1) + 1};
}

/// The cells along an axis whose middles are within `reach` of `at`.
IndexRange cells_within(const FloodLattice& lattice, const Vec3& first, double at, double reach, int a) {
  return cells_between(lattice, first, at - reach, at + reach, a);
}

/// How much of the squared distance `need` two gaps across leave for the third.
double left_of(double need, double gap_y, double gap_z) {
  return need * need - (larger(0.0, gap_y) * larger(0.0, gap_y) + larger(0.0, gap_z) * larger(0.0, gap_z));
}

/// What is cleared: a box with round edges, less what lies beyond the faces of a solid in it.
struct Near {
  Vec3 place;  ///< of the box's middle
  Vec3 half;
  double need;
  const ConvexSolid* solid;  ///< null: none
  Vec3 centre;               ///< that the solid is relative to
};

/// The part of a row of cells, whose middles have `y` and `z`, that is not beyond any face by more than is needed.
void cut_row(const Near& near, double y, double z, double& low, double& high) {
  constexpr double kAcross = 1e-12;
  for (int f = 0; f < near.solid->face_count; ++f) {
    const Halfspace& face = near.solid->faces[f];
    const Vec3 from = Vec3{0.0, y, z} - near.centre;
    const double left = near.need + face.offset - dot(face.normal, from);
    if (face.normal.x > kAcross) high = smaller(high, left / face.normal.x);
    if (face.normal.x < -kAcross) low = larger(low, left / face.normal.x);
    if (absolute(face.normal.x) <= kAcross && left <= 0.0) high = low - 1.0;
  }
}

void clear_near(const FloodLattice& lattice, const Vec3& first, const Near& near, std::uint64_t* layer,
                Operations& spent) {
  const Vec3& place = near.place;
  const Vec3& half = near.half;
  const double need = near.need;
  const IndexRange ys = cells_within(lattice, first, place.y, need + half.y, 1);
  const IndexRange zs = cells_within(lattice, first, place.z, need + half.z, 2);
  for (std::int32_t z = zs.begin; z < zs.end; ++z) {
    const double gap_z = absolute(first.z + z * lattice.size - place.z) - half.z;
    for (std::int32_t y = ys.begin; y < ys.end; ++y) {
      const double gap_y = absolute(first.y + y * lattice.size - place.y) - half.y;
      const double left = left_of(need, gap_y, gap_z);
      spent += ops::kRow;
      if (left < 0.0) continue;
      spent += ops::kRow + 2 * ops::kDot;
      const double reach = square_root(left) + half.x;
      double low = place.x - reach;
      double high = place.x + reach;
      if (near.solid != nullptr) {
        cut_row(near, first.y + y * lattice.size, first.z + z * lattice.size, low, high);
        spent += ops::kDot * near.solid->face_count;
      }
      const IndexRange xs = cells_between(lattice, first, low, high, 0);
      if (xs.begin >= xs.end) continue;
      std::uint64_t* const row = layer + lattice.row(y, z);
      for (std::int32_t k = xs.begin >> 6; k <= (xs.end - 1) >> 6; ++k) row[k] &= ~bits_within(xs, k);
    }
  }
}

FloodAxis limits_along(const FloodReach& from, int a) {
  return {axis(from.fastest, a), axis(from.strongest, a), axis(from.sharpest, a)};
}

}  // namespace

SpeedUp speed_up(double gain, const FloodAxis& limits) noexcept {
  const double most = smaller(limits.strongest, square_root(gain * limits.sharpest));
  return most > 0.0 ? SpeedUp{most, gain / most, most / limits.sharpest} : SpeedUp{0.0, 0.0, 0.0};
}

Operations clear_near_thing(const FloodLattice& lattice, const Grid& grid, const Things& things, const Track& track,
                            double time, double more, std::uint64_t* layer) noexcept {
  Operations spent = ops::kPiece + ops::kTurn * track.piece_count + (track.piece_count > 0 ? ops::kCurve : 0);
  Vec3 place{};
  double need = 0.0;
  if (!thing_now(things, track, time, place, need)) return spent;
  const Vec3 first = middle_of(lattice, grid, {0, 0, 0});
  const Box extent = extent_of(things, track);
  const Vec3 middle = 0.5 * (extent.lower + extent.upper);
  const ConvexSolid* const solid = track.shape == kConvex ? &things.solid_of(track) : nullptr;
  const Near near{place + middle, 0.5 * (extent.upper - extent.lower), larger(0.0, need + more), solid, place};
  clear_near(lattice, first, near, layer, spent);
  return spent;
}

void clear_out_of_reach(const FloodLattice& lattice, const Grid& grid, const FloodReach& from, double time,
                        std::uint64_t* layer) noexcept {
  const double spare = kSpare * lattice.size;
  Voxel low{};
  Voxel high{};
  for (int a = 0; a < 3; ++a) {
    const FloodAxis limits = limits_along(from, a);
    const double base = axis(lattice.low, a) * grid.spec().cell;
    const double up = axis(from.point, a) + reach_of(axis(from.velocity, a), limits, time) + spare;
    const double down = axis(from.point, a) - reach_of(-axis(from.velocity, a), limits, time) - spare;
    axis(low, a) = floor_index((down - base) / lattice.size, -1, axis(lattice.cells, a));
    axis(high, a) = floor_index((up - base) / lattice.size, -1, axis(lattice.cells, a));
  }
  keep_box(lattice, low, high, layer);
}

}  // namespace tern
