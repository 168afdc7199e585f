// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Binding a grid to its storage, and the frames.
#include "tern/grid.hpp"

#include "base/math.hpp"
#include "base/verdict.hpp"
#include "grid/changes.hpp"
#include "grid/distance.hpp"
#include "grid/lattice.hpp"
#include "grid/stencil.hpp"

namespace tern {
namespace {

/// Words before the layers: one cache line, so that the layers are aligned to cache lines if the storage is.
constexpr std::size_t kHeaderWords = 8;

/// First word of a storage that has been bound before.
constexpr std::uint64_t kHeaderTag = 0x7465726E2D677264u;

/// Each bind begins with the next multiple of this as its revision. It is later than every earlier revision of the
/// grid, even one that a copy of the grid counted in storage that is gone.
constexpr std::uint64_t kBindStep = std::uint64_t{1} << 32;

Verdict invalid(Field field) {
  return {Status::kInvalidArgument, field};
}

Verdict check_finite(const GridSpec& spec) {
  if (!finite(spec.origin)) return {Status::kNonFiniteInput, Field::kOrigin};
  if (!finite(spec.cell)) return {Status::kNonFiniteInput, Field::kCell};
  if (!finite(spec.boundary.lower) || !finite(spec.boundary.upper)) return {Status::kNonFiniteInput, Field::kBoundary};
  if (!finite(spec.radius)) return {Status::kNonFiniteInput, Field::kRadius};
  if (!finite(spec.tracking_margin)) return {Status::kNonFiniteInput, Field::kTrackingMargin};
  return kAccepted;
}

bool origin_resolves_cells(const GridSpec& spec) {
  for (int a = 0; a < 3; ++a) {
    if (!resolves_cells(axis(spec.origin, a), spec.cell)) return false;
  }
  return true;
}

/// True if the boundary is not inverted and, but for rounding, lies inside the grid's box.
bool boundary_fits(const GridSpec& spec) {
  for (int a = 0; a < 3; ++a) {
    const double lower = axis(spec.boundary.lower, a);
    const double upper = axis(spec.boundary.upper, a);
    if (lower > upper) return false;
    const double origin = axis(spec.origin, a);
    if ((lower - origin) / spec.cell < -world_tolerance(spec, lower)) return false;
    const double count = static_cast<double>(axis(spec.dims, a));
    if ((upper - origin) / spec.cell > count + world_tolerance(spec, upper)) return false;
  }
  return true;
}

Verdict check(const GridSpec& spec, const std::uint64_t* words, std::size_t word_count) {
  const Verdict numbers = check_finite(spec);
  if (numbers.status != Status::kOk) return numbers;
  const std::size_t needed = grid_words(spec.dims);
  if (needed == 0) return invalid(Field::kDimensions);
  if (words == nullptr || word_count < needed) return invalid(Field::kStorage);
  if (spec.cell < kMinCell || spec.cell > kMaxCell) return invalid(Field::kCell);
  if (!origin_resolves_cells(spec)) return invalid(Field::kOrigin);
  if (spec.tracking_margin < 0.0) return invalid(Field::kTrackingMargin);
  if (spec.radius < 0.0 || spec.clearance() > spec.cell * kMaxDimension) return invalid(Field::kRadius);
  if (!boundary_fits(spec)) return invalid(Field::kBoundary);
  return kAccepted;
}

std::size_t words_of_layer(const Voxel& dims) {
  return static_cast<std::size_t>(words_for(dims.x)) * static_cast<std::size_t>(dims.y) *
         static_cast<std::size_t>(dims.z);
}

/// One face of the boundary in the local frame: moved onto the lattice if it lies there but for rounding, and into the
/// grid.
double local_face(const GridSpec& spec, double world, int a) {
  const double local = onto_lattice(spec, world - axis(spec.origin, a), a);
  return clamp(local, 0.0, axis(spec.dims, a) * spec.cell);
}

Box boundary_in_grid(const GridSpec& spec) {
  Box local{};
  for (int a = 0; a < 3; ++a) {
    axis(local.lower, a) = local_face(spec, axis(spec.boundary.lower, a), a);
    axis(local.upper, a) = local_face(spec, axis(spec.boundary.upper, a), a);
  }
  return local;
}

std::uint64_t hash_after(std::uint64_t hash, double number) {
  std::uint64_t bits = 0;
  __builtin_memcpy(&bits, &number, sizeof bits);
  return content_after(hash, bits);
}

std::uint64_t hash_after(std::uint64_t hash, const Vec3& point) {
  return hash_after(hash_after(hash_after(hash, point.x), point.y), point.z);
}

/// The content number of an empty grid: a hash of everything that its blocked layer depends on.
std::uint64_t content_of(const GridSpec& spec, const Box& local_boundary) {
  std::uint64_t content = hash_after(hash_after(0, spec.cell), spec.clearance());
  content = hash_after(hash_after(content, local_boundary.lower), local_boundary.upper);
  for (int a = 0; a < 3; ++a) content = content_after(content, static_cast<std::uint64_t>(axis(spec.dims, a)));
  return content;
}

/// A number that differs between all binds of a storage, and between views of different specs.
std::uint64_t binding_of(const GridSpec& spec, std::uint64_t content, std::uint64_t revision) {
  const std::uint64_t frame =
      hash_after(hash_after(hash_after(content, spec.origin), spec.boundary.lower), spec.boundary.upper);
  return content_after(frame, revision);
}

/// Reads a word of storage that may never have been written. The volatile read gives it one definite value.
std::uint64_t word_as_it_is(const std::uint64_t& word) {
  return *static_cast<const volatile std::uint64_t*>(&word);
}

/// The index of the last voxel inside the boundary. A point on the upper face belongs to it.
std::int32_t last_index(double upper, double cell, std::int32_t count) {
  const std::int32_t last = ceil_index(upper / cell - kLatticeTolerance, 0, count) - 1;
  return last < 0 ? 0 : last;
}

}  // namespace

std::size_t grid_words(const Voxel& dims) noexcept {
  for (int a = 0; a < 3; ++a) {
    if (axis(dims, a) < 1 || axis(dims, a) > kMaxDimension) return 0;
  }
  if (std::int64_t{dims.x} * dims.y * dims.z > kMaxCells) return 0;
  return kHeaderWords + 2 * words_of_layer(dims) + Changes::words(dims);
}

Status Grid::bind(const GridSpec& spec, std::uint64_t* words, std::size_t word_count, Field* field) noexcept {
  const Verdict verdict = check(spec, words, word_count);
  if (field != nullptr) *field = verdict.field;
  if (verdict.status != Status::kOk) return verdict.status;
  const std::size_t layer = words_of_layer(spec.dims);
  spec_ = spec;
  // Inflation takes a radius within the tolerance as 0. It is stored as 0, so that all stages do.
  if (spec.clearance() <= kClearTolerance) spec_.radius = spec_.tracking_margin = 0.0;
  local_boundary_ = boundary_in_grid(spec_);
  row_words_ = words_for(spec.dims.x);
  reach_x_ = Stencil(spec_).gap_x() + 1;
  words_ = words;
  obstacles_ = words + kHeaderWords;
  blocked_ = obstacles_ + layer;
  changes_ = blocked_ + layer;
  for (std::size_t k = 0; k < layer; ++k) obstacles_[k] = 0;
  for (std::size_t k = 0; k < layer; ++k) blocked_[k] = ~std::uint64_t{0};
  Changes(spec.dims, changes_).note_all();
  begin_header();
  return Status::kOk;
}

/// Numbers the bind: its revision is later than any that this grid or the storage had.
void Grid::begin_header() noexcept {
  const bool used = word_as_it_is(words_[kTag]) == kHeaderTag;
  const std::uint64_t before = used ? word_as_it_is(words_[kRevision]) : 0;
  const std::uint64_t latest = before > bound_at_revision_ ? before : bound_at_revision_;
  bound_at_revision_ = (latest / kBindStep + 1) * kBindStep;
  const std::uint64_t content = content_of(spec_, local_boundary_);
  binding_ = binding_of(spec_, content, bound_at_revision_);
  for (std::size_t k = 0; k < kHeaderWords; ++k) words_[k] = 0;
  words_[kTag] = kHeaderTag;
  words_[kBinding] = binding_;
  words_[kRevision] = bound_at_revision_;
  words_[kInflated] = bound_at_revision_ - 1;
  words_[kContent] = content;
}

Vec3 Grid::to_local(const Vec3& world) const noexcept {
  return world - spec_.origin;
}

Voxel Grid::voxel_of(const Vec3& local) const noexcept {
  Voxel voxel{};
  for (int a = 0; a < 3; ++a) {
    const std::int32_t count = axis(spec_.dims, a);
    const double cells = onto_boundary(*this, axis(local, a), a) / spec_.cell;
    std::int32_t index = floor_index(cells + kLatticeTolerance, -1, count);
    const double upper = axis(local_boundary_.upper, a);
    const std::int32_t last = last_index(upper, spec_.cell, count);
    if (index > last && cells <= upper / spec_.cell + kLatticeTolerance) index = last;
    axis(voxel, a) = index;
  }
  return voxel;
}

Vec3 Grid::center(const Voxel& voxel) const noexcept {
  return {(voxel.x + 0.5) * spec_.cell, (voxel.y + 0.5) * spec_.cell, (voxel.z + 0.5) * spec_.cell};
}

}  // namespace tern
