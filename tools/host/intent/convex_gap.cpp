// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/intent/convex_gap.hpp"

#include <algorithm>
#include <cmath>

namespace tern_host {
namespace {

using Vertex = ConvexPiece::Vertex;

/// Positive where p is to the left of the line from a to b.
double side_of(const Vertex& a, const Vertex& b, const Vertex& p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

/// One of a's sides has all of b beyond it.
bool is_apart(const PlanPolygon& a, const PlanPolygon& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vertex& p = a[i];
    const Vertex& q = a[(i + 1) % a.size()];
    if (std::all_of(b.begin(), b.end(), [&](const Vertex& v) { return side_of(p, q, v) < 0.0; })) return true;
  }
  return false;
}

Vertex nearest_on(const Vertex& a, const Vertex& b, const Vertex& p) {
  const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
  const double u = square > 0.0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0) : 0.0;
  return {a.x + u * dx, a.y + u * dy};
}

struct Nearest {
  double distance = HUGE_VAL;
  Vertex middle{};
};

/// Of a's corners to b's sides.
void approach(const PlanPolygon& a, const PlanPolygon& b, Nearest& nearest) {
  for (const Vertex& p : a) {
    for (std::size_t i = 0; i < b.size(); ++i) {
      const Vertex q = nearest_on(b[i], b[(i + 1) % b.size()], p);
      const double distance = std::hypot(p.x - q.x, p.y - q.y);
      if (distance < nearest.distance) nearest = {distance, {0.5 * (p.x + q.x), 0.5 * (p.y + q.y)}};
    }
  }
}

Nearest nearest_of(const PlanPolygon& a, const PlanPolygon& b) {
  Nearest nearest;
  approach(a, b, nearest);
  approach(b, a, nearest);
  return nearest;
}

/// What of the polygon is to the left of the line from a to b.
PlanPolygon clipped(const PlanPolygon& polygon, const Vertex& a, const Vertex& b) {
  PlanPolygon out;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vertex& p = polygon[i];
    const Vertex& q = polygon[(i + 1) % polygon.size()];
    const double at_p = side_of(a, b, p), at_q = side_of(a, b, q);
    if (at_p >= 0.0) out.push_back(p);
    if ((at_p >= 0.0) == (at_q >= 0.0)) continue;
    const double u = at_p / (at_p - at_q);
    out.push_back({p.x + u * (q.x - p.x), p.y + u * (q.y - p.y)});
  }
  return out;
}

}  // namespace

double gap_between(const PlanPolygon& a, const PlanPolygon& b) {
  return is_apart(a, b) || is_apart(b, a) ? nearest_of(a, b).distance : 0.0;
}

Vertex common_place(const PlanPolygon& a, const PlanPolygon& b) {
  PlanPolygon common = a;
  for (std::size_t i = 0; i < b.size() && !common.empty(); ++i) common = clipped(common, b[i], b[(i + 1) % b.size()]);
  if (common.empty()) return nearest_of(a, b).middle;
  Vertex middle{0.0, 0.0};
  for (const Vertex& v : common) {
    middle.x += v.x / static_cast<double>(common.size());
    middle.y += v.y / static_cast<double>(common.size());
  }
  return middle;
}

}  // namespace tern_host
