// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Marking and clearing the obstacle layer.
#include "base/math.hpp"
#include "grid/changes.hpp"
#include "grid/cylinder.hpp"
#include "grid/lattice.hpp"
#include "tern/grid.hpp"

namespace tern {
namespace {

/// Upper bound, in cells, of the tolerance of a point inside a grid. bind() refuses coarser coordinates.
constexpr double kMostTolerance = 0.01;

/// The index of the voxel that holds a world coordinate on one axis. It is outside the grid's indices if the coordinate
/// is outside the grid.
std::int32_t index_holding(const GridSpec& spec, double world, int a) {
  const std::int32_t count = axis(spec.dims, a);
  const double cells = (world - axis(spec.origin, a)) / spec.cell;
  // Few points are so near to a face that their tolerance matters.
  const std::int32_t whole = floor_index(cells, -1, count);
  if (whole >= 0 && whole < count && cells - whole < 1.0 - kMostTolerance) return whole;
  return floor_index(cells + world_tolerance(spec, world), -1, count);
}

/// The voxel that holds a world point; lower faces are closed. Its indices are outside the grid if the point is.
Voxel voxel_holding(const GridSpec& spec, const Vec3& world) {
  return {index_holding(spec, world.x, 0), index_holding(spec, world.y, 1), index_holding(spec, world.z, 2)};
}

/// Sets or clears bits [begin, end) of a row, begin < end. Returns the range from the first to the last bit that
/// changed; empty if none did.
IndexRange set_bits(std::uint64_t* row, std::int32_t begin, std::int32_t end, bool value) {
  const std::int32_t first = begin >> 6;
  const std::int32_t last = (end - 1) >> 6;
  IndexRange changed{end, begin};
  for (std::int32_t k = first; k <= last; ++k) {
    const std::uint64_t mask = bits_within({begin, end}, k);
    const std::uint64_t flips = mask & (value ? ~row[k] : row[k]);
    if (flips == 0) continue;
    row[k] ^= flips;
    if (changed.begin == end) changed.begin = 64 * k + __builtin_ctzll(flips);
    changed.end = 64 * k + 64 - __builtin_clzll(flips);
  }
  return changed;
}

/// The end of the range that holds this voxel alone.
Voxel past(const Voxel& voxel) {
  return {voxel.x + 1, voxel.y + 1, voxel.z + 1};
}

/// The content number after the voxels [begin, end) were set or cleared.
std::uint64_t content_with(std::uint64_t content, const Voxel& begin, const Voxel& end, bool value) {
  const auto bits = [](std::int32_t first, std::int32_t last) {
    return static_cast<std::uint64_t>(first) | static_cast<std::uint64_t>(last) << 12;
  };
  content = content_after(content, bits(begin.x, end.x) | bits(begin.y, end.y) << 24);
  return content_after(content, bits(begin.z, end.z) | std::uint64_t{value ? 1u : 0u} << 24);
}

}  // namespace

/// Sets or clears the voxels [begin, end) on each axis, and notes the words of the blocked layer that may change.
void Grid::set_voxels(const Voxel& begin, const Voxel& end, bool value) noexcept {
  for (std::int32_t z = begin.z; z < end.z; ++z) {
    for (std::int32_t y = begin.y; y < end.y; ++y) {
      const IndexRange changed = set_bits(obstacles_ + row(y, z), begin.x, end.x, value);
      if (changed.begin >= changed.end) continue;
      const std::int32_t first = changed.begin - reach_x_;
      const std::int32_t last = changed.end - 1 + reach_x_;
      Changes(spec_.dims, changes_)
          .note(y, z, first < 0 ? 0 : first >> 6, last < spec_.dims.x ? last >> 6 : row_words_ - 1);
    }
  }
}

Status Grid::set_box(const Box& world, bool value) noexcept {
  if (!bound()) return Status::kInvalidArgument;
  if (!finite(world.lower) || !finite(world.upper)) return Status::kNonFiniteInput;
  if (!valid_box(world)) return Status::kInvalidArgument;
  ++words_[kRevision];
  const IndexRange x = voxels_met(spec_, world.lower.x, world.upper.x, 0);
  const IndexRange y = voxels_met(spec_, world.lower.y, world.upper.y, 1);
  const IndexRange z = voxels_met(spec_, world.lower.z, world.upper.z, 2);
  if (x.begin >= x.end) return Status::kOk;
  const Voxel begin{x.begin, y.begin, z.begin};
  const Voxel end{x.end, y.end, z.end};
  words_[kContent] = content_with(words_[kContent], begin, end, value);
  set_voxels(begin, end, value);
  return Status::kOk;
}

Status Grid::mark_box(const Box& world) noexcept {
  return set_box(world, true);
}

Status Grid::clear_box(const Box& world) noexcept {
  return set_box(world, false);
}

Status Grid::mark_cylinder(const Cylinder& world) noexcept {
  if (!bound()) return Status::kInvalidArgument;
  const Status status = check(world);
  if (status != Status::kOk) return status;
  ++words_[kRevision];
  const IndexRange z = planes_met(spec_, world);
  visit_rows(spec_, world, [&](std::int32_t y, const IndexRange& x) {
    const Voxel begin{x.begin, y, z.begin};
    const Voxel end{x.end, y + 1, z.end};
    words_[kContent] = content_with(words_[kContent], begin, end, true);
    set_voxels(begin, end, true);
  });
  return Status::kOk;
}

Status Grid::set_voxel(const Voxel& voxel, bool value) noexcept {
  if (!bound()) return Status::kInvalidArgument;
  if (!inside(voxel)) return Status::kOutOfMap;
  ++words_[kRevision];
  words_[kContent] = content_with(words_[kContent], voxel, past(voxel), value);
  set_voxels(voxel, past(voxel), value);
  return Status::kOk;
}

Status Grid::mark_voxel(const Voxel& voxel) noexcept {
  return set_voxel(voxel, true);
}

Status Grid::clear_voxel(const Voxel& voxel) noexcept {
  return set_voxel(voxel, false);
}

Status Grid::mark_points(const Vec3* world, std::size_t count, std::size_t* inside_count) noexcept {
  if (!bound() || (world == nullptr && count > 0)) return Status::kInvalidArgument;
  for (std::size_t k = 0; k < count; ++k) {
    if (!finite(world[k])) return Status::kNonFiniteInput;
  }
  ++words_[kRevision];
  std::size_t hits = 0;
  std::uint64_t content = words_[kContent];
  for (std::size_t k = 0; k < count; ++k) {
    const Voxel voxel = voxel_holding(spec_, world[k]);
    if (!inside(voxel)) continue;
    ++hits;
    // Earlier frames marked most of a frame's voxels already.
    if (bit(obstacles_, voxel)) continue;
    content = content_with(content, voxel, past(voxel), true);
    set_voxels(voxel, past(voxel), true);
  }
  words_[kContent] = content;
  if (inside_count != nullptr) *inside_count = hits;
  return Status::kOk;
}

}  // namespace tern
