// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "world/solid_layer.hpp"

#include <cstddef>

#include "base/capacity.hpp"
#include "base/math.hpp"
#include "base/work.hpp"
#include "grid/lattice.hpp"
#include "grid/stencil.hpp"
#include "inflation/patch_maker.hpp"

namespace tern {
namespace {

/// Blocks the voxels of a row that are in the range. An empty range blocks none.
void block_run(SolidLayer& layer, const Grid& view, std::int32_t y, std::int32_t z, const IndexRange& run) {
  if (run.end <= run.begin) return;
  std::uint64_t* row = layer.words + GridAccess::blocked(view).index(y, z);
  for (std::int32_t k = run.begin >> 6; k <= (run.end - 1) >> 6; ++k) row[k] |= bits_within(run, k);
}

/// A row of voxels by its lower corner, metres.
struct Row {
  double y;
  double z;
};

/// The least value of normal . p over the cubes of a row, without the term in x.
double least_across(const Vec3& normal, const Row& row, double cell) {
  const double y = normal.y * (normal.y < 0.0 ? row.y + cell : row.y);
  const double z = normal.z * (normal.z < 0.0 ? row.z + cell : row.z);
  return y + z;
}

/// Removes from `run` the voxels whose whole cube has normal . p >= offset. Along a row, these are at one end.
void keep_short_of(const Halfspace& beyond, const Row& row, double cell, IndexRange& run) {
  const double missing = beyond.offset - kLatticeTolerance * cell - least_across(beyond.normal, row, cell);
  const double slope = beyond.normal.x * cell;
  if (absolute(beyond.normal.x) <= kLatticeTolerance) {  // the whole row or none: x hardly matters and is bounded
    if (missing + absolute(slope) * static_cast<double>(kMaxDimension) <= 0.0) run.end = run.begin;
    return;
  }
  // The cube of voxel x begins at x. Its lower face decides if the normal points towards +x, otherwise its upper face.
  const double at = missing / slope;
  if (slope > 0.0) {
    const std::int32_t first = ceil_index(at - kLatticeTolerance, run.begin, run.end);
    run.end = first < run.end ? first : run.end;
  } else {
    const std::int32_t end = floor_index(at + kLatticeTolerance, run.begin - 1, run.end);
    run.begin = end > run.begin ? end : run.begin;
  }
}

/// If two normals are closer to opposite than this, their mean has no useful direction.
constexpr double kOpposite = -0.99;

void add_normal(const ConvexSolid& solid, const Vec3& unit, double radius, SolidLayer& layer) {
  layer.clear[layer.clear_count++] = {unit, radius - solid_support(-1.0 * unit, solid)};
}

/// The planes tried for the solid: a voxel beyond any of them is clear of it.
void collect_normals(const ConvexSolid& solid, double radius, SolidLayer& layer) {
  layer.clear_count = 0;
  for (int a = 0; a < 3; ++a) {
    Vec3 unit{0.0, 0.0, 0.0};
    axis(unit, a) = 1.0;
    add_normal(solid, unit, radius, layer);
    add_normal(solid, -1.0 * unit, radius, layer);
  }
  for (int i = 0; i < solid.face_count; ++i) {
    add_normal(solid, solid.faces[i].normal, radius, layer);
    for (int j = 0; j < i; ++j) {
      const double along = dot(solid.faces[i].normal, solid.faces[j].normal);
      if (along < kOpposite) continue;
      const Vec3 mean = solid.faces[i].normal + solid.faces[j].normal;
      add_normal(solid, (1.0 / length(mean)) * mean, radius, layer);
    }
  }
}

/// Rows whose cubes the solid, grown by the radius, may reach. They follow from the first six planes, which are
/// across the axes, two for each.
IndexRange rows_near(const SolidLayer& layer, const Grid& view, int a) {
  const double cell = view.spec().cell;
  const std::int32_t count = axis(view.spec().dims, a);
  return {floor_index(-layer.clear[2 * a + 1].offset / cell - 1.0, 0, count),
          ceil_index(layer.clear[2 * a].offset / cell + 1.0, 0, count)};
}

/// Makes plane z of the blocked layer from the obstacles, within the view's boundary.
void make_plane(SolidLayer& layer, const Grid& view, std::int32_t z, Work& work) {
  const Stencil stencil(view.spec());
  const PatchMaker maker(view, stencil, layer.words);
  const Voxel& dims = view.spec().dims;
  for (std::int32_t y = 0; y < dims.y; ++y) block_run(layer, view, y, z, {0, dims.x});
  work.spend(kStencilOperations + ops::kRow * dims.y);
  if (!contains(maker.planes_inside(), z)) return;
  const IndexRange x = inside_boundary(view, 0);
  const Patch patch{z, maker.rows_inside(), {x.begin >> 6, words_for(x.end)}};
  maker.make(patch, work);
}

}  // namespace

/// Each row of the ball around a voxel is added to each word of the plane.
Operations solid_plane_operations(const GridSpec& spec) noexcept {
  const Stencil stencil(spec);
  const Operations ball = (stencil.gap_z() + 1) * (2 * Operations{spec.dims.y} + 1);
  const Operations words = Operations{spec.dims.y} * words_for(spec.dims.x);
  const Operations rounds = 3 + 2 * Operations{stencil.gap_x() + 1} * (stencil.gap_z() + 1);
  return ops::kPiece + words * (ops::kWord * (3 + ball)) + (words / 64 + 1) * ops::kPiece * rounds;
}

Status copy_blocked(const Grid& grid, SolidLayer& layer, Grid& view) noexcept {
  const std::size_t words = GridAccess::layer_words(grid);
  if (is_full(words > static_cast<std::size_t>(kMaxWorldWords))) return Status::kWorldFull;
  const std::uint64_t* from = GridAccess::blocked(grid).words;
  for (std::size_t k = 0; k < words; ++k) layer.words[k] = from[k];
  view = GridAccess::with_blocked(grid, layer.words);
  layer.narrowed = false;
  return Status::kOk;
}

void block_outside(const Solids& solids, SolidLayer& layer, const Grid& view, std::int32_t z, Work& work) noexcept {
  const Voxel& dims = view.spec().dims;
  const double cell = view.spec().cell;
  work.spend(ops::kPiece + ops::kRow * dims.y * solids.wall_count);
  if (layer.narrowed) make_plane(layer, view, z, work);
  for (std::int32_t y = 0; y < dims.y; ++y) {
    for (int p = 0; p < solids.wall_count; ++p) {
      const Halfspace& plane = solids.walls[p];
      IndexRange run{0, dims.x};
      keep_short_of({-1.0 * plane.normal, -plane.offset}, {y * cell, z * cell}, cell, run);
      block_run(layer, view, y, z, run);
    }
  }
}

void prepare_solid(const ConvexSolid& solid, SolidLayer& layer, const Grid& view, Work& work) noexcept {
  collect_normals(solid, view.spec().clearance(), layer);
  layer.planes = rows_near(layer, view, 2);
  layer.rows = rows_near(layer, view, 1);
  work.spend(ops::kPiece + 12 * ops::kDot * layer.clear_count);
}

void block_solid(SolidLayer& layer, const Grid& view, std::int32_t z, Work& work) noexcept {
  work.spend(ops::kPiece);
  if (!contains(layer.planes, z)) return;
  const double cell = view.spec().cell;
  int cuts = 0;
  for (std::int32_t y = layer.rows.begin; y < layer.rows.end; ++y) {
    IndexRange run{0, view.spec().dims.x};
    int k = 0;
    for (; k < layer.clear_count && run.begin < run.end; ++k) {
      keep_short_of(layer.clear[k], {y * cell, z * cell}, cell, run);
    }
    block_run(layer, view, y, z, run);
    cuts += k + 1;
  }
  work.spend(ops::kRow * cuts);
}

}  // namespace tern
