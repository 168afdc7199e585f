// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Scans along y and z voxel by voxel, from the nine rows around the line.
#ifndef TERN_SEARCH_LINE_WALK_HPP
#define TERN_SEARCH_LINE_WALK_HPP

#include "grid/lattice.hpp"
#include "search/neighbourhood.hpp"

namespace tern {

/// Blocked cells across a line along kAxis (1 or 2) at a voxel: x - 1 .. x + 1 fastest, then three levels of the third
/// axis; the line's own cell is in bit 4.
template <int kAxis>
CellMask cross_section(const Grid& grid, const Voxel& v) noexcept {
  constexpr int kY = kAxis == 2 ? 1 : 0;
  constexpr int kZ = kAxis == 1 ? 1 : 0;
  return triple_at(grid, v.x, v.y - kY, v.z - kZ) | triple_at(grid, v.x, v.y, v.z) << 3 |
         triple_at(grid, v.x, v.y + kY, v.z + kZ) << 6;
}

/// True if an arrival at `at` from `from`, one step along the line, forces a move; `beyond` is one step further. The
/// same rule as in jump_stops.cpp, for one voxel.
inline bool section_forces(CellMask from, CellMask at, CellMask beyond) noexcept {
  constexpr CellMask kStraight = 1u << 1 | 1u << 3 | 1u << 5 | 1u << 7;
  constexpr CellMask kSquares[] = {0x1Bu, 0x36u, 0xD8u, 0x1B0u};  // around the corners 0, 2, 6 and 8
  const CellMask opens = from & ~at;
  if ((opens & kStraight) != 0) return true;
  for (int k = 0; k < 4; ++k) {
    const CellMask corner = 1u << ((k & 1) * 2 + (k >> 1) * 6);
    if ((opens & corner) != 0 && ((at | beyond) & kSquares[k]) == 0) return true;
  }
  return false;
}

/// The coordinate on kAxis of the first voxel after `from`, up to and including `last`, at which a scan stops. If there
/// is none: the coordinate after `last`, which is `last` + 1 if kUp, otherwise `last` - 1.
template <int kAxis, bool kUp>
std::int32_t walk_line(const Grid& grid, Voxel from, std::int32_t last) noexcept {
  constexpr CellMask kOwn = 1u << 4;
  std::int32_t& at = axis(from, kAxis);
  CellMask behind = cross_section<kAxis>(grid, from);
  while (at != last) {
    at += kUp ? 1 : -1;
    const CellMask here = cross_section<kAxis>(grid, from);
    if ((here & kOwn) != 0) return at;
    if ((behind & ~here) != 0) {
      Voxel next = from;
      axis(next, kAxis) += kUp ? 1 : -1;
      if (section_forces(behind, here, cross_section<kAxis>(grid, next))) return at;
    }
    behind = here;
  }
  return at + (kUp ? 1 : -1);
}

}  // namespace tern

#endif
