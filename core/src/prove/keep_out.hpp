// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Proves that a keep-out of any shape, however thin or pointed, is cut off along a given normal.
#ifndef TERN_PROVE_KEEP_OUT_HPP
#define TERN_PROVE_KEEP_OUT_HPP

#include "base/work.hpp"
#include "prove/cut_off.hpp"
#include "prove/solid.hpp"
#include "tern/fence.hpp"
#include "tern/grid.hpp"

namespace tern {

/// Memory for one keep-out at a time, relative to the centre of the box around the boundary.
struct FenceScratch {
  Solid<DoubleDouble> exact;
  Solid<double> quick;  ///< the same, rounded
};

/// A hull that keeps a distance. Local frame, metres.
struct Apart {
  const Vec3* points;
  int count;
  double distance;
};

/// True only if keep-out `index` of the fences is cut off from the hull by the distance, along the normal of a hint or
/// of one of its own faces. Only the part of it within the radius of the boundary and of all keep-ins counts.
bool keep_out_cut_off(const Grid& grid, const Fence* fences, int count, int index, const Hints& hints,
                      const Apart& hull, FenceScratch& scratch) noexcept;

/// Of one call: the corners of the part are those of all triples of planes.
constexpr Operations kKeepOutOperations = 150 * ops::kPiece;

}  // namespace tern

#endif
