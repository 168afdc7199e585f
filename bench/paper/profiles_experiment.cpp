// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Figure 8, and what velocity, acceleration and jerk of each plan do against the limits.
#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>

#include "host/number.hpp"
#include "host/picture/colours.hpp"
#include "host/session.hpp"
#include "paper/experiments.hpp"
#include "paper/figure.hpp"
#include "times/trapezoid.hpp"

namespace tern_bench {
namespace {

using tern::Vec3;
using tern_host::fixed;

constexpr int kMaps = 6;
constexpr int kSamples = 700;
constexpr double kPanelHeight = 150.0;

/// The numbers of the paper's Figure 8.
constexpr double kDistance = 30.0;
constexpr double kSpeed = 10.0;
constexpr double kRamp = 1.0;

std::string curve_style(const char* colour) {
  return std::string("class=\"curve\" stroke=\"") + colour + "\"";
}

Curve level(double value, double from, double to) {
  return {{from, to}, {value, value}, "class=\"limit\" stroke=\"#8b2e2e\""};
}

AxisRange range_of(const std::vector<Curve>& curves) {
  double low = 0.0;
  double high = 0.0;
  for (const Curve& curve : curves) {
    low = std::min(low, *std::min_element(curve.y.begin(), curve.y.end()));
    high = std::max(high, *std::max_element(curve.y.begin(), curve.y.end()));
  }
  const double room = 0.08 * std::max(high - low, 1e-6);
  return {low - (low < 0.0 ? room : 0.0), high + room};
}

void draw_trapezoid(const Run& run, Table& table) {
  const double acceleration = kSpeed / kRamp;
  const double end = tern::trapezoid_time(kDistance, {kSpeed, acceleration});
  Curve way{{}, {}, curve_style("#2b6cb0")};
  Curve speed{{}, {}, curve_style("#2f8f5b")};
  Curve push{{}, {}, curve_style("#c8553d")};
  for (int i = 0; i <= kSamples; ++i) {
    const double t = end * i / kSamples;
    const double up = std::min(t, kRamp);
    const double down = std::max(t - (end - kRamp), 0.0);
    for (Curve* curve : {&way, &speed, &push}) curve->x.push_back(t);
    way.y.push_back(0.5 * acceleration * up * up + kSpeed * std::max(0.0, std::min(t, end) - kRamp) -
                    0.5 * acceleration * down * down);
    speed.y.push_back(acceleration * (up - down));
    push.y.push_back(t < kRamp ? acceleration : (down > 0.0 ? -acceleration : 0.0));
  }
  Figure figure("Figure 8: trapezoidal profile, 30 m in 4 s", "profiles");
  const double x = kFigureMargin + kPanelLeft;
  double y = figure.top() + kPanelAbove;
  const struct {
    Curve* curve;
    const char* heading;
    const char* unit;
  } panels[] = {{&way, "Position", "m"}, {&speed, "Velocity", "m/s"}, {&push, "Acceleration", "m/s²"}};
  for (const auto& panel : panels) {
    const Rect frame{x, y, kFigureWidth - x - kFigureMargin, kPanelHeight};
    draw_plot(figure.canvas(), {frame, {0.0, end}, range_of({*panel.curve})}, {*panel.curve}, panel.heading, "time (s)",
              panel.unit);
    y = frame.bottom() + kPanelBelow + kPanelAbove;
  }
  figure.write(run, "trapezoid.svg", y - kPanelAbove);
  table.row({"trapezoid", fixed(end, 6), fixed(way.y.back(), 6), fixed(kSpeed, 3), fixed(acceleration, 3), ""});
}

using Quantity = std::function<Vec3(const tern::Sample&)>;

std::vector<Curve> axes_over_time(const tern::Trajectory& trajectory, const Quantity& quantity) {
  std::vector<Curve> curves;
  for (const char* colour : tern_host::kAxisColours) curves.push_back({{}, {}, curve_style(colour)});
  const double end = tern::duration(trajectory);
  for (int i = 0; i <= kSamples; ++i) {
    const double t = end * i / kSamples;
    const Vec3 v = quantity(tern::evaluate(trajectory, t));
    for (int a = 0; a < 3; ++a) {
      curves[static_cast<std::size_t>(a)].x.push_back(t);
      curves[static_cast<std::size_t>(a)].y.push_back(tern_host::component(v, a));
    }
  }
  return curves;
}

double peak(const std::vector<Curve>& curves) {
  double most = 0.0;
  for (const Curve& curve : curves) {
    for (const double v : curve.y) most = std::max(most, std::fabs(v));
  }
  return most;
}

void draw_profiles(Figure& figure, const tern::Trajectory& trajectory, double width, double v_limit, double a_limit,
                   std::vector<double>& peaks) {
  const struct {
    const char* heading;
    const char* unit;
    Quantity quantity;
    double limit;
  } panels[] = {{"Position", "m", [](const tern::Sample& s) { return s.position; }, 0.0},
                {"Velocity", "m/s", [](const tern::Sample& s) { return s.velocity; }, v_limit},
                {"Acceleration", "m/s²", [](const tern::Sample& s) { return s.acceleration; }, a_limit},
                {"Jerk", "m/s³", [](const tern::Sample& s) { return s.jerk; }, 0.0}};
  double y = figure.top() + kPanelAbove;
  for (const auto& panel : panels) {
    std::vector<Curve> curves = axes_over_time(trajectory, panel.quantity);
    peaks.push_back(peak(curves));
    const double end = tern::duration(trajectory);
    if (panel.limit > 0.0) {
      curves.push_back(level(panel.limit, 0.0, end));
      curves.push_back(level(-panel.limit, 0.0, end));
    }
    const Rect frame{kFigureMargin + kPanelLeft, y, width, kPanelHeight};
    draw_plot(figure.canvas(), {frame, {0.0, end}, range_of(curves)}, curves, panel.heading, "time (s)", panel.unit);
    y = frame.bottom() + kPanelBelow + kPanelAbove;
  }
}

/// The two axes along which the vector reaches furthest.
std::pair<std::size_t, std::size_t> busiest_axes(const std::vector<Curve>& axes) {
  std::size_t least = 0;
  for (std::size_t a = 1; a < 3; ++a) {
    if (peak({axes[a]}) <= peak({axes[least]})) least = a;
  }
  return {least == 0 ? 1 : 0, least == 2 ? 1 : 2};
}

/// A hodograph: the curve that the tip of the vector draws in the plane of its busiest axes, inside the square of its
/// limits.
void draw_hodograph(Figure& figure, const tern::Trajectory& trajectory, const Rect& frame, const Quantity& quantity,
                    double limit, const std::string& heading, const std::string& unit) {
  const std::vector<Curve> axes = axes_over_time(trajectory, quantity);
  const auto [first, second] = busiest_axes(axes);
  const double reach = 1.12 * limit;
  const std::vector<Curve> curves = {{{-limit, limit, limit, -limit, -limit},
                                      {-limit, -limit, limit, limit, -limit},
                                      "class=\"limit\" stroke=\"#8b2e2e\""},
                                     {axes[first].y, axes[second].y, curve_style("#a01e96")}};
  draw_plot(figure.canvas(), {frame, {-reach, reach}, {-reach, reach}}, curves, heading,
            "xyz"[first] + (" (" + unit + ")"), "xyz"[second] + (" (" + unit + ")"));
}

void draw_map(const Run& run, int map, const tern_host::PlanResult& plan, Table& table) {
  const double v_limit = plan.scenario.limits.v_max.x;
  const double a_limit = plan.scenario.limits.a_max.x;
  Figure figure("Map " + std::to_string(map) + ": Tern's plan against its limits", "profiles");
  figure.legend({{"x", curve_style(tern_host::kAxisColours[0])},
                 {"y", curve_style(tern_host::kAxisColours[1])},
                 {"z", curve_style(tern_host::kAxisColours[2])},
                 {"limit of each axis", "class=\"limit\" stroke=\"#8b2e2e\""},
                 {"hodograph, its two busiest axes", curve_style("#a01e96")}});
  const double side = 290.0;
  const double right = kFigureWidth - kFigureMargin - side;
  std::vector<double> peaks;
  draw_profiles(figure, plan.trajectory, right - 2.0 * kPanelLeft - kFigureMargin, v_limit, a_limit, peaks);
  const double y = figure.top() + kPanelAbove;
  draw_hodograph(
      figure, plan.trajectory, {right, y, side, side}, [](const tern::Sample& s) { return s.velocity; }, v_limit,
      "Velocity hodograph", "m/s");
  draw_hodograph(
      figure, plan.trajectory, {right, y + side + kPanelBelow + kPanelAbove, side, side},
      [](const tern::Sample& s) { return s.acceleration; }, a_limit, "Acceleration hodograph", "m/s²");
  figure.write(run, "map" + std::to_string(map) + "_profiles.svg",
               figure.top() + 4.0 * (kPanelAbove + kPanelHeight + kPanelBelow));
  table.row({"map" + std::to_string(map), fixed(tern::duration(plan.trajectory), 4), "", fixed(peaks[1], 4),
             fixed(peaks[2], 4), fixed(peaks[3], 3)});
}

}  // namespace

void profiles_experiment(const Run& run) {
  Table table("profile,duration_s,distance_m,v_peak,a_peak,jerk_peak");
  draw_trapezoid(run, table);
  tern_host::Session session;
  for (int map = 1; map <= kMaps; ++map) {
    const tern_host::PlanResult plan = session.plan(paper_map(map));
    if (!plan.ok()) throw std::runtime_error(std::string("no plan: ") + tern::status_name(plan.report.status));
    draw_map(run, map, plan, table);
  }
  table.write(run, "profiles.csv");
}

}  // namespace tern_bench
