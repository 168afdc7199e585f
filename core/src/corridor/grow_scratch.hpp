// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_CORRIDOR_GROW_SCRATCH_HPP
#define TERN_CORRIDOR_GROW_SCRATCH_HPP

#include <cstdint>

#include "base/capacity.hpp"
#include "grid/local_boxes.hpp"
#include "tern/corridor.hpp"
#include "tern/status.hpp"

namespace tern {

/// Scratch and high-water marks of growing polyhedra. The marks hold for all calls: reset them before the first.
struct GrowScratch {
  std::int32_t planes_high;  ///< half-spaces of the fullest polyhedron
  std::int32_t boxes_high;   ///< boxes in the fullest local box

  LocalBox boxes[kMaxLocalBoxes];
  std::int32_t remaining[kMaxLocalBoxes];  ///< boxes that no half-space cuts off yet, in ascending order
  double scale[kMaxLocalBoxes];            ///< scale at which the growing ellipsoid meets each remaining box, or a
                                           ///< lower bound of it
  Polyhedron trial;                        ///< the polyhedron of the current round or trial
  ExtractScratch extract;
};

/// Resets all marks to zero.
inline void reset_counters(GrowScratch& scratch) noexcept {
  scratch.planes_high = 0;
  scratch.boxes_high = 0;
}

/// Adds a half-space. kOk or kPlanesFull. The polyhedron is unchanged unless kOk.
inline Status append(const Halfspace& plane, GrowScratch& scratch, Polyhedron& polyhedron) noexcept {
  if (is_full(polyhedron.count == kMaxPlanes)) return Status::kPlanesFull;
  polyhedron.planes[polyhedron.count++] = plane;
  if (polyhedron.count > scratch.planes_high) scratch.planes_high = polyhedron.count;
  return Status::kOk;
}

}  // namespace tern

#endif
