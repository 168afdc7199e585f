// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Areas of the plane cut into convex pieces, exactly: any number of closed outlines that may cross, touch, repeat and
// run either way round, and a rule that says where they leave the area filled.
#ifndef TERN_HOST_AIRSPACE_CONVEX_PIECES_HPP
#define TERN_HOST_AIRSPACE_CONVEX_PIECES_HPP

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace tern_host {

/// Corners are whole multiples of this many metres, 2^-20: about a micrometre.
constexpr double kStep = 1.0 / 1048576.0;
/// The largest coordinate of a corner, in steps: 32 km.
constexpr std::int64_t kMostSteps = std::int64_t{1} << 35;
/// Corners of all outlines together, besides those of hulls of others (Outline::is_hull). Every two edges that share a
/// level are looked at once. The work grows with the corners, with the places where edges meet, and, for each level
/// edge, with the edges to its right at that level.
constexpr std::size_t kMostCorners = 20000;
/// Sides of a piece; one with more is cut.
constexpr std::size_t kMostSides = 40;

/// A corner, in steps.
struct Corner {
  std::int64_t x;
  std::int64_t y;
};

/// A closed outline, without the first corner again at its end. What it winds around is counted with the other outlines
/// of its layer.
struct Outline {
  std::vector<Corner> corners;
  std::size_t layer;
  bool is_hull = false;
};

/// True where the area is filled, from how often the outlines of each layer wind around the place: counter-clockwise
/// counts +1, clockwise -1. False where all are 0.
using Filled = std::function<bool(const std::vector<int>& windings)>;

/// The half-plane a x + b y <= c, in steps. (a, b) is not zero.
struct Side {
  std::int64_t a;
  std::int64_t b;
  __int128 c;
};

/// A convex piece: where all its half-planes hold. Its corners, metres, go round counter-clockwise; they are rounded,
/// the half-planes are not.
struct ConvexPiece {
  struct Vertex {
    double x;
    double y;
  };
  std::vector<Side> sides;
  std::vector<Vertex> vertices;
  double area;  ///< m^2
};

/// The pieces' union is the closed filled area but for parts without an area. Where outlines cross, a cut may be moved
/// outwards by up to one step. Throws std::invalid_argument with a reason beyond kMostSteps or kMostCorners.
std::vector<ConvexPiece> convex_pieces(const std::vector<Outline>& outlines, std::size_t layers, const Filled& filled);

}  // namespace tern_host

#endif
