// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/picture/picture.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "host/figures.hpp"
#include "host/number.hpp"
#include "host/picture/colours.hpp"
#include "host/picture/layout.hpp"
#include "host/picture/profile_view.hpp"
#include "host/plan_file.hpp"

namespace tern_host {
namespace {

constexpr double kFiguresTop = 100.0;
constexpr double kLegendTop = 158.0;
constexpr double kViewsTop = 182.0;

std::string base_name(const std::string& path) {
  const std::string file = path.substr(path.find_last_of('/') + 1);
  return file.size() > 4 && file.compare(file.size() - 4, 4, ".txt") == 0 ? file.substr(0, file.size() - 4) : file;
}

std::string vector_text(const tern::Vec3& v) {
  const std::string x = fixed(v.x, 2);
  const std::string y = fixed(v.y, 2);
  const std::string z = fixed(v.z, 2);
  return x == y && y == z ? x : x + " / " + y + " / " + z;
}

/// "2.00", or what differs: "2.00 / 2.00 / 3.00, down to -2.00 / -2.00 / -1.00, horizontal 2.00".
std::string limit_text(const LimitRange& limit) {
  const std::string upper = vector_text(limit.upper);
  const std::string lower = vector_text({-limit.lower.x, -limit.lower.y, -limit.lower.z});
  return upper + (lower == upper ? "" : ", down to " + vector_text(limit.lower)) +
         (limit.horizontal > 0.0 ? ", horizontal " + fixed(limit.horizontal, 2) : "");
}

std::string settings_line(const Scenario& scenario) {
  return "resolution " + fixed(scenario.resolution, 3) + " m   \u00b7   robot radius " + fixed(scenario.radius, 2) +
         " m   \u00b7   limits per axis " + limit_text(velocity_range(scenario.limits)) + " m/s, " +
         limit_text(acceleration_range(scenario.limits)) + " m/s\u00b2";
}

using Figure = std::pair<std::string, std::string>;  // name, value

std::string clearance_text(double clearance, bool fenced) {
  if (std::isfinite(clearance)) return fixed(clearance, 3) + " m";
  return fenced ? "fences only" : "no blocks";
}

std::vector<Figure> key_figures(const PlanResult& result, const Figures& figures) {
  const double us = result.timing.total();
  return {{"duration", fixed(figures.duration, 2) + " s"},
          {"length", fixed(figures.length, 2) + " m"},
          {"segments", std::to_string(result.trajectory.count)},
          {"peak |v|", fixed(figures.speed, 2) + " m/s"},
          {"peak |a|", fixed(figures.acceleration, 2) + " m/s\u00b2"},
          {"least clearance", clearance_text(figures.clearance, !result.scenario.fences.empty())},
          {"snap cost", fixed(figures.snap, figures.snap < 100.0 ? 1 : 0)},
          {"computed in", us < 10000.0 ? fixed(us, 0) + " \u00b5s" : fixed(us / 1000.0, 1) + " ms"}};
}

void draw_key_figures(Canvas& canvas, const std::vector<Figure>& figures) {
  const double width = (kPageWidth - 2.0 * kPageMargin) / static_cast<double>(figures.size());
  double x = kPageMargin;
  for (const Figure& figure : figures) {
    canvas.text({x, kFiguresTop}, figure.first, "class=\"figure-name\"");
    canvas.text({x, kFiguresTop + 24.0}, figure.second, "class=\"figure\"");
    x += width;
  }
}

void draw_failure(Canvas& canvas, const PlanResult& result) {
  constexpr std::size_t kLineLength = 160;
  canvas.text({kPageMargin, kFiguresTop - 2.0}, std::string("No plan: ") + tern::status_name(result.report.status),
              "class=\"figure\" style=\"fill:#b03030\"");
  const std::string text = describe_status(result.report);
  const std::size_t split = text.size() > kLineLength ? text.rfind(' ', kLineLength) : text.size();
  canvas.text({kPageMargin, kFiguresTop + 16.0}, text.substr(0, split), "class=\"figure-name\"");
  if (split < text.size()) {
    canvas.text({kPageMargin, kFiguresTop + 32.0}, text.substr(split + 1), "class=\"figure-name\"");
  }
}

double legend_entry(Canvas& canvas, double x, const char* name, double name_width) {
  canvas.text({x + 36.0, kLegendTop + 4.5}, name, "class=\"number\"");
  return x + 36.0 + name_width;
}

void draw_legend(Canvas& canvas, const PlanResult& result) {
  const double y = kLegendTop;
  const auto swatch = [&](double x) { return Rect{x, y - 7.0, 28.0, 14.0}; };
  double x = kPageMargin;
  canvas.rect(swatch(x), "class=\"block\" opacity=\"0.8\"");
  x = legend_entry(canvas, x, "obstacle", 78.0);
  canvas.rect(swatch(x), "class=\"inflated\"", 7.0);
  x = legend_entry(canvas, x, "inflated by the radius", 162.0);
  if (result.corridor != nullptr) {
    canvas.rect(swatch(x), "class=\"corridor\"");
    x = legend_entry(canvas, x, "corridor polyhedra", 142.0);
  }
  if (result.path == nullptr) return;
  canvas.line({x, y}, {x + 28.0, y}, "class=\"raw\"");
  x = legend_entry(canvas, x, "jump-point path", 124.0);
  canvas.line({x, y}, {x + 28.0, y}, "class=\"shortcut\"");
  canvas.circle({x + 14.0, y}, 3.6, "class=\"waypoint\"");
  legend_entry(canvas, x, "shortcut, waypoints", 0.0);
}

void draw_colour_bar(Canvas& canvas, double speed_scale) {
  constexpr int kStops = 12;
  std::string stops;
  for (int i = 0; i <= kStops; ++i) {
    const double t = static_cast<double>(i) / kStops;
    stops += "<stop offset=\"" + fixed(t, 3) + "\" stop-color=\"" + speed_colour(t) + "\"/>";
  }
  canvas.raw("<defs><linearGradient id=\"speed\">" + stops + "</linearGradient></defs>\n");
  const double right = kPageWidth - kPageMargin;
  const std::string high = fixed(speed_scale, 2) + " m/s";
  canvas.text({right, kLegendTop + 4.5}, high, "class=\"number\" text-anchor=\"end\"");
  const Rect bar{right - 62.0 - 130.0, kLegendTop - 6.0, 130.0, 12.0};
  canvas.rect(bar, "fill=\"url(#speed)\"", 3.0);
  canvas.text({bar.x - 6.0, kLegendTop + 4.5}, "trajectory, speed  0", "class=\"number\" text-anchor=\"end\"");
}

void draw_panel(Canvas& canvas, const PlanResult& result, const Projection& projection, const Rect& frame,
                const std::string& title, double speed_scale) {
  const Axes axes{frame, view_range(result, projection.horizontal), view_range(result, projection.vertical),
                  projection.down};
  canvas.text({frame.x, frame.y - 12.0}, title, "class=\"heading\"");
  draw_map_view(canvas, axes, projection, result, speed_scale);
}

void draw_header(Canvas& canvas, const PlanResult& result, const Figures& figures) {
  canvas.text({kPageMargin, 46.0}, base_name(result.scenario.name), "class=\"title\"");
  canvas.text({kPageMargin, 70.0}, settings_line(result.scenario), "class=\"subtitle\"");
  if (result.ok()) {
    draw_key_figures(canvas, key_figures(result, figures));
  } else {
    draw_failure(canvas, result);
  }
  canvas.line({kPageMargin, 138.0}, {kPageWidth - kPageMargin, 138.0}, "class=\"rule\"");
  draw_legend(canvas, result);
}

}  // namespace

std::string plan_svg(const PlanResult& result) {
  const Figures figures = result.ok() ? measure(result.trajectory, result.scenario) : Figures{};
  const double speed_scale = std::max(0.1, figures.speed);
  const PageLayout page = lay_out_page(result, kViewsTop);
  Canvas canvas;
  canvas.rect({0.0, 0.0, kPageWidth, page.height}, "fill=\"#ffffff\"");
  draw_header(canvas, result, figures);
  draw_panel(canvas, result, page.top, page.top_frame, "Top view", speed_scale);
  draw_panel(canvas, result, page.side, page.side_frame, "Side view", speed_scale);
  if (result.ok()) {
    draw_colour_bar(canvas, speed_scale);
    draw_profile(canvas, page.velocity_frame, Profile::kVelocity, result);
    draw_profile(canvas, page.acceleration_frame, Profile::kAcceleration, result);
  }
  return canvas.document(kPageWidth, page.height, style_sheet());
}

}  // namespace tern_host
