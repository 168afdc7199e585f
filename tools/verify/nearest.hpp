// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How near a curve comes to solid bodies, for all t.
#ifndef TERN_VERIFY_NEAREST_HPP
#define TERN_VERIFY_NEAREST_HPP

#include <cstddef>
#include <vector>

#include "verify/bezier.hpp"
#include "verify/problem.hpp"

namespace tern_verify {

/// All points within `radius`, horizontally, of a closed box: a box where the radius is 0, an upright cylinder where
/// the box is a line.
struct Solid {
  Box box;
  Rational radius;
};

/// The least distance of curves from solids, in metres. Inside a solid, it is minus the least way out along an axis,
/// or along the radius of a cylinder.
struct Nearest {
  Rational least;  ///< no point of a curve is nearer
  Rational most;   ///< this point is no further away
  std::size_t curve, solid;
  Rational u;  ///< of that point, in [0, 1]
};

/// To within 1e-12 m. There are curves and solids.
Nearest nearest_of(const std::vector<Polygon<3>>& curves, const std::vector<Solid>& solids);

/// The same of single points; `curve` is the number of the nearest one. There are points and solids.
Nearest nearest_point(const std::vector<Point>& points, const std::vector<Solid>& solids);

}  // namespace tern_verify

#endif
