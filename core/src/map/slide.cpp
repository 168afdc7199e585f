// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A slide of the window. All layers move in place, plane by plane, by whole words, rows and planes.
#include "base/math.hpp"
#include "base/work.hpp"
#include "map/grid_words.hpp"
#include "map/map_state.hpp"

namespace tern {
namespace {

/// The largest distance of the window's lower voxel from the spec's origin, in voxels.
constexpr double kMaxBase = 1 << 28;

/// Voxels by which the window must move on one axis; along x these are whole words.
std::int32_t shift_for(double cells, std::int32_t count, std::int32_t slack, bool words) {
  const std::int32_t off = floor_index(cells, -(1 << 29), 1 << 29) - count / 2;
  const std::int32_t size = off < 0 ? -off : off;
  if (!words) return size > slack ? off : 0;
  if (size <= 32 + slack) return 0;
  const std::int32_t moved = (size + 32) / 64 * 64;
  return off < 0 ? -moved : moved;
}

/// Voxels of the new window on one axis that were in the old one too; may be empty.
IndexRange kept_range(std::int32_t by, std::int32_t count) {
  const std::int32_t begin = by < 0 ? -by : 0;
  const std::int32_t end = by > 0 ? count - by : count;
  return begin < end ? IndexRange{begin, end} : IndexRange{0, 0};
}

VoxelBox kept_box(const Voxel& by, const Voxel& dims) {
  const VoxelBox box{kept_range(by.x, dims.x), kept_range(by.y, dims.y), kept_range(by.z, dims.z)};
  const bool any = box.x.end > 0 && box.y.end > 0 && box.z.end > 0;
  return any ? box : VoxelBox{{0, 0}, {0, 0}, {0, 0}};
}

/// One layer of the map that is being moved.
struct Layer {
  std::uint64_t* words;
  std::uint64_t outside;  ///< the word that enters the window
  const MapState& state;
  const VoxelBox& kept;

  std::uint64_t* row(std::int32_t y, std::int32_t z) const { return words + state.row(y, z); }

  void clear(std::int32_t z, std::int32_t begin, std::int32_t end) const {
    std::uint64_t* first = row(begin, z);
    std::uint64_t* last = row(end, z);
    for (std::uint64_t* word = first; word < last; ++word) *word = outside;
  }

  /// Moves whole rows of a plane, which are adjacent in memory.
  void move_rows(std::int32_t z, const Voxel& by) const {
    const std::size_t bytes = sizeof(std::uint64_t) * (state.row(kept.y.end, 0) - state.row(kept.y.begin, 0));
    __builtin_memmove(row(kept.y.begin, z), row(kept.y.begin + by.y, z + by.z), bytes);
  }

  /// Moves the words of one row, in the order in which no word is overwritten before it is read.
  void move_words(std::int32_t y, std::int32_t z, const Voxel& by) const {
    const std::int32_t count = state.row_words();
    const std::uint64_t* from = row(y + by.y, z + by.z);
    std::uint64_t* to = row(y, z);
    const std::int32_t shift = by.x / 64;
    for (std::int32_t n = 0; n < count; ++n) {
      const std::int32_t k = shift > 0 ? n : count - 1 - n;
      to[k] = k + shift >= 0 && k + shift < count ? from[k + shift] : outside;
    }
    to[count - 1] &= outside | GridWords::valid_bits(state.route, count - 1);
  }

  void move_plane(std::int32_t z, const Voxel& by) const {
    if (!contains(kept.z, z)) return clear(z, 0, state.spec.dims.y);
    if (by.x == 0) {
      move_rows(z, by);
    } else {
      const std::int32_t rows = kept.y.end - kept.y.begin;
      for (std::int32_t n = 0; n < rows; ++n) {
        move_words(by.y >= 0 ? kept.y.begin + n : kept.y.end - 1 - n, z, by);
      }
    }
    clear(z, 0, kept.y.begin);
    clear(z, kept.y.end, state.spec.dims.y);
  }
};

/// Indices on one axis whose blocked words must be made again. At the end that obstacles left through, this is the
/// outermost index; at the other end, these are the indices that entered the window.
struct Stale {
  IndexRange first;
  IndexRange last;

  Stale(std::int32_t by, const IndexRange& kept, std::int32_t count)
      : first{0, by > 0 ? 1 : kept.begin}, last{by < 0 ? count - 1 : kept.end, count} {
    if (kept.end > 0) return;
    first = {0, 0};
    last = {0, count};
  }
  bool contains(std::int32_t index) const { return tern::contains(first, index) || tern::contains(last, index); }
};

}  // namespace

Vec3 MapState::window_origin() const noexcept {
  return spec.origin + spec.cell * Vec3{double(base.x), double(base.y), double(base.z)};
}

Status RollingMap::follow(const Vec3& center) noexcept {
  if (state_ == nullptr || busy()) return Status::kInvalidArgument;
  if (!finite(center)) return Status::kNonFiniteInput;
  MapState& state = *state_;
  const MapSpec& spec = state.spec;
  const Vec3 local = state.route.to_local(center);
  Voxel by{};
  for (int a = 0; a < 3; ++a) {
    const double cells = axis(local, a) / spec.cell;
    if (!(absolute(cells + axis(state.base, a)) < kMaxBase) || !resolves_cells(axis(center, a), spec.cell)) {
      return Status::kOutOfMap;
    }
    axis(by, a) = shift_for(cells, axis(spec.dims, a), spec.slack, a == 0);
  }
  if (by.x == 0 && by.y == 0 && by.z == 0) return Status::kOk;
  state.slide_by = by;
  GridWords(state.route).begin_shift();
  GridWords(state.safe).begin_shift();
  state.begin(Task::kSlide);
  return Status::kRunning;
}

void MapState::move_plane(std::int32_t z, const VoxelBox& kept) noexcept {
  const GridWords route_words(route);
  const GridWords safe_words(safe);
  const std::uint64_t blocked = ~std::uint64_t{0};
  const Layer layers[] = {{seen, 0, *this, kept},
                          {low, 0, *this, kept},
                          {high, 0, *this, kept},
                          {route_words.obstacles(), 0, *this, kept},
                          {safe_words.obstacles(), 0, *this, kept},
                          {route_words.blocked(), blocked, *this, kept},
                          {safe_words.blocked(), blocked, *this, kept}};
  for (const Layer& layer : layers) layer.move_plane(z, slide_by);
}

void MapState::renew_row(std::int32_t y, std::int32_t z) noexcept {
  GridWords(route).note(y, z, 0, row_words() - 1);
  GridWords(safe).note(y, z, 0, row_words() - 1);
  const std::uint64_t* hits = GridWords(route).obstacles() + row(y, z);
  std::uint64_t* solid = GridWords(safe).obstacles() + row(y, z);
  for (std::int32_t k = 0; k < row_words(); ++k) {
    solid[k] = hits[k] | (~seen[row(y, z) + static_cast<std::size_t>(k)] & GridWords::valid_bits(route, k));
  }
}

void MapState::slide_plane(std::int32_t index, Work& work) noexcept {
  const Voxel dims = spec.dims;
  const VoxelBox kept = kept_box(slide_by, dims);
  const std::int32_t z = slide_by.z >= 0 ? index : dims.z - 1 - index;
  if (index == 0) move_origin();
  move_plane(z, kept);
  work.spend(moved_operations(slide_by.x == 0));
  mark_prior(z, kept, work);
  const bool whole = slide_by.x != 0 || Stale(slide_by.z, kept.z, dims.z).contains(z);
  const Stale stale(whole ? 1 : slide_by.y, whole ? IndexRange{0, 0} : kept.y, dims.y);
  for (std::int32_t y = stale.first.begin; y < stale.first.end; ++y) renew_row(y, z);
  for (std::int32_t y = stale.last.begin; y < stale.last.end; ++y) renew_row(y, z);
  const int renewed = (stale.first.end - stale.first.begin) + (stale.last.end - stale.last.begin);
  work.spend(renewed_operations() * renewed);
  if (index + 1 < dims.z) return;
  GridWords(route).end_shift(slide_by);
  GridWords(safe).end_shift(slide_by);
}

void MapState::move_origin() noexcept {
  if (timed) marked = time;
  added = {{0, spec.dims.x}, {0, spec.dims.y}, {0, spec.dims.z}};
  base = {base.x + slide_by.x, base.y + slide_by.y, base.z + slide_by.z};
  GridWords(route).move_to(window_origin());
  GridWords(safe).move_to(window_origin());
}

}  // namespace tern
