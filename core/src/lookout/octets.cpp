// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lookout/octets.hpp"

#include "grid/lattice.hpp"

namespace tern {
namespace {

constexpr std::int32_t kEdge = 2;  ///< voxels

std::int32_t octets_along(std::int32_t voxels, std::int32_t most) {
  const std::int32_t needed = (voxels + kEdge - 1) / kEdge;
  return needed < most ? needed : most;
}

/// The first voxel of `octets` octets that lie around `at`, as far as the window allows.
std::int32_t first_voxel(std::int32_t at, std::int32_t octets, std::int32_t voxels) {
  const std::int32_t wanted = at - octets;
  const std::int32_t last = voxels - kEdge * octets;
  const std::int32_t least = wanted < last ? wanted : last;
  return least > 0 ? least : 0;
}

/// 64 bits of a row of the blocked layer from a bit on, turned round: a bit of 1 is free. Nothing is free past the row.
std::uint64_t free_bits(const std::uint64_t* row, std::int32_t words, std::int32_t from) {
  const std::int32_t k = from / kWordBits;
  const std::int32_t shift = from % kWordBits;
  const std::uint64_t low = k < words ? row[k] : kAllBits;
  if (shift == 0) return ~low;
  const std::uint64_t high = k + 1 < words ? row[k + 1] : kAllBits;
  return ~(low >> shift | high << (kWordBits - shift));
}

/// The even bits of a word, side by side in its lower half.
std::uint64_t even_bits(std::uint64_t x) {
  x &= 0x5555555555555555u;
  x = (x | x >> 1) & 0x3333333333333333u;
  x = (x | x >> 2) & 0x0F0F0F0F0F0F0F0Fu;
  x = (x | x >> 4) & 0x00FF00FF00FF00FFu;
  x = (x | x >> 8) & 0x0000FFFF0000FFFFu;
  return (x | x >> 16) & 0x00000000FFFFFFFFu;
}

/// A row of octets: those with a free voxel in the grid.
std::uint64_t octets_with_free(const Grid& grid, const Voxel& first) {
  const Voxel& dims = grid.spec().dims;
  std::uint64_t low = 0;
  std::uint64_t high = 0;
  for (std::int32_t z = first.z; z < first.z + kEdge && z < dims.z; ++z) {
    for (std::int32_t y = first.y; y < first.y + kEdge && y < dims.y; ++y) {
      const std::uint64_t* const row = grid.blocked_row(y, z);
      low |= free_bits(row, grid.row_words(), first.x);
      high |= free_bits(row, grid.row_words(), first.x + kWordBits);
    }
  }
  return even_bits(low | low >> 1) | even_bits(high | high >> 1) << (kWordBits / 2);
}

}  // namespace

std::size_t octet_layer_words(const Voxel& dims) noexcept {
  return static_cast<std::size_t>(octets_along(dims.y, kOctetsY)) *
         static_cast<std::size_t>(octets_along(dims.z, kOctetsZ));
}

void Octets::place(const Grid& window, const Voxel& around, std::uint64_t* words) noexcept {
  const Voxel& dims = window.spec().dims;
  count = {octets_along(dims.x, kOctetsX), octets_along(dims.y, kOctetsY), octets_along(dims.z, kOctetsZ)};
  origin = {first_voxel(around.x, count.x, dims.x), first_voxel(around.y, count.y, dims.y),
            first_voxel(around.z, count.z, dims.z)};
  known = words;
  open = words + octet_layer_words(dims);
  edge = kEdge * window.spec().cell;
}

void Octets::read_plane(const RollingMap& map, std::int32_t z, Work& work) noexcept {
  const std::uint64_t inside = kAllBits >> (kWordBits - count.x);
  for (std::int32_t y = 0; y < count.y; ++y) {
    const Voxel first{origin.x, origin.y + kEdge * y, origin.z + kEdge * z};
    const std::uint64_t safe = octets_with_free(map.safe(), first) & inside;
    const std::uint64_t route = octets_with_free(map.route(), first) & inside;
    known[z * count.y + y] = safe;
    open[z * count.y + y] = route & ~safe;
  }
  work.spend(150 * ops::kWord * count.y);
}

void Octets::close_around(const Voxel& voxel, double radius) const noexcept {
  const Voxel at = of(voxel);
  const std::int32_t reach = floor_index(radius / edge, 0, kWordBits) + 1;
  const double most = radius / edge * (radius / edge);
  for (std::int32_t z = at.z - reach; z <= at.z + reach; ++z) {
    for (std::int32_t y = at.y - reach; y <= at.y + reach; ++y) {
      for (std::int32_t x = at.x - reach; x <= at.x + reach; ++x) {
        const Vec3 off{x + 0.5 - (voxel.x + 0.5 - origin.x) / kEdge, y + 0.5 - (voxel.y + 0.5 - origin.y) / kEdge,
                       z + 0.5 - (voxel.z + 0.5 - origin.z) / kEdge};
        if (!has({x, y, z}) || dot(off, off) > most) continue;
        open[row({x, y, z})] &= ~(std::uint64_t{1} << x);
      }
    }
  }
}

Voxel Octets::of(const Voxel& voxel) const noexcept {
  // Truncation towards zero would count the voxel below the first octet as inside.
  const auto along = [](std::int32_t from_origin) { return from_origin < 0 ? -1 : from_origin / kEdge; };
  return {along(voxel.x - origin.x), along(voxel.y - origin.y), along(voxel.z - origin.z)};
}

Voxel Octets::octet(std::int32_t index) const noexcept {
  const std::int32_t at = index / kOctetsX;
  return {index % kOctetsX, at % count.y, at / count.y};
}

Voxel Octets::free_voxel(const Grid& grid, const Voxel& octet, bool from_top) const noexcept {
  const Voxel first{origin.x + kEdge * octet.x, origin.y + kEdge * octet.y, origin.z + kEdge * octet.z};
  for (std::int32_t k = 0; k < kEdge * kEdge * kEdge; ++k) {
    const std::int32_t layer = k / (kEdge * kEdge);
    const std::int32_t z = first.z + (from_top ? kEdge - 1 - layer : layer);
    const Voxel voxel{first.x + k % kEdge, first.y + k / kEdge % kEdge, z};
    if (grid.free(voxel)) return voxel;
  }
  return first;
}

double Octets::middle_height(const Voxel& octet, double cell) const noexcept {
  return cell * (origin.z + kEdge * octet.z + 0.5 * kEdge);
}

}  // namespace tern
