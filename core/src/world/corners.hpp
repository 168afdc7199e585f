// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The corners of a solid that is given by its faces.
#ifndef TERN_WORLD_CORNERS_HPP
#define TERN_WORLD_CORNERS_HPP

#include "tern/grid.hpp"
#include "tern/halfspace.hpp"
#include "world/solids.hpp"

namespace tern {

/// The region where the robot's centre may be, grown: the boundary within the walls along the axes. Nothing beyond it
/// matters. A wall therefore cuts solids short just as a boundary of its size does.
struct Vicinity {
  Vec3 center;
  double reach;  ///< radius of a ball about the centre that contains the box
  double scale;  ///< the largest coordinate that a grid of this size may involve; rounding is proportional to it
  Halfspace faces[kBoxPlanes];
};

/// All walls must be known. `all_round`: by how much it grows, metres.
Vicinity vicinity_of(const Grid& grid, const Solids& solids, double all_round) noexcept;

/// Metres by which the hull of a solid's corners may reach further out than the solid.
double corner_tolerance(const Vicinity& around) noexcept;

/// Appends the corners of a solid's part in the vicinity. Its faces are in `solids`, and its corners begin at the end
/// of the list. Appends none if the solid lies elsewhere. False if they do not fit, however coarsely they are found.
bool find_corners(const Vicinity& around, Solids& solids, SolidParts& parts) noexcept;

}  // namespace tern

#endif
