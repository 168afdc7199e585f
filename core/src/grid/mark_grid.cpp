// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A coarse grid from a fine one. 4 x 4 x 4 fine voxels are one coarse cell, and one word: bit x + 4 y + 16 z.
#include "base/math.hpp"
#include "base/verdict.hpp"
#include "grid/bit_rows.hpp"
#include "grid/lattice.hpp"
#include "tern/grid.hpp"

namespace tern {
namespace {

static_assert(kFineVoxels * kFineVoxels * kFineVoxels == kWordBits, "a cell is a word");
constexpr int kSides = 6;
/// A cell whose free part is smaller is closed.
constexpr int kLeastFree = kWordBits / 2;

/// A cell's first and last layer along each axis, and the bits from a voxel to the next.
struct Layers {
  std::uint64_t first, last;
  int step;
};
constexpr Layers kLayers[3] = {{0x1111111111111111u, 0x8888888888888888u, 1},
                               {0x000F000F000F000Fu, 0xF000F000F000F000u, 4},
                               {0x000000000000FFFFu, 0xFFFF000000000000u, 16}};

int count_of(std::uint64_t bits) {
  bits -= (bits >> 1) & 0x5555555555555555u;
  bits = (bits & 0x3333333333333333u) + ((bits >> 2) & 0x3333333333333333u);
  bits = (bits + (bits >> 4)) & 0x0F0F0F0F0F0F0F0Fu;
  return static_cast<int>((bits * 0x0101010101010101u) >> 56);
}

/// The voxels of `within` that hang together with the seed, through faces. Each turn but the last adds a voxel.
std::uint64_t joined_to(std::uint64_t seed, std::uint64_t within) {
  for (int turn = 0; turn < kWordBits; ++turn) {
    std::uint64_t grown = seed;
    for (const Layers& along : kLayers) {
      grown |= ((seed & ~along.last) << along.step) | ((seed & ~along.first) >> along.step);
    }
    grown &= within;
    if (grown == seed) break;
    seed = grown;
  }
  return seed;
}

/// The largest part of the free voxels that hangs together; of equal ones, the one that has the first voxel. Each turn
/// takes a voxel at least.
std::uint64_t largest_part(std::uint64_t free) {
  std::uint64_t largest = 0;
  while (count_of(free) > count_of(largest)) {
    const std::uint64_t part = joined_to(free & (~free + 1), free);
    if (count_of(part) > count_of(largest)) largest = part;
    free &= ~part;
  }
  return largest;
}

/// The free part of a cell that the fine grid holds; none if it is less than half of the cell.
std::uint64_t free_part(const Grid& fine, const Voxel& cell) {
  const std::int32_t x = kFineVoxels * cell.x;
  std::uint64_t blocked = 0;
  for (int row = 0; row < kFineVoxels * kFineVoxels; ++row) {
    const std::int32_t y = kFineVoxels * cell.y + row % kFineVoxels;
    const std::int32_t z = kFineVoxels * cell.z + row / kFineVoxels;
    const std::uint64_t four = (fine.blocked_row(y, z)[x >> 6] >> (x & 63)) & 0xFu;
    blocked |= four << (kFineVoxels * row);
  }
  if (blocked == 0) return kAllBits;
  const std::uint64_t part = largest_part(~blocked);
  return count_of(part) >= kLeastFree ? part : 0;
}

/// Coarse cells on an axis that the fine grid holds as a whole.
std::int32_t cells_of(const Grid& fine, int a) {
  return axis(fine.spec().dims, a) / kFineVoxels;
}

/// True if voxels of the two parts share a face: `beyond` is that of the next cell along the axis.
bool meet(std::uint64_t part, std::uint64_t beyond, const Layers& along) {
  const int across = (kFineVoxels - 1) * along.step;
  return (((part & along.last) >> across) & beyond) != 0;
}

/// True if the cell has no free part, or one that does not meet that of a neighbour, and is the smaller of both; of
/// equal ones, the one further along the axis.
bool is_closed(const Grid& fine, const Voxel& cell) {
  const std::uint64_t own = free_part(fine, cell);
  if (own == 0 || own == kAllBits) return own == 0;
  for (int side = 0; side < kSides; ++side) {
    const int a = side / 2;
    const bool is_next = side % 2 != 0;
    Voxel beside = cell;
    axis(beside, a) += is_next ? 1 : -1;
    if (!contains({0, cells_of(fine, a)}, axis(beside, a))) continue;
    const std::uint64_t other = free_part(fine, beside);
    if (other == 0 || (is_next ? meet(own, other, kLayers[a]) : meet(other, own, kLayers[a]))) continue;
    const int more = count_of(other) - count_of(own);
    if (more > 0 || (more == 0 && !is_next)) return true;
  }
  return false;
}

/// The coarse cell of the fine grid's first voxel; `field` is what does not fit.
Verdict first_cell(const GridSpec& coarse, const GridSpec& fine, Voxel& first) {
  const double edge = kFineVoxels * fine.cell;
  if (absolute(edge - coarse.cell) > kWorldRounding * coarse.cell) return {Status::kInvalidArgument, Field::kCell};
  for (int a = 0; a < 3; ++a) {
    const double lower = axis(fine.origin, a);
    const double cells = (lower - axis(coarse.origin, a)) / coarse.cell;
    // Beyond either end, the fine grid holds none of these cells.
    const std::int32_t nearest = floor_index(cells + 0.5, -2 * kMaxDimension, 2 * kMaxDimension);
    const double off = absolute(cells - nearest);
    const double tolerance = world_tolerance(coarse, lower) + world_tolerance(coarse, axis(coarse.origin, a));
    if (off > tolerance && nearest > -2 * kMaxDimension && nearest < 2 * kMaxDimension) {
      return {Status::kInvalidArgument, Field::kOrigin};
    }
    axis(first, a) = nearest;
  }
  return kAccepted;
}

Verdict check(const Grid& coarse, const Grid& fine, Voxel& first) {
  if (!coarse.bound() || !fine.bound()) return {Status::kInvalidArgument, Field::kStorage};
  if (!fine.inflated()) return {Status::kInvalidArgument, Field::kNotInflated};
  return first_cell(coarse.spec(), fine.spec(), first);
}

}  // namespace

Status Grid::mark_grid(const Grid& fine, Field* field) noexcept {
  Voxel first{};
  const Verdict verdict = check(*this, fine, first);
  if (field != nullptr) *field = verdict.field;
  if (verdict.status != Status::kOk) return verdict.status;
  for (std::int32_t z = 0; z < cells_of(fine, 2); ++z) {
    for (std::int32_t y = 0; y < cells_of(fine, 1); ++y) {
      for (std::int32_t x = 0; x < cells_of(fine, 0); ++x) {
        const Voxel cell{first.x + x, first.y + y, first.z + z};
        if (inside(cell) && is_closed(fine, {x, y, z})) mark_voxel(cell);
      }
    }
  }
  return Status::kOk;
}

}  // namespace tern
