// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/picture/header.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "host/nearest_thing.hpp"
#include "host/number.hpp"
#include "host/picture/layout.hpp"
#include "host/picture/legend.hpp"
#include "host/picture/lettering.hpp"
#include "host/picture/moving_view.hpp"
#include "host/picture/oblique_scene.hpp"
#include "host/plan_file.hpp"

namespace tern_host {
namespace {

constexpr double kLine = 20.0;
constexpr const char* kDot = " \u00b7 ";

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

std::string settings_text(const Scenario& scenario) {
  const std::string margin =
      scenario.tracking_margin > 0.0 ? kDot + ("tracking margin " + fixed(scenario.tracking_margin, 2) + " m") : "";
  return "resolution " + fixed(scenario.resolution, 3) + " m" + kDot + "robot radius " + fixed(scenario.radius, 2) +
         " m" + margin + kDot + "velocity limit per axis " + limit_text(velocity_range(scenario.limits)) + " m/s" +
         kDot + "acceleration limit per axis " + limit_text(acceleration_range(scenario.limits)) + " m/s\u00b2";
}

/// Returns the next line's baseline.
double draw_lines(Canvas& canvas, const std::string& text, const Font& font, double y) {
  for (const std::string& line : wrap_text(text, font, kContentWidth)) {
    canvas.text({kPageMargin, y}, line, std::string("class=\"") + font.name + "\"");
    y += kLine;
  }
  return y;
}

using KeyFigure = std::pair<std::string, std::string>;  // name, value

std::string clearance_text(double clearance, bool fenced) {
  if (std::isfinite(clearance)) return fixed(clearance, 3) + " m";
  return fenced ? "fences only" : "no blocks";
}

std::string percent(double part) {
  return fixed(100.0 * part, 1) + " %";
}

/// From the blocks, and from what moves if there is anything.
std::vector<KeyFigure> clearances(const PlanResult& result, const Figures& figures) {
  const std::string blocks = clearance_text(figures.clearance, !result.scenario.fences.empty());
  const NearestThing moving = nearest_thing(result.trajectory, result.scenario);
  if (moving.index < 0) return {{"least clearance", blocks}};
  return {{"clear of blocks", blocks}, {"clear of things", fixed(moving.gap, 3) + " m"}};
}

std::vector<KeyFigure> key_figures(const PlanResult& result, const Figures& figures) {
  const double us = result.timing.total();
  std::vector<KeyFigure> all{{"duration", fixed(figures.duration, 2) + " s"},
                             {"length", fixed(figures.length, 2) + " m"},
                             {"segments", std::to_string(result.trajectory.count)},
                             {"velocity limit used", percent(figures.v_use)},
                             {"acceleration limit used", percent(figures.a_use)}};
  for (const KeyFigure& clearance : clearances(result, figures)) all.push_back(clearance);
  all.push_back({"snap cost", fixed(figures.snap, figures.snap < 100.0 ? 1 : 0)});
  all.push_back({"computed in", us < 10000.0 ? fixed(us, 0) + " \u00b5s" : fixed(us / 1000.0, 1) + " ms"});
  return all;
}

double width_of(const KeyFigure& figure) {
  return std::max(text_width(figure.first, kFigureName), text_width(figure.second, kFigure));
}

/// The room that the figures leave is shared out between them.
double draw_key_figures(Canvas& canvas, const std::vector<KeyFigure>& figures, double y) {
  double gap = kContentWidth;
  for (const KeyFigure& figure : figures) gap -= width_of(figure);
  gap = std::max(14.0, gap / static_cast<double>(figures.size() - 1));
  double x = kPageMargin;
  for (const KeyFigure& figure : figures) {
    canvas.text({x, y}, figure.first, "class=\"figure-name\"");
    canvas.text({x, y + 24.0}, figure.second, "class=\"figure\"");
    x += width_of(figure) + gap;
  }
  return y + 38.0;
}

double draw_failure(Canvas& canvas, const PlanResult& result, double y) {
  y += 6.0;
  canvas.text({kPageMargin, y}, std::string("No plan: ") + tern::status_name(result.report.status),
              "class=\"figure\" style=\"fill:#b03030\"");
  return draw_lines(canvas, describe_status(result), kFigureName, y + kLine) - 4.0;
}

bool has_block(const Scenario& scenario, bool keepout) {
  return std::any_of(scenario.blocks.begin(), scenario.blocks.end(),
                     [keepout](const Block& block) { return block.keepout == keepout; });
}

LegendEntry shortcut_entry() {
  return {"shortcut, waypoints", [](Canvas& canvas, const Rect& r) {
            const double y = r.y + 0.5 * r.height;
            canvas.line({r.x, y}, {r.right(), y}, "class=\"shortcut\"");
            canvas.circle({r.x + 0.5 * r.width, y}, 3.6, "class=\"waypoint\"");
          }};
}

std::vector<LegendEntry> legend_entries(const PlanResult& result, const Figures& figures) {
  std::vector<LegendEntry> entries = world_entries(result.scenario, WorldLegend::kViews);
  if (result.corridor != nullptr) entries.push_back(area_entry("corridor polyhedra", "class=\"corridor\""));
  if (result.path != nullptr) {
    entries.push_back(line_entry("jump-point path", "class=\"raw\""));
    entries.push_back(shortcut_entry());
  }
  if (result.ok()) {
    if (result.yaw != nullptr) entries.push_back(line_entry("where the nose points", "class=\"nose\""));
    entries.push_back(speed_entry("trajectory, speed |v| from 0 to " + fixed(speed_scale(figures), 2) + " m/s"));
  }
  return entries;
}

std::string obstacle_name(const Scenario& scenario, bool oblique) {
  const std::size_t count = scenario.blocks.size();
  if (!oblique || count <= kMaxObliqueBlocks) return "obstacle";
  return "obstacle (" + std::to_string(kMaxObliqueBlocks) + " of " + std::to_string(count) + ", large ones first)";
}

}  // namespace

std::vector<LegendEntry> world_entries(const Scenario& scenario, WorldLegend legend) {
  const bool oblique = legend == WorldLegend::kOblique;
  const bool keepout = has_block(scenario, true) || has_keepout(scenario.fences, false);
  const bool inflated = keepout || !scenario.blocks.empty() || has_keepout(scenario.fences, true);
  const std::string block = oblique ? "class=\"block-front\"" : "class=\"block\" opacity=\"0.8\"";
  std::vector<LegendEntry> entries;
  if (has_block(scenario, false)) entries.push_back(area_entry(obstacle_name(scenario, oblique), block));
  if (keepout) entries.push_back(keepout_entry());
  if (!oblique && inflated) {
    entries.push_back(area_entry("inflated by the radius", "class=\"inflated\"", 7.0));
  }
  if (has_fence(scenario.fences, tern::FenceKind::kKeepIn)) entries.push_back(keepin_entry());
  for (const LegendEntry& entry : thing_entries(scenario)) entries.push_back(entry);
  if (!scenario.vias.empty()) entries.push_back(dot_entry("vias", 6.0, "class=\"via\""));
  return entries;
}

double speed_scale(const Figures& figures) {
  return std::max(0.1, figures.speed);
}

std::string scenario_title(const PlanResult& result) {
  const std::string& path = result.scenario.name;
  const std::string file = path.substr(path.find_last_of('/') + 1);
  return file.size() > 4 && file.compare(file.size() - 4, 4, ".txt") == 0 ? file.substr(0, file.size() - 4) : file;
}

double draw_header(Canvas& canvas, const PlanResult& result, const Figures& figures) {
  canvas.text({kPageMargin, 46.0}, fit_text(scenario_title(result), kTitle, kContentWidth), "class=\"title\"");
  double y = draw_lines(canvas, settings_text(result.scenario), kSubtitle, 70.0) + 10.0;
  y = result.ok() ? draw_key_figures(canvas, key_figures(result, figures), y) : draw_failure(canvas, result, y);
  canvas.line({kPageMargin, y}, {kPageWidth - kPageMargin, y}, "class=\"rule\"");
  const std::vector<LegendEntry> entries = legend_entries(result, figures);
  draw_legend(canvas, entries, {kPageMargin, y + 13.0}, kContentWidth);
  return y + 18.0 + kLegendRow * legend_rows(entries, kContentWidth);
}

}  // namespace tern_host
