// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A plan as somebody sees it who has never seen one: the map from above and the side, the flight through it.
#include <algorithm>
#include <cmath>

#include "host/figures.hpp"
#include "host/number.hpp"
#include "host/picture/colours.hpp"
#include "host/picture/ends.hpp"
#include "host/picture/header.hpp"
#include "host/picture/layout.hpp"
#include "host/picture/legend.hpp"
#include "host/picture/lettering.hpp"
#include "host/picture/moving_view.hpp"
#include "host/picture/oblique_scene.hpp"
#include "host/picture/picture.hpp"
#include "host/plan_file.hpp"

namespace tern_host {
namespace {

using tern::Vec3;

constexpr int kMapSamples = 900;
constexpr double kHeadline = 40.0;  // the first line's baseline
constexpr double kLineHeight = 20.0;
constexpr double kMaxMapView = 640.0;        // height of the map
constexpr double kLastInstant = 1.0 - 1e-9;  // at the end itself the robot holds, whatever its velocity was
constexpr int kMaxRobots = 120;

struct Point {
  Vec3 world;
  int colour;   ///< 0 .. kColourSteps
  bool hidden;  ///< an obstacle stands before it
};

Point point_at(const PlanResult& result, const ObliqueScene& scene, double t, double scale) {
  const tern::Sample sample = tern::evaluate(result.trajectory, t);
  const Vec3& v = sample.velocity;
  const double speed = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
  return {sample.position, static_cast<int>(std::lround(speed / scale * kColourSteps)), scene.hidden(sample.position)};
}

std::vector<Point> sample(const PlanResult& result, const ObliqueScene& scene, double scale) {
  std::vector<Point> points;
  const double end = kLastInstant * tern::duration(result.trajectory);
  for (int i = 0; i <= kMapSamples; ++i) points.push_back(point_at(result, scene, end * i / kMapSamples, scale));
  return points;
}

std::string stroke(const Point& point) {
  return "stroke=\"" + speed_colour(static_cast<double>(point.colour) / kColourSteps) + "\"";
}

/// Calls draw(first, last) for each longest run of points from one to the next of which `alike` holds.
template <typename Alike, typename Draw>
void for_each_run(const std::vector<Point>& points, Alike alike, Draw draw) {
  std::size_t first = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (i + 1 < points.size() && alike(points[i], points[i + 1])) continue;
    draw(first, i);
    first = i;
  }
}

std::vector<Pixel> pixels(const std::vector<Point>& points, std::size_t first, std::size_t last,
                          const ObliqueCamera& camera) {
  std::vector<Pixel> found;
  for (std::size_t i = first; i <= last; ++i) found.push_back(camera.project(points[i].world));
  return found;
}

/// Where it would fall on the ground under a light from above.
void draw_shadow(Canvas& canvas, std::vector<Point> points, const ObliqueScene& scene, const ObliqueCamera& camera,
                 double ground) {
  for (Point& point : points) {
    point.world.z = ground;
    point.hidden = scene.hidden(point.world);
  }
  const auto alike = [](const Point& a, const Point& b) { return a.hidden == b.hidden; };
  for_each_run(points, alike, [&](std::size_t first, std::size_t last) {
    if (!points[last].hidden) canvas.polyline(pixels(points, first, last, camera), "class=\"shadow\"");
  });
}

void draw_flight(Canvas& canvas, const std::vector<Point>& points, const ObliqueCamera& camera) {
  const auto both = [](const Point& a, const Point& b) { return a.hidden == b.hidden; };
  for_each_run(points, both, [&](std::size_t first, std::size_t last) {
    if (!points[last].hidden) canvas.polyline(pixels(points, first, last, camera), "class=\"flight-halo\"");
  });
  const auto alike = [](const Point& a, const Point& b) { return a.hidden == b.hidden && a.colour == b.colour; };
  for_each_run(points, alike, [&](std::size_t first, std::size_t last) {
    const char* const style = points[last].hidden ? "class=\"behind\" " : "class=\"flight\" ";
    canvas.polyline(pixels(points, first, last, camera), style + stroke(points[last]));
  });
}

/// The robot once a second, as large as its radius.
void draw_robots(Canvas& canvas, const PlanResult& result, const ObliqueScene& scene, const ObliqueCamera& camera,
                 double scale) {
  const double end = tern::duration(result.trajectory);
  for (int i = 1; i < kMaxRobots && i < end; ++i) {
    const Point point = point_at(result, scene, i, scale);
    const std::string style = point.hidden ? "class=\"robot\" opacity=\"0.35\"" : "class=\"robot\"";
    canvas.circle(camera.project(point.world), std::max(2.0, result.scenario.radius * camera.scale()), style);
  }
}

std::string headline(const PlanResult& result, const Figures& figures) {
  if (!result.ok()) {
    return std::string("No plan: ") + tern::status_name(result.report.status) + ": " + describe_status(result);
  }
  const std::string flight = fixed(figures.length, 1) + " m in " + fixed(figures.duration, 1) + " s";
  const std::vector<Block>& blocks = result.scenario.blocks;
  if (blocks.empty()) return "A flight of " + flight;
  const bool keepouts = std::any_of(blocks.begin(), blocks.end(), [](const Block& block) { return block.keepout; });
  const std::string one = keepouts ? " obstacle or keep-out" : " obstacle";
  const std::string many = keepouts ? " obstacles and keep-outs" : " obstacles";
  return "A flight of " + flight + " past " + std::to_string(blocks.size()) + (blocks.size() == 1 ? one : many) +
         ", at least " + fixed(figures.clearance, 2) + " m from " + (blocks.size() == 1 ? "it" : "each") +
         "; the robot's radius is " + fixed(result.scenario.radius, 2) + " m";
}

std::vector<LegendEntry> legend_entries(const PlanResult& result, const Figures& figures, double robot_radius,
                                        const std::vector<Point>& points) {
  std::vector<LegendEntry> entries = world_entries(result.scenario, WorldLegend::kOblique);
  if (!result.ok()) return entries;
  entries.push_back(speed_entry("trajectory, speed from 0 to " + fixed(speed_scale(figures), 1) + " m/s"));
  if (std::any_of(points.begin(), points.end(), [](const Point& point) { return point.hidden; })) {
    entries.push_back(line_entry("behind an obstacle", "class=\"behind\" stroke=\"#a01e96\""));
  }
  entries.push_back(line_entry("its shadow on the ground", "class=\"shadow\""));
  if (tern::duration(result.trajectory) <= 1.0) return entries;  // before the first circle
  entries.push_back(dot_entry("the robot, once a second", std::min(9.0, robot_radius), "class=\"robot\""));
  return entries;
}

/// Returns where the map begins.
double draw_headline(Canvas& canvas, const std::string& text) {
  double y = kHeadline;
  for (const std::string& line : wrap_text(text, kHeading, kContentWidth)) {
    canvas.text({kPageMargin, y}, line, "class=\"heading\"");
    y += kLineHeight;
  }
  return y - 6.0;
}

void draw_plan(Canvas& canvas, const PlanResult& result, const ObliqueScene& scene, const ObliqueCamera& camera,
               const std::vector<Point>& points, double scale, const Rect& frame) {
  scene.draw_ground(canvas);
  scene.draw_blocks(canvas);
  scene.draw_fences(canvas, tern::FenceKind::kKeepOut);
  scene.draw_fences(canvas, tern::FenceKind::kKeepIn);
  canvas.begin_clipped(frame);
  draw_things(canvas, result, [&](const tern::Vec3& p) { return camera.project(p); });
  canvas.end_group();
  if (result.ok()) {
    draw_shadow(canvas, points, scene, camera, result.scenario.boundary.lower.z);
    draw_flight(canvas, points, camera);
    draw_robots(canvas, result, scene, camera, scale);
  }
  const std::vector<Pixel> way = points.empty() ? std::vector<Pixel>{} : pixels(points, 0, points.size() - 1, camera);
  std::vector<Pixel> vias;
  for (const tern::Via& via : result.scenario.vias) vias.push_back(camera.project(via.position));
  draw_via_marks(canvas, frame, vias);
  draw_end_marks(canvas, frame, camera.project(result.scenario.start.position),
                 camera.project(result.scenario.goal.position), way);
  draw_thing_names(
      canvas, result, [&](const tern::Vec3& p) { return camera.project(p); }, frame);
}

}  // namespace

std::string oblique_svg(const PlanResult& result) {
  const Figures figures = result.ok() ? measure(result.trajectory, result.scenario) : Figures{};
  Canvas page;
  const double top = draw_headline(page, headline(result, figures));
  ObliqueCamera camera(result.scenario.boundary);
  camera.fit({kPageMargin, top, kContentWidth, kMaxMapView});
  const ObliqueScene scene(result.scenario, camera);
  const double scale = speed_scale(figures);
  const std::vector<Point> points = result.ok() ? sample(result, scene, scale) : std::vector<Point>{};
  const std::vector<LegendEntry> entries =
      legend_entries(result, figures, result.scenario.radius * camera.scale(), points);
  draw_legend(page, entries, {kPageMargin, camera.bottom() + 12.0}, kContentWidth);
  draw_plan(page, result, scene, camera, points, scale, {kPageMargin, top, kContentWidth, camera.bottom() - top});
  const double height = camera.bottom() + 20.0 + kLegendRow * legend_rows(entries, kContentWidth);
  Canvas canvas;
  canvas.rect({0.5, 0.5, kPageWidth - 1.0, height - 1.0}, "class=\"card\"", 14.0);
  canvas.raw(page.body());
  return canvas.document(kPageWidth, height, style_sheet());
}

}  // namespace tern_host
