// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/picture/flight_picture.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "host/number.hpp"
#include "host/picture/axes.hpp"
#include "host/picture/colours.hpp"
#include "host/picture/ends.hpp"
#include "host/picture/layout.hpp"
#include "host/picture/legend.hpp"
#include "host/picture/lettering.hpp"

namespace tern_host {
namespace {

constexpr double kMostHeight = 640.0;  // of the top view
constexpr double kAxisRoom = 64.0;     // left of and below a view
constexpr double kDrawnStep = 3.0;     // pixels between the points drawn
constexpr double kFull = 0.85;         // opacity of what fills a view's depth, and of what fills none of it
constexpr double kFaintMap = 0.35;
constexpr const char* kCommit = "class=\"waypoint\"";
constexpr const char* kBlocked = "fill=\"none\" stroke=\"#c22b1a\" stroke-width=\"2.5\"";
constexpr double kBlockedRadius = 6.0;
constexpr const char* kThing = "class=\"thing\"";
constexpr const char* kTouched = "fill=\"none\" stroke=\"#7a1fa2\" stroke-width=\"2.5\"";

std::string block_style(double depth_part) {
  return "class=\"block\" opacity=\"" + fixed(kFaintMap + (kFull - kFaintMap) * std::clamp(depth_part, 0.0, 1.0), 2) +
         "\"";
}

Rect rect_between(const Pixel& a, const Pixel& b) {
  return {std::min(a.x, b.x), std::min(a.y, b.y), std::abs(a.x - b.x), std::abs(a.y - b.y)};
}

Rect rect_of(const Axes& axes, const Projection& view, const tern::Box& box) {
  return rect_between(project(axes, view, box.lower), project(axes, view, box.upper));
}

void draw_world(Canvas& canvas, const Axes& axes, const Projection& view, const FlightWorld& world) {
  const tern::Box& b = world.boundary;
  const double deep = component(b.upper, view.depth) - component(b.lower, view.depth);
  const double scale = axes.frame.width / axes.horizontal.extent();
  for (const tern::Box& box : world.blocks) {
    const double part = (component(box.upper, view.depth) - component(box.lower, view.depth)) / deep;
    canvas.rect(rect_of(axes, view, box), block_style(part));
  }
  for (const Cylinder& c : world.cylinders) {
    const tern::Box box{{c.x - c.radius, c.y - c.radius, c.bottom}, {c.x + c.radius, c.y + c.radius, c.top}};
    if (view.depth == 2) {
      canvas.circle(project(axes, view, {c.x, c.y, c.bottom}), c.radius * scale,
                    block_style((c.top - c.bottom) / deep));
    } else {
      canvas.rect(rect_of(axes, view, box), block_style(2.0 * c.radius / deep));
    }
  }
}

/// The way in runs of one colour; returns it for the names of start and goal to keep off.
std::vector<Pixel> draw_way(Canvas& canvas, const Axes& axes, const Projection& view, const FlightResult& result,
                            double fastest) {
  std::vector<Pixel> way;
  std::vector<Pixel> run;
  int colour = -1;
  const auto end_run = [&] {
    if (run.size() > 1) {
      canvas.polyline(
          run, "class=\"trajectory\" stroke=\"" + speed_colour(static_cast<double>(colour) / kColourSteps) + "\"");
    }
    run.erase(run.begin(), run.empty() ? run.end() : run.end() - 1);
  };
  for (const TrackPoint& point : result.track) {
    const Pixel at = project(axes, view, point.position);
    const bool last = &point == &result.track.back();
    if (!way.empty() && !last && std::hypot(at.x - way.back().x, at.y - way.back().y) < kDrawnStep) continue;
    const int step = static_cast<int>(kColourSteps * std::min(1.0, point.speed / fastest));
    way.push_back(at);
    run.push_back(at);
    if (step == colour) continue;
    end_run();
    colour = step;
  }
  end_run();
  return way;
}

void draw_commits(Canvas& canvas, const Axes& axes, const Projection& view, const FlightResult& result) {
  Pixel last{-1e9, -1e9};
  for (const TrackPoint& point : result.track) {
    const Pixel at = project(axes, view, point.position);
    if (!point.committed || std::hypot(at.x - last.x, at.y - last.y) < 2.0 * kDrawnStep) continue;
    canvas.circle(at, 2.2, kCommit);
    last = at;
  }
}

const char* axis_name(int axis) {
  constexpr const char* kNames[] = {"x (m)", "y (m)", "z (m)"};
  return kNames[axis];
}

/// Where things that move went, where they were at the end, and where the body touched one.
void draw_moving_things(Canvas& canvas, const Axes& axes, const Projection& view, const FlightWorld& world,
                        const ThingTotals& things) {
  for (const std::vector<tern::Vec3>& places : things.places) {
    std::vector<Pixel> way;
    for (const tern::Vec3& at : places) way.push_back(project(axes, view, at));
    if (way.size() > 1) canvas.polyline(way, "class=\"thing-way\"");
  }
  for (std::size_t k = 0; k < things.places.size(); ++k) {
    if (things.places[k].empty()) continue;
    const Thing& thing = world.things[k];
    const tern::Vec3 at = things.places[k].back();
    const double radius = thing.radius;
    const bool is_ball = thing.shape == tern::TrackShape::kBall;
    const bool is_box = thing.shape == tern::TrackShape::kBox;
    const tern::Vec3 half = is_box ? thing.half : tern::Vec3{radius, radius, is_ball ? radius : thing.half.z};
    const tern::Box box{{at.x - half.x, at.y - half.y, at.z - half.z}, {at.x + half.x, at.y + half.y, at.z + half.z}};
    if (is_ball || (!is_box && view.depth == 2)) {
      canvas.circle(project(axes, view, at), radius * axes.frame.width / axes.horizontal.extent(), kThing);
    } else {
      canvas.rect(rect_of(axes, view, box), kThing);
    }
  }
}

void draw_touches(Canvas& canvas, const Axes& axes, const Projection& view, const FlightWorld& world,
                  const FlightResult& result) {
  for (const ThingContact& contact : result.things.contacts) {
    const auto tick = static_cast<std::size_t>(contact.time * world.settings.tick_hz);
    if (tick >= result.track.size()) continue;
    canvas.circle(project(axes, view, result.track[tick].position), kBlockedRadius, kTouched);
  }
}

void draw_view(Canvas& canvas, const Axes& axes, const Projection& view, const FlightWorld& world,
               const FlightResult& result, double fastest) {
  canvas.rect(axes.frame, "class=\"paper\"");
  canvas.begin_clipped(axes.frame);
  draw_grid(canvas, axes);
  draw_world(canvas, axes, view, world);
  draw_fences(canvas, axes, view, world.fences, world.boundary);
  draw_moving_things(canvas, axes, view, world, result.things);
  canvas.end_group();
  draw_frame(canvas, axes, axis_name(view.horizontal), axis_name(view.vertical));
  const std::vector<Pixel> way = draw_way(canvas, axes, view, result, fastest);
  draw_commits(canvas, axes, view, result);
  draw_touches(canvas, axes, view, world, result);
  if (result.is_blocked()) canvas.circle(project(axes, view, result.blocked_at), kBlockedRadius, kBlocked);
  std::vector<Pixel> vias;
  for (const tern::Via& via : world.vias) vias.push_back(project(axes, view, via.position));
  draw_via_marks(canvas, axes.frame, vias);
  draw_end_marks(canvas, axes.frame, project(axes, view, world.start), project(axes, view, world.goal), way);
}

AxisRange range_of(const tern::Box& b, int axis) {
  return {component(b.lower, axis), component(b.upper, axis)};
}

/// Name, how it ended, and its figures. Returns where they end.
double draw_head(Canvas& canvas, const FlightWorld& world, const FlightResult& r, double fastest) {
  const std::string name = world.name.substr(world.name.find_last_of('/') + 1);
  canvas.text({kPageMargin, 46.0}, fit_text(name + ": " + r.status, kTitle, kContentWidth), "class=\"title\"");
  const std::string figures = fixed(r.time, 2) + " s, " + fixed(r.length, 2) + " m, " +
                              fixed(r.time > 0.0 ? r.length / r.time : 0.0, 2) + " m/s on average; clearance " +
                              fixed(r.min_clearance, 3) + " m at least; tracking error " + fixed(r.tracking_max, 3) +
                              " m at most; " + std::to_string(r.committed) + " of " + std::to_string(r.asked) +
                              " plans committed; " + r.reason;
  double y = 72.0;
  for (const std::string& line : wrap_text(figures, kSubtitle, kContentWidth)) {
    canvas.text({kPageMargin, y}, line, "class=\"subtitle\"");
    y += 20.0;
  }
  std::vector<LegendEntry> legend{area_entry("obstacle of the true world", "class=\"block\" opacity=\"0.85\""),
                                  speed_entry("way flown, speed from 0 to " + fixed(fastest, 1) + " m/s"),
                                  dot_entry("where a plan was committed", 2.6, kCommit)};
  if (r.is_blocked()) legend.push_back(dot_entry("in the way at the end", kBlockedRadius, kBlocked));
  if (!world.things.empty()) legend.push_back(area_entry("what moves, at the end, and its way", kThing, 5.0));
  if (!r.things.contacts.empty()) legend.push_back(dot_entry("where the body touched it", kBlockedRadius, kTouched));
  if (has_keepout(world.fences, false)) legend.push_back(keepout_entry());
  if (has_keepout(world.fences, true)) legend.push_back(keepout_for_a_while_entry());
  if (has_fence(world.fences, tern::FenceKind::kKeepIn)) legend.push_back(keepin_entry());
  draw_legend(canvas, legend, {kPageMargin, y}, kContentWidth);
  return y + 30.0 + kLegendRow * legend_rows(legend, kContentWidth);
}

}  // namespace

std::string flight_svg(const FlightWorld& world, const FlightResult& result) {
  const tern::Box& b = world.boundary;
  const bool turned = b.upper.y - b.lower.y > b.upper.x - b.lower.x;
  const Projection top{turned ? 1 : 0, turned ? 0 : 1, 2, turned};
  const Projection side{top.horizontal, 2, top.vertical, false};
  double fastest = 0.1;
  for (const TrackPoint& point : result.track) fastest = std::max(fastest, point.speed);
  Canvas page;
  const double y = draw_head(page, world, result, fastest);
  const AxisRange across = range_of(b, top.horizontal);
  const AxisRange up = range_of(b, top.vertical);
  const double scale = std::min((kContentWidth - kAxisRoom) / across.extent(), kMostHeight / up.extent());
  const Rect top_frame{kPageMargin + kAxisRoom, y, scale * across.extent(), scale * up.extent()};
  const Rect side_frame{top_frame.x, top_frame.bottom() + kAxisRoom + 26.0, top_frame.width,
                        scale * range_of(b, 2).extent()};
  page.text({top_frame.x, top_frame.y - 8.0}, "Top view", "class=\"heading\"");
  draw_view(page, {top_frame, across, up, top.down}, top, world, result, fastest);
  page.text({side_frame.x, side_frame.y - 8.0}, "Side view", "class=\"heading\"");
  draw_view(page, {side_frame, across, range_of(b, 2), false}, side, world, result, fastest);
  const double height = side_frame.bottom() + kAxisRoom;
  Canvas canvas;
  canvas.rect({0.0, 0.0, kPageWidth, height}, "fill=\"#ffffff\"");
  canvas.raw(page.body());
  return canvas.document(kPageWidth, height, style_sheet());
}

}  // namespace tern_host
