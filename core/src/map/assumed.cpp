// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the operator states before take-off: a ball that is free, or the column above the vehicle and the ground below.
#include "base/math.hpp"
#include "grid/cylinder.hpp"
#include "map/grid_words.hpp"
#include "map/map_state.hpp"
#include "map/voxel_words.hpp"

namespace tern {
namespace {

/// Square of the distance, on one axis, from a point to the farther face of voxel `index`, in cells.
double farthest_square(double cells, std::int32_t index) {
  const double far = larger(absolute(cells - index), absolute(cells - (index + 1)));
  return far * far;
}

/// Of the 64 voxels from `first` on along x, those whose farther face along x is within a distance of the centre.
std::uint64_t within_square(const Vec3& center, double square, const Voxel& first, std::int32_t count) {
  std::uint64_t bits = 0;
  if (square < 0.0) return bits;
  for (std::int32_t b = 0; b < 64 && first.x + b < count; ++b) {
    if (farthest_square(center.x, first.x + b) <= square) bits |= std::uint64_t{1} << b;
  }
  return bits;
}

/// Of the same voxels, those that lie wholly in a ball, and in an upright cylinder of any height.
std::uint64_t inside_ball(const Vec3& center, double square, const Voxel& first, std::int32_t count) {
  const double rest = square - farthest_square(center.y, first.y) - farthest_square(center.z, first.z);
  return within_square(center, rest, first, count);
}
std::uint64_t inside_disc(const Vec3& center, double square, const Voxel& first, std::int32_t count) {
  return within_square(center, square - farthest_square(center.y, first.y), first, count);
}

/// Marks voxels as seen: of those from `first` on, within(first) gives the bits of a word.
template <typename Within>
void assume_seen(MapState& state, Within within) {
  visit_words(all_voxels(state.spec.dims), [&](std::int32_t y, std::int32_t z, std::int32_t k, std::uint64_t) {
    const std::size_t at = state.row(y, z) + static_cast<std::size_t>(k);
    state.seen[at] |= within(Voxel{64 * k, y, z});
    state.store(y, z, k, GridWords(state.route).obstacles()[at]);
  });
  state.inflate();
}

}  // namespace

Status RollingMap::assume_free(const Vec3& center, double radius) noexcept {
  if (state_ == nullptr || busy()) return Status::kInvalidArgument;
  if (!finite(center) || !finite(radius)) return Status::kNonFiniteInput;
  if (radius < 0.0) return Status::kInvalidArgument;
  const double cell = state_->spec.cell;
  const Vec3 cells = (1.0 / cell) * state_->route.to_local(center);
  const double square = (radius / cell) * (radius / cell);
  assume_seen(*state_, [&](const Voxel& first) { return inside_ball(cells, square, first, state_->spec.dims.x); });
  return Status::kOk;
}

Status RollingMap::assume_column(const Cylinder& column) noexcept {
  if (state_ == nullptr || busy()) return Status::kInvalidArgument;
  const Status status = check(column);
  if (status != Status::kOk) return status;
  MapState& state = *state_;
  const double cell = state.spec.cell;
  const Vec3 base = state.route.to_local(column.base);
  const Vec3 cells = (1.0 / cell) * base;
  const double square = (column.radius / cell) * (column.radius / cell);
  assume_seen(state, [&](const Voxel& first) {
    const bool is_between = first.z * cell >= base.z && (first.z + 1) * cell <= base.z + column.height;
    return is_between ? inside_disc(cells, square, first, state.spec.dims.x) : 0;
  });
  state.column = column;
  return Status::kOk;
}

bool RollingMap::ground_at(const Vec3& place, double around, double& height) const noexcept {
  if (state_ == nullptr) return false;
  const Cylinder& column = state_->column;
  const double x = place.x - column.base.x;
  const double y = place.y - column.base.y;
  if (!(square_root(x * x + y * y) + around <= column.radius)) return false;
  height = column.base.z;
  return true;
}

}  // namespace tern
