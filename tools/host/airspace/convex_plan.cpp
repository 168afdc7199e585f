// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/airspace/convex_plan.hpp"

#include <algorithm>
#include <cmath>

namespace tern_host {
namespace {

/// Two sides whose normals are farther apart than this, as a cosine, would meet too far from their corner.
constexpr double kSharp = -0.5;

__int128 turn(const Corner& a, const Corner& b, const Corner& c) {
  return static_cast<__int128>(b.x - a.x) * (c.y - a.y) - static_cast<__int128>(b.y - a.y) * (c.x - a.x);
}

/// The hull's lower side, in order of the corners given.
std::vector<Corner> half_hull(const std::vector<Corner>& corners) {
  std::vector<Corner> half;
  for (const Corner& c : corners) {
    while (half.size() > 1 && turn(half[half.size() - 2], half.back(), c) <= 0) half.pop_back();
    half.push_back(c);
  }
  return half;
}

ConvexPiece::Vertex vertex_of(const Corner& c) {
  return {static_cast<double>(c.x) * kStep, static_cast<double>(c.y) * kStep};
}

/// The side's normal of length 1, and its offset, metres.
tern::Halfspace unit_plane(const Side& side) {
  const long double a = static_cast<long double>(side.a), b = static_cast<long double>(side.b);
  const long double norm = std::sqrt(a * a + b * b);
  return {{static_cast<double>(a / norm), static_cast<double>(b / norm), 0.0},
          static_cast<double>(static_cast<long double>(side.c) / norm) * kStep};
}

bool holds_box(const tern::Halfspace& plane, const PlanBox& box) {
  const double x = plane.normal.x > 0.0 ? box.upper.east : box.lower.east;
  const double y = plane.normal.y > 0.0 ? box.upper.north : box.lower.north;
  return plane.normal.x * x + plane.normal.y * y <= plane.offset;
}

/// How high the corner b is above the line from a to c, metres.
double height_of(const Corner& a, const Corner& b, const Corner& c) {
  const double base = std::hypot(static_cast<double>(c.x - a.x), static_cast<double>(c.y - a.y));
  return base > 0.0 ? std::fabs(static_cast<double>(turn(a, b, c))) / base * kStep : 0.0;
}

}  // namespace

std::vector<Corner> hull_of(std::vector<Corner> corners) {
  const auto before = [](const Corner& a, const Corner& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); };
  const auto equal = [](const Corner& a, const Corner& b) { return a.x == b.x && a.y == b.y; };
  std::sort(corners.begin(), corners.end(), before);
  corners.erase(std::unique(corners.begin(), corners.end(), equal), corners.end());
  std::vector<Corner> hull = half_hull(corners);
  std::reverse(corners.begin(), corners.end());
  const std::vector<Corner> upper = half_hull(corners);
  if (hull.size() < 2) return hull;
  hull.pop_back();
  hull.insert(hull.end(), upper.begin(), upper.end() - 1);
  return hull;
}

ConvexPiece piece_of(const std::vector<Corner>& corners) {
  ConvexPiece piece{};
  double twice = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Corner& p = corners[i];
    const Corner& q = corners[(i + 1) % corners.size()];
    const std::int64_t a = q.y - p.y, b = p.x - q.x;
    piece.sides.push_back({a, b, static_cast<__int128>(a) * p.x + static_cast<__int128>(b) * p.y});
    piece.vertices.push_back(vertex_of(p));
    twice += static_cast<double>(turn(corners[0], p, q));
  }
  piece.area = 0.5 * twice * kStep * kStep;
  return piece;
}

std::vector<Corner> fewer_corners(const std::vector<Corner>& corners, std::size_t most, double& lost) {
  std::vector<Corner> left = corners;
  while (left.size() > most) {
    std::size_t flattest = 0;
    double least = HUGE_VAL;
    for (std::size_t i = 0; i < left.size(); ++i) {
      const double height = height_of(left[(i + left.size() - 1) % left.size()], left[i], left[(i + 1) % left.size()]);
      if (height >= least) continue;
      least = height;
      flattest = i;
    }
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(flattest));
  }
  lost = 0.0;
  const ConvexPiece piece = piece_of(left);
  for (const Corner& c : corners) {
    for (const Side& side : piece.sides) lost = std::max(lost, beyond(side, vertex_of(c)));
  }
  return left;
}

double beyond(const Side& side, const ConvexPiece::Vertex& point) {
  const tern::Halfspace plane = unit_plane(side);
  return plane.normal.x * point.x + plane.normal.y * point.y - plane.offset;
}

double depth_within(const ConvexPiece& piece, const ConvexPiece& polygon) {
  double depth = HUGE_VAL;
  for (const Side& side : polygon.sides) {
    double deepest = 0.0;
    for (const ConvexPiece::Vertex& v : piece.vertices) deepest = std::max(deepest, -beyond(side, v));
    depth = std::min(depth, deepest);
  }
  return depth;
}

bool has_corner_deeper(const std::vector<Outline>& outlines, double depth, const ConvexPiece& hull) {
  const auto is_deeper = [&](const Corner& c) {
    const ConvexPiece::Vertex at{static_cast<double>(c.x) * kStep, static_cast<double>(c.y) * kStep};
    return depth_within({{}, {at}, 0.0}, hull) > depth;
  };
  return std::any_of(outlines.begin(), outlines.end(), [&](const Outline& outline) {
    return std::any_of(outline.corners.begin(), outline.corners.end(), is_deeper);
  });
}

bool reaches(const ConvexPiece& piece, const PlanBox& box, double by) {
  const ConvexPiece::Vertex corners[4] = {{box.lower.east, box.lower.north},
                                          {box.upper.east, box.lower.north},
                                          {box.upper.east, box.upper.north},
                                          {box.lower.east, box.upper.north}};
  for (const Side& side : piece.sides) {
    if (std::all_of(corners, corners + 4, [&](const auto& c) { return beyond(side, c) > by; })) return false;
  }
  const auto all = [&piece](auto test) { return std::all_of(piece.vertices.begin(), piece.vertices.end(), test); };
  return !all([&](const auto& v) { return v.x < box.lower.east - by; }) &&
         !all([&](const auto& v) { return v.x > box.upper.east + by; }) &&
         !all([&](const auto& v) { return v.y < box.lower.north - by; }) &&
         !all([&](const auto& v) { return v.y > box.upper.north + by; });
}

std::vector<tern::Halfspace> upright_planes(const ConvexPiece& piece, double by, const PlanBox& box) {
  std::vector<tern::Halfspace> planes;
  const auto add = [&planes, &box](const tern::Halfspace& plane) {
    if (!holds_box(plane, box)) planes.push_back(plane);
  };
  for (std::size_t i = 0; i < piece.sides.size(); ++i) {
    tern::Halfspace plane = unit_plane(piece.sides[i]);
    const tern::Halfspace next = unit_plane(piece.sides[(i + 1) % piece.sides.size()]);
    plane.offset += by;
    add(plane);
    const double cosine = plane.normal.x * next.normal.x + plane.normal.y * next.normal.y;
    if (by <= 0.0 || cosine >= kSharp) continue;
    // Halfway between the two normals, which go round counter-clockwise; where they are nearly opposite, their
    // difference is the better measure.
    const double dx = plane.normal.x - next.normal.x, dy = plane.normal.y - next.normal.y;
    const double norm = std::hypot(dx, dy);
    tern::Halfspace bevel{{-dy / norm, dx / norm, 0.0}, -HUGE_VAL};
    for (const ConvexPiece::Vertex& v : piece.vertices) {
      bevel.offset = std::max(bevel.offset, bevel.normal.x * v.x + bevel.normal.y * v.y);
    }
    bevel.offset += by;
    add(bevel);
  }
  return planes;
}

}  // namespace tern_host
