// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Binding a map to its words.
#include <new>

#include "base/capacity.hpp"
#include "base/math.hpp"
#include "base/verdict.hpp"
#include "grid/cylinder.hpp"
#include "map/grid_words.hpp"
#include "map/map_state.hpp"
#include "map/support.hpp"

namespace tern {
namespace {

constexpr std::int64_t kDay = std::int64_t{86400} * 1000000000;

Verdict invalid(Field field) {
  return {Status::kInvalidArgument, field};
}
bool not_negative(double x) {
  return finite(x) && x >= 0.0;
}

std::size_t state_words() {
  return (sizeof(MapState) + sizeof(std::uint64_t) - 1) / sizeof(std::uint64_t);
}
std::size_t layer_words(const Voxel& dims) {
  return static_cast<std::size_t>((dims.x + 63) / 64) * static_cast<std::size_t>(dims.y) *
         static_cast<std::size_t>(dims.z);
}

/// An image with all its levels takes 5/3 as many entries as it has pixels, a narrow one a little more. Twice the
/// pixels and a few suffice.
std::int64_t image_entries(const MapSpec& spec) {
  return 2 * std::int64_t{spec.pixels} + 64;
}
std::size_t image_words(const MapSpec& spec) {
  return static_cast<std::size_t>((image_entries(spec) + 3) / 4);
}

bool scans_fit(const MapSpec& spec) {
  const std::int64_t face = face_pixels(spec);
  return kFaces * face * face <= spec.pixels;
}

bool sensor_in_range(double scan_pixel) {
  return same(scan_pixel, 0.0) || (scan_pixel >= kMinScanPixel && scan_pixel <= 1.0);
}

bool margins_fit(const MapSpec& spec) {
  return not_negative(spec.depth_margin) && not_negative(spec.depth_margin_square) && not_negative(spec.pose_margin) &&
         not_negative(spec.angle_margin) && spec.angle_margin <= 0.5;
}

bool thresholds_fit(const MapSpec& spec) {
  return spec.hits >= 1 && spec.hits <= kMaxEvidence && spec.misses >= 1 && spec.misses <= kMaxEvidence &&
         spec.support >= 0 && spec.support <= kNeighbours;
}

bool cylinders_fit(const MapSpec& spec) {
  const std::int32_t count = spec.prior_cylinder_count;
  if (count < 0 || (spec.prior_cylinders == nullptr && count > 0)) return false;
  for (std::int32_t k = 0; k < count; ++k) {
    if (check(spec.prior_cylinders[k]) != Status::kOk) return false;
  }
  return true;
}

bool boxes_fit(const MapSpec& spec) {
  if (spec.prior_count < 0 || (spec.prior == nullptr && spec.prior_count > 0)) return false;
  for (std::int32_t k = 0; k < spec.prior_count; ++k) {
    const Box& box = spec.prior[k];
    if (!finite(box.lower) || !finite(box.upper)) return false;
    for (int a = 0; a < 3; ++a) {
      if (axis(box.lower, a) > axis(box.upper, a)) return false;
    }
  }
  return true;
}

/// Checks the fields that only a map has. The grids check the others.
Verdict check(const MapSpec& spec) {
  if (!finite(spec.range) || !(spec.range > 0.0) || spec.range > kMaxCell) return invalid(Field::kRange);
  if (!margins_fit(spec)) return invalid(Field::kMargins);
  if (!sensor_in_range(spec.scan_pixel)) return invalid(Field::kScanPixel);
  if (!thresholds_fit(spec)) return invalid(Field::kEvidence);
  if (spec.age < 0 || spec.age > kDay) return invalid(Field::kAge);
  if (spec.slack < 0 || spec.slack > kMaxDimension) return invalid(Field::kSlack);
  if (spec.pixels < 1) return invalid(Field::kPixels);
  if (is_full(spec.pixels > kMaxPixels || !scans_fit(spec))) return {Status::kPixelsFull, Field::kPixels};
  if (is_full(spec.prior_count > kMaxPriorBoxes || spec.prior_cylinder_count > kMaxPriorBoxes)) {
    return {Status::kPriorFull, Field::kPrior};
  }
  if (!boxes_fit(spec) || !cylinders_fit(spec)) return invalid(Field::kPrior);
  return kAccepted;
}

GridSpec grid_spec(const MapSpec& spec) {
  const Box window = window_box(spec.origin, spec.cell, spec.dims);
  return {spec.origin, spec.cell, spec.dims, window, spec.radius, spec.tracking_margin};
}

/// Divides the words between the layers and images, and clears them.
void lay_out(MapState& state, std::uint64_t* words) {
  const std::size_t layer = layer_words(state.spec.dims);
  std::uint64_t** const layers[] = {&state.seen, &state.low, &state.high, &state.hit};
  for (std::uint64_t** first : layers) {
    *first = words;
    words += layer;
  }
  for (std::size_t k = 0; k < 4 * layer; ++k) state.seen[k] = 0;
  state.hit_times = reinterpret_cast<std::int64_t*>(words);
  words += brick_count(state.spec.dims);
  state.forget_times();
  state.image = reinterpret_cast<Depth*>(words);
  state.image_entries = image_entries(state.spec);
  for (std::size_t k = 0; k < image_words(state.spec); ++k) words[k] = 0;
}

/// Nothing is seen yet: all of the safe grid is solid, and the prior is solid in both grids.
void fill(MapState& state) {
  const Voxel dims = state.spec.dims;
  Work work;
  for (std::int32_t z = 0; z < dims.z; ++z) {
    state.mark_prior(z, VoxelBox{}, work);
    for (std::int32_t y = 0; y < dims.y; ++y) {
      for (std::int32_t k = 0; k < state.row_words(); ++k) {
        state.store(y, z, k, GridWords(state.route).obstacles()[state.row(y, z) + static_cast<std::size_t>(k)]);
      }
    }
  }
  state.inflate();
}

}  // namespace

MapSpec map_spec(const Vec3& origin, double cell, const Voxel& dims, double radius) noexcept {
  MapSpec spec{};
  spec.origin = origin;
  spec.cell = cell;
  spec.dims = dims;
  spec.radius = radius;
  spec.range = 10.0;
  spec.depth_margin = 0.05;
  spec.pose_margin = 0.05;
  spec.hits = 1;
  spec.misses = 3;
  spec.slack = 4;
  spec.pixels = 320 * 240;
  return spec;
}

size_t map_words(const MapSpec& spec) noexcept {
  const std::size_t grid = grid_words(spec.dims);
  if (grid == 0 || spec.pixels < 1 || spec.pixels > kMaxPixels || !sensor_in_range(spec.scan_pixel)) return 0;
  if (!scans_fit(spec)) return 0;
  return state_words() + 2 * grid + 4 * layer_words(spec.dims) + brick_count(spec.dims) + image_words(spec);
}

Status RollingMap::bind(const MapSpec& spec, uint64_t* words, size_t word_count, Field* field) noexcept {
  Verdict verdict = check(spec);
  const std::size_t needed = map_words(spec);
  if (verdict.status == Status::kOk && needed == 0) verdict = invalid(Field::kDimensions);
  if (verdict.status == Status::kOk && (words == nullptr || word_count < needed)) verdict = invalid(Field::kStorage);
  if (field != nullptr) *field = verdict.field;
  if (verdict.status != Status::kOk) return verdict.status;
  // A grid is bound first. It comes last in the words, so if it refuses, nothing has been written.
  const std::size_t grid = grid_words(spec.dims);
  Grid route;
  std::uint64_t* const grids = words + (needed - 2 * grid);
  const Status status = route.bind(grid_spec(spec), grids, grid, field);
  if (status != Status::kOk) return status;
  state_ = new (words) MapState{};
  state_->spec = spec;
  state_->route = route;
  state_->safe.bind(grid_spec(spec), grids + grid, grid);
  state_->face = face_pixels(spec);
  lay_out(*state_, words + state_words());
  fill(*state_);
  return Status::kOk;
}

}  // namespace tern
