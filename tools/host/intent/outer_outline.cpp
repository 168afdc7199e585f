// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/intent/outer_outline.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace tern_host {
namespace {

using Vertex = ConvexPiece::Vertex;

constexpr double kRounding = 1e-7;

/// Where the lines from a to b and from c to d meet, beyond b and before c.
std::optional<Vertex> meeting(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& d) {
  const double ux = b.x - a.x, uy = b.y - a.y, vx = d.x - c.x, vy = d.y - c.y;
  const double turn = ux * vy - uy * vx;
  if (!(turn > 0.0)) return std::nullopt;
  const double s = ((c.x - b.x) * vy - (c.y - b.y) * vx) / turn;
  if (!(s >= 0.0)) return std::nullopt;
  return Vertex{b.x + s * ux, b.y + s * uy};
}

/// How far p is to the right of the line from a to b.
double outside(const Vertex& a, const Vertex& b, const Vertex& p) {
  const double dx = b.x - a.x, dy = b.y - a.y, length = std::hypot(dx, dy);
  return length > 0.0 ? (dy * (p.x - a.x) - dx * (p.y - a.y)) / length : 0.0;
}

/// The corner that takes the place of a side's two ends, and how far it is from the original.
struct Candidate {
  Vertex corner{};
  double away = HUGE_VAL;
};

Candidate without_side(const PlanPolygon& polygon, std::size_t i, const PlanPolygon& original) {
  const std::size_t n = polygon.size();
  const Vertex &a = polygon[(i + n - 1) % n], &b = polygon[i], &c = polygon[(i + 1) % n], &d = polygon[(i + 2) % n];
  const std::optional<Vertex> corner = meeting(a, b, c, d);
  if (!corner || outside(a, *corner, b) > kRounding || outside(*corner, d, c) > kRounding) return {};
  return {*corner, gap_between({*corner}, original)};
}

}  // namespace

PlanPolygon outer_outline(PlanPolygon polygon, std::size_t least, double most) {
  const PlanPolygon original = polygon;
  while (polygon.size() > std::max<std::size_t>(least, 3)) {
    Candidate best;
    std::size_t side = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Candidate candidate = without_side(polygon, i, original);
      if (candidate.away >= best.away) continue;
      best = candidate;
      side = i;
    }
    if (!(best.away <= most)) break;
    polygon[side] = best.corner;
    polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>((side + 1) % polygon.size()));
  }
  return polygon;
}

}  // namespace tern_host
