// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "flight/route_copy.hpp"

#include "base/math.hpp"
#include "grid/lattice.hpp"
#include "map/grid_words.hpp"

namespace tern {
namespace {

/// Planes that one piece inflates.
constexpr std::int32_t kCopiedPlanes = 4;
/// Words of a unit.
constexpr std::int32_t kCopiedWords = 64;
constexpr std::int32_t kInflatedWords = 16;
/// No voxels of a row.
constexpr IndexRange kNone{0, 0};

/// Rows that one piece copies.
std::int32_t rows_of_piece(std::int32_t row_words) {
  return row_words < kCopiedWords ? kCopiedWords / row_words : 1;
}

std::uint32_t units_for(std::int64_t words, std::int32_t unit) {
  return static_cast<std::uint32_t>((words + unit - 1) / unit);
}

/// Along one axis, in voxels; none for a reach of 0.
IndexRange voxels_around(double center, double reach, std::int32_t count) {
  if (!(reach > 0.0)) return kNone;
  return {floor_index(center - reach, 0, count), ceil_index(center + reach, 0, count)};
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
  row_ = plane_ = 0;
  paid_ = 0;
}

/// The voxels of a row that the ball meets.
IndexRange RouteCopy::emptied_voxels(std::int32_t y, std::int32_t z) const noexcept {
  const double off_y = center_.y - clamp(center_.y, y, y + 1);
  const double off_z = center_.z - clamp(center_.z, z, z + 1);
  const double rest = emptied_ * emptied_ - off_y * off_y - off_z * off_z;
  if (!(rest > 0.0)) return kNone;
  return voxels_around(center_.x, square_root(rest), grid_.spec().dims.x);
}

void RouteCopy::copy_row(const RollingMap& map, std::int32_t row) noexcept {
  const Grid& route = map.route();
  const std::int32_t rows_along_y = grid_.spec().dims.y;
  const std::int32_t y = row % rows_along_y;
  const std::int32_t z = row / rows_along_y;
  const IndexRange near = contains(near_[1], y) && contains(near_[2], z) ? near_[0] : kNone;
  const IndexRange hole = contains(hole_[1], y) && contains(hole_[2], z) ? hole_[0] : kNone;
  const IndexRange emptied = emptied_voxels(y, z);
  const std::uint64_t* const hit = route.obstacle_row(y, z);
  const std::uint64_t* const solid = map.safe().obstacle_row(y, z);
  const std::uint64_t* const before = grid_.obstacle_row(y, z);
  for (std::int32_t k = 0; k < grid_.row_words(); ++k) {
    const std::uint64_t unseen = solid[k] & bits_met(near, k) & ~bits_met(hole, k);
    const std::uint64_t word = (hit[k] | unseen) & ~bits_met(emptied, k);
    if (word != before[k]) GridWords(grid_).store(y, z, k, word);
  }
}

void RouteCopy::inflate_piece() noexcept {
  const std::int32_t end = plane_ + kCopiedPlanes;
  const std::int32_t planes = grid_.spec().dims.z;
  GridWords(grid_).inflate_planes(plane_, end < planes ? end : planes);
  plane_ = end;
  if (plane_ >= planes) GridWords(grid_).finish_inflation();
}

std::uint32_t RouteCopy::price() const noexcept {
  const Voxel& dims = grid_.spec().dims;
  if (row_ < dims.y * dims.z) return units_for(grid_.row_words(), kCopiedWords);
  return units_for(std::int64_t{grid_.row_words()} * dims.y * kCopiedPlanes, kInflatedWords);
}

Progress RouteCopy::advance(const RollingMap& map, Work& work) noexcept {
  const Voxel& dims = grid_.spec().dims;
  while (plane_ < dims.z) {
    const std::uint32_t given = least(work.left, price() - paid_);
    work.left -= given;
    paid_ += given;
    if (paid_ < price()) return Progress::kMore;
    paid_ = 0;
    if (row_ < dims.y * dims.z) {
      const std::int32_t last = row_ + rows_of_piece(grid_.row_words());
      for (; row_ < last && row_ < dims.y * dims.z; ++row_) copy_row(map, row_);
    } else {
      inflate_piece();
    }
  }
  return Progress::kDone;
}

}  // namespace tern
