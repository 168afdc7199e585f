// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/airspace/convex_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "host/airspace/outline_edges.hpp"
#include "host/airspace/outline_sweep.hpp"

namespace tern_host {
namespace {

/// Beyond which the piece does not go: to the left of an edge, or to its right.
Side side(const Edge& edge, bool is_left) {
  const std::int64_t turn = is_left ? -1 : 1;
  const std::int64_t a = turn * edge.dy(), b = -turn * edge.dx();
  return {a, b, static_cast<__int128>(a) * edge.low.x + static_cast<__int128>(b) * edge.low.y};
}

/// The level, or the next whole number below or above if it is none.
std::int64_t whole(const Level& level, bool upwards) {
  Wide down = level.p / level.q;
  if (down * level.q > level.p) down -= 1;
  if (upwards && down * level.q < level.p) down += 1;
  return down.convert_to<std::int64_t>();
}

ConvexPiece::Vertex vertex(const Edge& edge, const Level& level) {
  return {static_cast<double>(rounded_x(edge, level)) * kStep, static_cast<double>(rounded(level)) * kStep};
}

double area_of(const std::vector<ConvexPiece::Vertex>& v) {
  double twice = 0.0;
  for (std::size_t i = 1; i + 1 < v.size(); ++i) {
    twice += (v[i].x - v[0].x) * (v[i + 1].y - v[0].y) - (v[i].y - v[0].y) * (v[i + 1].x - v[0].x);
  }
  return 0.5 * twice;
}

ConvexPiece finished(const GrownPiece& piece) {
  const Level& bottom = *piece.bottom;
  const Level& top = *piece.top;
  const auto& left = piece.left;
  const auto& right = piece.right;
  const LevelLine below = line_of(bottom), above = line_of(top);
  const bool has_bottom = compare(abscissa(*left.front().edge, below), abscissa(*right.front().edge, below)) != 0;
  const bool has_top = compare(abscissa(*left.back().edge, above), abscissa(*right.back().edge, above)) != 0;
  ConvexPiece out{};
  for (const ChainLink& link : right) {
    out.sides.push_back(side(*link.edge, false));
    out.vertices.push_back(vertex(*link.edge, *link.from));
  }
  out.vertices.push_back(vertex(*right.back().edge, top));
  if (has_top) {
    out.sides.push_back({0, 1, whole(top, true)});
    out.vertices.push_back(vertex(*left.back().edge, top));
  }
  for (std::size_t i = left.size(); i-- > 0;) {
    out.sides.push_back(side(*left[i].edge, true));
    if (i > 0 || has_bottom) out.vertices.push_back(vertex(*left[i].edge, *left[i].from));
  }
  if (has_bottom) out.sides.push_back({0, -1, -whole(bottom, false)});
  out.area = area_of(out.vertices);
  return out;
}

std::vector<ConvexPiece> cut_along_levels(const std::vector<Outline>& outlines, std::size_t layers,
                                          const Filled& filled) {
  const Arrangement arrangement = arrange(outlines);
  std::vector<ConvexPiece> out;
  for (const GrownPiece& piece : sweep(arrangement, layers, filled)) out.push_back(finished(piece));
  return out;
}

void mirror(std::vector<ConvexPiece>& cut) {
  for (ConvexPiece& piece : cut) {
    for (Side& s : piece.sides) std::swap(s.a, s.b);
    for (ConvexPiece::Vertex& v : piece.vertices) std::swap(v.x, v.y);
    std::reverse(piece.sides.begin(), piece.sides.end());
    std::reverse(piece.vertices.begin(), piece.vertices.end());
  }
}

void check(const std::vector<Outline>& outlines) {
  std::size_t corners = 0;
  for (const Outline& outline : outlines) {
    if (!outline.is_hull) corners += outline.corners.size();
    for (const Corner& c : outline.corners) {
      if (std::max(std::llabs(c.x), std::llabs(c.y)) > kMostSteps) {
        throw std::invalid_argument("a corner is more than 32 km from the origin");
      }
    }
  }
  if (corners > kMostCorners) {
    throw std::invalid_argument("more than " + std::to_string(kMostCorners) + " corners in one area");
  }
}

}  // namespace

std::vector<ConvexPiece> convex_pieces(const std::vector<Outline>& outlines, std::size_t layers, const Filled& filled) {
  check(outlines);
  std::vector<ConvexPiece> upright = cut_along_levels(outlines, layers, filled);
  if (upright.size() < 2) return upright;
  // Cut across the other axis, there may be fewer pieces. Mirrored outlines would wind the other way.
  std::vector<Outline> mirrored = outlines;
  for (Outline& outline : mirrored) {
    for (Corner& c : outline.corners) std::swap(c.x, c.y);
    std::reverse(outline.corners.begin(), outline.corners.end());
  }
  std::vector<ConvexPiece> across = cut_along_levels(mirrored, layers, filled);
  if (across.size() >= upright.size()) return upright;
  mirror(across);
  return across;
}

}  // namespace tern_host
