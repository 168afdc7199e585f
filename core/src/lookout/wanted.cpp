// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lookout/wanted.hpp"

#include "base/math.hpp"
#include "grid/distance.hpp"
#include "grid/lattice.hpp"

namespace tern {
namespace {

/// Voxels along each axis that are looked at around a place, at most: a radius and one.
constexpr std::int32_t kMostAround = 16;

/// 0, 1, -1, 2, -2 and so on: what is nearest to the place comes first.
std::int32_t outward(std::int32_t k) {
  return k % 2 == 1 ? (k + 1) / 2 : -(k / 2);
}

/// True if this unseen voxel, one of the two highest of its column that hold ground, should be looked at: no ground was
/// hit in either, and the lower one only if the upper one was seen free.
bool lacks_ground(const RollingMap& map, const Voxel& voxel, std::int32_t top) {
  const Voxel upper{voxel.x, voxel.y, top};
  const Voxel lower{voxel.x, voxel.y, top - 1};
  if (map.route().obstacle(upper) || map.route().obstacle(lower)) return false;
  return voxel.z == top || map.seen(upper);
}

}  // namespace

bool is_unseen(const RollingMap& map, const Voxel& voxel) noexcept {
  return map.safe().obstacle(voxel) && !map.route().obstacle(voxel);
}

bool is_unseen_at(const RollingMap& map, const Vec3& place) noexcept {
  const Grid& safe = map.safe();
  return safe.bound() && is_unseen(map, safe.voxel_of(safe.to_local(place)));
}

bool Wanted::has(const Vec3& centre, double cell) const noexcept {
  for (std::int32_t k = count - 1; k >= 0; --k) {
    if (distance(voxel[k].centre, centre) < 0.5 * cell) return true;
  }
  return false;
}

void Wanted::add_around(const RollingMap& map, const Vec3& place, double radius, std::int32_t at, std::int32_t share,
                        Work& work) noexcept {
  const Grid& safe = map.safe();
  const GridSpec& spec = safe.spec();
  const Voxel middle = safe.voxel_of(place);
  const std::int32_t reach = floor_index(radius / spec.cell, 0, kMostAround) + 1;
  const bool is_dense = count < kDenseWanted && dense == count;
  const std::int32_t most = is_dense ? kDenseWanted : (count + share < kMaxWanted ? count + share : kMaxWanted);
  std::int32_t found = 0;
  const std::int32_t side = 2 * reach + 1;
  for (std::int32_t k = 0; k < side * side * side && count < most; ++k) {
    const Voxel near{middle.x + outward(k % side), middle.y + outward(k / side % side),
                     middle.z + outward(k / (side * side))};
    if (!is_unseen(map, near)) continue;
    ++found;
    const Vec3 off = place - nearest_in_box(place, cube_of(safe, near));
    const Vec3 centre = spec.origin + safe.center(near);
    if (dot(off, off) >= radius * radius || has(centre, spec.cell)) continue;
    voxel[count++] = {centre, at};
  }
  if (is_dense) dense = count;
  work.spend(ops::kTurn * side * side * side + ops::kTurn * (kMaxWanted / 2) * found);
}

/// From the ground up: what is right above it is the hardest to see.
void Wanted::add_site(const RollingMap& map, const Vec3& place, double radius, double ground, std::int32_t at,
                      Work& work) noexcept {
  const Grid& safe = map.safe();
  const GridSpec& spec = safe.spec();
  const Voxel middle = safe.voxel_of(place);
  const std::int32_t reach = floor_index(radius / spec.cell, 0, kMostAround) + 1;
  const std::int32_t above = ceil_index((ground - spec.origin.z) / spec.cell, 0, spec.dims.z);
  const std::int32_t side = 2 * reach + 1;
  const bool is_dense = dense == count;
  const std::int32_t layers = floor_index(1.0 * (middle.z - above + 1), 0, 2 * kMostAround) + 2;
  work.spend(2 * ops::kTurn * side * side * layers);
  for (std::int32_t k = 0; k < side * side * layers && count < kMaxWanted; ++k) {
    const Voxel near{middle.x + outward(k % side), middle.y + outward(k / side % side), above - 2 + k / (side * side)};
    if (!is_unseen(map, near) || (near.z < above && !lacks_ground(map, near, above - 1))) continue;
    Vec3 off = place - nearest_in_box(place, cube_of(safe, near));
    off.z = 0.0;
    const Vec3 centre = spec.origin + safe.center(near);
    if (dot(off, off) >= radius * radius || has(centre, spec.cell)) continue;
    voxel[count++] = {centre, at};
    work.spend(ops::kTurn * (kMaxWanted / 2));
  }
  if (is_dense) dense = count < kDenseWanted ? count : kDenseWanted;
}

Vec3 Wanted::middle(bool of_all) const noexcept {
  const std::int32_t some = of_all ? count : dense;
  Vec3 sum = kZero;
  for (std::int32_t k = 0; k < some; ++k) sum = sum + voxel[k].centre;
  return (1.0 / some) * sum;
}

}  // namespace tern
