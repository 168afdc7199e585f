// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "flight/route_copy.hpp"

#include "base/math.hpp"
#include "base/work.hpp"
#include "grid/lattice.hpp"
#include "map/grid_words.hpp"

namespace tern {
namespace {

/// Words that a piece copies, or one column if that has more.
constexpr std::int32_t kCopiedWords = 256;
/// No voxels of a row.
constexpr IndexRange kNone{0, 0};

/// The voxels within `radius` of `center` along one axis, both in voxels; none for a radius of 0.
IndexRange voxels_around(double center, double radius, std::int32_t count) {
  if (!(radius > 0.0)) return kNone;
  return {floor_index(center - radius, 0, count), ceil_index(center + radius, 0, count)};
}

/// A column of words, voxels above voxels: what was hit, and what is not known to be free.
struct Column {
  Column(const RollingMap& map, std::int32_t y, std::int32_t k) noexcept
      : hit(map.route().obstacle_row(y, 0) + k),
        solid(map.safe().obstacle_row(y, 0) + k),
        stride(static_cast<std::size_t>(map.route().row_words()) * static_cast<std::size_t>(map.route().spec().dims.y)),
        height(map.route().spec().dims.z) {}

  const std::uint64_t* hit;
  const std::uint64_t* solid;
  std::size_t stride;
  std::int32_t height;
};

/// A sweep along a column of words, up or down.
class WallSweep {
 public:
  /// The unseen voxels of the next word that follow a wall, with nothing between that was seen.
  std::uint64_t next(std::uint64_t hit, std::uint64_t unseen) noexcept {
    const std::uint64_t follows = follows_ & unseen;
    follows_ = follows | ends_wall(hit);
    return follows;
  }
  /// True for the voxels of the next word with which a wall is high enough.
  std::uint64_t ends_wall(std::uint64_t hit) noexcept {
    const std::uint64_t ends = three_ & hit;
    three_ = two_ & hit;
    two_ = one_ & hit;
    one_ = hit;
    return ends;
  }

 private:
  static_assert(kWallVoxels == 4);
  std::uint64_t one_ = 0, two_ = 0, three_ = 0;  ///< so many voxels up to the last one were hit
  std::uint64_t follows_ = 0;
};

bool has_wall(const Column& column) {
  WallSweep sweep;
  std::uint64_t ends = 0;
  const std::uint64_t* hit = column.hit;
  for (std::int32_t z = 0; z < column.height; ++z, hit += column.stride) ends |= sweep.ends_wall(*hit);
  return ends != 0;
}

/// What follows a wall downwards, from the lowest voxels up.
void go_down_walls(const Column& column, std::uint64_t* below) {
  WallSweep sweep;
  std::size_t at = column.stride * static_cast<std::size_t>(column.height);
  for (std::int32_t z = column.height - 1; z >= 0; --z) {
    at -= column.stride;
    below[z] = sweep.next(column.hit[at], column.solid[at] & ~column.hit[at]);
  }
}

}  // namespace

Status RouteCopy::bind(const RollingMap& map, std::uint64_t* words, std::size_t count) noexcept {
  const Status status = grid_.bind(map.route().spec(), words, count);
  if (status == Status::kOk) grid_.inflate();
  return status;
}

void RouteCopy::begin(const RollingMap& map, const Vec3& center, const CopyRule& rule) noexcept {
  const GridSpec& spec = map.route().spec();
  if (!same(spec.origin, grid_.spec().origin)) {  // the window slid
    const GridWords words(grid_);
    words.begin_shift();
    words.move_to(spec.origin);
    words.end_shift({0, 0, 0});
  }
  const Vec3 local = center - spec.origin;
  for (int a = 0; a < 3; ++a) {
    near_[a] = voxels_around(axis(local, a) / spec.cell, rule.near / spec.cell, axis(spec.dims, a));
    hole_[a] = voxels_around(axis(local, a) / spec.cell, rule.hole / spec.cell, axis(spec.dims, a));
  }
  center_ = (1.0 / spec.cell) * local;
  emptied_ = rule.emptied / spec.cell;
  has_walls_ = rule.has_walls;
  presumes_ = false;
  column_ = piece_ = 0;
}

/// The voxels of a row that the ball of the radius `emptied` meets.
IndexRange RouteCopy::emptied_voxels(std::int32_t y, std::int32_t z) const noexcept {
  const double off_y = center_.y - clamp(center_.y, y, y + 1);
  const double off_z = center_.z - clamp(center_.z, z, z + 1);
  const double rest = emptied_ * emptied_ - off_y * off_y - off_z * off_z;
  if (!(rest > 0.0)) return kNone;
  return voxels_around(center_.x, square_root(rest), grid_.spec().dims.x);
}

/// The words that changed.
std::int32_t RouteCopy::compose_column(const RollingMap& map, std::int32_t y, std::int32_t k, bool is_walled) noexcept {
  const Column column(map, y, k);
  if (is_walled) go_down_walls(column, below_wall_);
  const std::uint64_t near = contains(near_[1], y) ? bits_met(near_[0], k) : 0;
  const std::uint64_t hole = contains(hole_[1], y) ? bits_met(hole_[0], k) : 0;
  const std::uint64_t* before = grid_.obstacle_row(y, 0) + k;
  WallSweep upwards;
  std::int32_t changed = 0;
  std::size_t at = 0;
  for (std::int32_t z = 0; z < column.height; ++z, at += column.stride) {
    const std::uint64_t hit = column.hit[at];
    const std::uint64_t unseen = column.solid[at] & ~hit;
    std::uint64_t solid = is_walled ? below_wall_[z] | upwards.next(hit, unseen) : 0;
    presumes_ = presumes_ || solid != 0;
    if (near != 0 && contains(near_[2], z)) solid |= contains(hole_[2], z) ? near & ~hole : near;
    std::uint64_t word = hit | (solid & unseen);
    if (emptied_ > 0.0) word &= ~bits_met(emptied_voxels(y, z), k);
    if (word == before[at]) continue;
    GridWords(grid_).store(y, z, k, word);
    ++changed;
  }
  return changed;
}

/// Most columns are far from the vehicle and have no wall. False for these.
bool RouteCopy::copy_column(const RollingMap& map, std::int32_t y, std::int32_t k, std::int32_t& changed) noexcept {
  const Column column(map, y, k);
  const bool is_walled = has_walls_ && has_wall(column);
  const bool is_near = contains(near_[1], y) && bits_met(near_[0], k) != 0;
  if (is_walled || is_near || emptied_ > 0.0) {
    changed += compose_column(map, y, k, is_walled);
    return true;
  }
  const std::uint64_t* before = grid_.obstacle_row(y, 0) + k;
  const std::uint64_t* hit = column.hit;
  for (std::int32_t z = 0; z < column.height; ++z, hit += column.stride, before += column.stride) {
    if (*hit == *before) continue;
    GridWords(grid_).store(y, z, k, *hit);
    ++changed;
  }
  return false;
}

bool RouteCopy::done() const noexcept {
  return piece_ == GridWords::inflation_pieces(grid_.spec().dims);
}

void RouteCopy::advance(const RollingMap& map, Work& work) noexcept {
  const Voxel& dims = grid_.spec().dims;
  const std::int32_t columns = grid_.row_words() * dims.y;
  if (column_ == columns) return GridWords(grid_).inflate_piece(piece_++, work);
  std::int32_t words = 0;
  std::int32_t composed = 0;
  std::int32_t changed = 0;
  for (; column_ < columns && words < kCopiedWords; ++column_, words += dims.z) {
    if (copy_column(map, column_ / grid_.row_words(), column_ % grid_.row_words(), changed)) composed += dims.z;
  }
  const Operations looks = has_walls_ ? 4 * ops::kWord : 2 * ops::kWord;
  work.spend(ops::kRow + looks * words + 8 * ops::kWord * composed + 28 * ops::kWord * changed);
}

}  // namespace tern
