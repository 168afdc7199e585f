// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/airspace/outline_edges.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tern_host {
namespace {

__int128 cross(std::int64_t ax, std::int64_t ay, std::int64_t bx, std::int64_t by) {
  return static_cast<__int128>(ax) * by - static_cast<__int128>(ay) * bx;
}

/// Which side of the edge's line the corner is on: -1, 0 or 1.
int side_of(const Edge& e, const Corner& c) {
  const __int128 area = cross(e.dx(), e.dy(), c.x - e.low.x, c.y - e.low.y);
  return (area > 0) - (area < 0);
}

/// True if two edges that are not parallel meet.
bool meet(const Edge& a, const Edge& b) {
  return side_of(b, a.low) * side_of(b, a.high) <= 0 && side_of(a, b.low) * side_of(a, b.high) <= 0;
}

/// The level on which two edges that meet and are not parallel do so.
Level meeting_level(const Edge& a, const Edge& b) {
  __int128 down = cross(a.dx(), a.dy(), b.dx(), b.dy());
  __int128 up = cross(b.low.x - a.low.x, b.low.y - a.low.y, b.dx(), b.dy());
  if (down < 0) {
    down = -down;
    up = -up;
  }
  return {Wide(a.low.y) * Wide(down) + Wide(a.dy()) * Wide(up), Wide(down)};
}

bool parallel(const Edge& a, const Edge& b) {
  return cross(a.dx(), a.dy(), b.dx(), b.dy()) == 0;
}

/// What else an edge may meet, while both are open: its span, so that most are passed over at once.
struct Span {
  std::int64_t left, right, top;
  const Edge* edge;
};

Span span_of(const Edge& e) {
  return {std::min(e.low.x, e.high.x), std::max(e.low.x, e.high.x), e.high.y, &e};
}

std::vector<Edge> edges_of(const std::vector<Outline>& outlines) {
  std::vector<Edge> edges;
  for (const Outline& outline : outlines) {
    const std::vector<Corner>& corners = outline.corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Corner &from = corners[i], &to = corners[(i + 1) % corners.size()];
      if (from.y == to.y) continue;
      // The area to the left of an outline's direction is what it winds around.
      const bool rises = from.y < to.y;
      edges.push_back({rises ? from : to, rises ? to : from, rises ? -1 : 1, outline.layer});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) { return a.low.y < b.low.y; });
  return edges;
}

void note_meetings(const std::vector<Edge>& edges, std::vector<Event>& events) {
  std::vector<Span> open;
  for (const Edge& edge : edges) {
    const auto ended = [&edge](const Span& other) { return other.top < edge.low.y; };
    open.erase(std::remove_if(open.begin(), open.end(), ended), open.end());
    const Span span = span_of(edge);
    for (const Span& other : open) {
      if (span.right < other.left || other.right < span.left || parallel(edge, *other.edge)) continue;
      if (meet(*other.edge, edge)) events.push_back({meeting_level(*other.edge, edge), &edge});
    }
    open.push_back(span);
  }
}

/// What the few roundings of numbers up to 4 kMostSteps amount to, and more, in steps.
constexpr long double kRounding = 64.0L * kMostSteps * std::numeric_limits<long double>::epsilon();

/// Exactly x times q dy.
Wide scaled_x(const Abscissa& a) {
  const Wide above = a.level->p - Wide(a.edge->low.y) * a.level->q;
  return Wide(a.edge->low.x) * a.level->q * Wide(a.edge->dy()) + above * Wide(a.edge->dx());
}

}  // namespace

bool operator<(const Level& a, const Level& b) {
  return a.p * b.q < b.p * a.q;
}

bool operator==(const Level& a, const Level& b) {
  return a.p * b.q == b.p * a.q;
}

LevelLine line_of(const Level& level) {
  return {&level, rounded(level)};
}

Abscissa abscissa(const Edge& edge, const LevelLine& line) {
  const long double slope = static_cast<long double>(edge.dx()) / static_cast<long double>(edge.dy());
  const long double above = line.near - static_cast<long double>(edge.low.y);
  return {&edge, line.level, static_cast<long double>(edge.low.x) + above * slope,
          (1.0L + std::fabs(slope)) * kRounding};
}

int compare(const Abscissa& a, const Abscissa& b) {
  if (a.edge == b.edge) return 0;
  const long double apart = a.near - b.near, error = a.error + b.error;
  if (apart > error) return 1;
  if (apart < -error) return -1;
  const Wide left = scaled_x(a) * Wide(b.edge->dy()), right = scaled_x(b) * Wide(a.edge->dy());
  return (left > right) - (left < right);
}

long double rounded_x(const Edge& edge, const Level& level) {
  const Wide above = level.p - Wide(edge.low.y) * level.q;
  const long double part = above.convert_to<long double>() / level.q.convert_to<long double>();
  return static_cast<long double>(edge.low.x) +
         part * static_cast<long double>(edge.dx()) / static_cast<long double>(edge.dy());
}

long double rounded(const Level& level) {
  return level.p.convert_to<long double>() / level.q.convert_to<long double>();
}

int compare_slopes(const Edge& a, const Edge& b) {
  const __int128 left = static_cast<__int128>(a.dx()) * b.dy(), right = static_cast<__int128>(b.dx()) * a.dy();
  return (left > right) - (left < right);
}

Arrangement arrange(const std::vector<Outline>& outlines) {
  Arrangement found{edges_of(outlines), {}};
  note_meetings(found.edges, found.events);
  for (const Edge& edge : found.edges) {
    for (const Corner& end : {edge.low, edge.high}) found.events.push_back({{Wide(end.y), Wide(1)}, &edge});
  }
  std::sort(found.events.begin(), found.events.end(), [](const Event& a, const Event& b) { return a.level < b.level; });
  return found;
}

}  // namespace tern_host
