// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Table 7 and Figures 18 to 23: ordinary polynomials against Bezier curves, on the same waypoints with the same times.
#include <stdexcept>
#include <string>

#include "baselines/minimum_snap.hpp"
#include "host/figures.hpp"
#include "host/number.hpp"
#include "host/session.hpp"
#include "leg_times.hpp"
#include "paper/bezier_programme.hpp"
#include "paper/experiments.hpp"
#include "paper/figure.hpp"
#include "paper/statistics.hpp"

namespace tern_bench {
namespace {

using tern::Vec3;
using tern_host::fixed;

constexpr int kMaps = 6;
constexpr int kRounds = 20;
constexpr int kCurveSamples = 600;
constexpr const char* kSegmentColours[] = {"#a01e96", "#2b6cb0", "#c8553d", "#0f8a7a", "#b7791f", "#5a3fc0"};

struct Waypoints {
  std::vector<Vec3> points;
  std::vector<double> durations;  ///< by the trapezoid rule (Section 3.3.2)
};

/// The ends of the corridor's segments: the front end's waypoints, long legs cut.
Waypoints waypoints_of(const tern_host::PlanResult& plan) {
  Waypoints way;
  const Vec3& o = plan.grid.origin;
  const tern::Corridor& corridor = *plan.corridor;
  const auto world = [&o](const Vec3& p) { return Vec3{p.x + o.x, p.y + o.y, p.z + o.z}; };
  way.points.push_back(world(corridor.polyhedra[0].from));
  for (int i = 0; i < corridor.count; ++i) way.points.push_back(world(corridor.polyhedra[i].to));
  way.durations = leg_times(corridor, plan.scenario.limits);
  return way;
}

struct Method {
  std::string name;
  tern::Trajectory trajectory{};
  double time = 0.0;  ///< milliseconds
  int solves = 1;
  int inserted = 0;
  bool clear = true;
};

void write_row(Table& table, int map, const tern_host::Scenario& scenario, const Method& method) {
  const tern_host::Figures raw = tern_host::measure(method.trajectory, scenario);
  const tern_host::Figures slow = tern_host::measure(stretched_to_limits(method.trajectory, scenario), scenario);
  table.row({std::to_string(map), method.name, std::to_string(method.trajectory.count), fixed(method.time, 4),
             std::to_string(method.solves), std::to_string(method.inserted), method.clear ? "1" : "0",
             fixed(raw.duration, 3), fixed(raw.snap, 3), fixed(raw.length, 3),
             fixed(std::max({raw.v_peak.x, raw.v_peak.y, raw.v_peak.z}), 3),
             fixed(std::max({raw.a_peak.x, raw.a_peak.y, raw.a_peak.z}), 3), fixed(raw.clearance, 4),
             fixed(slow.duration, 3), fixed(slow.snap, 3)});
}

Method polynomial(const Waypoints& way, int repetitions) {
  Method method{"polynomial"};
  method.time = least_time(repetitions, [&] { method.trajectory = minimum_snap(way.points, way.durations); });
  return method;
}

Method mended_polynomial(const Waypoints& way, const tern_host::Scenario& scenario, int repetitions) {
  Method method{"polynomial mended"};
  MendedPolynomial mended;
  method.time =
      least_time(repetitions, [&] { mended = mend_collisions(way.points, way.durations, scenario, kRounds); });
  method.trajectory = mended.trajectory;
  method.solves = mended.solves;
  method.inserted = mended.inserted;
  method.clear = mended.clear;
  return method;
}

Method bezier(const Waypoints& way, const tern_host::PlanResult& plan, int repetitions) {
  Method method{"Bezier"};
  BezierProgramme programme;
  tern::Status status = tern::Status::kOk;
  method.time = least_time(repetitions, [&] {
    status = programme.solve(*plan.corridor, way.durations, plan.scenario, plan.grid.origin, method.trajectory);
  });
  if (status != tern::Status::kOk) throw std::runtime_error(tern::status_name(status));
  return method;
}

std::vector<Vec3> curve_of(const tern::Trajectory& trajectory) {
  std::vector<Vec3> points;
  const double end = tern::duration(trajectory);
  for (int i = 0; i <= kCurveSamples; ++i) {
    points.push_back(tern::evaluate(trajectory, end * i / kCurveSamples).position);
  }
  return points;
}

/// Dots on the control points, a colour a segment.
void draw_control_points(Canvas& canvas, const MapViews& views, const tern::Trajectory& trajectory) {
  const Vec3& o = trajectory.origin;
  for (int s = 0; s < trajectory.count; ++s) {
    const std::string style = std::string("fill=\"") + kSegmentColours[s % 6] + "\"";
    for (const Vec3& p : trajectory.segments[s].points) {
      const Vec3 world{p.x + o.x, p.y + o.y, p.z + o.z};
      canvas.circle(tern_host::project(views.top_axes, views.top, world), 2.6, style);
      canvas.circle(tern_host::project(views.side_axes, views.side, world), 2.6, style);
    }
  }
}

void draw_figure(const Run& run, int map, const tern_host::PlanResult& plan, const Method& poly, const Method& curve) {
  Figure figure("Figure " + std::to_string(map + 17) + ": polynomial and Bézier on Map " + std::to_string(map),
                "back_end");
  const std::string green = "stroke=\"#2f8f5b\" stroke-width=\"2.4\"";
  const std::string purple = "stroke=\"#a01e96\" stroke-width=\"2.4\"";
  const std::string black = "stroke=\"#1f2733\" stroke-width=\"1.8\" stroke-dasharray=\"7 3\"";
  figure.legend({{"minimum-snap polynomial", green},
                 {"Bézier, same times", purple},
                 {"Tern's plan", black},
                 {"control points of the Bézier, a colour a segment", "fill=\"#a01e96\"", true},
                 {"waypoints", "class=\"waypoint\"", true}});
  Canvas& canvas = figure.canvas();
  const MapViews views = lay_out_views(plan.scenario, figure.top());
  draw_map(canvas, views, plan.scenario);
  tern_host::draw_corridor(canvas, views.top_axes, views.top, plan);
  tern_host::draw_corridor(canvas, views.side_axes, views.side, plan);
  draw_route(canvas, views, curve_of(poly.trajectory), green);
  draw_route(canvas, views, curve_of(plan.trajectory), black);
  draw_route(canvas, views, curve_of(curve.trajectory), purple);
  draw_control_points(canvas, views, curve.trajectory);
  const std::vector<Vec3> way = waypoints_of(plan).points;
  draw_route(canvas, views, way, "stroke=\"none\"", "class=\"waypoint\"");
  finish_map(canvas, views, plan.scenario, way);
  figure.write(run, "map" + std::to_string(map) + "_trajectories.svg", views.bottom);
}

}  // namespace

void back_end_experiment(const Run& run) {
  Table table(
      "map,method,segments,time_ms,solves,inserted,clear,duration_s,snap,length_m,v_peak,a_peak,clearance_m,"
      "slow_duration_s,slow_snap");
  tern_host::Session session;
  const int repetitions = pick(run, 9, 1);
  for (int map = 1; map <= kMaps; ++map) {
    progress("map " + std::to_string(map));
    const tern_host::Scenario scenario = paper_map(map);
    tern_host::PlanResult plan = session.plan(scenario);
    if (!plan.ok()) throw std::runtime_error(std::string("no plan: ") + tern::status_name(plan.report.status));
    Method tern{"Tern", plan.trajectory, 1e-3 * plan.timing.of(tern::Stage::kTrajectory)};
    tern.solves = plan.report.diagnostics.high_water.qp_solves;
    for (int k = 1; k < repetitions; ++k) {
      const tern_host::PlanResult again = session.plan(scenario);
      tern.time = std::min(tern.time, 1e-3 * again.timing.of(tern::Stage::kTrajectory));
    }
    const Waypoints way = waypoints_of(plan);
    const Method poly = polynomial(way, repetitions);
    const Method curve = bezier(way, plan, repetitions);
    write_row(table, map, scenario, poly);
    write_row(table, map, scenario, mended_polynomial(way, scenario, repetitions));
    write_row(table, map, scenario, curve);
    write_row(table, map, scenario, tern);
    draw_figure(run, map, plan, poly, curve);
  }
  table.write(run, "back_end.csv");
}

}  // namespace tern_bench
