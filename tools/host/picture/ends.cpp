// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Start and goal, and where their names have room.
#include "host/picture/ends.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host/picture/lettering.hpp"

namespace tern_host {
namespace {

constexpr double kEndRadius = 7.0;
constexpr double kViaRadius = 7.5;
constexpr double kViaBaseline = 3.5;  ///< of its number, below its centre
constexpr double kSame = 2.0;         // pixels within which both ends are one
constexpr double kStep = 4.0;         // pixels between the points of a way that a name is kept off
constexpr double kOutside = 1000.0;   // what leaving the frame costs, in points covered
constexpr int kRings = 4;             // distances tried
constexpr const char* kStartColour = "#2f8f5b";
constexpr const char* kGoalColour = "#c23b3b";

std::vector<Pixel> densified(const std::vector<Pixel>& way) {
  std::vector<Pixel> points;
  for (std::size_t i = 1; i < way.size(); ++i) {
    const Pixel& a = way[i - 1];
    const Pixel& b = way[i];
    const int parts = 1 + static_cast<int>(std::min(500.0, std::hypot(b.x - a.x, b.y - a.y) / kStep));
    for (int k = 0; k < parts; ++k) points.push_back({a.x + (b.x - a.x) * k / parts, a.y + (b.y - a.y) * k / parts});
  }
  return points;
}

struct Name {
  Pixel at;
  std::string style;
  Rect room;
};

/// The name `ring` steps away, to one of eight sides.
Name name_beside(Pixel end, const std::string& text, int side, int ring) {
  constexpr double kSides[8][2] = {{1, -1}, {-1, -1}, {1, 1}, {-1, 1}, {1, 0}, {-1, 0}, {0, -1}, {0, 1}};
  const double dx = kSides[side][0];
  const double dy = kSides[side][1];
  const double gap = kEndRadius + 14.0 * ring;
  const char* const anchor = dx > 0.0 ? "start" : (dx < 0.0 ? "end" : "middle");
  const Pixel at{end.x + dx * (gap + (dy == 0.0 ? 5.0 : 2.0)), end.y + 5.0 + dy * (gap + 7.0)};
  const std::string style = std::string("class=\"end-name\" text-anchor=\"") + anchor + "\"";
  return {at, style, text_room(at, text, style)};
}

/// What a place for a name hides; infinite where it meets another text or the page's edge.
double cost(const Canvas& canvas, const Rect& frame, const std::vector<Pixel>& points, const Name& name, int ring) {
  const Rect& r = name.room;
  if (r.x < 2.0 || r.y < 2.0 || !canvas.clear_of_text(r)) return std::numeric_limits<double>::infinity();
  const bool inside = r.x >= frame.x && r.right() <= frame.right() && r.y >= frame.y && r.bottom() <= frame.bottom();
  const auto hidden = std::count_if(points.begin(), points.end(), [&](const Pixel& p) { return r.holds(p); });
  return static_cast<double>(hidden) + (inside ? 0.0 : kOutside) + 2.0 * ring;
}

/// The cheapest place of all; none where every place meets another text.
void draw_name(Canvas& canvas, const Rect& frame, const std::vector<Pixel>& points, Pixel end,
               const std::string& text) {
  double least = std::numeric_limits<double>::infinity();
  Name best{};
  for (int ring = 0; ring < kRings; ++ring) {
    for (int side = 0; side < 8; ++side) {
      const Name name = name_beside(end, text, side, ring);
      const double price = cost(canvas, frame, points, name, ring);
      if (!(price < least)) continue;
      least = price;
      best = name;
    }
  }
  if (std::isfinite(least)) canvas.text(best.at, text, best.style);
}

/// Corners of a marker, which names keep off as they do a way; many, as a marker matters more.
void append_marker(std::vector<Pixel>& points, Pixel end) {
  for (int i = -3; i <= 3; ++i) {
    for (int k = -3; k <= 3; ++k) points.push_back({end.x + kEndRadius * i / 3.0, end.y + kEndRadius * k / 3.0});
  }
}

void draw_dot(Canvas& canvas, Pixel at, double radius, const char* colour) {
  canvas.circle(at, radius, std::string("class=\"end\" fill=\"") + colour + "\"");
}

/// An end that the frame does not show stands at the frame's edge and says so.
struct End {
  Pixel at;
  std::string name;

  End(Pixel place, const Rect& frame, const char* what)
      : at{std::clamp(place.x, frame.x, frame.right()), std::clamp(place.y, frame.y, frame.bottom())},
        name(std::hypot(at.x - place.x, at.y - place.y) > kSame ? std::string(what) + ", off the map" : what) {}
};

}  // namespace

void draw_end_marks(Canvas& canvas, const Rect& frame, Pixel start, Pixel goal, const std::vector<Pixel>& way) {
  const End from(start, frame, "start");
  const End to(goal, frame, "goal");
  std::vector<Pixel> points = densified(way);
  append_marker(points, from.at);
  append_marker(points, to.at);
  const bool same = std::hypot(to.at.x - from.at.x, to.at.y - from.at.y) <= kSame;
  draw_dot(canvas, to.at, same ? kEndRadius + 3.5 : kEndRadius, kGoalColour);
  draw_dot(canvas, from.at, kEndRadius, kStartColour);
  if (same) return draw_name(canvas, frame, points, from.at, from.name + ", " + to.name);
  draw_name(canvas, frame, points, from.at, from.name);
  draw_name(canvas, frame, points, to.at, to.name);
}

void draw_via_marks(Canvas& canvas, const Rect& frame, const std::vector<Pixel>& vias) {
  for (std::size_t v = 0; v < vias.size(); ++v) {
    if (!frame.holds(vias[v])) continue;
    canvas.circle(vias[v], kViaRadius, "class=\"via\"");
    canvas.text({vias[v].x, vias[v].y + kViaBaseline}, std::to_string(v + 1), "class=\"via-number\"");
  }
}

}  // namespace tern_host
