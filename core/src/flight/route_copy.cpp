// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "flight/route_copy.hpp"

#include "base/math.hpp"
#include "base/work.hpp"
#include "grid/lattice.hpp"
#include "map/grid_words.hpp"

namespace tern {
namespace {

/// Words that a piece copies, or one row if a row is longer.
constexpr std::int32_t kCopiedWords = 256;
/// No voxels of a row.
constexpr IndexRange kNone{0, 0};

/// Rows that one piece copies.
std::int32_t rows_of_piece(std::int32_t row_words) {
  return row_words < kCopiedWords ? kCopiedWords / row_words : 1;
}

/// The voxels within `radius` of `center` along one axis, both in voxels; none for a radius of 0.
IndexRange voxels_around(double center, double radius, std::int32_t count) {
  if (!(radius > 0.0)) return kNone;
  return {floor_index(center - radius, 0, count), ceil_index(center + radius, 0, count)};
}

bool same_words(const std::uint64_t* a, const std::uint64_t* b, std::int32_t count) {
  std::uint64_t difference = 0;
  for (std::int32_t k = 0; k < count; ++k) difference |= a[k] ^ b[k];
  return difference == 0;
}

}  // namespace

Status RouteCopy::bind(const RollingMap& map, std::uint64_t* words, std::size_t count) noexcept {
  const Status status = grid_.bind(map.route().spec(), words, count);
  if (status == Status::kOk) grid_.inflate();
  return status;
}

void RouteCopy::begin(const RollingMap& map, const Vec3& center, double near, double hole, double emptied) noexcept {
  const GridSpec& spec = map.route().spec();
  if (!same(spec.origin, grid_.spec().origin)) {  // the window slid
    const GridWords words(grid_);
    words.begin_shift();
    words.move_to(spec.origin);
    words.end_shift({0, 0, 0});
  }
  const Vec3 local = center - spec.origin;
  for (int a = 0; a < 3; ++a) {
    near_[a] = voxels_around(axis(local, a) / spec.cell, near / spec.cell, axis(spec.dims, a));
    hole_[a] = voxels_around(axis(local, a) / spec.cell, hole / spec.cell, axis(spec.dims, a));
  }
  center_ = (1.0 / spec.cell) * local;
  emptied_ = emptied / spec.cell;
  row_ = piece_ = 0;
}

/// The voxels of a row that the ball of the radius `emptied` meets.
IndexRange RouteCopy::emptied_voxels(std::int32_t y, std::int32_t z) const noexcept {
  const double off_y = center_.y - clamp(center_.y, y, y + 1);
  const double off_z = center_.z - clamp(center_.z, z, z + 1);
  const double rest = emptied_ * emptied_ - off_y * off_y - off_z * off_z;
  if (!(rest > 0.0)) return kNone;
  return voxels_around(center_.x, square_root(rest), grid_.spec().dims.x);
}

/// Most rows are far from the vehicle, and equal to what was copied before.
RouteCopy::CopiedRow RouteCopy::copy_row(const RollingMap& map, std::int32_t row) noexcept {
  const Grid& route = map.route();
  const std::int32_t rows_along_y = grid_.spec().dims.y;
  const std::int32_t y = row % rows_along_y;
  const std::int32_t z = row / rows_along_y;
  const IndexRange near = contains(near_[1], y) && contains(near_[2], z) ? near_[0] : kNone;
  const IndexRange hole = contains(hole_[1], y) && contains(hole_[2], z) ? hole_[0] : kNone;
  const IndexRange emptied = emptied_voxels(y, z);
  const std::uint64_t* const hit = route.obstacle_row(y, z);
  const std::uint64_t* const before = grid_.obstacle_row(y, z);
  const bool is_far = near.begin >= near.end && emptied.begin >= emptied.end;
  if (is_far && same_words(hit, before, grid_.row_words())) return {0, false};
  std::int32_t changed = 0;
  const std::uint64_t* const solid = map.safe().obstacle_row(y, z);
  for (std::int32_t k = 0; k < grid_.row_words(); ++k) {
    const std::uint64_t unseen = solid[k] & bits_met(near, k) & ~bits_met(hole, k);
    const std::uint64_t word = (hit[k] | unseen) & ~bits_met(emptied, k);
    if (word == before[k]) continue;
    GridWords(grid_).store(y, z, k, word);
    ++changed;
  }
  return {changed, true};
}

bool RouteCopy::done() const noexcept {
  return piece_ == GridWords::inflation_pieces(grid_.spec().dims);
}

void RouteCopy::advance(const RollingMap& map, Work& work) noexcept {
  const Voxel& dims = grid_.spec().dims;
  const std::int32_t rows = dims.y * dims.z;
  if (row_ == rows) return GridWords(grid_).inflate_piece(piece_++, work);
  const std::int32_t left = rows - row_;
  const std::int32_t count = rows_of_piece(grid_.row_words()) < left ? rows_of_piece(grid_.row_words()) : left;
  std::int32_t changed = 0;
  std::int32_t composed = 0;
  for (std::int32_t n = 0; n < count; ++n) {
    const CopiedRow row = copy_row(map, row_++);
    changed += row.changed;
    composed += row.is_composed ? 1 : 0;
  }
  const Operations words = ops::kWord * grid_.row_words();
  work.spend((ops::kRow + words) * count + (2 * ops::kRow + 6 * words) * composed + 28 * ops::kWord * changed);
}

}  // namespace tern
