// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The 26 moves of the grid and their costs. Directions and the cells around a voxel share one numbering, 0 .. 26 with x
// fastest; 13 is the voxel itself. A set of either is a 27-bit mask.
#ifndef TERN_BASE_DIRECTION_HPP
#define TERN_BASE_DIRECTION_HPP

#include <cstdint>

#include "tern/config.hpp"
#include "tern/vec3.hpp"

namespace tern {

constexpr int kDirections = 27;
constexpr int kHere = 13;

/// A set of directions, or of cells of a 3x3x3 neighbourhood.
using CellMask = std::uint32_t;
constexpr CellMask kAllCells = (CellMask{1} << kDirections) - 1;

constexpr int direction(int dx, int dy, int dz) {
  return (dx + 1) + 3 * (dy + 1) + 9 * (dz + 1);
}
constexpr CellMask cell_bit(int d) {
  return CellMask{1} << d;
}
constexpr Voxel offset(int d) {
  return {d % 3 - 1, d / 3 % 3 - 1, d / 9 - 1};
}

/// Number of axes that a direction moves along: 1 straight, 2 or 3 diagonal, 0 for kHere.
constexpr int axes_of(int d) {
  const Voxel o = offset(d);
  return (o.x != 0 ? 1 : 0) + (o.y != 0 ? 1 : 0) + (o.z != 0 ? 1 : 0);
}

/// Path costs, fixed point with 36 fractional bits. Sums are associative, so ties are exact and all platforms agree. An
/// optimal path visits no voxel twice; its cost and the heuristic of one map stay below 2^64.
using Cost = std::uint64_t;
constexpr int kCostFraction = 36;
constexpr Cost kStraightCost = Cost{1} << kCostFraction;
constexpr Cost kPlaneDiagonalCost = 97184015999;   ///< floor(sqrt(2) * 2^36)
constexpr Cost kSpaceDiagonalCost = 119025625176;  ///< floor(sqrt(3) * 2^36)
static_assert(kMaxCells <= (std::int64_t{1} << 27) && kMaxDimension <= 2048, "costs would overflow 64 bits");

constexpr Cost move_cost(int d) {
  return axes_of(d) == 1 ? kStraightCost : (axes_of(d) == 2 ? kPlaneDiagonalCost : kSpaceDiagonalCost);
}

/// A move of the search.
struct Move {
  Voxel step;
  Cost cost;
};
struct MoveTable {
  Move at[kDirections];
};
constexpr MoveTable make_moves() {
  MoveTable table{};
  for (int d = 0; d < kDirections; ++d) table.at[d] = {offset(d), d == kHere ? 0 : move_cost(d)};
  return table;
}
inline constexpr MoveTable kMoveOf = make_moves();

/// Number of moves of each kind in the cheapest path between two voxels of an empty map.
struct MoveCounts {
  std::int32_t space;     ///< along three axes
  std::int32_t plane;     ///< along two axes
  std::int32_t straight;  ///< along one axis
};

constexpr std::int32_t magnitude(std::int32_t v) {
  return v < 0 ? -v : v;
}

constexpr MoveCounts octile_moves(const Voxel& a, const Voxel& b) {
  const std::int32_t x = magnitude(b.x - a.x);
  const std::int32_t y = magnitude(b.y - a.y);
  const std::int32_t z = magnitude(b.z - a.z);
  const std::int32_t low = x < y ? (x < z ? x : z) : (y < z ? y : z);
  const std::int32_t high = x > y ? (x > z ? x : z) : (y > z ? y : z);
  const std::int32_t middle = x + y + z - low - high;
  return {low, middle - low, high - middle};
}

/// The cost of the cheapest path between two voxels of an empty map. It is a consistent heuristic. It is also the cost
/// of a jump, which is always such a path.
constexpr Cost octile(const Voxel& a, const Voxel& b) {
  const MoveCounts moves = octile_moves(a, b);
  return static_cast<Cost>(moves.space) * kSpaceDiagonalCost + static_cast<Cost>(moves.plane) * kPlaneDiagonalCost +
         static_cast<Cost>(moves.straight) * kStraightCost;
}

constexpr Voxel operator+(const Voxel& a, const Voxel& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
constexpr bool same(const Voxel& a, const Voxel& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

}  // namespace tern

#endif
