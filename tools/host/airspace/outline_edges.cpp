// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/airspace/outline_edges.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tern_host {
namespace {

/// Any edge, level or not, as it stands in its outline.
struct Segment {
  Corner from;
  Corner to;
  std::size_t layer;

  std::int64_t bottom() const { return std::min(from.y, to.y); }
  std::int64_t top() const { return std::max(from.y, to.y); }
  std::int64_t left() const { return std::min(from.x, to.x); }
  std::int64_t right() const { return std::max(from.x, to.x); }
  bool is_level() const { return from.y == to.y; }
};

bool same(const Corner& a, const Corner& b) {
  return a.x == b.x && a.y == b.y;
}

__int128 cross(std::int64_t ax, std::int64_t ay, std::int64_t bx, std::int64_t by) {
  return static_cast<__int128>(ax) * by - static_cast<__int128>(ay) * bx;
}

/// Which side of the segment's line the corner is on: -1, 0 or 1.
int side_of(const Segment& s, const Corner& c) {
  const __int128 area = cross(s.to.x - s.from.x, s.to.y - s.from.y, c.x - s.from.x, c.y - s.from.y);
  return (area > 0) - (area < 0);
}

/// True if two segments that are not parallel meet.
bool meet(const Segment& a, const Segment& b) {
  return side_of(b, a.from) * side_of(b, a.to) <= 0 && side_of(a, b.from) * side_of(a, b.to) <= 0;
}

/// The level on which two segments that meet and are not parallel do so.
Level meeting_level(const Segment& a, const Segment& b) {
  const std::int64_t bx = b.to.x - b.from.x, by = b.to.y - b.from.y;
  __int128 down = cross(a.to.x - a.from.x, a.to.y - a.from.y, bx, by);
  __int128 up = cross(b.from.x - a.from.x, b.from.y - a.from.y, bx, by);
  if (down < 0) {
    down = -down;
    up = -up;
  }
  return {Wide(a.from.y) * Wide(down) + Wide(a.to.y - a.from.y) * Wide(up), Wide(down)};
}

bool parallel(const Segment& a, const Segment& b) {
  return cross(a.to.x - a.from.x, a.to.y - a.from.y, b.to.x - b.from.x, b.to.y - b.from.y) == 0;
}

void note_meeting(const Segment& a, const Segment& b, Arrangement& found) {
  if (a.right() < b.left() || b.right() < a.left() || a.is_level() || b.is_level() || parallel(a, b)) return;
  if (meet(a, b)) found.levels.push_back(meeting_level(a, b));
}

std::vector<Segment> segments_of(const std::vector<Outline>& outlines) {
  std::vector<Segment> segments;
  for (const Outline& outline : outlines) {
    const std::vector<Corner>& corners = outline.corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Corner& next = corners[(i + 1) % corners.size()];
      if (!same(corners[i], next)) segments.push_back({corners[i], next, outline.layer});
    }
  }
  std::sort(segments.begin(), segments.end(),
            [](const Segment& a, const Segment& b) { return a.bottom() < b.bottom(); });
  return segments;
}

void note_meetings(const std::vector<Segment>& segments, Arrangement& found) {
  std::vector<const Segment*> open;
  for (const Segment& segment : segments) {
    const auto ended = [&segment](const Segment* other) { return other->top() < segment.bottom(); };
    open.erase(std::remove_if(open.begin(), open.end(), ended), open.end());
    for (const Segment* other : open) note_meeting(*other, segment, found);
    open.push_back(&segment);
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
  Arrangement found;
  const std::vector<Segment> segments = segments_of(outlines);
  note_meetings(segments, found);
  for (const Segment& s : segments) {
    for (const Corner& end : {s.from, s.to}) found.levels.push_back({Wide(end.y), Wide(1)});
    if (s.is_level()) continue;
    // The area to the left of an outline's direction is what it winds around.
    const bool rises = s.from.y < s.to.y;
    found.edges.push_back({rises ? s.from : s.to, rises ? s.to : s.from, rises ? -1 : 1, s.layer});
  }
  std::sort(found.levels.begin(), found.levels.end());
  found.levels.erase(std::unique(found.levels.begin(), found.levels.end()), found.levels.end());
  return found;
}

}  // namespace tern_host
