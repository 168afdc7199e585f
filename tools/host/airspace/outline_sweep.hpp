// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A sweep through outlines from the bottom up, from event to event: what fills the area between edges is known, and
// changes only beside edges that begin, end or meet.
#ifndef TERN_HOST_AIRSPACE_OUTLINE_SWEEP_HPP
#define TERN_HOST_AIRSPACE_OUTLINE_SWEEP_HPP

#include <cstddef>
#include <vector>

#include "host/airspace/outline_edges.hpp"

namespace tern_host {

/// An edge, and the level from which it is the side of a piece.
struct ChainLink {
  const Edge* edge;
  const Level* from;
};

/// A convex piece between two levels: its two sides, from the bottom up. Levels and edges are the arrangement's.
struct GrownPiece {
  std::vector<ChainLink> left;
  std::vector<ChainLink> right;
  const Level* bottom;
  const Level* top;
};

/// The filled area, cut along levels through events.
std::vector<GrownPiece> sweep(const Arrangement& arrangement, std::size_t layers, const Filled& filled);

}  // namespace tern_host

#endif
