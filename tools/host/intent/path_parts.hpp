// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A plan's way cut into parts, each loose by no more than told, and as few as that allows.
#ifndef TERN_HOST_INTENT_PATH_PARTS_HPP
#define TERN_HOST_INTENT_PATH_PARTS_HPP

#include <cstddef>
#include <vector>

#include "host/intent/timed_path.hpp"

namespace tern_host {

/// Seconds and metres.
struct PartLimits {
  double longest;  ///< a part lasts no longer
  double spread;   ///< the hull of its control points is within this of the way, in plan
  double column;   ///< or its control points are within half of this of a common centre in plan
  double rise;     ///< of the highest control point above the lowest, if it is not a column
};

/// Pieces [first, last) of a way.
struct PathPart {
  std::size_t first;
  std::size_t last;
  bool column;
};

/// The way with its pieces halved until each is a fraction of the limits. Throws std::invalid_argument where that takes
/// more than 4096 pieces.
std::vector<PathPiece> halved(const std::vector<PathPiece>& pieces, const PartLimits& limits);

/// The fewest parts that end where pieces end. Every piece must be within the limits, as halved() leaves them.
std::vector<PathPart> fewest_parts(const std::vector<PathPiece>& pieces, const PartLimits& limits);

}  // namespace tern_host

#endif
