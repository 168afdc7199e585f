// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Obstacles that do not come from a sensor: the prior; marked boxes, cylinders and points.
#include "base/math.hpp"
#include "base/work.hpp"
#include "grid/cylinder.hpp"
#include "grid/lattice.hpp"
#include "map/grid_words.hpp"
#include "map/map_state.hpp"
#include "map/voxel_words.hpp"

namespace tern {
namespace {

/// The window's voxels whose interior overlaps the box.
VoxelBox voxels_met(const GridSpec& window, const Box& box) {
  return {voxels_met(window, box.lower.x, box.upper.x, 0), voxels_met(window, box.lower.y, box.upper.y, 1),
          voxels_met(window, box.lower.z, box.upper.z, 2)};
}

/// Blocks the voxels in `hit` at once, whatever MapSpec::hits says.
void enter_marks(MapState& state) {
  if (state.timed) state.marked = state.time;
  visit_words(all_voxels(state.spec.dims), [&](std::int32_t y, std::int32_t z, std::int32_t k, std::uint64_t) {
    const std::size_t at = state.row(y, z) + static_cast<std::size_t>(k);
    const std::uint64_t marked = state.hit[at];
    state.low[at] &= ~marked;
    state.high[at] &= ~marked;
    state.hit[at] = 0;
    state.store(y, z, k, GridWords(state.route).obstacles()[at] | marked);
  });
  state.inflate();
}

}  // namespace

void MapState::mark_prior(std::int32_t z, const VoxelBox& kept, Work& work) noexcept {
  const bool plane_kept = contains(kept.z, z);
  work.spend(ops::kPiece * (spec.prior_count + spec.prior_cylinder_count));
  int words = 0;
  const auto mark = [&](const IndexRange& met_x, const IndexRange& met_y) {
    visit_words({met_x, met_y, {z, z + 1}}, [&](std::int32_t y, std::int32_t, std::int32_t k, std::uint64_t bits) {
      const bool row_kept = plane_kept && contains(kept.y, y);
      ++words;
      if (row_kept) bits &= ~bits_met(kept.x, k);
      GridWords(route).store(y, z, k, GridWords(route).obstacles()[row(y, z) + static_cast<std::size_t>(k)] | bits);
    });
  };
  for (std::int32_t p = 0; p < spec.prior_count; ++p) {
    const VoxelBox met = voxels_met(route.spec(), spec.prior[p]);
    if (contains(met.z, z)) mark(met.x, met.y);
  }
  for (std::int32_t p = 0; p < spec.prior_cylinder_count; ++p) {
    const Cylinder& cylinder = spec.prior_cylinders[p];
    if (!contains(planes_met(route.spec(), cylinder), z)) continue;
    visit_rows(route.spec(), cylinder, [&](std::int32_t y, const IndexRange& x) { mark(x, {y, y + 1}); });
  }
  work.spend(kMarkOperations * words);
}

void MapState::inflate() noexcept {
  route.inflate();
  safe.inflate();
}

Status RollingMap::mark_box(const Box& world) noexcept {
  if (state_ == nullptr || busy()) return Status::kInvalidArgument;
  if (!finite(world.lower) || !finite(world.upper)) return Status::kNonFiniteInput;
  if (!valid_box(world)) return Status::kInvalidArgument;
  MapState& state = *state_;
  visit_words(voxels_met(state.route.spec(), world),
              [&](std::int32_t y, std::int32_t z, std::int32_t k, std::uint64_t bits) {
                state.hit[state.row(y, z) + static_cast<std::size_t>(k)] |= bits;
              });
  enter_marks(state);
  return Status::kOk;
}

Status RollingMap::mark_cylinder(const Cylinder& world) noexcept {
  if (state_ == nullptr || busy()) return Status::kInvalidArgument;
  const Status status = check(world);
  if (status != Status::kOk) return status;
  MapState& state = *state_;
  const GridSpec& window = state.route.spec();
  const IndexRange z = planes_met(window, world);
  visit_rows(window, world, [&](std::int32_t row, const IndexRange& x) {
    visit_words({x, {row, row + 1}, z}, [&](std::int32_t y, std::int32_t plane, std::int32_t k, std::uint64_t bits) {
      state.hit[state.row(y, plane) + static_cast<std::size_t>(k)] |= bits;
    });
  });
  enter_marks(state);
  return Status::kOk;
}

Status RollingMap::mark_points(const Vec3* world, size_t count) noexcept {
  if (state_ == nullptr || busy() || (world == nullptr && count > 0)) return Status::kInvalidArgument;
  for (std::size_t k = 0; k < count; ++k) {
    if (!finite(world[k])) return Status::kNonFiniteInput;
  }
  MapState& state = *state_;
  for (std::size_t k = 0; k < count; ++k) {
    const Voxel v = state.route.voxel_of(state.route.to_local(world[k]));
    if (!state.route.inside(v)) continue;
    state.hit[state.row(v.y, v.z) + static_cast<std::size_t>(v.x >> 6)] |= std::uint64_t{1} << (v.x & 63);
  }
  enter_marks(state);
  return Status::kOk;
}

}  // namespace tern
