// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Table 6, Figures 15 to 17, and the limits that the paper's Section 4.5 states.
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "baselines/paper_corridor.hpp"
#include "baselines/paper_search.hpp"
#include "host/figures.hpp"
#include "host/number.hpp"
#include "host/session.hpp"
#include "paper/corridor_widths.hpp"
#include "paper/experiments.hpp"
#include "paper/figure.hpp"
#include "paper/random_map.hpp"
#include "paper/statistics.hpp"

namespace tern_bench {
namespace {

using tern::Vec3;
using tern_host::fixed;

constexpr int kMaps = 6;
/// Reach of the bounding box around a segment: what Tern's own local box has.
constexpr double kBoxMargin = 2.0;
constexpr double kNoBox = std::numeric_limits<double>::infinity();

struct PaperTotals {
  double time = 0.0;
  std::uint64_t checks = 0;
  std::size_t planes = 0;
  int shrinks = 0;
  int most_shrinks = 0;
};

/// All segments of the paper's own path.
PaperTotals grow_all(const std::vector<Vec3>& way, const std::vector<Vec3>& points, double margin, int repetitions) {
  PaperTotals totals;
  totals.time = least_time(repetitions, [&] {
    totals = PaperTotals{};
    for (std::size_t i = 1; i < way.size(); ++i) {
      const PaperPolyhedron polyhedron = grow_paper_polyhedron(way[i - 1], way[i], points, margin);
      totals.checks += polyhedron.checks;
      totals.planes += polyhedron.planes.size();
      totals.shrinks += polyhedron.shrinks;
      totals.most_shrinks = std::max(totals.most_shrinks, polyhedron.shrinks);
    }
  });
  return totals;
}

void write_paper_rows(Table& table, int map, const tern_host::Scenario& scenario, int repetitions) {
  const PaperMap grid(scenario, kPaperCell, kPaperMargin);
  const Route raw = greedy_jump_search(grid, scenario.start.position, scenario.goal.position);
  const std::vector<Vec3> points = surface_points(grid);
  const std::vector<Vec3> path = shorten_by_sight(grid, raw.points);
  for (const double margin : {kNoBox, kBoxMargin}) {
    const PaperTotals t = grow_all(path, points, margin, repetitions);
    table.row({std::to_string(map), std::isinf(margin) ? "paper without box" : "paper with box",
               std::to_string(path.size() - 1), fixed(t.time, 4), std::to_string(t.checks), std::to_string(t.planes),
               std::to_string(t.shrinks), std::to_string(t.most_shrinks), std::to_string(points.size()), "", "", "",
               ""});
  }
}

void write_tern_row(Table& table, int map, const tern_host::PlanResult& plan, double time) {
  const CorridorWidths widths = measure_widths(plan);
  int planes = 0;
  for (int i = 0; i < plan.corridor->count; ++i) planes += plan.corridor->polyhedra[i].count;
  table.row({std::to_string(map), "Tern", std::to_string(plan.corridor->count), fixed(time, 4), "",
             std::to_string(planes), "", "", std::to_string(plan.report.diagnostics.high_water.local_boxes),
             fixed(widths.used, 3), fixed(widths.extreme, 3), fixed(widths.passage, 3), fixed(widths.over, 4)});
}

/// The points axes * q + center with |q| <= 1. `axes` is symmetric and positive definite.
struct Ellipsoid {
  double axes[3][3];
  Vec3 center;
};

double dot(const Vec3& a, const Vec3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// The ellipsoid inside the polyhedron that is round about the polyhedron's line and as long as it.
Ellipsoid inscribed(const tern::Polyhedron& polyhedron) {
  const Vec3& from = polyhedron.from;
  const Vec3& to = polyhedron.to;
  const Vec3 along{0.5 * (to.x - from.x), 0.5 * (to.y - from.y), 0.5 * (to.z - from.z)};
  const double half = std::max(std::sqrt(dot(along, along)), 1e-9);
  const double u[3] = {along.x / half, along.y / half, along.z / half};
  Ellipsoid result{{}, {from.x + along.x, from.y + along.y, from.z + along.z}};
  double thickness = half;
  for (int p = 0; p < polyhedron.count; ++p) {
    const tern::Halfspace& plane = polyhedron.planes[p];
    const double room = std::max(plane.offset - dot(plane.normal, result.center), 0.0);
    const double reach = dot(plane.normal, along);
    const double across = 1.0 - reach * reach / (half * half);
    const double left = std::max(room * room - reach * reach, 0.0);
    if (left < thickness * thickness * across) thickness = std::sqrt(left / across);
  }
  thickness = std::max(thickness, 1e-9 * half);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      result.axes[i][j] = (half - thickness) * u[i] * u[j] + (i == j ? thickness : 0.0);
    }
  }
  return result;
}

/// The outline of an ellipsoid seen along one axis: the support points of directions in the view's plane.
std::vector<Pixel> ellipse(const Ellipsoid& e, const Vec3& origin, const Axes& axes, const Projection& p) {
  std::vector<Pixel> outline;
  for (int k = 0; k <= 72; ++k) {
    const double angle = 2.0 * 3.14159265358979324 * k / 72;
    double d[3] = {0.0, 0.0, 0.0};
    d[p.horizontal] = std::cos(angle);
    d[p.vertical] = std::sin(angle);
    double q[3];
    for (int i = 0; i < 3; ++i) q[i] = e.axes[0][i] * d[0] + e.axes[1][i] * d[1] + e.axes[2][i] * d[2];
    const double norm = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2]);
    double s[3];
    for (int i = 0; i < 3; ++i) s[i] = (e.axes[i][0] * q[0] + e.axes[i][1] * q[1] + e.axes[i][2] * q[2]) / norm;
    const Vec3& c = e.center;
    outline.push_back(
        tern_host::project(axes, p, {origin.x + c.x + s[0], origin.y + c.y + s[1], origin.z + c.z + s[2]}));
  }
  return outline;
}

void draw_view(Canvas& canvas, const Axes& axes, const Projection& projection, const tern_host::PlanResult& plan) {
  const Vec3& o = plan.grid.origin;
  canvas.begin_clipped(axes.frame);
  tern_host::draw_corridor(canvas, axes, projection, plan);
  for (int i = 0; i < plan.corridor->count; ++i) {
    canvas.polygon(ellipse(inscribed(plan.corridor->polyhedra[i]), o, axes, projection),
                   "fill=\"#b7791f\" fill-opacity=\"0.22\" stroke=\"#b7791f\" stroke-width=\"1.4\"");
  }
  canvas.end_group();
}

void draw_figure(const Run& run, int map, const tern_host::PlanResult& plan) {
  Figure figure(
      "Figure " + std::to_string(15 + (map - 1) / 2) + ": ellipsoids and corridor on Map " + std::to_string(map),
      "corridors");
  figure.legend({{"ellipsoid", "stroke=\"#b7791f\" stroke-width=\"6\" stroke-opacity=\"0.5\""},
                 {"polyhedron", "class=\"corridor\" stroke-width=\"6\""},
                 {"path", "class=\"shortcut\""}});
  const MapViews views = lay_out_views(plan.scenario, figure.top());
  draw_map(figure.canvas(), views, plan.scenario);
  draw_view(figure.canvas(), views.top_axes, views.top, plan);
  draw_view(figure.canvas(), views.side_axes, views.side, plan);
  std::vector<Vec3> way;
  const Vec3& o = plan.grid.origin;
  for (int i = 0; i < plan.path->count; ++i) {
    const Vec3& p = plan.path->points[i];
    way.push_back({p.x + o.x, p.y + o.y, p.z + o.z});
  }
  draw_route(figure.canvas(), views, way, "class=\"shortcut\"", "class=\"waypoint\"");
  finish_map(figure.canvas(), views, plan.scenario, way);
  figure.write(run, "map" + std::to_string(map) + "_corridor.svg", views.bottom);
}

void six_maps(const Run& run, tern_host::Session& session) {
  Table table("map,method,segments,time_ms,checks,planes,shrinks,most_shrinks,obstacles,used,extreme,passage_m,over_m");
  const int repetitions = pick(run, 9, 1);
  for (int map = 1; map <= kMaps; ++map) {
    progress("map " + std::to_string(map));
    const tern_host::Scenario scenario = paper_map(map);
    write_paper_rows(table, map, scenario, repetitions);
    double time = std::numeric_limits<double>::infinity();
    tern_host::PlanResult plan;
    for (int k = 0; k < repetitions; ++k) {
      plan = session.plan(scenario);
      if (!plan.ok()) throw std::runtime_error(std::string("no plan: ") + tern::status_name(plan.report.status));
      time = std::min(time, 1e-3 * plan.timing.of(tern::Stage::kCorridor));
    }
    write_tern_row(table, map, plan, time);
    draw_figure(run, map, plan);
  }
  table.write(run, "corridors.csv");
}

/// What became of a set of plans.
struct Tally {
  int ok = 0, no_path = 0, other = 0, stop_and_go = 0;
  std::vector<double> times;
  double clearance = std::numeric_limits<double>::infinity();
  std::string last;

  void add(const tern_host::PlanResult& plan) {
    last = tern::status_name(plan.report.status);
    times.push_back(1e-3 * plan.timing.total());
    if (plan.ok()) {
      ++ok;
      stop_and_go += plan.report.quality == tern::Quality::kStopAndGo ? 1 : 0;
      clearance =
          std::min(clearance, tern_host::measure(plan.trajectory, plan.scenario).clearance - plan.scenario.radius);
    } else {
      (plan.report.status == tern::Status::kNoPath ? no_path : other) += 1;
    }
  }
};

void write_tally(Table& table, const std::string& what, const std::string& setting, const Tally& t) {
  table.row({what, setting, std::to_string(t.times.size()), std::to_string(t.ok), std::to_string(t.stop_and_go),
             std::to_string(t.no_path), std::to_string(t.other), t.ok > 0 ? fixed(t.clearance, 4) : "",
             fixed(quantile(t.times, 0.5), 3), fixed(quantile(t.times, 1.0), 3), t.last});
}

void dense_maps(const Run& run, tern_host::Session& session, Table& table) {
  for (const double density : {0.30, 0.45, 0.50, 0.55, 0.60}) {
    const MapKind kind{"dense", {10.0, 10.0, 3.0}, density, 0.1, 0.1, 0.3};
    Tally tally;
    for (int seed = 1; seed <= pick(run, 50, 2); ++seed) {
      tally.add(session.plan(random_map(kind, static_cast<std::uint64_t>(seed))));
    }
    write_tally(table, "density", fixed(100.0 * density, 0) + " %", tally);
  }
}

/// A wall of half a metre across the map with a slit of that width, for a robot of 0.1 m.
void narrow_passages(tern_host::Session& session, Table& table) {
  for (const double width : {0.40, 0.30, 0.26, 0.24, 0.22, 0.21, 0.19}) {
    for (const double cell : {0.1, 0.05, 0.02}) {
      const std::string left = fixed(2.0 - 0.5 * width, 4);
      const std::string right = fixed(2.0 + 0.5 * width, 4);
      const tern_host::Scenario scenario = tern_host::parse_scenario(
          "boundary 0 0 0 4 4 2\nblock 1.75 0 0 2.25 " + left + " 2\nblock 1.75 " + right + " 0 2.25 4 2\n" +
              "start 0.6 1.2 1\ngoal 3.4 2.7 1.1\nradius 0.1\nresolution " + fixed(cell, 3) + "\n",
          "slit");
      Tally tally;
      tally.add(session.plan(scenario));
      write_tally(table, "passage", fixed(width, 2) + " m wide; voxels of " + fixed(cell, 2) + " m", tally);
    }
  }
}

/// From below a balcony to above it, through a U that opens towards the start, and over a beam and under the next.
void overhangs(tern_host::Session& session, Table& table) {
  const struct {
    const char* name;
    const char* records;
  } cases[] = {{"from under a balcony onto it",
                "block 3 0 0 3.4 4 1.6\nblock 0.8 0 1.6 3.4 4 1.9\nstart 2.6 2 0.5\ngoal 2.6 2 2.6\n"},
               {"out of a U",
                "block 3 1 0 3.3 3 3\nblock 1 1 0 3 1.3 3\nblock 1 2.7 0 3 3 3\nstart 2.6 2 1.5\ngoal 3.8 2 1.5\n"},
               {"over a beam and under the next",
                "block 1.2 0 0 1.6 4 2\nblock 2.4 0 1 2.8 4 3\nstart 0.5 2 0.5\ngoal 3.5 2 2.5\n"}};
  for (const auto& c : cases) {
    Tally tally;
    tally.add(session.plan(tern_host::parse_scenario(
        std::string("boundary 0 0 0 4 4 3\nresolution 0.1\nradius 0.2\n") + c.records, c.name)));
    write_tally(table, "overhang", c.name, tally);
  }
}

}  // namespace

void corridors_experiment(const Run& run) {
  tern_host::Session session;
  six_maps(run, session);
  Table table("what,setting,maps,ok,stop_and_go,no_path,other,spare_m,median_ms,max_ms,status");
  progress("dense maps, narrow passages, overhangs");
  dense_maps(run, session, table);
  narrow_passages(session, table);
  overhangs(session, table);
  table.write(run, "limits.csv");
}

}  // namespace tern_bench
